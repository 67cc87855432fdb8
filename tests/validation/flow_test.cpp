#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "osculate/core/error.hpp"
#include "osculate/dynamics/random.hpp"
#include "validation/flow/flow_study.hpp"

using namespace osculate;
using namespace osculate::validation;

namespace {

/// What the law gives for the widths of the study.
std::vector<Discharge> beverloo_rates(double k, double diameter) {
  constexpr double scale = 170.0;
  std::vector<Discharge> discharges;
  for (const double width : slot_widths())
    discharges.push_back({.rate = scale * std::pow(width - k * diameter, 1.5), .error = 0.0});
  return discharges;
}

}  // namespace

TEST_CASE("Rates by Beverloo's law give back its constant, its k and its exponent") {
  constexpr double d = 5e-3, k = 1.4;
  const std::vector<Discharge> discharges = beverloo_rates(k, d);
  const BeverlooFit fit = beverloo_fit(slot_widths(), discharges, d);
  CHECK(fit.k == Approx(k));
  CHECK(fit.scale == Approx(170.0));
  CHECK(fit.exponent == Approx(1.5));
  CHECK(fit.correlation == Approx(1.0));
  CHECK(beverloo_rate(fit, d, slot_widths()[2]) == Approx(discharges[2].rate));
  CHECK(beverloo_rate(fit, d, 0.5 * d) == 0.0);
  CHECK_THROWS_AS(beverloo_fit({0.02, 0.03}, {discharges[0], discharges[1]}, d), InputError);
  CHECK_THROWS_AS(beverloo_fit({0.006, 0.02, 0.03, 0.04}, discharges, d), InputError);
}

TEST_CASE("Errors of k and of the exponent are those that errors of the rates make") {
  constexpr double d = 5e-3, share = 1e-4;
  std::vector<Discharge> discharges = beverloo_rates(1.4, d);
  const BeverlooFit exact = beverloo_fit(slot_widths(), discharges, d);
  double k_variance = 0.0, exponent_variance = 0.0;
  for (Discharge& one : discharges) {
    const double rate = one.rate;
    one.rate *= 1.0 + share;
    const BeverlooFit moved = beverloo_fit(slot_widths(), discharges, d);
    one = {.rate = rate, .error = share * rate};
    k_variance += std::pow(moved.k - exact.k, 2.0);
    exponent_variance += std::pow(moved.exponent - exact.exponent, 2.0);
  }
  const BeverlooFit fit = beverloo_fit(slot_widths(), discharges, d);
  CHECK(fit.k_error == Approx(std::sqrt(k_variance)).epsilon(1e-3));
  CHECK(fit.exponent_error == Approx(std::sqrt(exponent_variance)).epsilon(1e-3));
}

TEST_CASE("The exponents that are expected are those of the law with a k of 1 or 2") {
  const double d = hopper_grain_diameter();
  CHECK(beverloo_fit(slot_widths(), beverloo_rates(1.0, d), d).exponent ==
        Approx(expected::least_exponent).margin(0.05));
  CHECK(beverloo_fit(slot_widths(), beverloo_rates(2.0, d), d).exponent ==
        Approx(expected::most_exponent).margin(0.05));
}

TEST_CASE("A discharge agrees only if width and gravity do what the law says") {
  const double d = hopper_grain_diameter();
  DischargeSeries series{.diameter = d,
                         .widths = slot_widths(),
                         .discharges = beverloo_rates(1.4, d),
                         .light = {},
                         .fit = beverloo_fit(slot_widths(), beverloo_rates(1.4, d), d),
                         .overlap = 0.0};
  const double widest = series.discharges.back().rate;
  series.light.rate = 0.5 * widest;
  CHECK(series.agrees());
  series.fit = beverloo_fit(slot_widths(), beverloo_rates(0.7, d), d);
  CHECK_FALSE(series.k_agrees());
  CHECK_FALSE(series.exponent_agrees());
  series.fit = beverloo_fit(slot_widths(), series.discharges, d);
  series.light.rate = 0.6 * widest;
  CHECK_FALSE(series.agrees());
  series.light.rate = 0.5 * widest;
  std::swap(series.discharges[0], series.discharges[1]);
  CHECK_FALSE(series.agrees());
  // In proportion to the width, as a liquid of given height would.
  series.discharges = beverloo_rates(1.4, d);
  for (std::size_t i = 0; i < series.widths.size(); ++i) series.discharges[i].rate = series.widths[i];
  series.light.rate = 0.5 * series.discharges.back().rate;
  series.fit = beverloo_fit(series.widths, series.discharges, d);
  CHECK_FALSE(series.agrees());
}

