#include "osculate/geometry/relative_curvature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/tangent_plane.hpp"

namespace osculate {
namespace {

/// One term k t tᵀ of the summed shape operators.
struct Bend {
  double curvature;
  Eigen::Vector2d tangent;  // unit
};

std::array<Bend, 2> bends_of(const PrincipalCurvatures& curvature, const TangentPlane& plane) {
  const Eigen::Vector2d in_plane = plane.coordinates(curvature.max_direction);
  const double length = in_plane.norm();
  const Eigen::Vector2d t = length > 0.0 ? Eigen::Vector2d(in_plane / length) : Eigen::Vector2d::UnitX();
  return {Bend{curvature.max, t}, Bend{curvature.min, {-t.y(), t.x()}}};
}

/// Exactly zero for equal vectors, whether or not the compiler fuses products and sums.
double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * (b.y() - a.y()) - a.y() * (b.x() - a.x());
}

Vec3 towards_positive(const Vec3& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0.0 ? Vec3(-axis) : axis;
}

}  // namespace

RelativeCurvature relative_curvature(const Vec3& normal, const PrincipalCurvatures& curvature_1,
                                     const PrincipalCurvatures& curvature_2, double radius_cap) {
  const TangentPlane plane(normal);
  const auto [a, b] = bends_of(curvature_1, plane);
  const auto [c, d] = bends_of(curvature_2, plane);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Bend& bend : {a, b, c, d}) {
    xx += bend.curvature * bend.tangent.x() * bend.tangent.x();
    xy += bend.curvature * bend.tangent.x() * bend.tangent.y();
    yy += bend.curvature * bend.tangent.y() * bend.tangent.y();
  }
  const double mean = 0.5 * (a.curvature + b.curvature + c.curvature + d.curvature);
  const double half_difference = std::hypot(0.5 * (xx - yy), xy);
  const double larger = mean + half_difference;
  // The determinant as a sum over pairs of terms has only terms ≥ 0 for convex bodies: the smaller eigenvalue, taken
  // from it, keeps its digits beside a much larger one. Divided as it is built, against overflow.
  const auto pair_over_larger = [&](const Bend& p, const Bend& q) {
    const double sine = cross(p.tangent, q.tangent);
    return p.curvature * (q.curvature / larger) * sine * sine;
  };
  double smaller = mean - half_difference;
  if (larger > 0.0) {
    smaller = pair_over_larger(a, b) + pair_over_larger(c, d) + pair_over_larger(a, c) + pair_over_larger(a, d) +
              pair_over_larger(b, c) + pair_over_larger(b, d);
    smaller = std::min(smaller, larger);
  }
  RelativeCurvature relative;
  const auto radius_of = [&](double curvature) {
    const double radius = curvature > 0.0 ? 1.0 / curvature : std::numeric_limits<double>::infinity();
    if (radius > radius_cap) relative.capped = true;
    return std::min(radius, radius_cap);
  };
  relative.R_i = radius_of(smaller);
  relative.R_j = radius_of(larger);
  const double total =
      std::fabs(a.curvature) + std::fabs(b.curvature) + std::fabs(c.curvature) + std::fabs(d.curvature);
  const bool has_one_major_axis = half_difference > 8.0 * std::numeric_limits<double>::epsilon() * total;
  const double angle = has_one_major_axis ? major_angle(xx, xy, yy) + 0.5 * std::numbers::pi : 0.0;
  relative.major_axis = towards_positive(plane.lift(angle));
  return relative;
}

}  // namespace osculate
