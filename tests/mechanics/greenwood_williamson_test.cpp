#include "osculate/mechanics/greenwood_williamson.hpp"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "mechanics/reference.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/hertz.hpp"
#include "osculate/mechanics/johnson_greenwood.hpp"

namespace gw = osculate::greenwood_williamson;
using osculate::contact_ellipse;

namespace {

constexpr gw::Roughness rough{.density = 3e9, .radius = 20e-6, .deviation = 0.3e-6};
constexpr double modulus = 40e9;

/// GSL's adaptive rule on [h, h + 12], with the root taken out by z = h + t².
double by_quadrature(double n, double h) {
  const std::function<double(double)> f = [=](double t) {
    return 2.0 * std::pow(t, 2.0 * n + 1.0) * gw::height_density(h + t * t);
  };
  gsl_function integrand;
  integrand.params = const_cast<std::function<double(double)>*>(&f);
  integrand.function = [](double x, void* g) { return (*static_cast<std::function<double(double)>*>(g))(x); };
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(1000);
  double value = 0.0, error = 0.0;
  gsl_integration_qag(&integrand, 0.0, std::sqrt(12.0 - std::min(h, 0.0)), 0.0, 1e-13, 1000, GSL_INTEG_GAUSS61,
                      workspace, &value, &error);
  gsl_integration_workspace_free(workspace);
  return value;
}

}  // namespace

TEST_CASE("Height integrals agree with the reference values") {
  for (const auto& row : reference_rows("greenwood_williamson")) {
    const double h = row.at("h");
    CAPTURE(h);
    const auto integrals = gw::height_integrals(h);
    const double tolerance = 1e-13;  // rounding of some fifty terms
    REQUIRE(integrals.half == Approx(row.at("F_half").get<double>()).epsilon(tolerance));
    REQUIRE(integrals.one ==
            Approx(row.at("F_one").get<double>()).epsilon(tolerance * (1.0 + h * h)));  // F_1 cancels to 1/h²
    REQUIRE(integrals.three_halves == Approx(row.at("F_three_halves").get<double>()).epsilon(tolerance));
  }
}

TEST_CASE("Height integrals agree with direct quadrature for h from -4 to 8") {
  for (double h = -4.0; h <= 8.0; h += 0.37) {
    CAPTURE(h);
    const auto integrals = gw::height_integrals(h);
    const double tolerance = 1e-12;  // asked of the quadrature, times ten
    REQUIRE(integrals.zero == Approx(by_quadrature(0.0, h)).epsilon(tolerance));
    REQUIRE(integrals.half == Approx(by_quadrature(0.5, h)).epsilon(tolerance));
    REQUIRE(integrals.one == Approx(by_quadrature(1.0, h)).epsilon(tolerance));
    REQUIRE(integrals.three_halves == Approx(by_quadrature(1.5, h)).epsilon(tolerance));
  }
}

TEST_CASE("The Bessel form of (35) holds for h > 0") {
  for (const double h : {0.1, 0.9, 2.0, 5.0, 9.0}) {
    const double x = 0.25 * h * h;  // scaled functions carry e^x, so that e^{-2x} is left
    const double bessel =
        std::exp(-2.0 * x) * std::sqrt(h) / (4.0 * std::sqrt(M_PI)) *
        ((h * h + 1.0) * gsl_sf_bessel_Knu_scaled(0.25, x) - h * h * gsl_sf_bessel_Knu_scaled(0.75, x));
    // The difference cancels as h grows: one part in h⁴ is left.
    REQUIRE(gw::height_integrals(h).three_halves == Approx(bessel).epsilon(1e-14 * (10.0 + std::pow(h, 4))));
  }
}

TEST_CASE("The mean compression has erfc and exp(-h^2/2): erratum to (36)") {
  const double h = 1.0, true_value = by_quadrature(1.0, h);
  REQUIRE(gw::mean_compression(h) == Approx(true_value).epsilon(1e-12));
  const double printed_exponent = std::exp(-h * h) / std::sqrt(2.0 * M_PI) - 0.5 * h * std::erfc(h / std::sqrt(2.0));
  const double printed_function = gw::height_density(h) - 0.5 * h * std::erf(h / std::sqrt(2.0));
  REQUIRE(std::abs(printed_exponent / true_value - 1.0) > 1.0);
  REQUIRE(std::abs(printed_function / true_value - 1.0) > 1.0);
}

TEST_CASE("Height integrals keep their sense far away on both sides") {
  REQUIRE(gw::height_integrals(50.0).three_halves == 0.0);
  // Moments of a normal law about a far point: E(w^{3/2}) = |h|^{3/2}(1 + 3/8 h^{-2} + …), and F_1 = |h|.
  const double h = -1000.0;
  REQUIRE(gw::height_integrals(h).one == Approx(1000.0).epsilon(1e-14));
  REQUIRE(gw::height_integrals(h).three_halves ==
          Approx(std::pow(1000.0, 1.5) * (1.0 + 0.375e-6)).epsilon(1e-11));  // next term ~ 1e-12
  const double up = gw::height_integrals(0.3 + 1e-5).three_halves, down = gw::height_integrals(0.3 - 1e-5).three_halves;
  REQUIRE(gw::height_integrals(0.3).half == Approx(-(up - down) / 3e-5).epsilon(1e-9));  // central difference
  REQUIRE_THROWS_AS(gw::height_integrals(std::nan("")), osculate::InputError);
}

