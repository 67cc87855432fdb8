#include "osculate/mechanics/jeng_wang.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mechanics/quadrature.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"
#include "osculate/mechanics/greenwood_williamson.hpp"

namespace osculate::jeng_wang {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr const char* place = "jeng_wang";

void require(bool good, const char* what, double value, const char* expected) {
  if (!good || !std::isfinite(value))
    throw InputError(place, std::string(what) + " " + std::to_string(value), expected);
}

/// ∫ f(w) g(w + h) dw over one regime, w in deviations, g falling like the density of heights. The range is cut where
/// the density has fallen by e^{-45}, and w = from + t² takes out the elastic law's root at its start.
template <class Function>
double over_heights(const Function& f, double h, double from, double to) {
  constexpr double tail = 90.0, tolerance = 1e-11;
  const double nearest = std::max(h + from, 0.0);
  const double last = std::min(to, std::sqrt(nearest * nearest + tail) - h);
  if (!(from < last)) return 0.0;
  const auto integrand = [&](double t) { return 2.0 * t * f(from + t * t); };
  const double end = std::sqrt(last - from);
  // A first pass for the size, which the tolerance is relative to.
  constexpr int pieces = 8;
  double size = 0.0;
  for (int i = 0; i < pieces; ++i)
    size += std::abs(quadrature::gauss_kronrod(integrand, end * i / pieces, end * (i + 1) / pieces).kronrod);
  double sum = 0.0;
  for (int i = 0; i < pieces; ++i)
    sum += quadrature::integrate(integrand, end * i / pieces, end * (i + 1) / pieces, tolerance * size / pieces);
  return sum;
}

/// Starred limits of the regimes: 0, δ_n1*, δ_n2*, ∞.
std::array<double, 4> limits_of(const Asperity& asperity, double deviation) {
  return {0.0, asperity.first_yield / deviation, asperity.full_plastic / deviation, 1e300};
}

void require_patch(double nominal_area, double h) {
  require(nominal_area >= 0.0, "nominal area", nominal_area, "a finite value >= 0 [m2]");
  require(true, "separation h", h, "a finite value");
}

double horner(const std::array<double, TaylorSeries::order + 1>& coefficients, double x) {
  double sum = 0.0;
  for (int n = TaylorSeries::order; n >= 0; --n) sum = sum * x + coefficients[static_cast<std::size_t>(n)];
  return sum;
}

}  // namespace

double radius_ratio(double e) {
  require(e >= 0.0 && e < 1.0, "eccentricity", e, "0 <= e < 1");
  const double complement = (1.0 - e) * (1.0 + e);
  const auto integrals = complete_elliptic(complement);
  return integrals.B / (complement * integrals.D);
}

void validate(const Surface& surface) {
  require(surface.density > 0.0, "density of asperities", surface.density, "a positive, finite value [1/m2]");
  require(surface.R_j > 0.0, "smaller summit radius", surface.R_j, "a positive, finite value [m]");
  require(surface.R_i >= surface.R_j, "larger summit radius", surface.R_i, "R_i >= R_j, finite [m]");
  require(surface.deviation > 0.0, "deviation of heights", surface.deviation, "a positive, finite value [m]");
  require(surface.modulus > 0.0, "effective modulus", surface.modulus, "a positive, finite value [Pa]");
  require(surface.hardness > 0.0, "hardness", surface.hardness, "a positive, finite value [Pa]");
  require(surface.yield_ratio > 0.0 && surface.yield_ratio < 1.0, "yield ratio", surface.yield_ratio, "0 < k < 1");
  require(surface.plastic_ratio > 1.0, "plastic ratio", surface.plastic_ratio, "a finite value > 1");
}

std::string_view name(Deformation deformation) {
  switch (deformation) {
    case Deformation::elastic:
      return "elastic";
    case Deformation::elastic_plastic:
      return "elastic-plastic";
    case Deformation::plastic:
      return "plastic";
  }
  return "unknown";
}

