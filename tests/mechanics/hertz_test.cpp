#include "osculate/mechanics/hertz.hpp"

#include <gsl/gsl_integration.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "osculate/core/error.hpp"

namespace hertz = osculate::hertz;
using osculate::contact_ellipse;

namespace {

double integrate(const std::function<double(double)>& f, double from, double to) {
  gsl_function integrand;
  integrand.params = const_cast<std::function<double(double)>*>(&f);
  integrand.function = [](double x, void* g) { return (*static_cast<std::function<double(double)>*>(g))(x); };
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(500);
  double value = 0.0, error = 0.0;
  gsl_integration_qag(&integrand, from, to, 0.0, 1e-11, 500, GSL_INTEG_GAUSS31, workspace, &value, &error);
  gsl_integration_workspace_free(workspace);
  return value;
}

constexpr double modulus = 2.3e9, overlap = 4e-6;
constexpr double R_i = 0.013, R_j = 0.002;

/// Columns of a batch.
struct Batch {
  std::vector<double> R_i, R_j, R_min, modulus, overlap, force, a_c, b_c, pressure, stiffness, energy;
  std::vector<hertz::Validity> validity;

  void add(double i, double j, double smallest, double e, double delta) {
    R_i.push_back(i), R_j.push_back(j), R_min.push_back(smallest), modulus.push_back(e), overlap.push_back(delta);
  }
  void run() {
    for (auto* column : {&force, &a_c, &b_c, &pressure, &stiffness, &energy}) column->resize(R_i.size());
    validity.resize(R_i.size());
    hertz::contacts({R_i, R_j, R_min, modulus, overlap}, {force, a_c, b_c, pressure, stiffness, energy, validity});
  }
};

}  // namespace

TEST_CASE("Two spheres give classical Hertz") {
  const double R = 0.01;  // equal spheres of radius 2R
  const auto contact = hertz::contact(contact_ellipse(R, R), modulus, overlap, 2.0 * R);
  // Rounding of a handful of products.
  REQUIRE(contact.force == Approx(4.0 / 3.0 * modulus * std::sqrt(R) * std::pow(overlap, 1.5)).epsilon(2e-15));
  REQUIRE(contact.a_c == Approx(std::sqrt(R * overlap)).epsilon(2e-15));
  REQUIRE(contact.b_c == Approx(contact.a_c).epsilon(2e-15));
  REQUIRE(contact.peak_pressure == Approx(2.0 / M_PI * modulus * std::sqrt(overlap / R)).epsilon(2e-15));
  REQUIRE(contact.validity == hertz::Validity::valid);
}

TEST_CASE("Force and area are those of the review's gamma and beta") {
  const auto ellipse = contact_ellipse(R_i, R_j);
  const auto contact = hertz::contact(ellipse, modulus, overlap, R_j);
  REQUIRE(
      contact.force ==
      Approx(4.0 / 3.0 * modulus * std::sqrt(ellipse.R_c) * std::pow(overlap, 1.5) * ellipse.gamma()).epsilon(4e-15));
  REQUIRE(contact.a_c * contact.b_c == Approx(ellipse.beta() * ellipse.R_c * overlap).epsilon(4e-15));
  REQUIRE(contact.peak_pressure == Approx(1.5 * contact.force / (M_PI * contact.a_c * contact.b_c)).epsilon(4e-15));
  REQUIRE(hertz::force(ellipse, modulus, overlap) == contact.force);
}

TEST_CASE("The pressure ellipsoid presses the half-space into the bodies' shape") {
  // Boussinesq: u(x, y) = 1/(π Ê) ∫ p/s dA. With polar coordinates about the point of interest the 1/s cancels, and
  // along each chord of the ellipse the ellipsoidal pressure integrates to p_0 π/2 · disc/A^{3/2}, so that one
  // quadrature over the angle is left. Checked at points inside: u = δ − x²/(2R_i) − y²/(2R_j).
  const auto contact = hertz::contact(contact_ellipse(R_i, R_j), modulus, overlap, R_j);
  const double a = contact.a_c, b = contact.b_c;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.5 * a, 0.0}, {0.0, 0.7 * b}, {-0.4 * a, 0.6 * b}}) {
    const auto along_chord = [&, x = x, y = y](double phi) {
      const double c = std::cos(phi) / a, s = std::sin(phi) / b;
      const double A = c * c + s * s, B = x / a * c + y / b * s, C = 1.0 - x * x / (a * a) - y * y / (b * b);
      return contact.peak_pressure * M_PI_2 * (C + B * B / A) / std::sqrt(A);
    };
    const double sinking = integrate(along_chord, 0.0, M_PI) / (M_PI * modulus);
    // 1e-11 asked of the quadrature.
    REQUIRE(sinking == Approx(overlap - x * x / (2 * R_i) - y * y / (2 * R_j)).epsilon(1e-10));
  }
}