TEST_CASE("A rough patch sums its asperities") {
  const double area = 1e-8, h = 1.2;
  const auto patch = gw::patch_at(rough, modulus, area, h);
  const auto sum = [&](auto&& of_one) {
    double total = 0.0;
    const double width = 1e-4;  // midpoint rule over heights in the tail
    for (double z = h + 0.5 * width; z < 10.0; z += width)
      total += rough.density * area * gw::height_density(z) * of_one(rough.deviation * (z - h)) * width;
    return total;
  };
  // Error of the midpoint rule at the root-like start: width^{2}.
  REQUIRE(patch.force == Approx(sum([](double w) { return gw::asperity_force(rough, modulus, w); })).epsilon(1e-6));
  REQUIRE(patch.real_area == Approx(sum([](double w) { return gw::asperity_area(rough, w); })).epsilon(1e-6));
  REQUIRE(patch.touching == Approx(sum([](double) { return 1.0; })).epsilon(1e-6));
  const double step = 1e-5;
  const double slope =
      (gw::patch_at(rough, modulus, area, h - step).force - gw::patch_at(rough, modulus, area, h + step).force) /
      (2.0 * step * rough.deviation);
  REQUIRE(patch.stiffness == Approx(slope).epsilon(1e-8));
}

TEST_CASE("A prescribed separation works on the nominal area of Hertz and of JKR") {
  const auto ellipse = contact_ellipse(2e-3, 1e-3);
  const osculate::johnson_greenwood::Pair pair{.R_i = 2e-3, .R_j = 1e-3, .modulus = modulus, .work_of_adhesion = 1.0};
  const auto hertz = osculate::hertz::contact(ellipse, modulus, 1e-7, 1e-3);
  const auto adhesive = osculate::johnson_greenwood::at_overlap(pair, 1e-7);
  const double smooth_area = M_PI * hertz.a_c * hertz.b_c;
  REQUIRE(adhesive->area() > smooth_area);
  const auto on_hertz = gw::patch_at(rough, modulus, smooth_area, 1.0);
  const auto on_jkr = gw::patch_at(rough, modulus, adhesive->area(), 1.0);
  REQUIRE(on_jkr.force / on_hertz.force == Approx(adhesive->area() / smooth_area).epsilon(1e-14));
  REQUIRE(on_hertz.force == Approx(smooth_area * gw::pressure(rough, modulus, 1.0)).epsilon(1e-14));
}

TEST_CASE("Roughness and bulk carry one force and share the overlap") {
  const auto ellipse = contact_ellipse(5e-3, 1e-3);
  double last = 0.0;
  for (const double overlap : {-1.7e-6, -1e-6, -3e-7, 0.0, 1e-7, 1e-6, 1e-5}) {
    CAPTURE(overlap);
    const auto contact = gw::contact(ellipse, modulus, rough, overlap);
    const auto bulk = osculate::hertz::contact(ellipse, modulus, contact.bulk_overlap, 1e-3);
    const auto patch = gw::patch_at(rough, modulus, M_PI * bulk.a_c * bulk.b_c, contact.separation);
    REQUIRE(contact.force > last);  // also softer bodies never pull
    REQUIRE(contact.force == Approx(bulk.force).epsilon(1e-14));
    // The separation keeps 1e-16·h and the layer falls like exp(−h²/2).
    REQUIRE(patch.force == Approx(contact.force).epsilon(1e-11));
    REQUIRE(contact.bulk_overlap - rough.deviation * contact.separation ==
            Approx(overlap).margin(1e-15 * rough.deviation * 10.0));
    REQUIRE(contact.real_area == Approx(patch.real_area).epsilon(1e-12));
    const double step = 1e-10;
    const double slope = (gw::contact(ellipse, modulus, rough, overlap + step).force -
                          gw::contact(ellipse, modulus, rough, overlap - step).force) /
                         (2.0 * step);
    REQUIRE(contact.stiffness == Approx(slope).epsilon(1e-5));  // step/σ squared, and round-off over step
    last = contact.force;
  }
  REQUIRE(gw::contact(ellipse, modulus, rough, -6.0 * rough.deviation).force == 0.0);
}

TEST_CASE("Fine roughness is smooth") {
  const auto ellipse = contact_ellipse(5e-3, 1e-3);
  const double overlap = 1e-5, smooth = osculate::hertz::force(ellipse, modulus, overlap);
  double last = 1.0;
  for (const double sigma : {1e-7, 1e-8, 1e-9}) {  // χβσ held, as for similar surfaces
    const gw::Roughness fine{.density = 0.05 / (20e-6 * sigma), .radius = 20e-6, .deviation = sigma};
    const double error = std::abs(gw::contact(ellipse, modulus, fine, overlap).force / smooth - 1.0);
    REQUIRE(error < 0.3 * last);
    last = error;
  }
  REQUIRE(last < 3e-3);  // 3/2 σ|h|/δ with |h| ≈ 16: the fine layer is soft
}

TEST_CASE("Bad roughness is refused") {
  const auto ellipse = contact_ellipse(2.0, 1.0);
  for (const double bad : {0.0, -1.0, double(NAN), std::numeric_limits<double>::infinity()}) {
    auto density = rough, radius = rough, deviation = rough;
    density.density = bad, radius.radius = bad, deviation.deviation = bad;
    for (const auto& roughness : {density, radius, deviation}) {
      REQUIRE_THROWS_AS(gw::validate(roughness), osculate::InputError);
      REQUIRE_THROWS_AS(gw::contact(ellipse, modulus, roughness, 1e-6), osculate::InputError);
    }
    REQUIRE_THROWS_AS(gw::contact(ellipse, bad, rough, 1e-6), osculate::InputError);
  }
  REQUIRE_THROWS_AS(gw::contact(ellipse, modulus, rough, NAN), osculate::InputError);
  REQUIRE_THROWS_AS(gw::patch_at(rough, modulus, -1.0, 1.0), osculate::InputError);
}
