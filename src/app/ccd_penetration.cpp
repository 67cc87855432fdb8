#include "app/ccd_penetration.hpp"

#include <ccd/ccd.h>

namespace osculate::app {
namespace {

// libccd has no limit of its own and can cycle on smooth bodies.
constexpr unsigned long iteration_limit = 1000;

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const auto& body = *static_cast<const PlacedBody*>(object);
  const Vec3 direction_w(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3 found =
      body.body_to_world * support_point(body.shape, body.body_to_world.transpose() * direction_w) + body.position;
  ccdVec3Set(point, found.x(), found.y(), found.z());
}

}  // namespace

PlacedBody place(const Superquadric& shape, const Pose& pose) {
  return {.shape = shape, .position = pose.position, .body_to_world = pose.orientation.toRotationMatrix()};
}

std::optional<double> ccd_penetration(const PlacedBody& body_1, const PlacedBody& body_2, double tolerance) {
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = support;
  settings.support2 = support;
  settings.epa_tolerance = tolerance;
  settings.max_iterations = iteration_limit;
  ccd_real_t depth = 0.0;
  ccd_vec3_t direction;
  ccd_vec3_t position;
  if (ccdGJKPenetration(&body_1, &body_2, &settings, &depth, &direction, &position) != 0) return std::nullopt;
  return depth;
}

}  // namespace osculate::app
