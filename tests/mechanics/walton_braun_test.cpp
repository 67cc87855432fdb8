#include "osculate/mechanics/walton_braun.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <type_traits>

#include "mechanics/collision.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;
namespace wb = osculate::walton_braun;

TEST_CASE("A hysteretic spring collides as its closed forms say") {
  const double mass = 0.02, speed = 0.7;
  for (const wb::Model& model :
       {wb::constant_unloading(3e5, 0.7), wb::variable_unloading(3e5, 4e3), wb::constant_unloading(3e5, 1.0)}) {
    const Impact closed = wb::impact(model, mass, speed);
    // In two smooth parts, so that the witness need not step over the kink: the known turn splits them.
    const double largest = closed.largest_overlap;
    const auto force = [&](double d, double rate) {
      return rate > 0 ? model.loading * d
                      : model.loading * largest -
                            (model.unloading + model.hardening * model.loading * largest) * (largest - d);
    };
    const Impact witness = collide(force, mass, speed, closed.duration,
                                   [&](double d, double rate) { return rate < 0 && force(d, rate) < 0; });
    REQUIRE(closed.duration == Approx(witness.duration).epsilon(1e-6));
    REQUIRE(closed.restitution == Approx(witness.restitution).epsilon(1e-6));
    REQUIRE(closed.largest_overlap == Approx(witness.largest_overlap).epsilon(1e-6));
  }
}

TEST_CASE("Restitution is constant with a constant unloading stiffness and falls with speed with a variable one") {
  REQUIRE(wb::impact(wb::constant_unloading(1e5, 0.6), 1.0, 0.1).restitution == Approx(0.6).epsilon(1e-15));
  REQUIRE(wb::impact(wb::constant_unloading(1e5, 0.6), 1.0, 10.0).restitution == Approx(0.6).epsilon(1e-15));
  const wb::Model model = wb::variable_unloading(1e4, 50.0);
  for (const double speed : {0.1, 1.0, 10.0})
    REQUIRE(wb::impact(model, 1.0, speed).restitution ==
            Approx(1.0 / std::sqrt(1.0 + 50.0 * speed / 100.0)).epsilon(1e-14));
}

TEST_CASE("A hysteretic spring gives back no more than it took, along any path") {
  const wb::Model model = wb::variable_unloading(1e5, 2e3);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0.0, 1e-3);
  wb::Memory memory;
  double overlap = 0.0, work = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double next = uniform(random), before = wb::force(model, overlap, memory);
    // Piecewise linear: fine steps make the trapezoids nearly exact.
    constexpr int steps = 200;
    double force = before;
    for (int k = 1; k <= steps; ++k) {
      const double at = overlap + (next - overlap) * k / steps, here = wb::force(model, at, memory);
      work += 0.5 * (force + here) * (next - overlap) / steps;
      force = here;
    }
    overlap = next;
    const double unloading = model.unloading + model.hardening * model.loading * memory.largest_overlap;
    const double stored = 0.5 * force * force / unloading;
    REQUIRE(work - stored > -1e-9);  // of 0.05 J exchanged; kinks of the trapezoids
  }
  STATIC_REQUIRE(std::is_trivially_copyable_v<wb::Memory>);
  REQUIRE(wb::force(model, 0.99 * wb::residual_overlap(model, memory), memory) == 0.0);
}

TEST_CASE("Hysteretic springs that make no sense are refused") {
  const double nan = std::nan("");
  REQUIRE_THROWS_AS(wb::constant_unloading(0.0, 0.5), InputError);
  REQUIRE_THROWS_AS(wb::constant_unloading(1.0, 0.0), InputError);
  REQUIRE_THROWS_AS(wb::constant_unloading(1.0, nan), InputError);
  REQUIRE_THROWS_AS(wb::variable_unloading(1.0, -1.0), InputError);
  REQUIRE_THROWS_AS(wb::validate({.loading = 2.0, .unloading = 1.0}), InputError);
}
