#include "osculate/mechanics/impact.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mechanics/collision.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/hertz.hpp"
#include "osculate/mechanics/linear_spring_dashpot.hpp"

using namespace osculate;
namespace lsd = osculate::linear_spring_dashpot;

TEST_CASE("A Hertz impact is what its equation of motion says") {
  const ImpactPair pair = glass_spheres();
  const double k = pair.hertz_coefficient();
  const Impact closed = hertz_impact::impact(pair, 1.0);
  const Impact integrated = collide([&](double d, double) { return d > 0 ? k * d * std::sqrt(d) : 0.0; }, pair.mass,
                                    1.0, closed.duration, [](double d, double) { return d < 0; });
  REQUIRE(closed.duration == Approx(integrated.duration).epsilon(1e-8));
  REQUIRE(closed.largest_overlap == Approx(integrated.largest_overlap).epsilon(1e-8));
  REQUIRE(integrated.restitution == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("The Hertz duration's constant is 2.8683, between the printed 2.86 and 2.870") {
  // The digits of the closed form; the closed form itself stands against the integrated motion above.
  REQUIRE(hertz_impact::duration_constant() == Approx(2.868265699195).epsilon(1e-11));
  const ImpactPair pair = glass_spheres();
  const double scale = std::pow(pair.mass * pair.mass / (pair.modulus * pair.modulus * pair.radius * 1.0), 0.2);
  REQUIRE(hertz_impact::impact(pair, 1.0).duration == Approx(hertz_impact::duration_constant() * scale).epsilon(1e-14));
}

TEST_CASE("The lecture's glass spheres: overlap, duration, energy and the three stiffnesses") {
  const ImpactPair pair = glass_spheres();
  const Impact impact = hertz_impact::impact(pair, 1.0);
  // Printed: 0.2 % of the effective diameter, 9.51 µs, 10.5 µJ; with 3.18 mm as radius the energy would be 84 µJ.
  REQUIRE(impact.largest_overlap / (2.0 * pair.radius) == Approx(0.0020).margin(0.00005));
  REQUIRE(impact.duration == Approx(9.51e-6).margin(0.005e-6));
  REQUIRE(0.5 * pair.mass * 1.0 == Approx(10.5e-6).margin(0.05e-6));
  const auto stiffness = [&](lsd::Matching matching) {
    return lsd::matched(pair, 1.0, 0.97, matching, Attraction::allowed).stiffness;
  };
  REQUIRE(stiffness(lsd::Matching::largest_overlap) == Approx(1.96e6).margin(0.005e6));
  REQUIRE(stiffness(lsd::Matching::strain_energy) == Approx(2.02e6).margin(0.005e6));
  // Printed 2.29; the exact constant gives 2.297, the printed duration rounded down.
  REQUIRE(stiffness(lsd::Matching::duration) == Approx(2.29e6).margin(0.01e6));
}

TEST_CASE("An elliptical contact's effective radius gives its Hertz force") {
  const ContactEllipse ellipse = contact_ellipse(0.02, 0.003);
  const ImpactPair pair{.mass = 1.0, .radius = effective_radius(ellipse), .modulus = 5e9};
  const double overlap = 1e-5;
  REQUIRE(pair.hertz_coefficient() * std::pow(overlap, 1.5) ==
          Approx(hertz::force(ellipse, 5e9, overlap)).epsilon(1e-14));
  REQUIRE(effective_radius(contact_ellipse(0.01, 0.01)) == Approx(0.01).epsilon(1e-14));
}

TEST_CASE("A wall has no end of radius and mass") {
  const double infinity = std::numeric_limits<double>::infinity();
  const ImpactPair pair = sphere_pair(0.01, 2.0, infinity, infinity, 1e9);
  REQUIRE(pair.radius == Approx(0.01).epsilon(1e-15));
  REQUIRE(pair.mass == Approx(2.0).epsilon(1e-15));
  REQUIRE_THROWS_AS(sphere_pair(infinity, 2.0, infinity, infinity, 1e9), InputError);
  REQUIRE_THROWS_AS(sphere_pair(0.01, std::nan(""), 0.01, 1.0, 1e9), InputError);
  REQUIRE_THROWS_AS(sphere_pair(0.01, 1.0, 0.01, 1.0, 0.0), InputError);
  REQUIRE_THROWS_AS(hertz_impact::impact(pair, 0.0), InputError);
}
