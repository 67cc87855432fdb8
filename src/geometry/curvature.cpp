#include "osculate/geometry/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/tangent_plane.hpp"
#include "osculate/core/error.hpp"

namespace osculate {
namespace {

PrincipalCurvatures curvatures_of(const Superquadric& shape, const Vec3& point) {
  const Vec3 gradient = gauge(shape, point).gradient;
  const double slope = gradient.norm();
  const TangentPlane plane(gradient / slope);
  const RankTwoFactors factors = gauge_hessian_factors(shape, point);
  const Eigen::Vector2d a = plane.coordinates(factors.a) / std::sqrt(slope);
  const Eigen::Vector2d b = plane.coordinates(factors.b) / std::sqrt(slope);
  // Eigenvalues of a aᵀ + b bᵀ. The determinant is a square: the small one keeps its digits.
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), area = a.x() * b.y() - a.y() * b.x();
  PrincipalCurvatures curvature;
  curvature.max = 0.5 * (aa + bb + std::hypot(aa - bb, 2.0 * a.dot(b)));
  curvature.min = curvature.max > 0.0 ? std::min(area * (area / curvature.max), curvature.max) : 0.0;
  curvature.max_direction = plane.lift(
      major_angle(a.x() * a.x() + b.x() * b.x(), a.x() * a.y() + b.x() * b.y(), a.y() * a.y() + b.y() * b.y()));
  return curvature;
}

PrincipalCurvatures curvatures_of(const PotentialParticle& shape, const Vec3& point) {
  const ImplicitValue f = implicit_value(shape, point / gauge(shape, point).value);
  const double slope = f.gradient.norm();
  const TangentPlane plane(f.gradient / slope);
  const double xx = plane.first.dot(f.hessian * plane.first) / slope;
  const double xy = plane.first.dot(f.hessian * plane.second) / slope;
  const double yy = plane.second.dot(f.hessian * plane.second) / slope;
  const double half_difference = std::hypot(0.5 * (xx - yy), xy), mean = 0.5 * (xx + yy);
  // The sphere's term bounds every curvature from below; rounding must not take it away.
  const double of_sphere = 2.0 * shape.sphericity / (shape.sphere_radius * shape.sphere_radius) / slope;
  return {.max = mean + half_difference,
          .min = std::max(mean - half_difference, of_sphere),
          .max_direction = plane.lift(major_angle(xx, xy, yy))};
}

PrincipalCurvatures curvatures_of(const HalfSpace&, const Vec3&) {
  return {.max = 0.0, .min = 0.0, .max_direction = Vec3::UnitX()};
}

PrincipalCurvatures curvatures_of(const Cylinder& wall, const Vec3& point) {
  const Vec3 around = signed_distance(wall, point).normal.cross(Vec3::UnitZ());
  if (wall.solid == Cylinder::Solid::inside) return {.max = 1.0 / wall.radius, .min = 0.0, .max_direction = around};
  return {.max = 0.0, .min = -1.0 / wall.radius, .max_direction = Vec3::UnitZ()};
}

PrincipalCurvatures curvatures_of(const SphereContainer& wall, const Vec3& point) {
  const double curvature = -1.0 / wall.radius;
  return {
      .max = curvature, .min = curvature, .max_direction = TangentPlane(signed_distance(wall, point).normal).lift(0.0)};
}

}  // namespace

PrincipalCurvatures principal_curvatures(const Shape& shape, const Vec3& point_b) {
  if (is_particle(shape) && !(point_b.allFinite() && !point_b.isZero(0.0))) {
    throw InputError("principal curvatures",
                     "the point (" + std::to_string(point_b.x()) + ", " + std::to_string(point_b.y()) + ", " +
                         std::to_string(point_b.z()) + ")",
                     "a finite point other than the centre");
  }
  return std::visit(
      [&](const auto& s) {
        if constexpr (requires { as_superquadric(s); }) {
          return curvatures_of(as_superquadric(s), point_b);
        } else {
          return curvatures_of(s, point_b);
        }
      },
      shape);
}

}  // namespace osculate
