#include "osculate/shapes/superquadric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "osculate/core/error.hpp"
#include "shapes/superquadric-inl.hpp"

namespace osculate {
namespace {

namespace kernel = HWY_NAMESPACE;

using Jet = kernel::NestedJet<double>;
using Norm = kernel::NestedNorm<double>;
using RankTwo = kernel::RankTwo<double>;

constexpr double instead_of_infinity = 1e100;

kernel::V3<double> to_kernel(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
Vec3 from_kernel(const kernel::V3<double>& v) {
  return {v.x, v.y, v.z};
}

Norm gauge_norm(const Superquadric& shape) {
  return kernel::gauge_norm(to_kernel(shape.half_axes), shape.exponents.n1, shape.exponents.n2);
}
Norm support_norm(const Superquadric& shape) {
  return kernel::support_norm(to_kernel(shape.half_axes), shape.exponents.n1, shape.exponents.n2);
}

/// The kernel nudges exact zeros off the symmetry planes; there the gradient is known exactly.
Jet evaluate(const Norm& norm, const Vec3& x) {
  Jet jet = kernel::evaluate<kernel::RealPower>(norm, to_kernel(x));
  if (x.x() == 0.0) jet.gradient.x = 0.0;
  if (x.y() == 0.0) jet.gradient.y = 0.0;
  if (x.z() == 0.0) jet.gradient.z = 0.0;
  return jet;
}

/// The weight of a direction of curvature on the symmetry plane across it.
double weight_on_symmetry_plane(double exponent, double weight) {
  if (exponent > 2.0) return 0.0;
  return exponent < 2.0 ? instead_of_infinity : weight;
}

RankTwo unit_hessian(const Jet& jet, const Norm& norm, const Vec3& x) {
  RankTwo hessian = kernel::unit_hessian(jet, norm.scale);
  const bool on_axis = x.x() == 0.0 && x.y() == 0.0;
  if (on_axis) {
    hessian.weight_a = weight_on_symmetry_plane(norm.e1, hessian.weight_a);
  } else if (x.x() == 0.0 || x.y() == 0.0) {
    hessian.weight_a = weight_on_symmetry_plane(norm.e2, hessian.weight_a);
  }
  if (on_axis || x.z() == 0.0) hessian.weight_b = weight_on_symmetry_plane(norm.e1, hessian.weight_b);
  return hessian;
}

RankTwoFactors factors(const RankTwo& m) {
  return {std::sqrt(m.weight_a) * from_kernel(m.a), std::sqrt(m.weight_b) * from_kernel(m.b)};
}

Mat3 product(const RankTwoFactors& f) {
  return f.a * f.a.transpose() + f.b * f.b.transpose();
}

void require_axis(double axis, const std::string& which) {
  if (!(axis > 0.0) || !std::isfinite(axis)) {
    throw InputError("superquadric", which + " = " + std::to_string(axis) + " m", "a positive, finite length");
  }
}

void require_exponent(double exponent, const std::string& which) {
  if (!(exponent > 1.0 && exponent <= 64.0)) {
    throw InputError("superquadric", which + " = " + std::to_string(exponent),
                     "an exponent in (1, 64], that is η = 2/n in [1/32, 2)");
  }
}

/// Largest |(x, y)| on |x/a|^n + |y/b|^n = 1: the longer axis for n ≤ 2, by Hölder's inequality beyond.
double largest_radius(double a, double b, double n) {
  const double longer = std::max(a, b);
  if (n <= 2.0) return longer;
  const double power = 2.0 * n / (n - 2.0);
  return longer * std::exp(std::log1p(std::pow(std::min(a, b) / longer, power)) / power);
}

double beta(double p, double q) {
  return std::tgamma(p) * std::tgamma(q) / std::tgamma(p + q);
}

/// ∫ over t in (0, 1) of t^power (1 − t^n)^(m/n).
double section_moment(double power, double n, double m) {
  return beta((power + 1.0) / n, m / n + 1.0) / n;
}

}  // namespace

void validate(const Superquadric& shape) {
  require_axis(shape.half_axes.x(), "half-axis a");
  require_axis(shape.half_axes.y(), "half-axis b");
  require_axis(shape.half_axes.z(), "half-axis c");
  require_exponent(shape.exponents.n1, "n1");
  require_exponent(shape.exponents.n2, "n2");
}

void validate(const Ellipsoid& shape) {
  validate(as_superquadric(shape));
}

void validate(const Sphere& shape) {
  if (!(shape.radius > 0.0) || !std::isfinite(shape.radius)) {
    throw InputError("sphere", "radius = " + std::to_string(shape.radius) + " m", "a positive, finite length");
  }
}

Gauge gauge(const Superquadric& shape, const Vec3& x) {
  if (x.isZero(0.0)) return {0.0, Vec3::Zero(), Mat3::Zero()};
  const Norm norm = gauge_norm(shape);
  const Jet jet = evaluate(norm, x);
  return {jet.value, from_kernel(jet.gradient), product(factors(unit_hessian(jet, norm, x))) / jet.value};
}

Support support(const Superquadric& shape, const Vec3& u) {
  if (u.isZero(0.0)) return {0.0, Vec3::Zero(), Mat3::Zero()};
  const Norm norm = support_norm(shape);
  const Jet jet = evaluate(norm, u);
  return {jet.value, from_kernel(jet.gradient), product(factors(unit_hessian(jet, norm, u))) / jet.value};
}

RankTwoFactors gauge_hessian_factors(const Superquadric& shape, const Vec3& x) {
  const Norm norm = gauge_norm(shape);
  return factors(unit_hessian(evaluate(norm, x), norm, x));
}

Vec3 support_point(const Superquadric& shape, const Vec3& u) {
  return u.isZero(0.0) ? Vec3(Vec3::Zero()) : from_kernel(evaluate(support_norm(shape), u).gradient);
}

double bounding_radius(const Superquadric& shape) {
  const double in_plane = largest_radius(shape.half_axes.x(), shape.half_axes.y(), shape.exponents.n2);
  constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
  return largest_radius(in_plane, shape.half_axes.z(), shape.exponents.n1) * (1.0 + rounding);
}

OrientedBox oriented_box(const Superquadric& shape) {
  return {Vec3::Zero(), shape.half_axes};
}

MassProperties mass_properties(const Superquadric& shape) {
  const double a = shape.half_axes.x(), b = shape.half_axes.y(), c = shape.half_axes.z();
  const auto [n1, n2] = shape.exponents;
  // Sections z = const are similar superellipses of size m(z) = (1 − |z/c|^n1)^(1/n1).
  const double section_area = 4.0 * a * b * section_moment(0.0, n2, 1.0);
  const double section_second = 4.0 * a * b * section_moment(2.0, n2, 1.0);  // times a² or b²
  const double volume = 2.0 * c * section_area * section_moment(0.0, n1, 2.0);
  const double height = 2.0 * c * section_moment(0.0, n1, 4.0);
  const double xx = a * a * section_second * height, yy = b * b * section_second * height;
  const double zz = 2.0 * c * c * c * section_area * section_moment(2.0, n1, 2.0);
  return {volume, Vec3::Zero(), Vec3(yy + zz, zz + xx, xx + yy).asDiagonal(), 0.0};
}

}  // namespace osculate
