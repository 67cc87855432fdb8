#include "osculate/mechanics/contact_ellipse.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "osculate/core/error.hpp"
#include "reference.hpp"

using osculate::contact_ellipse;
using osculate::contact_ellipse_approximate;

namespace {
double square(double x) {
  return x * x;
}
}  // namespace

TEST_CASE("The contact ellipse agrees with 40-digit reference values in every digit asked") {
  for (const auto& row : reference_rows("hertz")) {
    const double ratio = row.at("ratio");
    CAPTURE(ratio);
    // Radii scaled to integers, since the double nearest 1.000001 is another ratio in e²'s tenth digit.
    const auto ellipse = contact_ellipse(std::round(ratio * 1e6), 1e6);
    // The library's promise, ten times stricter than needed of a reference row.
    const double tolerance = 1e-14;
    REQUIRE(ellipse.e2 == Approx(row.at("e2").get<double>()).epsilon(1e-13).margin(0));  // 14 digits printed
    REQUIRE(ellipse.axis_ratio == Approx(row.at("b_over_a").get<double>()).epsilon(tolerance).margin(0));
    REQUIRE(ellipse.K == Approx(row.at("K").get<double>()).epsilon(tolerance).margin(0));
    REQUIRE(ellipse.E == Approx(row.at("E").get<double>()).epsilon(tolerance).margin(0));
    REQUIRE(ellipse.gamma() == Approx(row.at("gamma").get<double>()).epsilon(tolerance).margin(0));
    REQUIRE(ellipse.beta() == Approx(row.at("beta").get<double>()).epsilon(tolerance).margin(0));
  }
}

TEST_CASE("The contact ellipse satisfies its equation in Carlson's forms from ratio 1 to 1e12") {
  for (double t = 0.0; t <= 12.0; t += 0.0125) {
    const double ratio = std::pow(10.0, t);
    const auto ellipse = contact_ellipse(ratio, 1.0);
    CAPTURE(ratio);
    REQUIRE_FALSE(ellipse.ratio_limited);
    const double m1 = ellipse.axis_ratio * ellipse.axis_ratio;
    const double d = gsl_sf_ellint_RD(0.0, m1, 1.0, GSL_PREC_DOUBLE);
    const double b = m1 * gsl_sf_ellint_RD(0.0, 1.0, m1, GSL_PREC_DOUBLE);
    // Three rounded functions and b/a to 5e-15, twice.
    REQUIRE(m1 * d / b * ratio == Approx(1.0).epsilon(2e-14));
    REQUIRE(ellipse.K == Approx(gsl_sf_ellint_RF(0.0, m1, 1.0, GSL_PREC_DOUBLE)).epsilon(5e-15).margin(0));
    REQUIRE(ellipse.e2 + m1 == Approx(1.0).epsilon(5e-16));
  }
}

TEST_CASE("A nearly circular contact keeps every digit of its eccentricity") {
  for (double deviation = 1e-4; deviation > 1e-15; deviation /= 3.0) {
    const double R_i = 1.0 + deviation, exact_deviation = (R_i - 1.0) / R_i;
    // From the series of (1 − m) D/B at m = 0; what is left out is of order s² relative.
    const double series = 4.0 / 3.0 * exact_deviation * (1.0 - exact_deviation / 6.0);
    CAPTURE(deviation);
    REQUIRE(contact_ellipse(R_i, 1.0).e2 == Approx(series).epsilon(square(deviation) + 5e-15).margin(0));
  }
  REQUIRE(contact_ellipse(1.0, 1.0).e2 == 0.0);
  REQUIRE(contact_ellipse(1.0, 1.0).axis_ratio == 1.0);
}

TEST_CASE("Equal spheres give back Hertz's sphere: gamma = sqrt 2, beta = 2, R_c = R/4") {
  const auto ellipse = contact_ellipse(0.005, 0.005);
  REQUIRE(ellipse.gamma() == Approx(std::sqrt(2.0)).epsilon(1e-15));
  REQUIRE(ellipse.beta() == Approx(2.0).epsilon(1e-15));
  REQUIRE(ellipse.R_c == Approx(0.0025).epsilon(1e-15));
}

TEST_CASE("A flat direction is held at the largest ratio and says so") {
  const auto flat = contact_ellipse(std::numeric_limits<double>::infinity(), 1.0);
  REQUIRE(flat.ratio_limited);
  REQUIRE(flat.axis_ratio == contact_ellipse(osculate::largest_radius_ratio, 1.0).axis_ratio);
  REQUIRE(std::isfinite(flat.gamma()));
  REQUIRE_FALSE(contact_ellipse(osculate::largest_radius_ratio, 1.0).ratio_limited);
}

TEST_CASE("The review's approximate axis ratio errs by what is documented") {
  const auto error = [](double ratio) {
    return contact_ellipse_approximate(ratio, 1.0).gamma() / contact_ellipse(ratio, 1.0).gamma() - 1.0;
  };
  // Half a unit of the documented digits.
  REQUIRE(error(1.2) == Approx(-0.0002).margin(0.00005));
  REQUIRE(error(5.0) == Approx(-0.0019).margin(0.00005));
  REQUIRE(error(44.0) == Approx(0.0024).margin(0.00005));
  REQUIRE(error(1000.0) == Approx(0.0045).margin(0.00005));
  REQUIRE(error(1.0) == Approx(0.0).margin(1e-12));
}

TEST_CASE("Radii that are no contact ellipse are refused") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const auto& [R_i, R_j] :
       {std::pair{1.0, 2.0}, {1.0, 0.0}, {1.0, -1.0}, {nan, 1.0}, {1.0, nan}, {infinity, infinity}, {-5.0, -6.0}}) {
    REQUIRE_THROWS_AS(contact_ellipse(R_i, R_j), osculate::InputError);
    REQUIRE_THROWS_AS(contact_ellipse_approximate(R_i, R_j), osculate::InputError);
  }
}
