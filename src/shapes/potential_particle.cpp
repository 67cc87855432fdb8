#include "osculate/shapes/potential_particle.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "shapes/direction_search.hpp"
#include "shapes/radial_quadrature.hpp"

namespace osculate {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A t > 0 with f(t x) ≥ 0: no plane lets the surface further out than d + r/√(1−k), and the sphere of radius R/√k
/// holds everything.
double stretch_from_above(const PotentialParticle& shape, const Vec3& x) {
  double t = shape.sphere_radius / (std::sqrt(shape.sphericity) * x.norm());
  const double face_offset = shape.edge_radius / std::sqrt(1.0 - shape.sphericity);  // ∞ at k = 1
  for (const FacePlane& plane : shape.planes) {
    const double along = plane.normal.dot(x);
    if (along > 0.0) t = std::min(t, (plane.distance + face_offset) / along);
  }
  return t;
}

/// The t > 0 with f(t x) = 0. f is convex and increasing along the ray where it is ≥ 0, so Newton's steps from above
/// decrease monotonically until rounding stops them.
double stretch_to_surface(const PotentialParticle& shape, const Vec3& x) {
  const double of_planes = (1.0 - shape.sphericity) / (shape.edge_radius * shape.edge_radius);
  const double of_sphere = shape.sphericity * x.squaredNorm() / (shape.sphere_radius * shape.sphere_radius);
  double t = stretch_from_above(shape, x);
  constexpr int enough_steps = 100;
  for (int step = 0; step < enough_steps; ++step) {
    double value = of_sphere * t * t - 1.0, slope = 2.0 * of_sphere * t;
    for (const FacePlane& plane : shape.planes) {
      const double along = plane.normal.dot(x), beyond = along * t - plane.distance;
      if (beyond <= 0.0) continue;
      value += of_planes * beyond * beyond;
      slope += 2.0 * of_planes * beyond * along;
    }
    const double next = t - value / slope;
    if (!(next < t)) break;
    t = next;
  }
  return t;
}

/// The point with ∇f(x) = μ u moves along straight pieces from the centre (μ = 0) to the support point (f = 0): f is
/// quadratic between the values of μ where a plane comes into play or leaves it.
Vec3 follow_to_support_point(const PotentialParticle& shape, const Vec3& u) {
  const double of_planes = 2.0 * (1.0 - shape.sphericity) / (shape.edge_radius * shape.edge_radius);
  const double of_sphere = 2.0 * shape.sphericity / (shape.sphere_radius * shape.sphere_radius);
  std::vector<char> in_play(shape.planes.size(), 0);
  Mat3 hessian = of_sphere * Mat3::Identity();
  Vec3 x = Vec3::Zero();
  double multiplier = 0.0, value = -1.0;
  const std::size_t enough_pieces = 4 * shape.planes.size() + 16;
  for (std::size_t piece = 0; piece < enough_pieces; ++piece) {
    const Vec3 velocity = hessian.ldlt().solve(u);
    const double rate = u.dot(velocity);  // f = value + rate (multiplier s + s²/2), s being the increase of μ
    double length = std::sqrt(multiplier * multiplier - 2.0 * value / rate) - multiplier;
    std::size_t turning = shape.planes.size();
    for (std::size_t i = 0; i < shape.planes.size(); ++i) {
      const double approach = shape.planes[i].normal.dot(velocity);
      if (in_play[i] ? approach >= 0.0 : approach <= 0.0) continue;
      const double until = std::max((shape.planes[i].distance - shape.planes[i].normal.dot(x)) / approach, 0.0);
      if (until >= length) continue;
      length = until;
      turning = i;
    }
    x += length * velocity;
    if (turning == shape.planes.size()) break;
    value += rate * length * (multiplier + 0.5 * length);
    multiplier += length;
    const Vec3& normal = shape.planes[turning].normal;
    hessian += (in_play[turning] ? -of_planes : of_planes) * normal * normal.transpose();
    in_play[turning] = in_play[turning] ? 0 : 1;
  }
  return stretch_to_surface(shape, x) * x;
}

double mismatch(const Vec3& gradient, const Vec3& unit_direction) {
  return (gradient.normalized() - unit_direction).norm();
}

/// Newton's method for the same point from a surface point nearby. Where f is quadratic its level set is an ellipsoid,
/// whose support point is the answer once the set of planes in play is right; until then it is a direction of ascent,
/// since the ellipsoid touches the body at `best`.
Vec3 polish_support_point(const PotentialParticle& shape, const Vec3& u, Vec3 best) {
  ImplicitValue at_best = implicit_value(shape, best);
  constexpr int enough_steps = 50, enough_halvings = 30;
  constexpr double sufficient_ascent = 1e-4;
  for (int step = 0; step < enough_steps; ++step) {
    const double best_mismatch = mismatch(at_best.gradient, u);
    if (best_mismatch <= epsilon) break;
    const Eigen::LDLT<Mat3> hessian(at_best.hessian);
    const Vec3 to_centre = -hessian.solve(at_best.gradient), towards = hessian.solve(u);
    const double depth = -at_best.gradient.dot(to_centre) - 2.0 * at_best.value;
    const Vec3 move = to_centre + std::sqrt(std::max(depth, 0.0) / u.dot(towards)) * towards;
    const double height = u.dot(best);
    const double slope = u.dot(move) - height * at_best.gradient.dot(move) / at_best.gradient.dot(best);
    double fraction = std::min(1.0, 2.0 * best.norm() / std::max(move.norm(), std::numeric_limits<double>::min()));
    bool moved = false;
    for (int halving = 0; halving < enough_halvings && !moved; ++halving, fraction *= 0.5) {
      const Vec3 ray = best + fraction * move;
      const Vec3 candidate = stretch_to_surface(shape, ray) * ray;
      const double gain = u.dot(candidate - best);
      // The height is flat at its maximum: within its rounding only the normal tells which point is better.
      const bool within_rounding = std::fabs(gain) <= 4.0 * epsilon * height;
      if (!within_rounding && gain < sufficient_ascent * fraction * slope) continue;
      const ImplicitValue at_candidate = implicit_value(shape, candidate);
      if (within_rounding && !(mismatch(at_candidate.gradient, u) < best_mismatch)) break;
      best = candidate;
      at_best = at_candidate;
      moved = true;
    }
    if (!moved) break;
  }
  return best;
}

}  // namespace

