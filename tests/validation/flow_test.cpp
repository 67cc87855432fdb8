#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "io/scene.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/random.hpp"
#include "validation/flow/flow_study.hpp"
#include "validation/flow/scenes.hpp"

using namespace osculate;
using namespace osculate::validation;

TEST_CASE("Rates by Beverloo's law give back its constant, its k and its exponent") {
  constexpr double d = 5e-3, k = 1.4, scale = 170.0;
  std::vector<double> widths;
  std::vector<Discharge> discharges;
  for (const double width : {0.02, 0.025, 0.03, 0.04}) {
    widths.push_back(width);
    discharges.push_back({.rate = scale * std::pow(width - k * d, 1.5), .error = 0.0, .diameter = d});
  }
  const BeverlooFit fit = beverloo_fit(widths, discharges);
  CHECK(fit.k == Approx(k));
  CHECK(fit.scale == Approx(scale));
  CHECK(fit.exponent == Approx(1.5));
  CHECK(fit.correlation == Approx(1.0));
  CHECK(beverloo_rate(fit, d, 0.03) == Approx(discharges[2].rate));
  CHECK(beverloo_rate(fit, d, 0.5 * d) == 0.0);
  CHECK_THROWS_AS(beverloo_fit({0.02, 0.03}, {discharges[0], discharges[1]}), InputError);
  CHECK_THROWS_AS(beverloo_fit({0.005, 0.025, 0.03, 0.04}, discharges), InputError);

  DischargeSeries series{
      .name = "", .widths = widths, .discharges = discharges, .fit = fit, .light_rate = 0.5 * discharges.back().rate};
  CHECK(series.agrees());
  series.light_rate = 0.6 * discharges.back().rate;
  CHECK_FALSE(series.agrees());
  series.light_rate = 0.5 * discharges.back().rate;
  std::swap(series.discharges[0].rate, series.discharges[1].rate);
  CHECK_FALSE(series.agrees());
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

TEST_CASE("A scene is varied only where the text stands once") {
  CHECK(varied("a = 1\nb = 2\n", {{"a = 1", "a = 3"}}) == "a = 3\nb = 2\n");
  CHECK_THROWS_AS(varied("a = 1\n", {{"b = 1", ""}}), InputError);
  CHECK_THROWS_AS(varied("a = 1\na = 1\n", {{"a = 1", ""}}), InputError);
}

TEST_CASE("A scene from text is the scene from its file") {
  const std::string file = OSCULATE_EXAMPLES_DIR "/scenes/hopper.toml";
  const io::Scene from_file = io::read_scene(file), from_text = io::parse_scene(hopper_scene(), "hopper.toml");
  CHECK(from_text.text == from_file.text);
  CHECK(from_text.setup.bodies.size() == from_file.setup.bodies.size());
  CHECK(from_text.setup.time_step == from_file.setup.time_step);
}

TEST_CASE("A few dozen grains without friction spread wider than with") {
  const auto angle = [](double friction) {
    return heap_angle({.friction = friction, .exponent = 2.0, .seed = 1, .grains = 48});
  };
  CHECK(angle(0.6) > angle(0.0) + 0.02);
}
