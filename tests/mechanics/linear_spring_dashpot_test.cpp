#include "osculate/mechanics/linear_spring_dashpot.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "mechanics/collision.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;
namespace lsd = osculate::linear_spring_dashpot;

TEST_CASE("A linear spring and dashpot collide as their closed forms say, with and without attraction") {
  const double mass = 0.02, k = 3e5;
  for (const double ratio : {0.0, 0.01, 0.3, 0.9, 0.999999, 1.0, 1.7, 6.0}) {
    const lsd::Model model{.stiffness = k, .damping = 2.0 * ratio * std::sqrt(k * mass)};
    for (const Attraction attraction : {Attraction::allowed, Attraction::cut_off}) {
      if (attraction == Attraction::allowed && ratio >= 0.9) continue;
      CAPTURE(ratio, attraction == Attraction::cut_off);
      const Impact closed = lsd::impact(model, mass, 0.7, attraction);
      const auto raw = [&](double d, double rate) { return k * d + model.damping * rate; };
      const Impact integrated = collide(raw, mass, 0.7, closed.duration, [&](double d, double rate) {
        return attraction == Attraction::allowed ? d < 0 : rate < 0 && raw(d, rate) < 0;
      });
      REQUIRE(closed.duration == Approx(integrated.duration).epsilon(1e-8));
      REQUIRE(closed.restitution == Approx(integrated.restitution).epsilon(1e-8));
      REQUIRE(closed.largest_overlap == Approx(integrated.largest_overlap).epsilon(1e-8));
    }
  }
  REQUIRE(lsd::impact({k, 2.0 * std::sqrt(k * mass)}, mass, 1.0, Attraction::allowed).restitution == 0.0);
}

TEST_CASE("The damping ratio for a restitution gives that restitution") {
  for (const double restitution : {1.0, 1.0 - 1e-9, 0.97, 0.5, 0.135, 0.01, 1e-4})
    for (const Attraction attraction : {Attraction::allowed, Attraction::cut_off}) {
      const double ratio = lsd::damping_ratio_for(restitution, attraction);
      const lsd::Model model{.stiffness = 1.0, .damping = 2.0 * ratio};
      REQUIRE(lsd::impact(model, 1.0, 1.0, attraction).restitution == Approx(restitution).epsilon(1e-12));
    }
}

TEST_CASE("A matched spring shares duration, overlap or energy with Hertz") {
  const ImpactPair pair = glass_spheres();
  const double speed = 0.8, restitution = 0.6;
  const Impact hertz = hertz_impact::impact(pair, speed);
  for (const Attraction attraction : {Attraction::allowed, Attraction::cut_off}) {
    const auto impact = [&](lsd::Matching matching) {
      return lsd::impact(lsd::matched(pair, speed, restitution, matching, attraction), pair.mass, speed, attraction);
    };
    REQUIRE(impact(lsd::Matching::duration).duration == Approx(hertz.duration).epsilon(1e-12));
    REQUIRE(impact(lsd::Matching::largest_overlap).largest_overlap == Approx(hertz.largest_overlap).epsilon(1e-12));
    REQUIRE(impact(lsd::Matching::strain_energy).restitution == Approx(restitution).epsilon(1e-12));
    const double k = lsd::matched(pair, speed, restitution, lsd::Matching::strain_energy, attraction).stiffness;
    REQUIRE(0.5 * k * hertz.largest_overlap * hertz.largest_overlap ==
            Approx(0.5 * pair.mass * speed * speed).epsilon(1e-12));
  }
}

TEST_CASE("Without attraction the dashpot never pulls") {
  const lsd::Model model{.stiffness = 10.0, .damping = 5.0};
  REQUIRE(lsd::force(model, 0.1, -1.0, Attraction::cut_off) == 0.0);
  REQUIRE(lsd::force(model, 0.1, -1.0, Attraction::allowed) == Approx(-4.0).epsilon(1e-15));
  REQUIRE(lsd::force(model, 0.1, 1.0, Attraction::cut_off) == Approx(6.0).epsilon(1e-15));
  REQUIRE(lsd::force(model, -0.1, 1.0, Attraction::allowed) == 0.0);
}

TEST_CASE("Springs and restitutions that make no sense are refused") {
  const double nan = std::nan("");
  for (const lsd::Model& model :
       {lsd::Model{0.0, 1.0}, lsd::Model{-1.0, 1.0}, lsd::Model{nan, 1.0}, lsd::Model{1.0, -1.0}, lsd::Model{1.0, nan}})
    REQUIRE_THROWS_AS(lsd::validate(model), InputError);
  for (const double restitution : {0.0, -0.5, 1.01, nan})
    REQUIRE_THROWS_AS(lsd::damping_ratio_for(restitution, Attraction::cut_off), InputError);
}