ImplicitValue implicit_value(const PotentialParticle& shape, const Vec3& x) {
  const double of_planes = (1.0 - shape.sphericity) / (shape.edge_radius * shape.edge_radius);
  const double of_sphere = shape.sphericity / (shape.sphere_radius * shape.sphere_radius);
  ImplicitValue f{of_sphere * x.squaredNorm() - 1.0, 2.0 * of_sphere * x, 2.0 * of_sphere * Mat3::Identity()};
  for (const FacePlane& plane : shape.planes) {
    const double beyond = plane.normal.dot(x) - plane.distance;
    if (beyond <= 0.0) continue;
    f.value += of_planes * beyond * beyond;
    f.gradient += (2.0 * of_planes * beyond) * plane.normal;
    f.hessian += (2.0 * of_planes) * plane.normal * plane.normal.transpose();
  }
  return f;
}

Gauge gauge(const PotentialParticle& shape, const Vec3& x) {
  if (x.isZero(0.0)) return {0.0, Vec3::Zero(), Mat3::Zero()};
  const double stretch = stretch_to_surface(shape, x);
  const Vec3 p = stretch * x;
  const ImplicitValue f = implicit_value(shape, p);
  // N(y) is defined by f(y/N) = 0; differentiate twice at the surface point, where N = 1.
  const double along = f.gradient.dot(p);
  const Vec3 gradient = f.gradient / along;
  const Mat3 onto_surface = Mat3::Identity() - p * gradient.transpose();
  const Mat3 hessian = onto_surface.transpose() * f.hessian * onto_surface / along;
  return {1.0 / stretch, gradient, hessian * stretch};
}

Vec3 support_point(const PotentialParticle& shape, const Vec3& u) {
  if (u.isZero(0.0)) return Vec3::Zero();
  const Vec3 direction = u.stableNormalized();
  return polish_support_point(shape, direction, follow_to_support_point(shape, direction));
}

double bounding_radius(const PotentialParticle& shape) {
  const double of_sphere = shape.sphere_radius / std::sqrt(shape.sphericity);
  return std::min(of_sphere * (1.0 + 4.0 * epsilon),
                  largest_radius([&](const Vec3& u) { return support_point(shape, u); }));
}

OrientedBox oriented_box(const PotentialParticle& shape) {
  Vec3 lowest, highest;
  for (int axis = 0; axis < 3; ++axis) {
    highest[axis] = support_point(shape, Vec3::Unit(axis))[axis];
    lowest[axis] = support_point(shape, -Vec3::Unit(axis))[axis];
  }
  return {0.5 * (highest + lowest), 0.5 * (highest - lowest)};
}

MassProperties mass_properties(const PotentialParticle& shape) {
  return mass_properties_by_quadrature([&](const Vec3& x) { return stretch_to_surface(shape, x); });
}

}  // namespace osculate
