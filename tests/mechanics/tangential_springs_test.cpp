#include "osculate/mechanics/tangential_springs.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <type_traits>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/hertzian_tangential.hpp"
#include "osculate/mechanics/material.hpp"

using osculate::TangentVector;
namespace ts = osculate::tangential_springs;

TEST_CASE("Sliding opposes the motion with the friction force, and nothing at rest") {
  const TangentVector force = ts::sliding(0.4, 10.0, {3.0, -4.0});
  REQUIRE(force.x == Approx(-2.4).epsilon(1e-15));
  REQUIRE(force.y == Approx(3.2).epsilon(1e-15));
  REQUIRE(norm(ts::sliding(0.4, 10.0, {0.0, 0.0})) == 0.0);
  REQUIRE(norm(ts::viscous_sliding(1e9, 0.4, 10.0, {3.0, -4.0})) == Approx(4.0).epsilon(1e-15));
  REQUIRE(ts::viscous_sliding(0.1, 0.4, 10.0, {3.0, -4.0}).x == Approx(-0.3).epsilon(1e-15));
}

TEST_CASE("A mass on a tangential spring and dashpot swings as a damped oscillator until it slides") {
  // x = x0' /ω_d e^{−ζωt} sin ω_d t, integrated here with the model's own steps (velocity Verlet, error ~ (ω dt)²/24).
  const double mass = 0.3, k = 2e3, speed = 0.2, ratio = 0.05, omega = std::sqrt(k / mass);
  const ts::Model model{.stiffness = k, .damping = 2 * ratio * mass * omega, .friction = 1.0};
  ts::Memory memory;
  const double step = 1e-4 / omega, end = 5.0 / omega, damped = omega * std::sqrt(1 - ratio * ratio);
  double x = 0.0, v = speed, f = -model.damping * v;
  for (double t = 0.0; t < end - 0.5 * step; t += step) {
    const double half = v + 0.5 * step * f / mass;
    x += step * half;
    // The dashpot sees the velocity at the step's end, which depends on its force.
    const ts::Memory before = memory;
    for (int round = 0; round < 4; ++round) {
      memory = before;
      f = ts::force(model, 1e9, {step * half, 0.0}, {v, 0.0}, memory).x;
      v = half + 0.5 * step * f / mass;
    }
  }
  REQUIRE(x == Approx(speed / damped * std::exp(-ratio * omega * end) * std::sin(damped * end)).epsilon(1e-6));
}

TEST_CASE("A spring with a slider never exceeds friction and never creates energy") {
  const ts::Model model{.stiffness = 1e4, .damping = 0.0, .friction = 0.5};
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  ts::Memory memory;
  double work = 0.0;
  TangentVector before;
  for (int i = 0; i < 20000; ++i) {
    const TangentVector step{1e-4 * normal(random), 1e-4 * normal(random)};
    const double normal_force = 3.0 + std::sin(0.01 * i);
    const TangentVector force = ts::force(model, normal_force, step, {}, memory);
    REQUIRE(norm(force) <= 0.5 * normal_force * (1 + 1e-15));
    // Without slip the mean of the forces is exact; in sliding the force at the end bounds what the slider took.
    work += norm(step) > 0 ? -dot(0.5 * (before + force), step) : 0.0;
    const double stored = 0.5 * model.stiffness * dot(memory.stretch, memory.stretch);
    REQUIRE(work - stored > -1e-12);
    before = force;
  }
  REQUIRE(work > 0.1);
  STATIC_REQUIRE(std::is_trivially_copyable_v<ts::Memory>);
}

TEST_CASE("Stiffness ratio and tangential damping are those of like spheres") {
  const osculate::ElasticMaterial glass{71e9, 0.22};
  const double ratio = ts::stiffness_ratio(effective_modulus(glass, glass), effective_shear_modulus(glass, glass));
  REQUIRE(ratio == Approx(2.0 * (1.0 - 0.22) / (2.0 - 0.22)).epsilon(1e-14));
  // A mass of 2/7 m on k_t turns back with ε_t after half a period.
  const double c = ts::damping_for_restitution(5e4, 0.7, 0.3), mass = 0.2, zeta = 0.5 * c / std::sqrt(5e4 * mass);
  REQUIRE(std::exp(-M_PI * zeta / std::sqrt(1 - zeta * zeta)) == Approx(0.3).epsilon(1e-13));
}

TEST_CASE("Tangential springs that make no sense are refused") {
  const double nan = std::nan("");
  for (const ts::Model& model : {ts::Model{0.0, 0.0, 0.5}, ts::Model{-1.0, 0.0, 0.5}, ts::Model{nan, 0.0, 0.5},
                                 ts::Model{1.0, -1.0, 0.5}, ts::Model{1.0, 0.0, -0.5}, ts::Model{1.0, 0.0, nan}})
    REQUIRE_THROWS_AS(ts::validate(model), osculate::InputError);
  REQUIRE_THROWS_AS(ts::damping_for_restitution(1.0, 1.0, 0.0), osculate::InputError);
  REQUIRE_THROWS_AS(ts::stiffness_ratio(0.0, 1.0), osculate::InputError);
}
