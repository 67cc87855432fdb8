#include "osculate/mechanics/linear_spring_dashpot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mechanics/require.hpp"

namespace osculate::linear_spring_dashpot {
namespace {

constexpr const char* here = "linear_spring_dashpot";

/// ω_0 times the time to the largest overlap: arccos ζ/(1 − ζ²)^{1/2}, through the half-angle, so that it stays smooth
/// at ζ = 1.
double time_to_turn(double damping_ratio) {
  const double square = 0.5 * (1.0 - damping_ratio);
  const double t = std::sqrt(std::fabs(square));
  if (t == 0.0) return 1.0;
  return (square > 0.0 ? std::asin(t) : std::asinh(t)) / (t * std::sqrt(1.0 - square));
}

}  // namespace

void validate(const Model& model) {
  require_positive(here, "stiffness", model.stiffness, "[N/m]");
  require_not_negative(here, "damping", model.damping, "[N s/m]");
}

double force(const Model& model, double overlap, double rate, Attraction attraction) {
  if (!(overlap > 0.0)) return 0.0;
  const double total = model.stiffness * overlap + model.damping * rate;
  return attraction == Attraction::cut_off ? std::max(total, 0.0) : total;
}

double damping_ratio(const Model& model, double mass) {
  return 0.5 * model.damping / std::sqrt(model.stiffness * mass);
}

double overlap_decrement(double damping_ratio) {
  return damping_ratio * time_to_turn(damping_ratio);
}

double damping_ratio_for(double restitution, Attraction attraction) {
  require_restitution(here, restitution);
  const double loss = -std::log(restitution);
  if (attraction == Attraction::allowed) return loss / std::hypot(std::numbers::pi, loss);
  // ζ g grows with ζ; ε > (2ζ)^{−2} bounds it. Halved to the last digit, at set-up.
  double low = 0.0, high = 1.0 / std::sqrt(restitution);
  for (double middle = 0.5 * high; low < middle && middle < high; middle = 0.5 * (low + high))
    (2.0 * overlap_decrement(middle) < loss ? low : high) = middle;
  return high * (loss > 0.0 ? 1.0 : 0.0);
}

Impact impact(const Model& model, double mass, double speed, Attraction attraction) {
  validate(model);
  require_positive(here, "effective mass", mass, "[kg]");
  require_positive(here, "speed", speed, "[m/s]");
  const double frequency = std::sqrt(model.stiffness / mass), ratio = damping_ratio(model, mass);
  const double largest = speed / frequency * std::exp(-overlap_decrement(ratio));
  if (attraction == Attraction::cut_off)
    return {.duration = 2.0 * time_to_turn(ratio) / frequency,
            .largest_overlap = largest,
            .restitution = std::exp(-2.0 * overlap_decrement(ratio))};
  if (ratio >= 1.0)
    return {.duration = std::numeric_limits<double>::infinity(), .largest_overlap = largest, .restitution = 0.0};
  const double damped = std::sqrt((1.0 - ratio) * (1.0 + ratio));
  return {.duration = std::numbers::pi / (frequency * damped),
          .largest_overlap = largest,
          .restitution = std::exp(-std::numbers::pi * ratio / damped)};
}

Model matched(const ImpactPair& pair, double speed, double restitution, Matching matching, Attraction attraction) {
  const Impact elastic = hertz_impact::impact(pair, speed);
  const double ratio = damping_ratio_for(restitution, attraction);
  double frequency = speed / elastic.largest_overlap;  // of equal strain energy
  if (matching == Matching::largest_overlap) frequency *= std::exp(-overlap_decrement(ratio));
  if (matching == Matching::duration) {
    // At ω_0 = 1 rad/s the impact lasts as many seconds as it has radians.
    const Impact unit =
        impact({.stiffness = pair.mass, .damping = 2.0 * ratio * pair.mass}, pair.mass, 1.0, attraction);
    frequency = unit.duration / elastic.duration;
  }
  return {.stiffness = pair.mass * frequency * frequency, .damping = 2.0 * ratio * pair.mass * frequency};
}

}  // namespace osculate::linear_spring_dashpot