TEST_CASE("The pressure ellipsoid adds up to the force") {
  const auto contact = hertz::contact(contact_ellipse(R_i, R_j), modulus, overlap, R_j);
  const double force = integrate(
      [&](double x) {
        const double h = std::sqrt(1.0 - std::pow(x / contact.a_c, 2));
        return integrate(
            [&](double y) {
              return contact.peak_pressure * std::sqrt(std::fmax(0.0, h * h - std::pow(y / contact.b_c, 2)));
            },
            -contact.b_c * h, contact.b_c * h);
      },
      -contact.a_c, contact.a_c);
  REQUIRE(contact.force == Approx(force).epsilon(1e-9));  // square-root edges slow the quadrature down
}

TEST_CASE("Stiffness is the slope of the force and energy its integral") {
  const auto ellipse = contact_ellipse(R_i, R_j);
  const auto contact = hertz::contact(ellipse, modulus, overlap, R_j);
  const auto force = [&](double delta) { return hertz::force(ellipse, modulus, delta); };
  const double step = 1e-4 * overlap;
  // Central difference: step²/24 · F'''/F' ~ 1e-9 relative.
  REQUIRE(contact.stiffness == Approx((force(overlap + step) - force(overlap - step)) / (2 * step)).epsilon(1e-8));
  REQUIRE(contact.strain_energy == Approx(integrate(force, 0.0, overlap)).epsilon(1e-10));
}

TEST_CASE("Bodies that do not overlap do not press") {
  for (const double delta : {0.0, -1e-6}) {
    const auto contact = hertz::contact(contact_ellipse(R_i, R_j), modulus, delta, R_j);
    REQUIRE(contact.force == 0.0);
    REQUIRE(contact.a_c == 0.0);
    REQUIRE(contact.b_c == 0.0);
    REQUIRE(contact.peak_pressure == 0.0);
    REQUIRE(contact.stiffness == 0.0);
    REQUIRE(contact.strain_energy == 0.0);
    REQUIRE(contact.validity == hertz::Validity::valid);
  }
}

TEST_CASE("A contact as large as half the smallest radius is flagged") {
  const auto ellipse = contact_ellipse(1.0, 1.0);  // a_c = √δ
  REQUIRE(hertz::contact(ellipse, modulus, 0.2501, 1.0).validity == hertz::Validity::large_contact);
  REQUIRE(hertz::contact(ellipse, modulus, 0.2499, 1.0).validity == hertz::Validity::valid);
}

TEST_CASE("A flat direction is a line contact, with finite numbers") {
  const auto ellipse = contact_ellipse(std::numeric_limits<double>::infinity(), R_j);
  const auto contact = hertz::contact(ellipse, modulus, overlap, R_j);
  REQUIRE(contact.validity == hertz::Validity::line_contact);
  REQUIRE(std::isfinite(contact.force));
}

TEST_CASE("Hertz does not care about units") {
  const auto metres = hertz::contact(contact_ellipse(R_i, R_j), modulus, overlap, R_j);
  const auto microns = hertz::contact(contact_ellipse(R_i * 1e6, R_j * 1e6), modulus * 1e-12, overlap * 1e6, R_j * 1e6);
  REQUIRE(microns.force == Approx(metres.force).epsilon(4e-15));
  REQUIRE(microns.a_c * 1e-6 == Approx(metres.a_c).epsilon(4e-15));
}

