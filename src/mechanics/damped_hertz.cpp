#include "osculate/mechanics/damped_hertz.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mechanics/require.hpp"
#include "osculate/mechanics/linear_spring_dashpot.hpp"

namespace osculate::damped_hertz {
namespace {

constexpr const char* here = "damped_hertz";

/// ∫ f(τ) dτ over [0, end] by the double-exponential rule: ends where f ∝ τ^{−1/5} do no harm. `f` is given the
/// distance from the nearer end and which end that is, so that no digit is lost there.
enum class End { first, last };
template <class F>
double integrate(double end, const F& f) {
  constexpr double step = 1.0 / 32.0;
  constexpr int points = 160;
  double sum = 0.0;
  for (int i = -points; i <= points; ++i) {
    const double s = step * i;
    const double t = 0.5 * std::numbers::pi * std::sinh(s);
    const double weight = 0.5 * std::numbers::pi * std::cosh(s) / (std::cosh(t) * std::cosh(t));
    const double distance = end / (1.0 + std::exp(2.0 * std::fabs(t)));
    if (distance > 0.0) sum += weight * f(distance, t < 0.0 ? End::first : End::last);
  }
  return 0.5 * end * step * sum;
}

Impact tsuji_impact(const Model& model, double mass, double speed, Attraction attraction) {
  // z = δ^{5/4}: z″ + 2ζω z′ + ω² z = 0 in τ, with ω² = 5 k_H/(4 m) and z′(0) = 5 v/4.
  const linear_spring_dashpot::Model oscillator{.stiffness = 1.25 * model.stiffness, .damping = model.damping};
  const Impact linear = linear_spring_dashpot::impact(oscillator, mass, 1.25 * speed, attraction);
  const double frequency = std::sqrt(oscillator.stiffness / mass);
  const double ratio = linear_spring_dashpot::damping_ratio(oscillator, mass);
  Impact impact{.duration = linear.duration,
                .largest_overlap = std::pow(linear.largest_overlap, 0.8),
                .restitution = linear.restitution};
  if (!std::isfinite(linear.duration)) return impact;
  const double square = 1.0 - ratio * ratio, damped = frequency * std::sqrt(std::fabs(square));
  const auto swing = [&](double tau) {
    const double angle = damped * tau;
    return angle == 0.0 ? tau : tau * (square > 0.0 ? std::sin(angle) : std::sinh(angle)) / angle;
  };
  impact.duration = integrate(linear.duration, [&](double distance, End end) {
    const double tau = end == End::first ? distance : linear.duration - distance;
    // At zero overlap the swing returns to zero as it left it.
    const bool mirrored = end == End::last && attraction == Attraction::allowed;
    const double z = 1.25 * speed * std::exp(-ratio * frequency * tau) * swing(mirrored ? distance : tau);
    return std::pow(z, -0.2);
  });
  return impact;
}

/// y = x^{1/2} makes the right-hand sides smooth at the touch: with s = dx/dt, x = y², and time replaced by σ,
/// dt = y dσ:  dy/dσ = s/2,  ds/dσ = −y (β y s + y³),  dt/dσ = y.
using State = std::array<double, 3>;

State slope(const State& state, double damping) {
  const double y = state[0], s = state[1];
  return {0.5 * s, -y * y * (damping * s + y * y), y};
}

State advanced(const State& state, double damping, double step) {
  const auto at = [&](const State& k, double part) {
    return State{state[0] + part * k[0], state[1] + part * k[1], state[2] + part * k[2]};
  };
  const State k1 = slope(state, damping), k2 = slope(at(k1, 0.5 * step), damping),
              k3 = slope(at(k2, 0.5 * step), damping), k4 = slope(at(k3, step), damping);
  State next = state;
  for (std::size_t i = 0; i < 3; ++i) next[i] += step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  return next;
}

/// Impact of x″ + β x^{1/2} x′ + x^{3/2} = 0 from x = 0, x′ = 1. Classical Runge–Kutta with a step that leaves an error
/// of 1e-12; the turn and the end are found by halving the step in which they lie.
Impact viscoelastic_impact(double damping, Attraction attraction) {
  const double step = 1.0 / (500.0 * (1.0 + damping));
  const auto run = [&](State state, const auto& is_over) {
    State next = advanced(state, damping, step);
    while (!is_over(next)) {
      state = next;
      next = advanced(state, damping, step);
    }
    double low = 0.0, high = step;
    for (double middle = 0.5 * high; low < middle && middle < high; middle = 0.5 * (low + high))
      (is_over(advanced(state, damping, middle)) ? high : low) = middle;
    return advanced(state, damping, high);
  };
  const State turn = run({0.0, 1.0, 0.0}, [](const State& state) { return state[1] <= 0.0; });
  const State end = run(turn, [&](const State& state) {
    // The force is β x^{1/2} x′ + x^{3/2} = y (β s + y²).
    return state[0] <= 0.0 || (attraction == Attraction::cut_off && damping * state[1] + state[0] * state[0] <= 0.0);
  });
  return {.duration = end[2], .largest_overlap = turn[0] * turn[0], .restitution = -end[1]};
}

/// β = c k_H^{−3/5} m^{−2/5} v^{1/5}, and the units of length and time that bring it out.
struct Units {
  double damping, length, time;
};

Units units_of(const Model& model, double mass, double speed) {
  const double length = std::pow(mass * speed * speed / model.stiffness, 0.4);
  const double time = length / speed;
  return {model.damping * std::sqrt(length) * time / mass, length, time};
}

/// Beyond this β the rebound is slower than a ten-thousandth of the approach.
constexpr double heaviest_damping = 1e3;

}  // namespace

void validate(const Model& model) {
  require_positive(here, "Hertz coefficient", model.stiffness, "[N/m^1.5]");
  require_not_negative(here, "damping", model.damping, "");
}

double force(const Model& model, double overlap, double rate, Attraction attraction) {
  if (!(overlap > 0.0)) return 0.0;
  const double root = std::sqrt(overlap);
  const double dashpot = model.damping * (model.kind == Damping::half ? root : std::sqrt(root));
  const double total = model.stiffness * overlap * root + dashpot * rate;
  return attraction == Attraction::cut_off ? std::max(total, 0.0) : total;
}

double tsuji_factor(double restitution, Attraction attraction) {
  return std::sqrt(5.0) * linear_spring_dashpot::damping_ratio_for(restitution, attraction);
}

Model tsuji(const ImpactPair& pair, double restitution, Attraction attraction) {
  validate(pair);
  const double stiffness = pair.hertz_coefficient();
  return {.stiffness = stiffness,
          .damping = tsuji_factor(restitution, attraction) * std::sqrt(pair.mass * stiffness),
          .kind = Damping::quarter};
}

Model kuwabara_kono(const ImpactPair& pair, double damping) {
  validate(pair);
  const Model model{.stiffness = pair.hertz_coefficient(), .damping = damping, .kind = Damping::half};
  validate(model);
  return model;
}

Model brilliantov(const ImpactPair& pair, double dissipative_time) {
  return kuwabara_kono(pair, 1.5 * dissipative_time * pair.hertz_coefficient());
}

Impact impact(const Model& model, double mass, double speed, Attraction attraction) {
  validate(model);
  require_positive(here, "effective mass", mass, "[kg]");
  require_positive(here, "speed", speed, "[m/s]");
  if (model.kind == Damping::quarter) return tsuji_impact(model, mass, speed, attraction);
  const Units units = units_of(model, mass, speed);
  if (!(units.damping <= heaviest_damping))
    throw InputError(here, "dimensionless damping " + std::to_string(units.damping),
                     "at most " + std::to_string(heaviest_damping));
  const Impact impact = viscoelastic_impact(units.damping, attraction);
  return {.duration = impact.duration * units.time,
          .largest_overlap = impact.largest_overlap * units.length,
          .restitution = impact.restitution};
}

Model viscoelastic_with(const ImpactPair& pair, double speed, double restitution, Attraction attraction) {
  require_positive(here, "speed", speed, "[m/s]");
  require_restitution(here, restitution);
  double low = 0.0, high = 1.0;
  while (viscoelastic_impact(high, attraction).restitution > restitution) {
    if (high > heaviest_damping)
      throw InputError(here, "restitution " + std::to_string(restitution), "a value that the model reaches");
    high *= 2.0;
  }
  constexpr int halvings = 48;
  for (int i = 0; restitution < 1.0 && i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (viscoelastic_impact(middle, attraction).restitution > restitution ? low : high) = middle;
  }
  const Units unit = units_of(kuwabara_kono(pair, 1.0), pair.mass, speed);
  return kuwabara_kono(pair, low / unit.damping);
}

double viscoelastic_loss_first_order(const Model& model, double mass, double speed) {
  const double beta_function = std::tgamma(0.6) * std::tgamma(1.5) / std::tgamma(2.1);
  return 0.8 * std::pow(1.25, 0.6) * beta_function * units_of(model, mass, speed).damping;
}

}  // namespace osculate::damped_hertz