TEST_CASE("The steady rate is that between the first tenth and a filling as low as the bin is wide") {
  Outflow out;
  out.total = 1.0;
  constexpr double rate = 2.0;
  for (int i = 0; i <= 300; ++i) {
    const double time = 1e-3 * i;
    // At first, and when little is left, all is different.
    const double mass = time < 0.05 ? time : 0.05 + rate * (time - 0.05) * (time < 0.2005 ? 1.0 : 3.0);
    out.times.push_back(time);
    out.masses.push_back(mass);
    out.heights.push_back(hopper_bin_width * (1.0 + 0.5 * (0.2 - time)));
  }
  const Discharge steady = steady_discharge(out);
  CHECK(steady.rate == Approx(rate).epsilon(1e-9));
  CHECK(steady.error == Approx(0.0).margin(1e-9));
  out.total = 4.0;
  CHECK_THROWS_AS(steady_discharge(out), std::runtime_error);
}

TEST_CASE("The mean of hoppers is as uncertain as their differences or their own errors say") {
  CHECK(mean_discharge({{.rate = 2.0, .error = 0.1}}).error == Approx(0.1));
  const Discharge apart = mean_discharge({{.rate = 1.0, .error = 0.0}, {.rate = 2.0, .error = 0.0}, {3.0, 0.0}});
  CHECK(apart.rate == Approx(2.0));
  CHECK(apart.error == Approx(std::sqrt(1.0 / 3.0)));  // 1 the standard deviation
  const Discharge alike = mean_discharge({{.rate = 2.0, .error = 0.3}, {.rate = 2.0, .error = 0.4}});
  CHECK(alike.error == Approx(0.25));
}

TEST_CASE("The angle of a cone comes from its medians, whatever lies far away") {
  Random random(7);
  const double height = 0.02, radius = 0.05;
  std::vector<Vec3> centroids;
  constexpr int grains = 40000;
  while (centroids.size() < grains) {
    const double x = random.uniform(-radius, radius), y = random.uniform(-radius, radius),
                 z = random.uniform(0.0, height);
    if (z < height * (1.0 - std::hypot(x, y) / radius)) centroids.emplace_back(x, y, z);
  }
  // The medians of so many scatter by half a per cent.
  CHECK(cone_angle(centroids) == Approx(std::atan2(height, radius)).epsilon(0.02));
  for (int i = 0; i < grains / 100; ++i) centroids.emplace_back(1.0, 0.0, 0.002);
  CHECK(cone_angle(centroids) == Approx(std::atan2(height, radius)).epsilon(0.04));
  CHECK_THROWS_AS(cone_angle({}), InputError);
}

TEST_CASE("Angles of heaps have a mean and its error, and rise only if every step does") {
  const HeapAngle mean = mean_angle({0.2, 0.3, 0.4});
  CHECK(mean.mean == Approx(0.3));
  CHECK(mean.error == Approx(0.1 / std::sqrt(3.0)));
  CHECK(mean_angle({0.2}).error == 0.0);
  HeapSeries series{.name = "", .values = {1.0, 2.0, 3.0}, .angles = {{0.2, 0.0}, {0.3, 0.0}, {0.4, 0.0}}};
  CHECK(series.rises());
  series.angles[2].mean = 0.25;
  CHECK_FALSE(series.rises());
}

TEST_CASE("A few dozen grains without friction spread wider than with") {
  const auto angle = [](double friction) {
    return heap_angle({.friction = friction, .exponent = 2.0, .seed = 1, .grains = 48});
  };
  CHECK(angle(0.6) > angle(0.0) + 0.02);
}