TEST_CASE("A batch gives what single contacts give, whatever stands beside them") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Batch batch;
  for (int i = 0; i < 1003; ++i) {  // not a multiple of any vector length
    const double j = std::pow(10.0, -6.0 + 6.0 * uniform(random));
    const double ratio =
        i % 10 == 0 ? 1.0 + std::pow(10.0, -16.0 * uniform(random)) : std::pow(10.0, 12.0 * uniform(random));
    batch.add(j * ratio, j, j, 1e9 * (0.1 + uniform(random)), j * (uniform(random) - 0.2));
  }
  batch.run();
  for (std::size_t i = 0; i < batch.R_i.size(); ++i) {
    CAPTURE(i, batch.R_i[i], batch.R_j[i]);
    const auto contact =
        hertz::contact(contact_ellipse(batch.R_i[i], batch.R_j[i]), batch.modulus[i], batch.overlap[i], batch.R_min[i]);
    // Fused and separate roundings, and a logarithm good to four units in the last place.
    const double tolerance = 1e-14;
    REQUIRE(batch.force[i] == Approx(contact.force).epsilon(tolerance).margin(0));
    REQUIRE(batch.a_c[i] == Approx(contact.a_c).epsilon(tolerance).margin(0));
    REQUIRE(batch.b_c[i] == Approx(contact.b_c).epsilon(tolerance).margin(0));
    REQUIRE(batch.pressure[i] == Approx(contact.peak_pressure).epsilon(tolerance).margin(0));
    REQUIRE(batch.stiffness[i] == Approx(contact.stiffness).epsilon(tolerance).margin(0));
    REQUIRE(batch.energy[i] == Approx(contact.strain_energy).epsilon(tolerance).margin(0));
    REQUIRE(batch.validity[i] == contact.validity);

    Batch alone;
    alone.add(batch.R_i[i], batch.R_j[i], batch.R_min[i], batch.modulus[i], batch.overlap[i]);
    alone.run();
    REQUIRE(alone.force[0] == batch.force[i]);
  }
}

TEST_CASE("Bad numbers in a batch are said and give zeros, never NaN") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  Batch batch;
  batch.add(nan, 1, 1, 1, 0.01);
  batch.add(1, nan, 1, 1, 0.01);
  batch.add(1, 2, 1, 1, 0.01);
  batch.add(1, 0, 1, 1, 0.01);
  batch.add(-1, -2, 1, 1, 0.01);
  batch.add(infinity, infinity, 1, 1, 0.01);
  batch.add(1, 1, 0, 1, 0.01);
  batch.add(1, 1, 1, nan, 0.01);
  batch.add(1, 1, 1, -1, 0.01);
  batch.add(1, 1, 1, 1, nan);
  batch.add(1, 1, 1, 1, infinity);
  const std::size_t bad = batch.R_i.size();
  batch.add(infinity, 1, 1, 1, 0.01);
  batch.add(1, 1, 1, 1, 0.01);
  batch.run();
  for (std::size_t i = 0; i < bad; ++i) {
    CAPTURE(i);
    REQUIRE(batch.validity[i] == hertz::Validity::bad_input);
    for (const auto* column : {&batch.force, &batch.a_c, &batch.b_c, &batch.pressure, &batch.stiffness, &batch.energy})
      REQUIRE((*column)[i] == 0.0);
  }
  REQUIRE(batch.validity[bad] == hertz::Validity::line_contact);
  REQUIRE(std::isfinite(batch.force[bad]));
  REQUIRE(batch.validity[bad + 1] == hertz::Validity::valid);
  batch.overlap.pop_back();
  REQUIRE_THROWS_AS(batch.run(), osculate::InputError);
}

TEST_CASE("Bad numbers of a single contact are refused") {
  const auto ellipse = contact_ellipse(R_i, R_j);
  const double nan = std::nan("");
  REQUIRE_THROWS_AS(hertz::force(ellipse, nan, overlap), osculate::InputError);
  REQUIRE_THROWS_AS(hertz::force(ellipse, -1.0, overlap), osculate::InputError);
  REQUIRE_THROWS_AS(hertz::force(ellipse, modulus, nan), osculate::InputError);
  REQUIRE_THROWS_AS(hertz::contact(ellipse, modulus, overlap, 0.0), osculate::InputError);
}
