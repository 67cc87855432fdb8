#include "validation/halfspace/gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate::validation::halfspace {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How deep under the tangent plane at `on` (body frame, outward normal n) the surface lies on the line through
/// `start`: the first root of N(start − z n) = 1. N is convex along the line, so that Newton from outside never
/// overshoots.
double depth(const Shape& shape, const Vec3& start, const Vec3& normal) {
  constexpr int most_steps = 100;
  double z = 0.0;
  for (int i = 0; i < most_steps; ++i) {
    const Gauge here = gauge(shape, start - z * normal);
    const double rate = -here.gradient.dot(normal);
    const double excess = here.value - 1.0;
    if (!(rate < 0.0)) return excess > 0.0 ? infinity : z;  // past the outline
    const double step = -excess / rate;
    z += step;
    if (std::fabs(step) <= 1e-15 * start.norm() || (i > 0 && step <= 0.0)) return z;
  }
  return z;
}

/// The largest |t| with gap(t·(ux, uy)) < overlap along a ray: bracketing, then halving.
double reach(const GapField& gap, double ux, double uy, double overlap, double guess) {
  double inside = 0.0, outside = guess;
  while (gap(outside * ux, outside * uy) < overlap) {
    inside = outside;
    outside *= 2.0;
  }
  constexpr int halvings = 30;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    (gap(middle * ux, middle * uy) < overlap ? inside : outside) = middle;
  }
  return outside;
}

}  // namespace

GapField true_gap(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2,
                  const ContactGeometry& contact) {
  if (!is_particle(shape_1) || !is_particle(shape_2)) throw InputError("halfspace", "a wall", "two particles");
  if (!is_resolved(contact.status) || contact.status == ContactStatus::ambiguous)
    throw InputError("halfspace", "a contact that is " + std::string(name(contact.status)), "one with a common normal");
  const Vec3 n = contact.normal, e_i = contact.relative.major_axis, e_j = n.cross(e_i);
  struct Side {
    Shape shape;
    Vec3 on, outward, along_i, along_j;
  };
  const auto side = [&](const Shape& shape, const Pose& pose, const Vec3& on, const Vec3& outward) {
    return Side{shape, pose.to_body(on), pose.rotate_to_body(outward), pose.rotate_to_body(e_i),
                pose.rotate_to_body(e_j)};
  };
  return [first = side(shape_1, pose_1, contact.on_1, n), second = side(shape_2, pose_2, contact.on_2, -n)](double x,
                                                                                                            double y) {
    const auto under = [&](const Side& body) {
      return depth(body.shape, body.on + x * body.along_i + y * body.along_j, body.outward);
    };
    return under(first) + under(second);
  };
}

GapField quadratic_gap(double R_i, double R_j) {
  return [=](double x, double y) { return 0.5 * (x * x / R_i + y * y / R_j); };
}

Grid grid_around(const GapField& gap, double overlap, double size, int cells) {
  // The outline of {gap < δ} by rays; where it is widest in x and y.
  constexpr int rays = 64;
  double half_x = 0.0, half_y = 0.0;
  for (int k = 0; k < rays; ++k) {
    const double angle = 2.0 * M_PI * k / rays;
    const double ux = std::cos(angle), uy = std::sin(angle), length = reach(gap, ux, uy, overlap, size);
    half_x = std::max(half_x, length * std::fabs(ux));
    half_y = std::max(half_y, length * std::fabs(uy));
  }
  constexpr double margin = 1.02;  // between two rays
  return {cells, cells, 2.0 * margin * half_x / cells, 2.0 * margin * half_y / cells};
}

std::vector<double> sampled(const GapField& gap, const Grid& grid) {
  std::vector<double> values;
  for (int j = 0; j < grid.cells_y; ++j)
    for (int i = 0; i < grid.cells_x; ++i) values.push_back(gap(grid.x(i), grid.y(j)));
  return values;
}

}  // namespace osculate::validation::halfspace
