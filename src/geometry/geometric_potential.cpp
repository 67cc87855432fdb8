#include "osculate/geometry/geometric_potential.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "osculate/core/error.hpp"
#include "osculate/geometry/curvature.hpp"
#include "osculate/geometry/relative_curvature.hpp"

namespace osculate {
namespace {

/// p of F = N^p − 1.
double potential_power(const Shape& shape) {
  const auto* superquadric = std::get_if<Superquadric>(&shape);
  return superquadric ? superquadric->exponents.n1 : 2.0;
}

struct PlacedShape {
  const Shape& shape;
  Mat3 rotation;  // body → world
  Vec3 centre;    // world, from the origin of the computation
  double power;

  PlacedShape(const Shape& which, const Pose& pose, const Vec3& origin)
      : shape(which),
        rotation(pose.orientation.toRotationMatrix()),
        centre(pose.position - origin),
        power(potential_power(which)) {}

  Vec3 to_body(const Vec3& x) const { return rotation.transpose() * (x - centre); }
  Gauge at(const Vec3& x) const {
    Gauge gauge = osculate::gauge(shape, to_body(x));
    gauge.gradient = rotation * gauge.gradient;
    gauge.hessian = rotation * gauge.hessian * rotation.transpose();
    return gauge;
  }
};

struct Blend {
  Gauge gauge_1, gauge_2;
  double value;  // (1 − μ) N1² + μ N2²
  Vec3 gradient;
  Mat3 hessian;
};

Blend blend(const PlacedShape& one, const PlacedShape& two, double share_1, double share_2, const Vec3& x) {
  Blend result{.gauge_1 = one.at(x), .gauge_2 = two.at(x), .value = 0.0, .gradient = {}, .hessian = {}};
  const auto square = [](const Gauge& g) -> Mat3 { return g.gradient * g.gradient.transpose() + g.value * g.hessian; };
  const Gauge &n1 = result.gauge_1, &n2 = result.gauge_2;
  result.value = share_1 * n1.value * n1.value + share_2 * n2.value * n2.value;
  result.gradient = 2.0 * (share_1 * n1.value * n1.gradient + share_2 * n2.value * n2.gradient);
  result.hessian = 2.0 * (share_1 * square(n1) + share_2 * square(n2));
  return result;
}

struct Minimum {
  Vec3 x;
  Blend at;
  bool converged;
};

/// Newton with step halving. The Newton decrement, the square of a relative error, says when to stop: where it is so
/// small that values no longer differ, full steps are taken as long as they shrink it.
Minimum minimise(const PlacedShape& one, const PlacedShape& two, double log_ratio, Vec3 x) {
  constexpr int most_steps = 100, most_halvings = 40;
  constexpr double arrived = 1e-30, near = 1e-10, round_off = 1e-13, armijo = 1e-4;
  constexpr double regularisation = 1e-14;  // of the trace: aligned faces leave the Hessian singular
  const double share_2 = 1.0 / (1.0 + std::exp(-log_ratio)), share_1 = 1.0 / (1.0 + std::exp(log_ratio));
  Blend here = blend(one, two, share_1, share_2, x);
  double decrement = std::numeric_limits<double>::infinity(), last = decrement;
  for (int step = 0; step < most_steps; ++step) {
    const Mat3 hessian = here.hessian + regularisation * here.hessian.trace() * Mat3::Identity();
    const Vec3 move = -hessian.ldlt().solve(here.gradient);
    decrement = -move.dot(here.gradient) / here.value;
    if (!(decrement > arrived) || (decrement < near && decrement > 0.25 * last)) break;
    last = decrement;
    double t = 1.0;
    bool descended = false;
    for (int halving = 0; halving < most_halvings && !descended; ++halving, t *= 0.5) {
      const Vec3 next = x + t * move;
      if (next == one.centre || next == two.centre) continue;
      const Blend there = blend(one, two, share_1, share_2, next);
      descended = there.value < here.value * (1.0 - armijo * t * decrement) || decrement < near;
      if (!descended) continue;
      x = next;
      here = there;
    }
    if (!descended) break;
  }
  return {x, here, decrement >= 0.0 && decrement < round_off};
}

/// p1 log N1 − p2 log N2: zero where F1 = F2, and rising with μ.
double imbalance(const PlacedShape& one, const PlacedShape& two, const Minimum& minimum) {
  return one.power * std::log(minimum.at.gauge_1.value) - two.power * std::log(minimum.at.gauge_2.value);
}

/// Regula falsi with the Illinois weights in log(μ/(1 − μ)).
Minimum midway(const PlacedShape& one, const PlacedShape& two) {
  constexpr int most_steps = 100;
  constexpr double balanced = 1e-13, widest = 700.0;
  const double size_1 = bounding_radius(one.shape), size_2 = bounding_radius(two.shape);
  // Exact for spheres.
  double low = std::log(size_2 / size_1);
  Minimum best = minimise(one, two, low, one.centre + size_1 / (size_1 + size_2) * (two.centre - one.centre));
  double at_low = imbalance(one, two, best);
  if (std::fabs(at_low) <= balanced) return best;

  double high = low, at_high = at_low, stride = at_low > 0.0 ? -0.5 : 0.5;
  while (at_high * at_low > 0.0 && std::fabs(high) < widest) {
    low = high;
    at_low = at_high;
    high += stride;
    stride *= 2.0;
    best = minimise(one, two, high, best.x);
    at_high = imbalance(one, two, best);
  }
  int kept = 0;
  for (int step = 0; step < most_steps && std::fabs(imbalance(one, two, best)) > balanced; ++step) {
    const double middle = (low * at_high - high * at_low) / (at_high - at_low);
    best = minimise(one, two, middle, best.x);
    const double at_middle = imbalance(one, two, best);
    if (!std::isfinite(at_middle)) break;
    if (at_middle * at_high > 0.0) {
      high = middle;
      at_high = at_middle;
      if (kept == 1) at_low *= 0.5;
      kept = 1;
    } else {
      low = middle;
      at_low = at_middle;
      if (kept == -1) at_high *= 0.5;
      kept = -1;
    }
  }
  constexpr double close_enough = 1e-10;
  best.converged = best.converged && std::fabs(imbalance(one, two, best)) < close_enough;
  return best;
}

/// How far from x along the unit direction the gauge reaches 1. x inside, the gauge rising: convex along the line, so
/// that Newton's method overshoots once and then comes back monotonously.
double reach(const PlacedShape& body, const Vec3& x, const Vec3& direction) {
  constexpr int most_steps = 100;
  constexpr double round_off = 1e-15;
  double along = 0.0;
  for (int step = 0; step < most_steps; ++step) {
    const Gauge gauge = body.at(x + along * direction);
    const double change = (1.0 - gauge.value) / gauge.gradient.dot(direction);
    if (!std::isfinite(change)) break;
    along += change;
    if (std::fabs(change) <= round_off * std::fabs(along)) break;
  }
  return along;
}

/// Level surfaces are scaled copies of the surface.
PrincipalCurvatures level_curvatures(const PlacedShape& body, const Vec3& x, double level) {
  PrincipalCurvatures curvatures = principal_curvatures(body.shape, body.to_body(x));
  curvatures.max /= level;
  curvatures.min /= level;
  curvatures.max_direction = body.rotation * curvatures.max_direction;
  return curvatures;
}

}  // namespace

GeometricPotentialContact geometric_potential(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2,
                                              const Pose& pose_2) {
  GeometricPotentialContact contact;
  const Vec3 origin = pose_1.position;
  const PlacedShape one(shape_1, pose_1, origin), two(shape_2, pose_2, origin);
  for (const Shape* shape : {&shape_1, &shape_2})
    if (!is_particle(*shape))
      throw InputError("geometric_potential", "a " + std::string(kind(*shape)), "a particle: walls have no gauge");
  if (!one.rotation.allFinite() || !two.rotation.allFinite() || !two.centre.allFinite() || one.centre == two.centre)
    return contact;

  const Minimum minimum = midway(one, two);
  const Gauge &gauge_1 = minimum.at.gauge_1, &gauge_2 = minimum.at.gauge_2;
  const Vec3 normal = (gauge_1.gradient.normalized() - gauge_2.gradient.normalized()).normalized();
  if (!normal.allFinite() || normal.isZero()) return contact;
  contact.point = minimum.x + origin;
  contact.normal = normal;
  // Of equals up to round-off the mean.
  contact.potential =
      0.5 * (std::expm1(one.power * std::log(gauge_1.value)) + std::expm1(two.power * std::log(gauge_2.value)));
  const bool gap = contact.potential > 0.0;
  contact.status = !minimum.converged ? ContactStatus::not_converged
                   : gap              ? ContactStatus::separated
                                      : ContactStatus::touching;
  const double along_1 = gap ? (1.0 - gauge_1.value) / gauge_1.gradient.norm() : reach(one, minimum.x, normal);
  const double along_2 = gap ? (1.0 - gauge_2.value) / gauge_2.gradient.norm() : reach(two, minimum.x, -normal);
  contact.overlap = along_1 + along_2;
  contact.on_1 = contact.point + along_1 * normal;
  contact.on_2 = contact.point - along_2 * normal;
  contact.curvature_1 = level_curvatures(one, minimum.x, gauge_1.value);
  contact.curvature_2 = level_curvatures(two, minimum.x, gauge_2.value);
  contact.relative = relative_curvature(normal, contact.curvature_1, contact.curvature_2);
  return contact;
}

}  // namespace osculate
