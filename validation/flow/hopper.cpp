#include "validation/flow/hopper.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "osculate/core/error.hpp"
#include "osculate/dynamics/insertion.hpp"
#include "osculate/dynamics/simulation.hpp"
#include "validation/flow/grains.hpp"

namespace osculate::validation {
namespace {

constexpr double beverloo_k = 1.4;  // [BLV61]
constexpr double slot_exponent = 1.5;

const Ellipsoid grain{.half_axes = {3e-3, 3e-3, 2e-3}};
constexpr double depth = 20e-3;   // m, of the hopper and so the length of the slot
constexpr double friction = 0.3;  // of grains, wedge and gate; the bin's upright walls have none

constexpr double steepness = std::numbers::pi / 3.0;  // of the wedge
constexpr double usual_gravity = 9.81;                // m/s²
constexpr double rest = 0.2;                          // s: after that grains at usual gravity have come to rest
constexpr double fall = 0.06;                         // m, from the slot to the floor
constexpr double gate_speed = 2.0;                    // m/s: the gate is away before a grain reaches it
constexpr double below = -8e-3;                       // m: what is lower has left the slot
constexpr double between_looks = 1e-3;                // s
constexpr double longest_rest = 0.5;                  // s

enum Materials : std::int32_t { rough, smooth };

/// The wedge: a plate on either side whose nearest points are half the slot from the middle and whose lowest are at
/// z = 0.
void add_plates(Setup& setup, double width) {
  constexpr double half_thickness = 3e-3, bulge = 8e-3;
  const double reach = 0.5 * (hopper_bin_width - width) + 2.0 * half_thickness;
  const Superquadric plate{.half_axes = {0.5 * reach / std::cos(steepness), 0.5 * depth + bulge, half_thickness},
                           .exponents = {8.0, 8.0}};
  const auto shape = static_cast<std::int32_t>(setup.shapes.size());
  setup.shapes.emplace_back(plate);
  for (const double side : {1.0, -1.0}) {
    const Quat turn(Eigen::AngleAxisd(-side * steepness, Vec3::UnitY()));
    const double inwards = support(plate, turn.conjugate() * Vec3(-side, 0.0, 0.0)).value,
                 downwards = support(plate, turn.conjugate() * -Vec3::UnitZ()).value;
    setup.bodies.push_back({.shape = shape,
                            .material = rough,
                            .motion = 0,
                            .pose = {Vec3(side * (0.5 * width + inwards), 0.0, downwards), turn}});
  }
}

void add_gate(Setup& setup, double width, double opening) {
  constexpr double half_thickness = 2e-3, overhang = 8e-3;
  setup.bodies.push_back({.shape = static_cast<std::int32_t>(setup.shapes.size()),
                          .material = rough,
                          .motion = static_cast<std::int32_t>(setup.motions.size()),
                          .pose = {Vec3(0.0, 0.0, -1.2 * half_thickness), Quat::Identity()}});
  setup.shapes.emplace_back(Superquadric{.half_axes = {0.5 * width + overhang, 0.5 * depth + overhang, half_thickness},
                                         .exponents = {8.0, 8.0}});
  setup.motions.emplace_back(Translation{.velocity = Vec3(0.0, 0.0, -gate_speed),
                                         .begin = opening,
                                         .end = opening + (fall + 4.0 * half_thickness) / gate_speed});
}

double opening_of(const HopperCase& hopper) {
  return rest * std::sqrt(usual_gravity / hopper.gravity);
}

Setup setup_of(const HopperCase& hopper) {
  Setup setup;
  setup.gravity = Vec3(0.0, 0.0, -hopper.gravity);
  setup.shapes = {grain, HalfSpace{}};
  setup.materials = {{.name = "rough", .elastic = soft, .density = grain_density},
                     {.name = "smooth", .elastic = soft, .density = grain_density}};
  setup.interactions = {{rough, rough, grain_law(friction)}, {rough, smooth, grain_law(0.0)}};
  setup.motions = {Fixed{}};
  constexpr std::int32_t half_space = 1;
  for (const double side : {1.0, -1.0}) {
    setup.bodies.push_back(fixed_plane(Vec3(0.0, side * 0.5 * depth, 0.0), Vec3(0.0, -side, 0.0), half_space, smooth));
    setup.bodies.push_back(
        fixed_plane(Vec3(side * 0.5 * hopper_bin_width, 0.0, 0.0), Vec3(-side, 0.0, 0.0), half_space, smooth));
  }
  setup.bodies.push_back(fixed_plane(Vec3(0.0, 0.0, -fall), Vec3::UnitZ(), half_space, rough));
  add_plates(setup, hopper.width);
  add_gate(setup, hopper.width, opening_of(hopper));

  constexpr double loose_fraction = 0.27, margin = 3e-3, throw_speed = 0.3;
  // Between plates and bin no grain finds room from here on.
  constexpr double lower_end = 15e-3;
  const double low = 0.5 * (hopper_bin_width - hopper.width) * std::tan(steepness) - lower_end;
  const double height =
      static_cast<double>(hopper.particles) * body_shape(grain).volume / (loose_fraction * hopper_bin_width * depth);
  insert_randomly(setup, {.region = BoxRegion{.lower = {-0.5 * hopper_bin_width, -0.5 * depth, low},
                                              .upper = {0.5 * hopper_bin_width, 0.5 * depth, low + height + margin}},
                          .kinds = {{.shape = 0, .material = rough}},
                          .count = hopper.particles,
                          .seed = hopper.seed,
                          .velocity = Vec3(0.0, 0.0, -throw_speed)});
  setup.time_step = flow_time_step(setup);
  return setup;
}

double mean_overlap(const Simulation& simulation) {
  double sum = 0.0, count = 0.0;
  for (const Contact& contact : simulation.contacts()) {
    if (!simulation.bodies().is_free(static_cast<std::size_t>(contact.body_1)) ||
        !simulation.bodies().is_free(static_cast<std::size_t>(contact.body_2)))
      continue;
    sum += contact.overlap;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

void look(const Simulation& simulation, double opening, Outflow& out) {
  const Bodies& bodies = simulation.bodies();
  double left = 0.0;
  std::vector<double> heights;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.is_free(i)) continue;
    const double z = bodies.position[i].z();
    if (z < below)
      left += bodies.mass[i];
    else
      heights.push_back(z);
  }
  constexpr double filling = 0.95;
  const auto surface = heights.begin() + static_cast<std::ptrdiff_t>(filling * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), surface, heights.end());
  out.times.push_back(simulation.time() - opening);
  out.masses.push_back(left);
  out.heights.push_back(surface == heights.end() ? 0.0 : *surface);
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

}  // namespace

double hopper_grain_diameter() {
  return 2.0 * body_shape(grain).volume_radius;
}

Outflow outflow(const HopperCase& hopper, const std::function<void(double)>& done) {
  const double opening = opening_of(hopper);
  Simulation simulation(setup_of(hopper));
  const double step = simulation.setup().time_step;
  const auto steps = static_cast<std::uint64_t>(std::max(1.0, std::round(between_looks / step)));
  constexpr double settling_share = 0.4;  // of the work
  while (simulation.time() < opening) {
    simulation.advance(steps);
    if (done) done(settling_share * std::min(1.0, simulation.time() / opening));
  }
  Outflow out;
  out.overlap = mean_overlap(simulation);
  for (std::size_t i = 0; i < simulation.bodies().size(); ++i)
    if (simulation.bodies().is_free(i)) out.total += simulation.bodies().mass[i];
  look(simulation, opening, out);
  double latest = out.times.back();
  while (out.heights.back() > hopper_bin_width) {
    simulation.advance(steps);
    look(simulation, opening, out);
    const std::size_t last = out.times.size() - 1;
    if (out.masses[last] > out.masses[last - 1]) latest = out.times[last];
    if (out.times[last] > latest + longest_rest)
      throw std::runtime_error(fmt::format("a slot of {:.3g} mm is clogged", 1e3 * hopper.width));
    if (done) {
      const double part = (out.heights[0] - out.heights[last]) / (out.heights[0] - hopper_bin_width);
      done(settling_share + (1.0 - settling_share) * std::clamp(part, 0.0, 1.0));
    }
  }
  return out;
}

Discharge steady_discharge(const Outflow& out) {
  constexpr double first = 0.1;
  std::vector<double> times, masses;
  for (std::size_t i = 0; i < out.times.size(); ++i) {
    if (out.masses[i] < first * out.total) continue;
    times.push_back(out.times[i]);
    masses.push_back(out.masses[i]);
    if (out.heights[i] <= hopper_bin_width) break;
  }
  constexpr std::size_t parts = 4, fewest_looks = 5 * parts;
  if (times.size() < fewest_looks)
    throw std::runtime_error(fmt::format("the flow is steady for {} ms only: too few particles", times.size()));
  Discharge result{.rate = line_through(times, masses).slope, .error = 0.0};
  double squares = 0.0;
  for (std::size_t p = 0; p < parts; ++p) {
    const std::size_t begin = p * (times.size() - 1) / parts, end = (p + 1) * (times.size() - 1) / parts;
    const double rate = (masses[end] - masses[begin]) / (times[end] - times[begin]);
    squares += (rate - result.rate) * (rate - result.rate);
  }
  result.error = std::sqrt(squares / static_cast<double>(parts * (parts - 1)));
  return result;
}

Discharge mean_discharge(const std::vector<Discharge>& discharges) {
  const auto count = static_cast<double>(discharges.size());
  double sum = 0.0, own = 0.0, differences = 0.0;
  for (const Discharge& one : discharges) sum += one.rate, own += one.error * one.error;
  const double mean = sum / count;
  for (const Discharge& one : discharges) differences += (one.rate - mean) * (one.rate - mean);
  const double between = discharges.size() > 1 ? differences / (count * (count - 1.0)) : 0.0;
  return {.rate = mean, .error = std::sqrt(std::max(own / (count * count), between))};
}

BeverlooFit beverloo_fit(const std::vector<double>& widths, const std::vector<Discharge>& discharges, double diameter) {
  constexpr std::size_t fewest = 3;
  if (widths.size() < fewest || widths.size() != discharges.size())
    throw InputError("Beverloo's law", fmt::format("{} widths", widths.size()), "three at least, a discharge each");
  std::vector<double> roots, log_widths, log_rates;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double free_width = widths[i] - beverloo_k * diameter;
    if (!(free_width > 0.0))
      throw InputError("Beverloo's law", fmt::format("a slot of {} m", widths[i]), "one above 1.4 d");
    roots.push_back(std::pow(discharges[i].rate, 1.0 / slot_exponent));
    log_widths.push_back(std::log(free_width));
    log_rates.push_back(std::log(discharges[i].rate));
  }
  const Line line = line_through(widths, roots);
  // k and the exponent are linear in small changes of the rates.
  const auto mean_of = [](const std::vector<double>& values) {
    return std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
  };
  const auto squares_of = [](const std::vector<double>& values, double mean) {
    return std::transform_reduce(values.begin(), values.end(), 0.0, std::plus<>(),
                                 [mean](double value) { return (value - mean) * (value - mean); });
  };
  const double zero = -line.intercept / line.slope, mean = mean_of(widths), log_mean = mean_of(log_widths);
  const double squares = squares_of(widths, mean), log_squares = squares_of(log_widths, log_mean);
  double zero_variance = 0.0, exponent_variance = 0.0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double error = discharges[i].error / discharges[i].rate;
    const double share = 1.0 / static_cast<double>(widths.size()) + (zero - mean) * (widths[i] - mean) / squares;
    const double log_share = (log_widths[i] - log_mean) / log_squares;
    zero_variance += std::pow(share * roots[i] / slot_exponent * error / line.slope, 2.0);
    exponent_variance += std::pow(log_share * error, 2.0);
  }
  return {.k = zero / diameter,
          .k_error = std::sqrt(zero_variance) / diameter,
          .scale = std::pow(line.slope, slot_exponent),
          .correlation = line.correlation,
          .exponent = line_through(log_widths, log_rates).slope,
          .exponent_error = std::sqrt(exponent_variance)};
}

double beverloo_rate(const BeverlooFit& fit, double diameter, double width) {
  return fit.scale * std::pow(std::max(width - fit.k * diameter, 0.0), slot_exponent);
}

}  // namespace osculate::validation
