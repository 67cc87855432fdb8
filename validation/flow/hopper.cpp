#include "validation/flow/hopper.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/scene.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/simulation.hpp"
#include "validation/flow/scenes.hpp"

namespace osculate::validation {
namespace {

constexpr double beverloo_k = 1.4;  // [BLV61]
constexpr double slot_exponent = 1.5;
constexpr double opening = 0.3;            // s: grains that fall 0.3 m have come to rest
constexpr double below = -8e-3;            // m: what is lower has left the slot
constexpr double first = 0.2, last = 0.6;  // of the mass: between them the flow is steady
constexpr double between_looks = 1e-3;     // s
constexpr double longest_rest = 0.5;       // s

std::string scene_of(const HopperCase& hopper) {
  const double mm = 1e3 * hopper.width;
  const double plate = 27.6 + 0.5 * mm;  // mm: in the example 37.6 leaves a slot of 20
  const double filling = 36.0 + 0.2 * static_cast<double>(hopper.particles) + 12.0;  // mm: room to insert at random
  constexpr double fast_enough = 4.0;  // m/s: the gate is away before a grain reaches it
  std::string text =
      varied(hopper_scene(), {{R"(youngs_modulus = "5 MPa")", R"(youngs_modulus = "1 MPa")"},
                              {"gravity = [0, 0, -9.81]", fmt::format("gravity = [0, 0, {}]", -hopper.gravity)},
                              {R"({kind = "ellipsoid", half_axes = [3, 3, 2]})", hopper.shape},
                              {"position = [37.6, 0, 41.8]", fmt::format("position = [{}, 0, 41.8]", plate)},
                              {"point = [0, 0, -40]", "point = [0, 0, -140]"},
                              {"count = 250", fmt::format("count = {}", hopper.particles)},
                              {"upper = [26, 12, 84]", fmt::format("upper = [26, 12, {}]", filling)},
                              {"duration = \"0.5 s\"", "duration = \"10 s\"\nspeed = \"2 m/s\""}});
  text += fmt::format(
      "\n[[obstacles]]\nname = \"gate\"\nshape = {{kind = \"superquadric\", half_axes = [{}, 25, 2], n = [8, 8]}}\n"
      "position = [0, 0, -5.5]\nmotion = {{kind = \"translation\", velocity = [0, 0, {}], begin = {}, end = {}}}\n",
      0.5 * mm + 12.0, -fast_enough, opening, opening + 0.13 / fast_enough);
  return text;
}

struct Line {
  double slope, intercept, correlation;
};
Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto count = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / count;
    mean_y += y[i] / count;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  return {.slope = xy / xx, .intercept = mean_y - xy / xx * mean_x, .correlation = xy / std::sqrt(xx * yy)};
}

/// Mass over time, as it left.
struct Outflow {
  std::vector<double> times, masses;
};

Discharge rate_of(const Outflow& out, double diameter) {
  Discharge result{.rate = line_through(out.times, out.masses).slope, .error = 0.0, .diameter = diameter};
  constexpr std::size_t parts = 4;
  double squares = 0.0;
  for (std::size_t p = 0; p < parts; ++p) {
    const std::size_t begin = p * (out.times.size() - 1) / parts, end = (p + 1) * (out.times.size() - 1) / parts;
    const double rate = (out.masses[end] - out.masses[begin]) / (out.times[end] - out.times[begin]);
    squares += (rate - result.rate) * (rate - result.rate);
  }
  result.error = std::sqrt(squares / static_cast<double>(parts * (parts - 1)));
  return result;
}

}  // namespace

Discharge discharge(const HopperCase& hopper, const std::function<void(double)>& done) {
  const io::Scene scene = io::parse_scene(scene_of(hopper), "hopper.toml");
  Simulation simulation(scene.setup);
  const Bodies& bodies = simulation.bodies();
  double total = 0.0, diameter = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.is_free(i)) continue;
    total += bodies.mass[i];
    diameter = 2.0 * simulation.shapes()[static_cast<std::size_t>(bodies.shape[i])].volume_radius;
  }
  Outflow out;
  double latest = 0.0, latest_time = opening;
  for (;;) {
    simulation.advance(scene.steps_in(between_looks));
    double left = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (bodies.is_free(i) && bodies.position[i].z() < below) left += bodies.mass[i];
    const double time = simulation.time();
    if (left > latest) latest_time = time;
    latest = left;
    if (time > latest_time + longest_rest)
      throw std::runtime_error(fmt::format("a slot of {:.3g} mm is clogged", 1e3 * hopper.width));
    if (left >= last * total) break;
    if (left >= first * total) {
      out.times.push_back(time);
      out.masses.push_back(left);
    }
    if (done) done(std::min(0.4, 0.4 * time / opening) + 0.6 * left / (last * total));
  }
  constexpr std::size_t fewest_looks = 9;
  if (out.times.size() < fewest_looks)
    throw std::runtime_error(
        fmt::format("{} particles leave a slot of {:.3g} mm too fast", hopper.particles, 1e3 * hopper.width));
  return rate_of(out, diameter);
}

BeverlooFit beverloo_fit(const std::vector<double>& widths, const std::vector<Discharge>& discharges) {
  constexpr std::size_t fewest = 3;
  if (widths.size() < fewest || widths.size() != discharges.size())
    throw InputError("Beverloo's law", fmt::format("{} widths", widths.size()), "three at least, a discharge each");
  std::vector<double> roots, log_widths, log_rates;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double free_width = widths[i] - beverloo_k * discharges[i].diameter;
    if (!(free_width > 0.0))
      throw InputError("Beverloo's law", fmt::format("a slot of {} m", widths[i]), "one above 1.4 d");
    roots.push_back(std::pow(discharges[i].rate, 1.0 / slot_exponent));
    log_widths.push_back(std::log(free_width));
    log_rates.push_back(std::log(discharges[i].rate));
  }
  const Line line = line_through(widths, roots);
  return {.k = -line.intercept / line.slope / discharges[0].diameter,
          .scale = std::pow(line.slope, slot_exponent),
          .correlation = line.correlation,
          .exponent = line_through(log_widths, log_rates).slope};
}

double beverloo_rate(const BeverlooFit& fit, double diameter, double width) {
  return fit.scale * std::pow(std::max(width - fit.k * diameter, 0.0), slot_exponent);
}

}  // namespace osculate::validation