Asperity asperity(const Surface& surface) {
  validate(surface);
  const auto ellipse = contact_ellipse(surface.R_i, surface.R_j);
  Asperity result{.force_factor = 4.0 / 3.0 * surface.modulus * std::sqrt(ellipse.R_c) * ellipse.gamma(),
                  .area_factor = pi * ellipse.beta() * ellipse.R_c,
                  .plastic_factor = 2.0 * pi * std::sqrt(surface.R_i) * std::sqrt(surface.R_j),
                  .hardness = surface.hardness,
                  .yield_ratio = surface.yield_ratio,
                  .first_yield = 0.0,
                  .full_plastic = 0.0};
  const double root = surface.yield_ratio * surface.hardness * result.area_factor / result.force_factor;
  result.first_yield = root * root;
  result.full_plastic = surface.plastic_ratio * result.first_yield;
  return result;
}

Load load(const Asperity& asperity, double compression) {
  const double w = std::max(compression, 0.0);
  const double elastic_area = asperity.area_factor * w, plastic_area = asperity.plastic_factor * w;
  if (w <= asperity.first_yield) return {asperity.force_factor * w * std::sqrt(w), elastic_area, Deformation::elastic};
  if (w >= asperity.full_plastic) return {asperity.hardness * plastic_area, plastic_area, Deformation::plastic};
  const double s = (w - asperity.first_yield) / (asperity.full_plastic - asperity.first_yield);
  const double area = elastic_area + (plastic_area - elastic_area) * s * s * (3.0 - 2.0 * s);
  const double elastic_share =
      std::log(asperity.full_plastic / w) / std::log(asperity.full_plastic / asperity.first_yield);
  const double pressure = asperity.hardness * (1.0 - (1.0 - asperity.yield_ratio) * elastic_share);
  return {pressure * area, area, Deformation::elastic_plastic};
}

Patch patch_at(const Surface& surface, double nominal_area, double h) {
  const Asperity one = asperity(surface);
  require_patch(nominal_area, h);
  const double count = surface.density * nominal_area, sigma = surface.deviation;
  const auto limit = limits_of(one, sigma);
  Patch patch{};
  for (std::size_t regime = 0; regime < 3; ++regime) {
    const auto sum = [&](double Load::*quantity) {
      return count *
             over_heights(
                 [&](double w) { return load(one, sigma * w).*quantity * greenwood_williamson::height_density(w + h); },
                 h, limit[regime], limit[regime + 1]);
    };
    patch.force += patch.force_by_regime[regime] = sum(&Load::force);
    patch.area += patch.area_by_regime[regime] = sum(&Load::area);
  }
  return patch;
}

TaylorSeries::TaylorSeries(const Surface& surface, double nominal_area, double centre) : centre_(centre) {
  const Asperity one = asperity(surface);
  require_patch(nominal_area, centre);
  const double count = surface.density * nominal_area, sigma = surface.deviation;
  const auto limit = limits_of(one, sigma);
  double factorial = 1.0;
  for (int n = 0; n <= order; ++n) {
    if (n > 0) factorial *= -n;  // carries the sign (−1)^n too
    // φ^{(n)} = (−1)^n He_n φ, He_{k+1} = z He_k − k He_{k−1}.
    const auto derivative = [n](double z) {
      double before = 0.0, hermite = 1.0;
      for (int k = 0; k < n; ++k) {
        const double next = z * hermite - k * before;
        before = hermite;
        hermite = next;
      }
      return hermite * greenwood_williamson::height_density(z);
    };
    const auto sum = [&](double Load::*quantity) {
      double total = 0.0;
      for (std::size_t regime = 0; regime < 3; ++regime)
        total += over_heights([&](double w) { return load(one, sigma * w).*quantity * derivative(w + centre); }, centre,
                              limit[regime], limit[regime + 1]);
      return count * total / factorial;
    };
    force_[static_cast<std::size_t>(n)] = sum(&Load::force);
    area_[static_cast<std::size_t>(n)] = sum(&Load::area);
  }
}

double TaylorSeries::force(double h) const {
  return horner(force_, h - centre_);
}

double TaylorSeries::area(double h) const {
  return horner(area_, h - centre_);
}

double TaylorSeries::last_term(double h) const {
  const double sum = std::abs(force(h));
  return sum > 0.0 ? std::abs(force_[order] * std::pow(h - centre_, order)) / sum : 0.0;
}

}  // namespace osculate::jeng_wang
