#include "osculate/mechanics/greenwood_williamson.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace osculate::greenwood_williamson {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double inverse_root_two_pi = 0.3989422804014327;
constexpr const char* place = "greenwood_williamson";

void require_finite(const char* what, double value, const char* unit) {
  if (!std::isfinite(value))
    throw InputError(place, std::string(what) + " " + std::to_string(value), std::string("a finite value") + unit);
}

void require_positive(const char* what, double value, const char* unit) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw InputError(place, std::string(what) + " " + std::to_string(value),
                     std::string("a positive, finite value ") + unit);
}

/// One term of the layer's pressure with its slope by h.
struct LayerPressure {
  double value, slope;
};

LayerPressure layer_pressure(const Roughness& roughness, double modulus, const HeightIntegrals& integrals) {
  const double unit = roughness.density * asperity_force(roughness, modulus, roughness.deviation);
  return {unit * integrals.three_halves, -1.5 * unit * integrals.half};
}

/// Hertz's mean pressure, proportional to the root of the overlap.
double mean_pressure(const hertz::Contact& contact) {
  return 2.0 / 3.0 * contact.peak_pressure;
}

}  // namespace

double height_density(double height) {
  return inverse_root_two_pi * std::exp(-0.5 * height * height);
}

double mean_compression(double h) {
  require_finite("separation h", h, "");
  return std::max(0.0, height_density(h) - 0.5 * h * std::erfc(h / std::sqrt(2.0)));
}

HeightIntegrals height_integrals(double h) {
  require_finite("separation h", h, "");
  // F_n = ∫ t^{2n+1} φ(t² + h) dt over all t, an entire, even integrand that dies like exp(−t⁴/2): the trapezoidal rule
  // gains digits exponentially. Range: beyond t² + h = z_last the density has fallen by e^{-45} from its largest.
  constexpr double nodes_per_unit = 7.0, tail = 90.0, far_below = 10.0;
  const double step = 1.0 / (nodes_per_unit * std::sqrt(1.0 + std::abs(h)));
  const double last = std::sqrt(std::sqrt(std::pow(std::max(h, 0.0), 2) + tail) - h);
  const double first = std::sqrt(std::max(0.0, -h - far_below));
  double half = 0.0, three_halves = 0.0;
  for (double i = std::max(1.0, std::floor(first / step)); i * step <= last; ++i) {
    const double w = (i * step) * (i * step);
    const double density = height_density(w + h);
    half += w * density;
    three_halves += w * w * density;
  }
  return {.zero = 0.5 * std::erfc(h / std::sqrt(2.0)),
          .half = 2.0 * step * half,
          .one = mean_compression(h),
          .three_halves = 2.0 * step * three_halves};
}

void validate(const Roughness& roughness) {
  require_positive("density of asperities", roughness.density, "[1/m2]");
  require_positive("radius of asperities", roughness.radius, "[m]");
  require_positive("deviation of heights", roughness.deviation, "[m]");
}

double asperity_force(const Roughness& roughness, double modulus, double compression) {
  const double w = std::max(compression, 0.0);
  return 4.0 / 3.0 * modulus * std::sqrt(roughness.radius * w) * w;
}

double asperity_area(const Roughness& roughness, double compression) {
  return pi * roughness.radius * std::max(compression, 0.0);
}

double pressure(const Roughness& roughness, double modulus, double h) {
  return layer_pressure(roughness, modulus, height_integrals(h)).value;
}

double area_fraction(const Roughness& roughness, double h) {
  return roughness.density * asperity_area(roughness, roughness.deviation) * mean_compression(h);
}

Patch patch_at(const Roughness& roughness, double modulus, double nominal_area, double h) {
  validate(roughness);
  require_positive("effective modulus", modulus, "[Pa]");
  if (!(nominal_area >= 0.0) || !std::isfinite(nominal_area))
    throw InputError(place, "nominal area " + std::to_string(nominal_area), "a value >= 0 [m2]");
  const auto integrals = height_integrals(h);
  const auto layer = layer_pressure(roughness, modulus, integrals);
  return {.touching = roughness.density * nominal_area * integrals.zero,
          .force = nominal_area * layer.value,
          .real_area = nominal_area * area_fraction(roughness, h),
          .stiffness = -nominal_area * layer.slope / roughness.deviation};
}

Contact contact(const ContactEllipse& ellipse, double modulus, const Roughness& roughness, double overlap) {
  validate(roughness);
  require_positive("effective modulus", modulus, "[Pa]");
  require_finite("overlap", overlap, " [m]");
  const double sigma = roughness.deviation;
  const auto layer_at = [&](double depth) {
    return layer_pressure(roughness, modulus, height_integrals((depth - overlap) / sigma));
  };
  const auto bulk_at = [&](double depth) { return hertz::contact(ellipse, modulus, depth, ellipse.R_c); };

  // ln(layer/bulk) is a falling, concave function of ln δ_b, δ_b being the only small number that keeps its digits when
  // few asperities touch. Newton's steps from the right of the root stay there.
  double depth = overlap + largest_separation * sigma;
  if (!(depth > 0.0) || layer_at(depth).value >= mean_pressure(bulk_at(depth))) return {};
  for (int step = 0; step < 200; ++step) {
    const auto layer = layer_at(depth);
    const double mismatch = std::log(layer.value / mean_pressure(bulk_at(depth)));
    const double slope = layer.slope / layer.value * depth / sigma - 0.5;
    const double change = std::clamp(-mismatch / slope, -30.0, 30.0);
    depth *= std::exp(change);
    if (std::abs(change) < 1e-15) break;
  }
  const auto layer = layer_at(depth);
  const auto bulk = bulk_at(depth);
  // dh/dδ from layer(h) = bulk(δ + σh), then dF/dδ = dF/dδ_b (1 + σ dh/dδ).
  const double bulk_slope = 0.5 * mean_pressure(bulk) / depth;
  const double share = -layer.slope / (sigma * bulk_slope - layer.slope);
  return {.force = bulk.force,
          .separation = (depth - overlap) / sigma,
          .bulk_overlap = depth,
          .a_c = bulk.a_c,
          .b_c = bulk.b_c,
          .real_area = pi * bulk.a_c * bulk.b_c * area_fraction(roughness, (depth - overlap) / sigma),
          .stiffness = bulk.stiffness * share};
}

}  // namespace osculate::greenwood_williamson
