#include "osculate/mechanics/twisting.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "mechanics/gsl_quadrature.hpp"
#include "mechanics/reference.hpp"
#include "osculate/core/error.hpp"

namespace twisting = osculate::twisting;
using osculate::ElasticMaterial;

namespace {

const ElasticMaterial glass{.youngs_modulus = 71e9, .poissons_ratio = 0.22};
const ElasticMaterial steel{.youngs_modulus = 210e9, .poissons_ratio = 0.29};

}  // namespace

TEST_CASE("Erratum (77): the torsional compliance holds G and a_c cubed, as the reference has it") {
  const double a_c = 0.7e-3;
  for (const auto& row : reference_rows("tangential")) {
    const double nu = row.at("nu");
    const ElasticMaterial material{.youngs_modulus = 5e9, .poissons_ratio = nu};
    const double unit = 3.0 / (8.0 * material.shear_modulus() * a_c * a_c * a_c);
    const double compliance = twisting::compliance(ellipse_of(row.at("e2")), a_c, material, material);
    CHECK(compliance / unit ==
          Approx(row.at("twist_compliance_times_8Ga3_over_3_two_identical").get<double>()).epsilon(1e-13));
  }
}

TEST_CASE("Different materials in torsion add their compliances") {
  const auto ellipse = ellipse_of(0.6);
  CHECK(2.0 * twisting::compliance(ellipse, 1e-3, glass, steel) ==
        Approx(twisting::compliance(ellipse, 1e-3, glass, glass) + twisting::compliance(ellipse, 1e-3, steel, steel))
            .epsilon(1e-15));
}

TEST_CASE("The limit of the moment is the integral of friction times radius over the ellipse") {
  const double a = 2e-3, force = 50.0, friction = 0.4;
  for (const double e2 : {0.0, 0.5, 0.99}) {
    const auto ellipse = ellipse_of(e2);
    const double b = a * ellipse.axis_ratio, peak = 1.5 * force / (M_PI * a * b);
    const double moment = quadrature(
        [&](double phi) {
          return quadrature(
              [&](double rho) {
                const double x = a * rho * std::cos(phi), y = b * rho * std::sin(phi);
                return friction * peak * std::sqrt(1.0 - rho * rho) * std::hypot(x, y) * a * b * rho;
              },
              0.0, 1.0);
        },
        0.0, 2.0 * M_PI, 1e-9);
    CHECK(twisting::limit(ellipse, a, friction, force) == Approx(moment).epsilon(1e-8));
  }
  CHECK(twisting::limit(ellipse_of(0.0), a, friction, force) ==
        Approx(3.0 * M_PI / 16.0 * friction * force * a).epsilon(1e-15));
}

TEST_CASE("A batch of twisted contacts has the stiffness and the limit of single ones") {
  const std::size_t size = 21;
  std::vector<double> a_c(size), ratio(size), stiffness(size), arm(size);
  for (std::size_t i = 0; i < size; ++i) a_c[i] = 1e-6 * static_cast<double>(i * i), ratio[i] = std::pow(0.7, i);
  twisting::contacts(glass, steel, {a_c, ratio}, {stiffness, arm});
  CHECK(stiffness[0] == 0.0);
  CHECK(arm[0] == 0.0);
  for (std::size_t i = 1; i < size; ++i) {
    const auto ellipse = ellipse_of((1.0 - ratio[i]) * (1.0 + ratio[i]));
    // 1 − (1 − m1) has lost digits of m1, on which the integrals depend by its logarithm.
    const double tolerance = 1e-15 / (ratio[i] * ratio[i]) + 1e-13;
    CHECK(stiffness[i] == Approx(1.0 / twisting::compliance(ellipse, a_c[i], glass, steel)).epsilon(tolerance));
    CHECK(arm[i] == Approx(twisting::limit(ellipse, a_c[i], 1.0, 1.0)).epsilon(tolerance));
  }
  const ElasticMaterial incompressible{.youngs_modulus = 1e6, .poissons_ratio = 0.5};
  CHECK_THROWS_AS(twisting::contacts(glass, incompressible, {}, {}), osculate::InputError);
  CHECK_THROWS_AS(twisting::contacts(glass, steel, {a_c, ratio}, {stiffness, {}}), osculate::InputError);
}

TEST_CASE("A twisted contact is elastic, then spins at the limit, and remembers") {
  const twisting::Contact contact{.stiffness = 20.0, .limit = 3.0};
  twisting::Memory memory{};
  CHECK(twisting::advance(memory, contact, 0.1) == Approx(2.0));
  CHECK(twisting::advance(memory, contact, 1.0) == 3.0);
  CHECK(twisting::advance(memory, contact, -0.1) == Approx(1.0));
  CHECK(twisting::advance(memory, contact, -9.0) == -3.0);
  CHECK(twisting::advance(memory, {.stiffness = 0.0, .limit = 0.0}, 1.0) == 0.0);
  CHECK(twisting::advance(memory, contact, 0.0) == 0.0);
}

TEST_CASE("Twisting never creates energy, whatever the contact does") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int path = 0; path < 2000; ++path) {
    twisting::Memory memory{};
    double lost = 0.0, energy = 0.0;
    for (int i = 0; i < 50; ++i) {
      const double a = uniform(random);
      const twisting::Contact contact{.stiffness = a * a * a, .limit = 0.3 * a * a * a * a};
      const double twist = uniform(random) - 0.5;
      const double moment = twisting::advance(memory, contact, twist);
      const double now = 0.5 * moment * moment / contact.stiffness;
      lost += moment * twist - (now - energy);
      energy = now;
      REQUIRE(std::fabs(moment) <= contact.limit);
      REQUIRE(lost >= -1e-14);  // rounding of terms below one
    }
  }
}

TEST_CASE("Twisting refuses what it cannot mean") {
  const auto ellipse = ellipse_of(0.3);
  const ElasticMaterial incompressible{.youngs_modulus = 1e6, .poissons_ratio = 0.5};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(twisting::compliance(ellipse, 1e-3, glass, incompressible), osculate::InputError);
  CHECK_THROWS_AS(twisting::compliance(ellipse, 0.0, glass, glass), osculate::InputError);
  CHECK_THROWS_AS(twisting::compliance(ellipse, nan, glass, glass), osculate::InputError);
  CHECK_THROWS_AS(twisting::limit(ellipse, 1e-3, -0.1, 1.0), osculate::InputError);
  CHECK_THROWS_AS(twisting::limit(ellipse, 1e-3, nan, 1.0), osculate::InputError);
  CHECK_THROWS_AS(twisting::limit(ellipse, 1e-3, 0.1, -1.0), osculate::InputError);
}
