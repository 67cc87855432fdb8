#include "osculate/mechanics/hisakado.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mechanics/gsl_quadrature.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/greenwood_williamson.hpp"
#include "osculate/mechanics/mindlin.hpp"

namespace hisakado = osculate::hisakado;
using osculate::ElasticMaterial;

namespace {

const ElasticMaterial steel{.youngs_modulus = 210e9, .poissons_ratio = 0.29};
const ElasticMaterial brass{.youngs_modulus = 100e9, .poissons_ratio = 0.34};
const auto rough = hisakado::surface(20e-6, 1e-6, 500.0, steel, brass, 0.3);

double density(double z) {
  return std::exp(-0.5 * z * z) / std::sqrt(2.0 * M_PI);
}

}  // namespace

TEST_CASE("One asperity has Mindlin's compliance of its own contact radius") {
  const double w = 0.4e-6, a = std::sqrt(20e-6 * w);
  CHECK(hisakado::asperity_contact_radius(rough, w) == Approx(a).epsilon(1e-15));
  const auto circle = osculate::contact_ellipse(20e-6, 20e-6);
  CHECK(hisakado::asperity_compliance(rough, w) ==
        Approx(osculate::mindlin::compliance(circle, a, steel, brass).major).epsilon(1e-14));
}

TEST_CASE("Erratum (78): against a rigid flat an asperity's compliance is (2−ν)/(8 G a)") {
  const ElasticMaterial rigid{.youngs_modulus = 1e30, .poissons_ratio = 0.3};
  const auto flat = hisakado::surface(20e-6, 1e-6, 500.0, steel, rigid, 0.3);
  const double w = 0.1e-6, a = hisakado::asperity_contact_radius(flat, w);
  CHECK(hisakado::asperity_compliance(flat, w) ==
        Approx((2.0 - steel.poissons_ratio) / (8.0 * steel.shear_modulus() * a)).epsilon(1e-14));
}

TEST_CASE("Errata (79),(81): the rough tangential force is the sum of the asperities' Mindlin forces") {
  for (const double h : {-2.0, 0.0, 1.5, 3.0})
    for (const double displacement : {0.02e-6, 0.2e-6, 1.5e-6}) {
      CAPTURE(h, displacement);
      const double sigma = rough.height_deviation;
      const double touching_sum = quadrature(
          [&](double s) {  // z = h + s²: removes the roots at both ends of the partial slip
            const double w = sigma * s * s;
            if (w == 0.0) return 0.0;
            const double a = hisakado::asperity_contact_radius(rough, w);
            const auto asperity = osculate::mindlin::contact(hisakado::asperity_compliance(rough, w), rough.friction,
                                                             4.0 / 3.0 * rough.modulus * a * w);
            return osculate::mindlin::force(asperity, displacement) * density(h + s * s) * 2.0 * s;
          },
          0.0, std::sqrt(9.0 - h), 1e-11);
      CHECK(hisakado::tangential_force(rough, h, displacement) ==
            Approx(rough.asperities * touching_sum).epsilon(1e-9));
      CHECK(hisakado::tangential_force(rough, h, -displacement) == -hisakado::tangential_force(rough, h, displacement));
    }
}

TEST_CASE("The rough contact starts at its stiffness and slides at μF_n") {
  for (const double h : {-1.0, 0.5, 2.0}) {
    const double small = 1e-12;
    // The next term is −δ_t/(2μκσ) F_0/F_half ~ 2e-6 relative at h = 2.
    CHECK(hisakado::tangential_force(rough, h, small) / small == Approx(hisakado::stiffness(rough, h)).epsilon(2e-5));
    CHECK(hisakado::tangential_force(rough, h, 1e-3) ==
          Approx(rough.friction * hisakado::normal_force(rough, h)).epsilon(1e-14));
    CHECK(hisakado::sliding_share(rough, h, 0.0) == 0.0);
    CHECK(hisakado::sliding_share(rough, h, 1e-3) == 1.0);
    const double displacement = 0.1e-6;
    const double from = h + hisakado::sliding_interference(rough, displacement) / rough.height_deviation;
    CHECK(hisakado::sliding_share(rough, h, displacement) ==
          Approx(quadrature(density, h, from) / quadrature(density, h, 12.0)).epsilon(1e-9));
  }
}

TEST_CASE("Erratum (84): the Bessel form with √π/(4√(2h)) is the height integral for positive h") {
  // ∫(z−h)^{1/2} φ dz = e^{−h²/4} h^{3/2}/(4√π) [K_{3/4}(h²/4) − K_{1/4}(h²/4)], from the parabolic cylinder D_{−3/2}.
  for (const double h : {0.3, 1.0, 2.5}) {
    const double x = 0.25 * h * h;
    const double bessel = std::exp(-x) * std::pow(h, 1.5) / (4.0 * std::sqrt(M_PI)) *
                          (gsl_sf_bessel_Knu(0.75, x) - gsl_sf_bessel_Knu(0.25, x));
    CHECK(osculate::greenwood_williamson::height_integrals(h).half == Approx(bessel).epsilon(1e-11));
  }
}

TEST_CASE("A rough surface without sense is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(hisakado::surface(0.0, 1e-6, 1.0, steel, brass, 0.3), osculate::InputError);
  CHECK_THROWS_AS(hisakado::surface(1e-5, 0.0, 1.0, steel, brass, 0.3), osculate::InputError);
  CHECK_THROWS_AS(hisakado::surface(1e-5, 1e-6, nan, steel, brass, 0.3), osculate::InputError);
  CHECK_THROWS_AS(hisakado::surface(1e-5, 1e-6, 1.0, steel, brass, -0.3), osculate::InputError);
}
