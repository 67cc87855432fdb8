#include "validation/flow/flow_study.hpp"

#include <algorithm>
#include <cmath>

namespace osculate::validation {
namespace {

struct Grain {
  std::string name, shape;
};
/// Of equal volume, nearly: d = 5.24 mm and 5.2 mm.
const std::vector<Grain>& grains() {
  static const std::vector<Grain> all{
      {"lentil, half-axes 3 : 3 : 2", R"({kind = "ellipsoid", half_axes = [3, 3, 2]})"},
      {"rounded cube, n = 4", R"({kind = "superquadric", half_axes = [2.25, 2.25, 2.25], n = [4, 4]})"}};
  return all;
}
const std::vector<double> widths{0.018, 0.021, 0.024, 0.028};    // m
constexpr double gravity = 9.81, light_gravity = gravity / 4.0;  // m/s²
const std::vector<double> frictions{0.1, 0.3, 0.6}, exponents{2.0, 3.0, 5.0};
constexpr double usual_friction = 0.6, usual_exponent = 3.0;

/// Where one of several equal parts of the work is.
class Steps {
 public:
  Steps(std::size_t count, const std::function<void(double)>& done) : count_(static_cast<double>(count)), done_(done) {}
  void begin_next() { finished_ += 1.0; }
  std::function<void(double)> within() const {
    return [this](double part) {
      if (done_) done_((finished_ + part) / count_);
    };
  }

 private:
  double count_;
  const std::function<void(double)>& done_;
  double finished_ = 0.0;
};

DischargeSeries discharge_series(const Grain& grain, std::uint64_t particles, Steps& steps) {
  DischargeSeries series{.name = grain.name, .widths = widths, .discharges = {}, .fit = {}, .light_rate = 0.0};
  const auto at = [&](double width, double g) {
    const Discharge one =
        discharge({.shape = grain.shape, .width = width, .gravity = g, .particles = particles}, steps.within());
    steps.begin_next();
    return one;
  };
  for (const double width : widths) series.discharges.push_back(at(width, gravity));
  series.light_rate = at(widths.back(), light_gravity).rate;
  series.fit = beverloo_fit(series.widths, series.discharges);
  return series;
}

double mean_angle(double friction, double exponent, int heaps, Steps& steps) {
  double sum = 0.0;
  for (int seed = 1; seed <= heaps; ++seed) {
    sum += heap_angle({.friction = friction, .exponent = exponent, .seed = static_cast<std::uint64_t>(seed)},
                      steps.within());
    steps.begin_next();
  }
  return sum / heaps;
}

bool increases(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

}  // namespace

bool DischargeSeries::agrees() const {
  std::vector<double> rates;
  for (const Discharge& one : discharges) rates.push_back(one.rate);
  constexpr double exponent = 1.5, exponent_tolerance = 0.3, least_correlation = 0.99, largest_k = 3.5,
                   gravity_tolerance = 0.05;
  return increases(rates) && std::fabs(fit.exponent - exponent) <= exponent_tolerance &&
         fit.correlation >= least_correlation && fit.k > 0.0 && fit.k < largest_k &&
         std::fabs(gravity_ratio() - 0.5) <= gravity_tolerance;
}

bool HeapSeries::rises() const {
  return increases(angles);
}

FlowStudy flow_study(const FlowSettings& settings, const std::function<void(double)>& done) {
  const std::size_t kinds_of_heaps = frictions.size() + exponents.size() - 1;  // one is in both
  Steps steps(grains().size() * (widths.size() + 1) + kinds_of_heaps * static_cast<std::size_t>(settings.heaps), done);
  FlowStudy study;
  for (const Grain& grain : grains()) study.discharges.push_back(discharge_series(grain, settings.particles, steps));
  const auto angle = [&](double friction, double exponent) {
    return mean_angle(friction, exponent, settings.heaps, steps);
  };
  const double usual = angle(usual_friction, usual_exponent);
  HeapSeries by_friction{.name = "friction", .values = frictions, .angles = {}};
  for (const double friction : frictions)
    by_friction.angles.push_back(friction == usual_friction ? usual : angle(friction, usual_exponent));
  HeapSeries by_exponent{.name = "exponent n", .values = exponents, .angles = {}};
  for (const double exponent : exponents)
    by_exponent.angles.push_back(exponent == usual_exponent ? usual : angle(usual_friction, exponent));
  study.heaps = {by_friction, by_exponent};
  return study;
}

}  // namespace osculate::validation
