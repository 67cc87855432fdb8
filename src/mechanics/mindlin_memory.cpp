#include "osculate/mechanics/mindlin_memory.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>

#include "mechanics/mindlin_memory-inl.hpp"
#include "osculate/core/error.hpp"

namespace osculate::mindlin {
namespace {

static_assert(std::is_trivially_copyable_v<Memory>);

using Line = HWY_NAMESPACE::SpringsOf<double>;
using Vector = HWY_NAMESPACE::V3<double>;

Line line_of(const Springs& springs) {
  Line line;
  line.rim_root = std::sqrt(springs.overlap);
  line.count = static_cast<double>(springs.count);
  line.most = static_cast<int>(springs.count);
  for (int i = 0; i < line.most; ++i) {
    const Layer& layer = springs.at[static_cast<std::size_t>(i)];
    line.at[i] = {std::sqrt(layer.depth), layer.x, layer.y};
  }
  line.at[line.most] = line.rim();
  return line;
}

/// The root of a square is the number itself: depths come back to the bit.
void keep(Springs& springs, const Line& line) {
  springs.count = line.most;
  for (int i = 0; i < line.most; ++i)
    springs.at[static_cast<std::size_t>(i)] = {line.at[i].depth(), line.at[i].x, line.at[i].y};
}

Vector vector(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Vector vector(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

void advance(Springs& springs, double overlap, Planar shift, double friction) {
  if (!(overlap > 0.0)) {
    springs.overlap = 0.0;
    springs.count = 0;
    return;
  }
  Line line = line_of(springs);
  if (line.most == 0) line.most = 1;  // just made: one spring at the centre
  HWY_NAMESPACE::advance<double>(line, overlap, {shift.x, shift.y}, friction);
  springs.overlap = overlap;
  keep(springs, line);
}

Planar traction(const Springs& springs) {
  const auto [x, y] = HWY_NAMESPACE::sums(line_of(springs)).traction;
  return {x, y};
}

double stored_energy(const Springs& springs, double coefficient, const Axes& compliance_ratio) {
  const auto [x, y] = HWY_NAMESPACE::sums(line_of(springs)).squared;  // F'' = 3/4 k η^{−1/2}
  return 0.375 * coefficient * (compliance_ratio.major * x + compliance_ratio.minor * y);
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

Springs carried(const Memory& memory, const Step& step) {
  Springs springs = memory.springs;
  if (springs.count == 0) return springs;
  Line line = line_of(springs);
  const Vec3 minor = step.normal.cross(step.major_axis);
  const auto turned =
      HWY_NAMESPACE::carried<double>(vector(memory.normal), vector(memory.axis), vector(step.normal),
                                     vector(step.major_axis), vector(minor), std::sin(step.spin), std::cos(step.spin));
  for (int i = 0; i < line.most; ++i) line.at[i] = turned(line.at[i]);
  keep(springs, line);
  return springs;
}

Vec3 advance(Memory& memory, const Law& law, const Step& step) {
  const Vec3 minor = step.normal.cross(step.major_axis);
  memory.springs = carried(memory, step);
  advance(memory.springs, step.overlap,
          {step.displacement.dot(step.major_axis) / law.compliance_ratio.major,
           step.displacement.dot(minor) / law.compliance_ratio.minor},
          law.friction);
  Vec3::Map(memory.normal.data()) = step.normal;
  Vec3::Map(memory.axis.data()) = step.major_axis;
  const Planar force = traction(memory.springs);
  return law.coefficient * (force.x * step.major_axis + force.y * minor);
}

double spin_of(const Quat& rotation, const Vec3& normal) {
  return 2.0 * std::atan2(rotation.vec().dot(normal), rotation.w());
}

}  // namespace osculate::mindlin
