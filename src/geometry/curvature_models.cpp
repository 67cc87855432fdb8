#include "osculate/geometry/curvature_models.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "osculate/geometry/relative_curvature.hpp"

namespace osculate {
namespace {

/// The curvature of the sphere that stands for a body, signed.
double sphere_curvature(CurvatureModel model, const ContactBody& body) {
  const double mean = body.curvature.mean();
  const bool is_wall = std::isinf(body.volume_radius);
  if (model == CurvatureModel::volume_equivalent && !is_wall) return 1.0 / body.volume_radius;
  if (model == CurvatureModel::gaussian) {
    // √a √b, since the product may overflow where a rim's curvature stands for ∞.
    const double geometric = std::sqrt(std::fabs(body.curvature.max)) * std::sqrt(std::fabs(body.curvature.min));
    return std::copysign(geometric, mean);
  }
  return mean;
}

}  // namespace

std::string_view name(CurvatureModel model) {
  switch (model) {
    case CurvatureModel::exact:
      return "exact";
    case CurvatureModel::gaussian:
      return "gaussian";
    case CurvatureModel::mean:
      return "mean";
    case CurvatureModel::volume_equivalent:
      return "volume-equivalent";
  }
  return "unknown";
}

RelativeCurvature relative_curvature(CurvatureModel model, const Vec3& normal, const ContactBody& body_1,
                                     const ContactBody& body_2, double cap) {
  if (model == CurvatureModel::exact) {
    return relative_curvature(normal, body_1.curvature, body_2.curvature,
                              cap * std::min(body_1.volume_radius, body_2.volume_radius));
  }
  bool capped = false;
  const auto floored = [&](const ContactBody& body) {
    const double curvature = sphere_curvature(model, body);
    const double floor = std::isinf(body.volume_radius) ? 0.0 : 1.0 / (cap * body.volume_radius);
    if (curvature < 0.0 || curvature >= floor) return curvature;
    capped = true;
    return floor;
  };
  const double sum = floored(body_1) + floored(body_2);
  const double radius = sum > 0.0 ? 1.0 / sum : std::numeric_limits<double>::infinity();
  // The major axis of a circle: the fixed tangent of this normal.
  const PrincipalCurvatures round{.max = 1.0, .min = 1.0, .max_direction = Vec3::Zero()};
  return {.R_i = radius,
          .R_j = radius,
          .major_axis = relative_curvature(normal, round, round).major_axis,
          .capped = capped};
}

}  // namespace osculate
