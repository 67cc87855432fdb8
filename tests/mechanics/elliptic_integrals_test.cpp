#include "osculate/mechanics/elliptic_integrals.hpp"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_ellint.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "osculate/core/error.hpp"
#include "reference.hpp"

using osculate::complete_elliptic;

namespace {
/// ∫ s²c²/Δ³ over the quarter period, by quadrature.
double c_by_quadrature(double complement) {
  gsl_function integrand;
  integrand.params = &complement;
  integrand.function = [](double theta, void* m1) {
    const double s2 = std::pow(std::sin(theta), 2), c2 = std::pow(std::cos(theta), 2);
    return s2 * c2 / std::pow(c2 + *static_cast<double*>(m1) * s2, 1.5);
  };
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(200);
  double value = 0.0, error = 0.0;
  gsl_integration_qag(&integrand, 0.0, M_PI_2, 0.0, 1e-13, 200, GSL_INTEG_GAUSS61, workspace, &value, &error);
  gsl_integration_workspace_free(workspace);
  return value;
}
}  // namespace

TEST_CASE("Complete elliptic integrals agree with Carlson's forms for any complement") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 4000; ++i) {
    const double m1 =
        i % 2 == 0 ? uniform(random) : std::pow(10.0, -190.0 * uniform(random));  // GSL's own limit is 1e-205
    const auto integrals = complete_elliptic(m1);
    CAPTURE(m1);
    // GSL's Carlson duplication is good to a few units in the last place of a sum of a few terms.
    const double tolerance = 4e-15;
    const double r_f = gsl_sf_ellint_RF(0.0, m1, 1.0, GSL_PREC_DOUBLE);
    const double r_d = gsl_sf_ellint_RD(0.0, m1, 1.0, GSL_PREC_DOUBLE) / 3.0;
    REQUIRE(integrals.K == Approx(r_f).epsilon(tolerance).margin(0));
    REQUIRE(integrals.D == Approx(r_d).epsilon(tolerance).margin(0));
    // B = m1 R_D(0, 1, m1)/3 is a sum without cancellation, E = B + m1 D too.
    const double b = m1 * gsl_sf_ellint_RD(0.0, 1.0, m1, GSL_PREC_DOUBLE) / 3.0;
    REQUIRE(integrals.B == Approx(b).epsilon(tolerance).margin(0));
    REQUIRE(integrals.E == Approx(b + m1 * r_d).epsilon(tolerance).margin(0));
  }
}

TEST_CASE("The integral C agrees with quadrature of its definition") {
  for (const double m1 : {1.0, 1.0 - 1e-9, 0.99, 0.9, 0.8, 0.7, 0.6, 0.5, 0.3, 0.1, 1e-2, 1e-3, 1e-4}) {
    CAPTURE(m1);
    // 5e-15 of the fit's evaluation, 1e-13 asked of the quadrature.
    REQUIRE(complete_elliptic(m1).C == Approx(c_by_quadrature(m1)).epsilon(2e-13).margin(0));
  }
}

TEST_CASE("Legendre's relation ties complementary ellipses together") {
  for (const double m1 : {0.5, 0.3, 0.1, 1e-3, 1e-8}) {
    const auto one = complete_elliptic(m1), other = complete_elliptic(1.0 - m1);
    // K ~ 10 at 1e-8 amplifies rounding of the difference K'(E − K) + E'K.
    REQUIRE(one.E * other.K + other.E * one.K - one.K * other.K == Approx(M_PI_2).epsilon(2e-14).margin(0));
  }
}

TEST_CASE("Complete elliptic integrals agree with 40-digit reference values") {
  for (const auto& row : reference_rows("hertz")) {
    const double axis_ratio = row.at("b_over_a");
    CAPTURE(axis_ratio);
    // The file rounds b/a to 1.1e-16: K' ~ 1/m1 · dm1 stays relative, so that 5e-15 is the fit's own error.
    const auto integrals = complete_elliptic(axis_ratio * axis_ratio);
    REQUIRE(integrals.K == Approx(row.at("K").get<double>()).epsilon(5e-15).margin(0));
    REQUIRE(integrals.E == Approx(row.at("E").get<double>()).epsilon(5e-15).margin(0));
    REQUIRE(integrals.B == Approx(row.at("B").get<double>()).epsilon(5e-15).margin(0));
    REQUIRE(integrals.C == Approx(row.at("C").get<double>()).epsilon(5e-15).margin(0));
    REQUIRE(integrals.D == Approx(row.at("D").get<double>()).epsilon(5e-15).margin(0));
  }
}

TEST_CASE("Complete elliptic integrals take their limits at the circle and at the line") {
  const auto circle = complete_elliptic(1.0);
  REQUIRE(circle.K == Approx(M_PI_2).epsilon(1e-15).margin(0));  // rounding
  REQUIRE(circle.C == Approx(M_PI / 16).epsilon(1e-15).margin(0));
  const auto line = complete_elliptic(0.0);
  REQUIRE(line.E == 1.0);
  REQUIRE(line.B == 1.0);
  REQUIRE(std::isinf(line.K));
  REQUIRE(std::isinf(line.C));
  REQUIRE(std::isinf(line.D));
  REQUIRE(complete_elliptic(std::numeric_limits<double>::min()).B == 1.0);
}

TEST_CASE("A complement outside [0, 1] is refused") {
  for (const double m1 : {-1e-300, 1.0000001, std::nan("")})
    REQUIRE_THROWS_AS(complete_elliptic(m1), osculate::InputError);
}
