#include "osculate/mechanics/damped_hertz.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "mechanics/collision.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;
namespace dh = osculate::damped_hertz;

namespace {

Impact integrated(const dh::Model& model, double mass, double speed, Attraction attraction, double duration) {
  const auto raw = [&](double d, double rate) {
    return dh::force(model, std::fmax(d, 0.0), rate, Attraction::allowed);
  };
  return collide(raw, mass, speed, duration, [&](double d, double rate) {
    return attraction == Attraction::allowed ? d <= 0 : rate < 0 && (d <= 0 || raw(d, rate) < 0);
  });
}

}  // namespace

TEST_CASE("Tsuji's dashpot has its restitution at any speed") {
  const ImpactPair pair = glass_spheres();
  for (const Attraction attraction : {Attraction::allowed, Attraction::cut_off})
    for (const double restitution : {0.99, 0.8, 0.4, 0.1})
      for (const double speed : {0.01, 3.0}) {
        if (attraction == Attraction::allowed && restitution < 0.4) continue;  // creeps to its end
        CAPTURE(restitution, speed, attraction == Attraction::cut_off);
        const dh::Model model = dh::tsuji(pair, restitution, attraction);
        const Impact closed = dh::impact(model, pair.mass, speed, attraction);
        const Impact witness = integrated(model, pair.mass, speed, attraction, closed.duration);
        REQUIRE(closed.restitution == Approx(restitution).epsilon(1e-12));
        // The dashpot δ^{1/4} δ̇ starts like t^{1/4}: the witness loses some digits there.
        REQUIRE(witness.restitution == Approx(restitution).epsilon(1e-6));
        REQUIRE(closed.duration == Approx(witness.duration).epsilon(1e-6));
        REQUIRE(closed.largest_overlap == Approx(witness.largest_overlap).epsilon(1e-6));
      }
}

TEST_CASE("Undamped, both kinds are Hertz") {
  const ImpactPair pair = glass_spheres();
  const Impact hertz = hertz_impact::impact(pair, 2.0);
  for (const dh::Model& model : {dh::tsuji(pair, 1.0, Attraction::allowed), dh::kuwabara_kono(pair, 0.0)})
    for (const Attraction attraction : {Attraction::allowed, Attraction::cut_off}) {
      const Impact impact = dh::impact(model, pair.mass, 2.0, attraction);
      REQUIRE(impact.duration == Approx(hertz.duration).epsilon(1e-9));
      REQUIRE(impact.largest_overlap == Approx(hertz.largest_overlap).epsilon(1e-10));
      REQUIRE(impact.restitution == Approx(1.0).epsilon(1e-10));
    }
}

TEST_CASE("A viscoelastic impact is what its equation of motion says") {
  const ImpactPair pair = glass_spheres();
  for (const double dissipative_time : {1e-9, 1e-7, 1e-6, 5e-6})
    for (const Attraction attraction : {Attraction::allowed, Attraction::cut_off}) {
      CAPTURE(dissipative_time, attraction == Attraction::cut_off);
      const dh::Model model = dh::brilliantov(pair, dissipative_time);
      const Impact closed = dh::impact(model, pair.mass, 1.0, attraction);
      const Impact witness = integrated(model, pair.mass, 1.0, attraction, closed.duration);
      REQUIRE(closed.restitution == Approx(witness.restitution).epsilon(1e-6));
      REQUIRE(closed.duration == Approx(witness.duration).epsilon(1e-6));
      REQUIRE(closed.largest_overlap == Approx(witness.largest_overlap).epsilon(1e-6));
    }
}

TEST_CASE("The viscoelastic loss grows as the fifth root of the speed, by the constant of the literature") {
  const ImpactPair pair = glass_spheres();
  const dh::Model model = dh::brilliantov(pair, 1e-10);
  for (const double speed : {0.01, 1.0, 30.0}) {
    const double loss = 1.0 - dh::impact(model, pair.mass, speed, Attraction::allowed).restitution;
    const double first = dh::viscoelastic_loss_first_order(model, pair.mass, speed);
    // The second term is 3/5 of the first squared.
    REQUIRE(loss == Approx(first).epsilon(1e-3));
    REQUIRE(loss == Approx(first - 0.6 * first * first).epsilon(1e-6));
  }
  const ImpactPair unit{.mass = 1.0, .radius = 1.0, .modulus = 0.75};  // k_H = 1
  REQUIRE(dh::viscoelastic_loss_first_order(dh::kuwabara_kono(unit, 1.0), 1.0, 1.0) == Approx(1.15344).epsilon(1e-5));
}

TEST_CASE("A viscoelastic model made for a restitution has it at that speed") {
  const ImpactPair pair = glass_spheres();
  for (const double restitution : {1.0, 0.97, 0.5, 0.2})
    for (const Attraction attraction : {Attraction::allowed, Attraction::cut_off}) {
      const dh::Model model = dh::viscoelastic_with(pair, 0.5, restitution, attraction);
      REQUIRE(dh::impact(model, pair.mass, 0.5, attraction).restitution == Approx(restitution).epsilon(1e-9));
    }
  REQUIRE(dh::impact(dh::viscoelastic_with(pair, 0.5, 0.8, Attraction::cut_off), pair.mass, 5.0, Attraction::cut_off)
              .restitution < 0.8);
}

TEST_CASE("Without attraction the damped Hertz force never pulls") {
  const dh::Model model = dh::kuwabara_kono(glass_spheres(), 1e9);
  REQUIRE(dh::force(model, 1e-6, -1.0, Attraction::cut_off) == 0.0);
  REQUIRE(dh::force(model, 1e-6, -1.0, Attraction::allowed) < 0.0);
  REQUIRE(dh::force(model, 0.0, 1.0, Attraction::allowed) == 0.0);
}

TEST_CASE("Damped Hertz refuses numbers that make no sense") {
  const ImpactPair pair = glass_spheres();
  const double nan = std::nan("");
  for (const double restitution : {0.0, 1.5, nan}) {
    REQUIRE_THROWS_AS(dh::tsuji(pair, restitution, Attraction::cut_off), InputError);
    REQUIRE_THROWS_AS(dh::viscoelastic_with(pair, 1.0, restitution, Attraction::cut_off), InputError);
  }
  REQUIRE_THROWS_AS(dh::kuwabara_kono(pair, -1.0), InputError);
  REQUIRE_THROWS_AS(dh::brilliantov(pair, nan), InputError);
  REQUIRE_THROWS_AS(dh::brilliantov({0.0, 1.0, 1.0}, 1e-6), InputError);
  REQUIRE_THROWS_AS(dh::impact(dh::brilliantov(pair, 1e-8), pair.mass, 0.0, Attraction::allowed), InputError);
}
