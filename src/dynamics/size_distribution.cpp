#include "osculate/dynamics/size_distribution.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

void require(bool sound, const std::string& found, const std::string& expected) {
  if (!sound) throw InputError("size distribution", found, expected);
}

/// Φ⁻¹ by bisection on erfc: a handful of calls a scene.
double normal_quantile(double probability) {
  double low = -10.0, high = 10.0;
  constexpr int halvings = 80;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::numbers::sqrt2) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double quantile(const UniformSizes& sizes, double probability) {
  return std::lerp(sizes.least, sizes.most, probability);
}
double quantile(const LogNormalSizes& sizes, double probability) {
  return sizes.median * std::exp(sizes.sigma * normal_quantile(probability));
}
double quantile(const WeibullSizes& sizes, double probability) {
  return sizes.scale * std::pow(-std::log1p(-probability), 1.0 / sizes.modulus);
}

void check(const UniformSizes& sizes) {
  require(sizes.least > 0.0 && sizes.most >= sizes.least && std::isfinite(sizes.most),
          "sizes from " + std::to_string(sizes.least) + " to " + std::to_string(sizes.most), "0 < least <= most");
}
void check(const LogNormalSizes& sizes) {
  require(sizes.median > 0.0 && std::isfinite(sizes.median) && sizes.sigma >= 0.0 && std::isfinite(sizes.sigma),
          "median " + std::to_string(sizes.median) + ", sigma " + std::to_string(sizes.sigma),
          "a median > 0 and a sigma >= 0");
}
void check(const WeibullSizes& sizes) {
  require(sizes.scale > 0.0 && std::isfinite(sizes.scale) && sizes.modulus > 0.0 && std::isfinite(sizes.modulus),
          "scale " + std::to_string(sizes.scale) + ", modulus " + std::to_string(sizes.modulus), "both > 0");
}

Shape enlarged(const Superquadric& shape, double factor) {
  return Superquadric{.half_axes = factor * shape.half_axes, .exponents = shape.exponents};
}
Shape enlarged(const Ellipsoid& shape, double factor) {
  return Ellipsoid{.half_axes = factor * shape.half_axes};
}
Shape enlarged(const Sphere& shape, double factor) {
  return Sphere{.radius = factor * shape.radius};
}
Shape enlarged(const PotentialParticle& shape, double factor) {
  PotentialParticle larger = shape;
  for (FacePlane& plane : larger.planes) plane.distance *= factor;
  larger.edge_radius *= factor;
  larger.sphere_radius *= factor;
  return larger;
}

}  // namespace

std::vector<double> size_classes(const SizeDistribution& distribution, int count) {
  std::visit([](const auto& sizes) { check(sizes); }, distribution);
  require(count >= 1, std::to_string(count) + " classes", "1 or more");
  std::vector<double> classes;
  for (int i = 0; i < count; ++i)
    classes.push_back(std::visit([&](const auto& sizes) { return quantile(sizes, (i + 0.5) / count); }, distribution));
  return classes;
}

Shape scaled(const Shape& shape, double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor))
    throw InputError("scaled shape", "factor " + std::to_string(factor), "a finite value > 0");
  return std::visit(
      [&](const auto& one) -> Shape {
        if constexpr (requires { enlarged(one, factor); })
          return enlarged(one, factor);
        else
          throw InputError("scaled shape", "a " + std::string(kind(one)), "a particle");
      },
      shape);
}

}  // namespace osculate
