#include "validation/narrow_phase/ccd_witness.hpp"

#include <ccd/ccd.h>

#include <algorithm>

#include "validation/narrow_phase/plain_superquadric.hpp"

namespace osculate::validation {
namespace {

/// libccd works in units of the smaller body's R_vol, with body 1's centre as origin: its tolerances are absolute.
struct Body {
  Superquadric shape;
  Vec3 position;
  Quat orientation;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const auto& body = *static_cast<const Body*>(object);
  const Vec3 u(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3 found =
      body.orientation * plain::support<double>(body.shape, body.orientation.conjugate() * u).point + body.position;
  ccdVec3Set(point, found.x(), found.y(), found.z());
}

void centre(const void* object, ccd_vec3_t* point) {
  const Vec3& position = static_cast<const Body*>(object)->position;
  ccdVec3Set(point, position.x(), position.y(), position.z());
}

using Penetration = decltype(&ccdMPRPenetration);

std::optional<CcdPenetration> penetration(const Pair& pair, double tolerance, Penetration find) {
  const double unit = std::min(plain::volume_radius(pair.shape_1), plain::volume_radius(pair.shape_2));
  const auto body = [&](const Superquadric& shape, const Pose& pose) {
    return Body{
        {shape.half_axes / unit, shape.exponents}, (pose.position - pair.pose_1.position) / unit, pose.orientation};
  };
  const Body body_1 = body(pair.shape_1, pair.pose_1), body_2 = body(pair.shape_2, pair.pose_2);
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = settings.support2 = support;
  settings.center1 = settings.center2 = centre;
  settings.epa_tolerance = settings.mpr_tolerance = tolerance;
  settings.max_iterations = 2000;  // its default is no limit, and it can cycle on smooth bodies
  ccd_real_t depth = 0.0;
  ccd_vec3_t direction, position;
  if (find(&body_1, &body_2, &settings, &depth, &direction, &position) != 0) return std::nullopt;
  return CcdPenetration{depth * unit, Vec3(direction.v[0], direction.v[1], direction.v[2])};
}

}  // namespace

std::optional<CcdPenetration> ccd_gjk_epa(const Pair& pair, double tolerance) {
  return penetration(pair, tolerance, &ccdGJKPenetration);
}

std::optional<CcdPenetration> ccd_mpr(const Pair& pair, double tolerance) {
  return penetration(pair, tolerance, &ccdMPRPenetration);
}

}  // namespace osculate::validation
