#include "osculate/dynamics/rigid_rotation.hpp"

#include <gsl/gsl_sf_elljac.h>

#include <catch2/catch.hpp>
#include <cmath>

using namespace osculate;

namespace {

const Vec3 inertia(1.0, 2.0, 3.5);  // I1 < I2 < I3
const Vec3 start_velocity(0.4, 0.1, 1.3);

double energy_of(const Vec3& momentum) {
  return 0.5 * momentum.dot(momentum.cwiseQuotient(inertia));
}

/// Euler's solution of the torque-free body that starts with ω_2 = 0, for L² > 2 T I2:                 [LL76 §37]
///   ω1 = A1 cn(τ|m), ω2 = A2 sn(τ|m), ω3 = A3 dn(τ|m).
Vec3 exact_velocity(double energy, double momentum_squared, double t) {
  const double I1 = inertia[0], I2 = inertia[1], I3 = inertia[2], E2 = 2.0 * energy, M2 = momentum_squared;
  const double A1 = std::sqrt((E2 * I3 - M2) / (I1 * (I3 - I1))), A2 = std::sqrt((E2 * I3 - M2) / (I2 * (I3 - I2)));
  const double A3 = std::sqrt((M2 - E2 * I1) / (I3 * (I3 - I1)));
  const double rate = std::sqrt((I3 - I2) * (M2 - E2 * I1) / (I1 * I2 * I3));
  const double m = (I2 - I1) * (E2 * I3 - M2) / ((I3 - I2) * (M2 - E2 * I1));
  double sn = 0.0, cn = 0.0, dn = 0.0;
  REQUIRE(gsl_sf_elljac_e(rate * t, m, &sn, &cn, &dn) == 0);
  return {A1 * cn, A2 * sn, A3 * dn};
}

Spin started() {
  return {.orientation = Quat::Identity(),
          .momentum = inertia.cwiseProduct(Vec3(start_velocity[0], 0.0, start_velocity[2]))};
}

double error_after(double time, int steps) {
  Spin spin = started();
  const double energy = energy_of(spin.momentum), squared = spin.momentum.squaredNorm();
  for (int i = 0; i < steps; ++i) spin = rotate_free(spin, inertia, time / steps).spin;
  return (spin.momentum.cwiseQuotient(inertia) - exact_velocity(energy, squared, time)).norm();
}

}  // namespace

TEST_CASE("The angular velocity of a free triaxial body follows Jacobi's functions to second order") {
  const double coarse = error_after(20.0, 2000), fine = error_after(20.0, 4000), finest = error_after(20.0, 8000);
  CHECK(finest < 1e-4);
  CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.05));
  CHECK(std::log2(fine / finest) == Approx(2.0).margin(0.05));
}

TEST_CASE("The orientation of a free body keeps the angular momentum fixed in space and converges to second order") {
  const auto orientation_after = [](int steps) {
    Spin spin{.orientation = Quat(0.5, 0.5, -0.5, 0.5), .momentum = inertia.cwiseProduct(start_velocity)};
    const Vec3 world = spin.orientation * spin.momentum;
    for (int i = 0; i < steps; ++i) spin = rotate_free(spin, inertia, 20.0 / steps).spin;
    CHECK((spin.orientation * spin.momentum - world).norm() < 1e-13 * std::sqrt(steps) * world.norm());
    return spin.orientation;
  };
  const Quat reference = orientation_after(64000);
  const double coarse = orientation_after(2000).angularDistance(reference),
               fine = orientation_after(4000).angularDistance(reference);
  CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.05));
}

TEST_CASE("A step of free rotation and one back lead to where it began") {
  const Spin spin{.orientation = Quat(0.1, 0.7, -0.5, 0.5).normalized(), .momentum = {0.3, -1.0, 0.7}};
  const Spin there = rotate_free(spin, inertia, 0.1).spin;
  const Spin back = rotate_free(there, inertia, -0.1).spin;
  CHECK(back.orientation.angularDistance(spin.orientation) < 1e-15);
  CHECK((back.momentum - spin.momentum).norm() < 1e-15);
}

TEST_CASE("The mean velocity of a step turns the body as the step did") {
  const Spin spin{.orientation = Quat(0.1, 0.7, -0.5, 0.5).normalized(), .momentum = {0.3, -1.0, 0.7}};
  const double dt = 1e-3;
  const Turn turn = rotate_free(spin, inertia, dt);
  const double angle = dt * turn.mean_velocity.norm();
  const Quat turned = Quat(Eigen::AngleAxisd(angle, turn.mean_velocity.normalized())) * spin.orientation;
  // 2 tan(φ/2) stands for φ.
  CHECK(turned.angularDistance(turn.spin.orientation) < angle * angle * angle / 6.0);
}

TEST_CASE("Energy and momentum of a free body do not drift in 1e7 steps", "[.long]") {
  Spin spin = started();
  const double energy = energy_of(spin.momentum), momentum = spin.momentum.norm();
  const double dt = 0.02;
  double largest = 0.0, late = 0.0;
  constexpr int steps = 10'000'000;
  for (int i = 0; i < steps; ++i) {
    spin = rotate_free(spin, inertia, dt).spin;
    const double error = std::fabs(energy_of(spin.momentum) / energy - 1.0);
    double& most = i < steps / 10 ? largest : late;
    most = std::max(most, error);
  }
  CHECK(largest < 1e-4);
  CHECK(late < 1.01 * largest);
  CHECK(spin.momentum.norm() == Approx(momentum).epsilon(1e-9));  // five roundings a step, all in one direction
}
