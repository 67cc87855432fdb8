#include "osculate/mechanics/vermeulen_johnson.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mechanics/gsl_quadrature.hpp"
#include "osculate/core/error.hpp"

namespace kalker = osculate::kalker;
namespace vj = osculate::vermeulen_johnson;
using osculate::contact_ellipse;

namespace {

const auto kalkers = kalker::coefficients(kalker::table(0.28), 0.6);
const auto held = vj::contact(kalkers, 8.2e10, 5e-3, 3e-3, 0.3, 9e4);

}  // namespace

TEST_CASE("At small creepage Vermeulen and Johnson's force is the linear theory") {
  for (const auto& creepage : {kalker::Creepage{1e-9, 0, 0}, {0, -2e-9, 0}, {1e-9, 1e-9, 1e-7}}) {
    const auto force = vj::force(held, creepage);
    const auto linear = kalker::linear_force(held.coefficients, held.shear_modulus, held.a_c, held.b_c, creepage);
    // Relative departure τ ~ 1e-6.
    CHECK(force.longitudinal == Approx(linear.longitudinal).epsilon(1e-5));
    CHECK(force.lateral == Approx(linear.lateral).epsilon(1e-5));
    CHECK(force.moment == Approx(linear.moment).epsilon(1e-5));
  }
  CHECK(vj::force(held, {0, 0, 0}).longitudinal == 0.0);
}

TEST_CASE("Force and creepage are inverse up to sliding") {
  for (const double share : {1e-8, 0.3, 0.9, 0.999})
    for (const double angle : {0.0, 0.8, 3.5}) {
      const double x = share * held.limit * std::cos(angle), y = share * held.limit * std::sin(angle);
      const auto back = vj::force(held, vj::creepage(held, x, y));
      CHECK(back.longitudinal == Approx(x).epsilon(1e-12).margin(1e-12 * held.limit * share));
      CHECK(back.lateral == Approx(y).epsilon(1e-12).margin(1e-12 * held.limit * share));
    }
}

TEST_CASE("Rolling friction saturates at μF_n against the creepage, without a kink") {
  for (const double size : {3e-3, 1e-2, 10.0, 1e9}) {
    const auto force = vj::force(held, {size, size, 0.0});
    CHECK(std::hypot(force.longitudinal, force.lateral) <= held.limit * (1.0 + 1e-15));
    CHECK(force.longitudinal < 0.0);
  }
  const auto sliding = vj::force(held, {1.0, 0.0, 0.0});
  CHECK(sliding.longitudinal == Approx(-held.limit).epsilon(1e-15));
  double last = 0.0;
  for (double xi = 0.0; xi < 0.02; xi += 1e-5) {
    const double now = -vj::force(held, {xi, 0.0, 0.0}).longitudinal;
    REQUIRE(now >= last * (1.0 - 1e-14));  // rounding, once it slides
    last = now;
  }
}

TEST_CASE("Without friction nothing is transmitted") {
  const auto smooth = vj::contact(kalkers, 8.2e10, 5e-3, 3e-3, 0.0, 9e4);
  const auto force = vj::force(smooth, {1e-3, 1e-3, 0.1});
  CHECK(force.longitudinal == 0.0);
  CHECK(force.lateral == 0.0);
  CHECK(force.moment == 0.0);
}

TEST_CASE("A circular contact has Vermeulen and Johnson's own coefficients") {
  const auto circle = contact_ellipse(1.0, 1.0);
  for (const auto axis : {vj::RollingAxis::major, vj::RollingAxis::minor}) {
    const auto c = vj::coefficients(circle, 0.25, axis);
    CHECK(c.c11 == Approx(16.0 / (4.0 - 3.0 * 0.25)).epsilon(1e-14));
    CHECK(c.c22 == Approx(16.0 / (4.0 - 0.25)).epsilon(1e-14));
    CHECK(c.c11 > kalker::coefficients(kalker::table(0.25), 1.0).c11);
  }
}

TEST_CASE("The elliptical coefficients are the curvature of the displacement that Hertzian traction makes") {
  // u under q_0 (1 − x²/a² − y²/b²)^{1/2}, by Cerruti's kernel along chords through the point (compare hertz_test).
  // Stick needs the two superposed tractions' curvatures along the rolling to cancel: C_ii = π … from −u''.
  const auto ellipse = contact_ellipse(4.0, 1.0);
  const double a = 1.0, b = ellipse.axis_ratio, nu = 0.3;
  const auto displacement = [&](double x, double y, bool force_x) {
    return quadrature(
               [&](double phi) {
                 const double c = std::cos(phi), s = std::sin(phi);
                 const double A = c * c / (a * a) + s * s / (b * b), B = x * c / (a * a) + y * s / (b * b);
                 const double C = 1.0 - x * x / (a * a) - y * y / (b * b);
                 return M_PI_2 * (C + B * B / A) / std::sqrt(A) * (1.0 - nu + nu * (force_x ? c * c : s * s));
               },
               0.0, M_PI) /
           (2.0 * M_PI);
  };
  const double step = 0.3;  // u is quadratic: any step is exact
  const auto bend = [&](double dx, double dy, bool force_x) {
    return displacement(0, 0, force_x) - displacement(dx, dy, force_x);
  };
  // ξ = 4 κ d, F = 3 · (2/3 π a b q_0) d/r with r the semi-axis along the rolling: C = F/(a b ξ) = π/(2 κ r).
  const auto coefficient = [&](double curvature, double r) { return M_PI / (2.0 * curvature * r); };
  const double square = step * step;
  const auto along = vj::coefficients(ellipse, nu, vj::RollingAxis::major);
  CHECK(along.c11 == Approx(coefficient(bend(step, 0, true) / square, a)).epsilon(1e-10));
  CHECK(along.c22 == Approx(coefficient(bend(step, 0, false) / square, a)).epsilon(1e-10));
  const double short_step = 0.3 * b;
  const double short_square = short_step * short_step;
  const auto across = vj::coefficients(ellipse, nu, vj::RollingAxis::minor);
  CHECK(across.c11 == Approx(coefficient(bend(0, short_step, false) / short_square, b)).epsilon(1e-10));
  CHECK(across.c22 == Approx(coefficient(bend(0, short_step, true) / short_square, b)).epsilon(1e-10));
}

TEST_CASE("Rolling contacts without sense are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(vj::contact(kalkers, 0.0, 1.0, 1.0, 0.3, 1.0), osculate::InputError);
  CHECK_THROWS_AS(vj::contact(kalkers, 1.0, nan, 1.0, 0.3, 1.0), osculate::InputError);
  CHECK_THROWS_AS(vj::contact(kalkers, 1.0, 1.0, 1.0, -0.3, 1.0), osculate::InputError);
  CHECK_THROWS_AS(vj::contact(kalkers, 1.0, 1.0, 1.0, 0.3, nan), osculate::InputError);
  CHECK_THROWS_AS(vj::contact({}, 1.0, 1.0, 1.0, 0.3, 1.0), osculate::InputError);
}
