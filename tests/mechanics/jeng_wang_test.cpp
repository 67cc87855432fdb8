#include "osculate/mechanics/jeng_wang.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "mechanics/gsl_quadrature.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/greenwood_williamson.hpp"

namespace gw = osculate::greenwood_williamson;
namespace jw = osculate::jeng_wang;

namespace {

/// Bead-blasted steel with ridges.
constexpr jw::Surface steel{
    .density = 3e9, .R_i = 80e-6, .R_j = 10e-6, .deviation = 0.3e-6, .modulus = 110e9, .hardness = 3e9};
constexpr double area = 1e-8;

}  // namespace

TEST_CASE("The radius ratio of a round contact is 1, without loss near it") {
  REQUIRE(jw::radius_ratio(0.0) == 1.0);
  // R_i/R_j = 1 + 3/4 e² + …: the slope of λ = (1 − m)D/B at the circle is −3/4.
  for (const double e : {1e-7, 1e-5, 1e-4})
    REQUIRE((jw::radius_ratio(e) - 1.0) == Approx(0.75 * e * e).epsilon(2.0 * e * e).margin(4e-16));
  for (const double ratio : {1.5, 8.0, 300.0}) {
    const double e = std::sqrt(osculate::contact_ellipse(ratio, 1.0).e2);
    REQUIRE(jw::radius_ratio(e) == Approx(ratio).epsilon(1e-12));  // e near 1 loses digits of 1 − e²
  }
  REQUIRE_THROWS_AS(jw::radius_ratio(1.0), osculate::InputError);
}

TEST_CASE("An asperity's force and area are continuous, rise, and stay below hardness") {
  const auto one = jw::asperity(steel);
  REQUIRE(one.full_plastic == Approx(54.0 * one.first_yield));
  for (const double edge : {one.first_yield, one.full_plastic}) {
    const auto below = jw::load(one, edge * (1.0 - 1e-9)), above = jw::load(one, edge * (1.0 + 1e-9));
    REQUIRE(below.deformation != above.deformation);
    REQUIRE(above.force == Approx(below.force).epsilon(1e-8));  // slopes of order one over the gap of 2e-9
    REQUIRE(above.area == Approx(below.area).epsilon(1e-8));
  }
  jw::Load last{};
  for (double w = 0.01 * one.first_yield; w < 200.0 * one.first_yield; w *= 1.02) {
    const auto load = jw::load(one, w);
    REQUIRE(load.force > last.force);
    REQUIRE(load.area > last.area);
    REQUIRE(load.force <= one.hardness * load.area * (1.0 + 1e-14));
    last = load;
  }
  const auto yield = jw::load(one, one.first_yield);
  REQUIRE(yield.force / yield.area == Approx(0.4 * steel.hardness).epsilon(1e-14));
  REQUIRE(jw::load(one, -1e-6).force == 0.0);
}

TEST_CASE("Asperities that never yield are Greenwood and Williamson's") {
  auto hard = steel;
  hard.R_i = hard.R_j = 20e-6;
  hard.hardness = 1e15;
  const gw::Roughness rough{.density = hard.density, .radius = 20e-6, .deviation = hard.deviation};
  for (const double h : {-2.0, 0.0, 1.0, 4.0}) {
    const auto plastic = jw::patch_at(hard, area, h);
    const auto elastic = gw::patch_at(rough, hard.modulus, area, h);
    REQUIRE(plastic.force == Approx(elastic.force).epsilon(1e-10));
    REQUIRE(plastic.area == Approx(elastic.real_area).epsilon(1e-10));
    REQUIRE(plastic.force_by_regime[2] == 0.0);
  }
}

TEST_CASE("Asperities as soft as butter carry their hardness on the area cut off") {
  auto soft = steel;
  soft.hardness = 1e4;
  for (const double h : {-1.0, 1.0, 3.0}) {
    const auto patch = jw::patch_at(soft, area, h);
    const double cut =
        soft.density * area * 2.0 * M_PI * std::sqrt(soft.R_i * soft.R_j) * soft.deviation * gw::mean_compression(h);
    REQUIRE(patch.area == Approx(cut).epsilon(1e-8));  // δ_n2/σ ~ 1e-9 is not yet plastic
    REQUIRE(patch.force == Approx(soft.hardness * cut).epsilon(1e-8));
  }
}

