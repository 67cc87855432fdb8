#include "validation/flow/flow_study.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace osculate::validation {
namespace {

constexpr double gravity = 9.81, light_gravity = gravity / 4.0;  // m/s²
const std::vector<double> frictions{0.1, 0.3, 0.6}, exponents{2.0, 3.0, 5.0};
constexpr double usual_friction = 0.6, usual_exponent = 3.0;

bool increases(const std::vector<Discharge>& discharges) {
  return std::adjacent_find(discharges.begin(), discharges.end(), [](const Discharge& one, const Discharge& next) {
           return one.rate >= next.rate;
         }) == discharges.end();
}

/// @param flows  of each width, then of the widest at light gravity, so many alike one after another
DischargeSeries series_of(const std::vector<Outflow>& flows, std::size_t alike) {
  const auto mean_of = [&](std::size_t kind) {
    std::vector<Discharge> discharges;
    for (std::size_t i = kind * alike; i < (kind + 1) * alike; ++i) discharges.push_back(steady_discharge(flows[i]));
    return mean_discharge(discharges);
  };
  DischargeSeries series{.diameter = hopper_grain_diameter(),
                         .widths = slot_widths(),
                         .discharges = {},
                         .light = mean_of(slot_widths().size()),
                         .fit = {},
                         .overlap = 0.0};
  for (std::size_t i = 0; i < series.widths.size(); ++i) series.discharges.push_back(mean_of(i));
  for (const Outflow& flow : flows) series.overlap = std::max(series.overlap, flow.overlap);
  series.fit = beverloo_fit(series.widths, series.discharges, series.diameter);
  return series;
}

}  // namespace

const std::vector<double>& slot_widths() {
  static const std::vector<double> widths{0.018, 0.022, 0.027, 0.032};
  return widths;
}

Discharge DischargeSeries::gravity_ratio() const {
  const Discharge& usual = discharges.back();
  const double ratio = light.rate / usual.rate;
  return {.rate = ratio, .error = ratio * std::hypot(light.error / light.rate, usual.error / usual.rate)};
}

bool DischargeSeries::exponent_agrees() const {
  return fit.exponent >= expected::least_exponent && fit.exponent <= expected::most_exponent;
}

bool DischargeSeries::k_agrees() const {
  return fit.k >= expected::least_k && fit.k <= expected::most_k;
}

bool DischargeSeries::is_straight() const {
  return increases(discharges) && fit.correlation >= expected::least_correlation;
}

bool DischargeSeries::gravity_agrees() const {
  return std::fabs(gravity_ratio().rate - expected::gravity_ratio) <= expected::gravity_tolerance;
}

bool DischargeSeries::agrees() const {
  return exponent_agrees() && k_agrees() && is_straight() && gravity_agrees();
}

HeapAngle mean_angle(const std::vector<double>& angles) {
  const auto count = static_cast<double>(angles.size());
  const double mean = std::reduce(angles.begin(), angles.end()) / count;
  double squares = 0.0;
  for (const double angle : angles) squares += (angle - mean) * (angle - mean);
  return {.mean = mean, .error = angles.size() > 1 ? std::sqrt(squares / (count * (count - 1.0))) : 0.0};
}

bool HeapSeries::rises() const {
  return std::adjacent_find(angles.begin(), angles.end(), [](const HeapAngle& one, const HeapAngle& next) {
           return one.mean >= next.mean;
         }) == angles.end();
}

FlowStudy flow_study(const FlowSettings& settings, const Done& done) {
  std::vector<Case> jobs;
  std::vector<HopperCase> hoppers;
  const auto alike = static_cast<std::size_t>(settings.hoppers);
  const auto add_hoppers = [&](double width, double pull) {
    for (std::size_t seed = 1; seed <= alike; ++seed)
      hoppers.push_back({.width = width, .gravity = pull, .particles = settings.particles, .seed = seed});
  };
  for (const double width : slot_widths()) add_hoppers(width, gravity);
  add_hoppers(slot_widths().back(), light_gravity);
  std::vector<Outflow> flows(hoppers.size());
  for (std::size_t i = 0; i < hoppers.size(); ++i)
    jobs.emplace_back([&, i](const Done& told) { flows[i] = outflow(hoppers[i], told); });
  std::rotate(jobs.begin(), jobs.end() - settings.hoppers, jobs.end());  // the longest first

  struct Heaps {
    double friction, exponent;
    std::vector<double> angles;
  };
  std::vector<Heaps> heaps;
  for (const double friction : frictions) heaps.push_back({friction, usual_exponent, {}});
  for (const double exponent : exponents)
    if (exponent != usual_exponent) heaps.push_back({usual_friction, exponent, {}});
  const auto count = static_cast<std::size_t>(settings.heaps);
  for (Heaps& kind : heaps) {
    kind.angles.resize(count);
    for (std::size_t seed = 1; seed <= count; ++seed)
      jobs.emplace_back([&kind, seed](const Done& told) {
        kind.angles[seed - 1] = heap_angle({.friction = kind.friction, .exponent = kind.exponent, .seed = seed}, told);
      });
  }
  run_independent(jobs, settings.threads, done);

  const auto angle = [&](double friction, double exponent) {
    return mean_angle(std::find_if(heaps.begin(), heaps.end(), [&](const Heaps& kind) {
                        return kind.friction == friction && kind.exponent == exponent;
                      })->angles);
  };
  FlowStudy study{.discharge = series_of(flows, alike), .heaps = {}};
  HeapSeries by_friction{.name = "friction μ", .values = frictions, .angles = {}};
  for (const double friction : frictions) by_friction.angles.push_back(angle(friction, usual_exponent));
  HeapSeries by_exponent{.name = "exponent n", .values = exponents, .angles = {}};
  for (const double exponent : exponents) by_exponent.angles.push_back(angle(usual_friction, exponent));
  study.heaps = {by_friction, by_exponent};
  return study;
}

}  // namespace osculate::validation
