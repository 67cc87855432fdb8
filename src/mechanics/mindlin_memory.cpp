#include "osculate/mechanics/mindlin_memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>

#include "osculate/core/error.hpp"

namespace osculate::mindlin {
namespace {

static_assert(std::is_trivially_copyable_v<Memory>);

/// Deviations from a straight line below this, relative to the sliding deflection, are rounding.
constexpr double straight = 1e-14;

double dot(const Layer& a, const Layer& b) {
  return a.x * b.x + a.y * b.y;
}

Layer between(const Layer& a, const Layer& b, double t) {
  return {a.depth + t * (b.depth - a.depth), a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// The polyline of one step under way: room for what a step can add before it is cut down to `layers`.
struct Polyline {
  std::array<Layer, layers + 4> at;
  int count = 0;

  void add(const Layer& layer) { at[static_cast<std::size_t>(count++)] = layer; }
  Layer& operator[](int i) { return at[static_cast<std::size_t>(i)]; }
  const Layer& operator[](int i) const { return at[static_cast<std::size_t>(i)]; }
  void erase(int i) {
    std::copy(at.begin() + i + 1, at.begin() + count, at.begin() + i);
    --count;
  }
};

struct Cone {
  double overlap, friction;

  double radius(const Layer& layer) const { return friction * (overlap - layer.depth); }
  bool slides(const Layer& layer) const { return dot(layer, layer) > radius(layer) * radius(layer); }
  Layer projected(const Layer& layer) const {
    if (!slides(layer)) return layer;
    const double share = radius(layer) / std::sqrt(dot(layer, layer));
    return {layer.depth, layer.x * share, layer.y * share};
  }
  /// Where the line from a spring that sticks to one that slides leaves the cone.
  Layer crossing(const Layer& sticks, const Layer& slips) const {
    const double drop = friction * (slips.depth - sticks.depth), r = radius(sticks);
    const double dx = slips.x - sticks.x, dy = slips.y - sticks.y;
    const double A = dx * dx + dy * dy - drop * drop;
    const double B = sticks.x * dx + sticks.y * dy + r * drop;
    const double C = std::fmin(dot(sticks, sticks) - r * r, 0.0);
    // B² − AC, written so that small deflections keep their digits.
    const double px = r * dx + drop * sticks.x, py = r * dy + drop * sticks.y;
    const double twist = sticks.x * dy - sticks.y * dx;
    const double root = std::sqrt(std::fmax(px * px + py * py - twist * twist, 0.0));
    const double t = B > 0.0 ? -C / (B + root) : A > 0.0 ? (root - B) / A : 0.0;
    return between(sticks, slips, std::clamp(t, 0.0, 1.0));
  }
};

/// ∫ η^{−1/2} s_x², s_y² dη along a straight piece: a polynomial of degree 4 in √η, for which three Gauss points are
/// exact.
Planar squared(const Layer& a, const Layer& b) {
  static constexpr double node = 0.7745966692414834;  // √(3/5)
  const double from = std::sqrt(a.depth), to = std::sqrt(b.depth);
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const double inverse = b.depth > a.depth ? 1.0 / (b.depth - a.depth) : 0.0;
  Planar sum{0.0, 0.0};
  for (const auto& [place, weight] : {std::pair{-node, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {node, 5.0 / 9.0}}) {
    const double q = middle + place * half;
    const Layer s = between(a, b, (q * q - a.depth) * inverse);
    sum.x += weight * s.x * s.x;
    sum.y += weight * s.y * s.y;
  }
  return {2.0 * half * sum.x, 2.0 * half * sum.y};
}

/// The same over the whole polyline, its last point included.
Planar squared(const Polyline& line) {
  Planar sum{0.0, 0.0};
  for (int i = 0; i + 1 < line.count; ++i) {
    const Planar piece = squared(line[i], line[i + 1]);
    sum.x += piece.x;
    sum.y += piece.y;
  }
  return sum;
}

/// Leaves out the point that bends the line least, weighed by the stretch it bends. If that would raise the energy of
/// a component, the component shrinks until it does not: forgetting must not create energy.
void forget_one(Polyline& line) {
  int least = 1;
  double smallest = INFINITY;
  Layer last_slope{};
  for (int i = 0; i + 1 < line.count; ++i) {
    const double inverse = 1.0 / (line[i + 1].depth - line[i].depth);
    const Layer slope{0.0, (line[i + 1].x - line[i].x) * inverse, (line[i + 1].y - line[i].y) * inverse};
    if (i > 0) {
      const double bend = (std::fabs(slope.x - last_slope.x) + std::fabs(slope.y - last_slope.y)) *
                          (line[i + 1].depth - line[i - 1].depth);
      if (bend < smallest) smallest = bend, least = i;
    }
    last_slope = slope;
  }
  const Planar before_1 = squared(line[least - 1], line[least]), before_2 = squared(line[least], line[least + 1]);
  const Planar after = squared(line[least - 1], line[least + 1]);
  const double rise_x = after.x - before_1.x - before_2.x, rise_y = after.y - before_1.y - before_2.y;
  line.erase(least);
  if (rise_x <= 0.0 && rise_y <= 0.0) return;
  const Planar total = squared(line);
  const auto shrink = [](double rise, double energy) {
    return rise > 0.0 ? std::sqrt(std::fmax(1.0 - rise / energy, 0.0)) : 1.0;
  };
  const double scale_x = shrink(rise_x, total.x), scale_y = shrink(rise_y, total.y);
  for (int i = 0; i < line.count; ++i) line[i].x *= scale_x, line[i].y *= scale_y;
}

/// The springs after the shift, before any slides, from depth 0 to the new overlap.
Polyline shifted(const Springs& springs, double overlap, Planar shift) {
  Polyline line;
  const Layer old_end{springs.overlap, shift.x, shift.y};
  for (int i = 0; i < springs.count; ++i) {
    const Layer& old = springs.at[static_cast<std::size_t>(i)];
    const Layer moved{old.depth, old.x + shift.x, old.y + shift.y};
    if (moved.depth >= overlap) {
      const Layer& inner = line[line.count - 1];
      line.add(between(inner, moved, (overlap - inner.depth) / (moved.depth - inner.depth)));
      return line;
    }
    line.add(moved);
  }
  if (line.count == 0) {  // just made: the shift is that since the surfaces met
    line.add({0.0, shift.x, shift.y});
  } else if (overlap <= springs.overlap) {
    const Layer& inner = line[line.count - 1];
    line.add(between(inner, old_end, (overlap - inner.depth) / (old_end.depth - inner.depth)));
    return line;
  } else {
    line.add(old_end);
  }
  line.add({overlap, 0.0, 0.0});
  return line;
}

}  // namespace

void advance(Springs& springs, double overlap, Planar shift, double friction) {
  if (!(overlap > 0.0)) {
    springs.overlap = 0.0;
    springs.count = 0;
    return;
  }
  const Polyline trial = shifted(springs, overlap, shift);
  const Cone cone{overlap, friction};
  const int end = trial.count - 1;
  int stuck = end - 1;  // the last spring before the slide at the rim, −1 when all slide
  while (stuck >= 0 && cone.slides(trial[stuck])) --stuck;
  const bool rim_slides = stuck < end - 1 || cone.slides(trial[end]);

  Polyline line;
  for (int i = 0; i <= stuck; ++i) line.add(cone.projected(trial[i]));
  int first_new = stuck;
  if (rim_slides) {
    if (stuck >= 0) line.add(cone.crossing(trial[stuck], trial[stuck + 1]));
    const Layer foot = stuck >= 0 ? line[line.count - 1] : trial[0];
    first_new = line.count - 1;
    for (int i = stuck + 1; i < end; ++i) line.add(cone.projected(trial[i]));
    // Where the slide turns, the outer springs turn first: the outermost piece is halved until it is an eighth.
    const Layer inner = line[std::max(line.count - 1, 0)], outer = trial[end - 1];
    const double turn = std::fabs(foot.x * shift.y - foot.y * shift.x), sliding = friction * overlap;
    if (turn > straight * sliding * sliding && overlap - inner.depth > 0.125 * (overlap - foot.depth) &&
        line.count <= layers) {
      const double share = (0.5 * (inner.depth + overlap) - outer.depth) / (overlap - outer.depth);
      line.add(cone.projected(between(outer, trial[end], share)));
    }
  }
  line.add({overlap, 0.0, 0.0});

  // Points on a straight line, or on top of each other, say nothing.
  const double rounding = straight * friction * overlap, nearest = 1e-15 * overlap;
  for (int i = std::max(first_new, 1); i + 1 < line.count;) {
    const Layer& a = line[i - 1];
    const Layer& b = line[i + 1];
    const double stretch = b.depth - a.depth;
    const Layer chord = stretch > 0.0 ? between(a, b, (line[i].depth - a.depth) / stretch) : a;
    const bool idle = std::fabs(chord.x - line[i].x) <= rounding && std::fabs(chord.y - line[i].y) <= rounding;
    if (idle || line[i].depth - a.depth <= nearest || b.depth - line[i].depth <= nearest)
      line.erase(i);
    else
      ++i;
  }
  while (line.count - 1 > layers) forget_one(line);

  springs.overlap = overlap;
  springs.count = line.count - 1;
  std::copy(line.at.begin(), line.at.begin() + line.count - 1, springs.at.begin());
}

Planar traction(const Springs& springs) {
  // ∫ F' (−s') dη; on a straight piece (q_2³ − q_1³)/(q_2² − q_1²) of q = √η is the mean of F'/k.
  Planar sum{0.0, 0.0};
  double root = 0.0;
  for (std::int64_t i = 0; i < springs.count; ++i) {
    const Layer& a = springs.at[static_cast<std::size_t>(i)];
    const Layer b = i + 1 < springs.count ? springs.at[static_cast<std::size_t>(i + 1)]
                                          : Layer{.depth = springs.overlap, .x = 0.0, .y = 0.0};
    const double next = std::sqrt(b.depth);
    const double mean = next + root * root / (root + next);
    sum.x += mean * (a.x - b.x);
    sum.y += mean * (a.y - b.y);
    root = next;
  }
  return sum;
}

double stored_energy(const Springs& springs, double coefficient, const Axes& compliance_ratio) {
  Polyline line;
  for (int i = 0; i < springs.count; ++i) line.add(springs.at[static_cast<std::size_t>(i)]);
  line.add({springs.overlap, 0.0, 0.0});
  const Planar sum = squared(line);  // F'' = 3/4 k η^{−1/2}
  return 0.375 * coefficient * (compliance_ratio.major * sum.x + compliance_ratio.minor * sum.y);
}

Law law(double coefficient, const Axes& compliance_ratio, double friction) {
  const auto require = [](const char* name, double value, bool good) {
    if (!good || !std::isfinite(value))
      throw InputError("mindlin::law", std::string(name) + " " + std::to_string(value), "a positive, finite value");
  };
  require("Hertz coefficient", coefficient, coefficient > 0.0);
  require("compliance ratio of the major axis", compliance_ratio.major, compliance_ratio.major > 0.0);
  require("compliance ratio of the minor axis", compliance_ratio.minor, compliance_ratio.minor > 0.0);
  if (!(friction >= 0.0) || !std::isfinite(friction))
    throw InputError("mindlin::law", "friction coefficient " + std::to_string(friction), "a finite value >= 0");
  return {.coefficient = coefficient, .compliance_ratio = compliance_ratio, .friction = friction};
}

Vec3 advance(Memory& memory, const Law& law, const Step& step) {
  const Vec3 normal = step.normal;
  const Vec3 major = (step.major_axis - step.major_axis.dot(normal) * normal).normalized();
  const Vec3 minor = normal.cross(major);
  Vec3 axis = major;
  if (memory.springs.count > 0) {
    // The turn that takes the old normal to the new one by the shortest way, applied to the old axis.
    const Vec3 before(memory.normal[0], memory.normal[1], memory.normal[2]);
    const Vec3 old_axis(memory.axis[0], memory.axis[1], memory.axis[2]);
    const Vec3 sum = before + normal;
    const Vec3 carried = old_axis - sum * (old_axis.dot(normal) / std::fmax(0.5 * sum.squaredNorm(), 1e-30));
    const Vec3 turned = std::cos(step.spin) * carried + std::sin(step.spin) * normal.cross(carried);
    axis = (turned - turned.dot(normal) * normal).normalized();
  }
  const Vec3 across = normal.cross(axis);
  // Into the ellipse's axes to divide by κ, and back.
  const double along_major = step.displacement.dot(major) / law.compliance_ratio.major;
  const double along_minor = step.displacement.dot(minor) / law.compliance_ratio.minor;
  const Vec3 shift = along_major * major + along_minor * minor;
  advance(memory.springs, step.overlap, {shift.dot(axis), shift.dot(across)}, law.friction);
  memory.normal = {normal.x(), normal.y(), normal.z()};
  memory.axis = {axis.x(), axis.y(), axis.z()};
  const Planar force = traction(memory.springs);
  return law.coefficient * (force.x * axis + force.y * across);
}

double spin_of(const Quat& rotation, const Vec3& normal) {
  return 2.0 * std::atan2(rotation.vec().dot(normal), rotation.w());
}

}  // namespace osculate::mindlin
