#include "osculate/dynamics/motion.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

void require(bool sound, const std::string& where, const std::string& found, const std::string& expected) {
  if (!sound) throw InputError(where, found, expected);
}

void check(const Fixed&) {}

void check(const Translation& motion) {
  require(motion.velocity.allFinite(), "translation", "a velocity that is not finite", "three finite numbers");
  require(std::isfinite(motion.begin) && motion.end >= motion.begin, "translation",
          "a time from " + std::to_string(motion.begin) + " s to " + std::to_string(motion.end) + " s",
          "an end not before a finite beginning");
}

void check(const Rotation& motion) {
  constexpr double tolerance = 1e-9;
  require(motion.point.allFinite() && std::isfinite(motion.rate), "rotation", "a point or rate that is not finite",
          "finite numbers");
  require(std::fabs(motion.axis.norm() - 1.0) <= tolerance, "rotation",
          "an axis of length " + std::to_string(motion.axis.norm()), "a unit vector");
}

void check(const Oscillation& motion) {
  require(motion.amplitude.allFinite() && std::isfinite(motion.phase), "oscillation",
          "an amplitude or phase that is not finite", "finite numbers");
  require(motion.frequency >= 0.0 && std::isfinite(motion.frequency), "oscillation",
          "a frequency of " + std::to_string(motion.frequency) + " Hz", "a finite value >= 0");
}

void check(const Path& motion) {
  require(!motion.times.empty() && motion.times.size() == motion.displacements.size(), "path",
          std::to_string(motion.times.size()) + " times and " + std::to_string(motion.displacements.size()) +
              " displacements",
          "as many of both, one at least");
  for (std::size_t i = 0; i < motion.times.size(); ++i) {
    require(std::isfinite(motion.times[i]) && motion.displacements[i].allFinite(), "path, entry " + std::to_string(i),
            "a number that is not finite", "finite numbers");
    require(i == 0 || motion.times[i] > motion.times[i - 1], "path, entry " + std::to_string(i),
            "time " + std::to_string(motion.times[i]) + " s", "a time after the entry before");
  }
}

Moving moved(const Pose& start, const Vec3& displacement, const Vec3& velocity) {
  return {.pose = {.position = start.position + displacement, .orientation = start.orientation},
          .velocity = velocity,
          .angular_velocity = Vec3::Zero()};
}

Moving place(const Fixed&, const Pose& start, double) {
  return moved(start, Vec3::Zero(), Vec3::Zero());
}

Moving place(const Translation& motion, const Pose& start, double t) {
  const double elapsed = std::clamp(t, motion.begin, motion.end) - motion.begin;
  const bool on_the_way = t >= motion.begin && t < motion.end;
  return moved(start, elapsed * motion.velocity, on_the_way ? motion.velocity : Vec3::Zero());
}

Moving place(const Rotation& motion, const Pose& start, double t) {
  const Quat turn(Eigen::AngleAxisd(motion.rate * t, motion.axis));
  const Vec3 arm = turn * (start.position - motion.point);
  const Vec3 angular_velocity = motion.rate * motion.axis;
  return {.pose = {.position = motion.point + arm, .orientation = (turn * start.orientation).normalized()},
          .velocity = angular_velocity.cross(arm),
          .angular_velocity = angular_velocity};
}

Moving place(const Oscillation& motion, const Pose& start, double t) {
  const double rate = 2.0 * std::numbers::pi * motion.frequency, angle = rate * t + motion.phase;
  return moved(start, (std::sin(angle) - std::sin(motion.phase)) * motion.amplitude,
               rate * std::cos(angle) * motion.amplitude);
}

Moving place(const Path& motion, const Pose& start, double t) {
  const auto after = std::upper_bound(motion.times.begin(), motion.times.end(), t);
  if (after == motion.times.begin()) return moved(start, motion.displacements.front(), Vec3::Zero());
  if (after == motion.times.end()) return moved(start, motion.displacements.back(), Vec3::Zero());
  const auto next = static_cast<std::size_t>(std::distance(motion.times.begin(), after));
  const Vec3 way = motion.displacements[next] - motion.displacements[next - 1];
  const double span = motion.times[next] - motion.times[next - 1];
  return moved(start, motion.displacements[next - 1] + (t - motion.times[next - 1]) / span * way, way / span);
}

}  // namespace

void validate(const Motion& motion) {
  std::visit([](const auto& one) { check(one); }, motion);
}

Moving at_time(const Motion& motion, const Pose& start, double t) {
  return std::visit([&](const auto& one) { return place(one, start, t); }, motion);
}

}  // namespace osculate