TEST_CASE("The integrals over each regime join without gap or overlap: errata to (47), (48)") {
  // Against one sum over all heights, which knows nothing of limits.
  const auto one = jw::asperity(steel);
  for (const double h : {-1.5, 0.0, 1.0, 2.5}) {
    CAPTURE(h);
    const auto patch = jw::patch_at(steel, area, h);
    double force = 0.0, contact = 0.0;
    const double width = 1e-4;
    for (double z = h + 0.5 * width; z < 9.0; z += width) {
      const auto load = jw::load(one, steel.deviation * (z - h));
      const double count = steel.density * area * gw::height_density(z) * width;
      force += count * load.force;
      contact += count * load.area;
    }
    REQUIRE(patch.force == Approx(force).epsilon(1e-6));  // midpoint rule, width², kinks at δ_n1
    REQUIRE(patch.area == Approx(contact).epsilon(1e-6));
    const auto total = [](const auto& parts) { return std::accumulate(parts.begin(), parts.end(), 0.0); };
    REQUIRE(patch.force == Approx(total(patch.force_by_regime)).epsilon(1e-15));
    REQUIRE(patch.area == Approx(total(patch.area_by_regime)).epsilon(1e-15));
    // A last integral of the force from h + δ_n1* would count the elastic-plastic asperities twice.
    const double twice = osculate::quadrature::integrate(
        [&](double z) {
          return steel.density * area * one.hardness * one.plastic_factor * steel.deviation * (z - h) *
                 gw::height_density(z);
        },
        h + one.first_yield / steel.deviation, h + 9.0, 1e-12);
    REQUIRE(twice > 1.05 * patch.force_by_regime[2]);
  }
}

TEST_CASE("Yielding lowers the force and widens the area") {
  auto elastic = steel;
  elastic.hardness = 1e15;
  const auto yielding = jw::patch_at(steel, area, 0.5), springy = jw::patch_at(elastic, area, 0.5);
  REQUIRE(yielding.force < springy.force);
  REQUIRE(yielding.area > springy.area);
}

TEST_CASE("The Taylor series follows the integrals near its centre and says where it fails") {
  const jw::TaylorSeries series(steel, area, 1.0);
  const auto at_centre = jw::patch_at(steel, area, 1.0);
  REQUIRE(series.force(1.0) == Approx(at_centre.force).epsilon(1e-10));
  REQUIRE(series.area(1.0) == Approx(at_centre.area).epsilon(1e-10));
  for (const double h : {0.5, 0.8, 1.3, 1.6}) {
    const auto patch = jw::patch_at(steel, area, h);
    CAPTURE(h, series.last_term(h));
    REQUIRE(std::abs(series.force(h) / patch.force - 1.0) < 2.0 * series.last_term(h) + 1e-9);
    REQUIRE(series.area(h) == Approx(patch.area).epsilon(1e-4));  // (0.6)^9 He_9/9!
  }
  REQUIRE(series.last_term(4.0) > 0.1);
}

TEST_CASE("Bad elastic-plastic surfaces are refused") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    for (double jw::Surface::*member :
         {&jw::Surface::density, &jw::Surface::R_j, &jw::Surface::deviation, &jw::Surface::modulus,
          &jw::Surface::hardness, &jw::Surface::yield_ratio, &jw::Surface::plastic_ratio}) {
      auto surface = steel;
      surface.*member = bad;
      REQUIRE_THROWS_AS(jw::validate(surface), osculate::InputError);
      REQUIRE_THROWS_AS(jw::patch_at(surface, area, 1.0), osculate::InputError);
    }
  }
  REQUIRE_THROWS_AS(jw::patch_at(steel, -1.0, 1.0), osculate::InputError);
  REQUIRE_THROWS_AS(jw::patch_at(steel, area, nan), osculate::InputError);
}
