#include "osculate/dynamics/motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "osculate/core/error.hpp"

using namespace osculate;

namespace {

/// Velocities are the derivatives of the poses.
void check_velocities(const Motion& motion, const Pose& start, double t) {
  constexpr double h = 1e-6;
  const Moving before = at_time(motion, start, t - h), now = at_time(motion, start, t),
               after = at_time(motion, start, t + h);
  CHECK(((after.pose.position - before.pose.position) / (2.0 * h) - now.velocity).norm() <
        1e-6 * (1.0 + now.velocity.norm()));
  const Quat turn = after.pose.orientation * before.pose.orientation.conjugate();
  CHECK((turn.vec() / turn.w() / h - now.angular_velocity).norm() < 1e-6 * (1.0 + now.angular_velocity.norm()));
}

}  // namespace

TEST_CASE("A prescribed motion begins where the body is and moves as fast as it says") {
  const Pose start{.position = {0.3, -0.1, 0.2}, .orientation = Quat(0.5, -0.5, 0.5, 0.5)};
  const Motion motions[] = {
      Fixed{}, Translation{.velocity = {0.1, 0.2, -0.3}, .begin = 0.0, .end = std::numeric_limits<double>::infinity()},
      Rotation{.point = {0.1, 0, 0}, .axis = Vec3(1, 2, -1).normalized(), .rate = 3.0},
      Oscillation{.amplitude = {0.0, 0.1, 0.05}, .frequency = 2.0, .phase = 0.7},
      Path{.times = {0.0, 0.4, 1.0}, .displacements = {Vec3::Zero(), {0, 0, 1}, {0, 1, 1}}}};
  for (const Motion& motion : motions) {
    validate(motion);
    const Moving moving = at_time(motion, start, 0.0);
    CHECK((moving.pose.position - start.position).norm() < 1e-15);
    CHECK(moving.pose.orientation.angularDistance(start.orientation) < 1e-15);
    for (const double t : {0.1, 0.7, 0.9}) check_velocities(motion, start, t);
  }
}

TEST_CASE("A translation and a path rest before and after") {
  const Pose start;
  const Translation lift{.velocity = {0, 0, 2}, .begin = 1.0, .end = 1.5};
  CHECK(at_time(lift, start, 0.5).pose.position.z() == 0.0);
  CHECK(at_time(lift, start, 0.5).velocity.norm() == 0.0);
  CHECK(at_time(lift, start, 1.25).pose.position.z() == Approx(0.5));
  CHECK(at_time(lift, start, 9.0).pose.position.z() == Approx(1.0));
  CHECK(at_time(lift, start, 9.0).velocity.norm() == 0.0);
}

TEST_CASE("Motions that make no sense are refused") {
  CHECK_THROWS_AS(validate(Motion(Rotation{.point = Vec3::Zero(), .axis = {1, 1, 0}, .rate = 1.0})), InputError);
  CHECK_THROWS_AS(validate(Motion(Translation{.velocity = Vec3::Zero(), .begin = 2.0, .end = 1.0})), InputError);
  CHECK_THROWS_AS(validate(Motion(Path{.times = {0.0, 0.0}, .displacements = {Vec3::Zero(), Vec3::Zero()}})),
                  InputError);
  CHECK_THROWS_AS(validate(Motion(Oscillation{.amplitude = {0, 0, std::nan("")}, .frequency = 1.0})), InputError);
}
