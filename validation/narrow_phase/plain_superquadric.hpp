#pragma once
// The superquadric's two closed forms as one would write them on paper, for any floating-point type.
// The library has its own, faster and batched; what judges it must not share them.      [KDY23 (15)]

#include <algorithm>
#include <cmath>

#include "osculate/shapes/superquadric.hpp"

namespace osculate::validation::plain {

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;

template <class Real>
struct Support {
  Real value;          ///< h(u) [m] for unit u
  Vector<Real> point;  ///< ∇h(u) [m]
};

/// h(u) = ((|a u_x|^q2 + |b u_y|^q2)^(q1/q2) + |c u_z|^q1)^(1/q1), q = n/(n−1), and its gradient. u = 0 gives zeros.
template <class Real>
Support<Real> support(const Vector<Real>& half_axes, Real q1, Real q2, const Vector<Real>& u) {
  const Vector<Real> full = half_axes.cwiseProduct(u.cwiseAbs());
  const Real largest = full.maxCoeff();
  if (!(largest > 0)) return {0, Vector<Real>::Zero()};
  const Vector<Real> w = full / largest;
  // From the larger one: the powers of two small numbers are zero.
  const auto [less, more] = std::minmax({w.x(), w.y()});
  const Real s = more > 0 ? more * std::pow(1 + std::pow(less / more, q2), 1 / q2) : Real(0);
  const Real h = std::pow(std::pow(s, q1) + std::pow(w.z(), q1), 1 / q1);
  const Real along_s = std::pow(s / h, q1 - 1);
  Vector<Real> point = Vector<Real>::Zero();
  if (s > 0) {
    point.x() = along_s * std::pow(w.x() / s, q2 - 1);
    point.y() = along_s * std::pow(w.y() / s, q2 - 1);
  }
  point.z() = std::pow(w.z() / h, q1 - 1);
  for (int i = 0; i < 3; ++i) point[i] *= std::copysign(half_axes[i], u[i]);
  return {h * largest, point};
}

/// N(x) = ((|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1)^(1/n1) and its gradient; x ≠ 0. The gauge is the support function
/// with inverted axes and the exponents themselves.
template <class Real>
Support<Real> gauge(const Superquadric& shape, const Vector<Real>& x) {
  return support<Real>(shape.half_axes.cast<Real>().cwiseInverse(), static_cast<Real>(shape.exponents.n1),
                       static_cast<Real>(shape.exponents.n2), x);
}

template <class Real>
Support<Real> support(const Superquadric& shape, const Vector<Real>& u) {
  const auto dual = [](double n) { return static_cast<Real>(n) / (static_cast<Real>(n) - 1); };
  return support<Real>(shape.half_axes.cast<Real>(), dual(shape.exponents.n1), dual(shape.exponents.n2), u);
}

/// V = 2 a b c ε1 ε2 B(ε1/2 + 1, ε1) B(ε2/2, ε2/2), ε = 2/n.      [JLS00]
inline double volume(const Superquadric& shape) {
  const auto beta = [](double x, double y) { return std::exp(std::lgamma(x) + std::lgamma(y) - std::lgamma(x + y)); };
  const double e1 = 2 / shape.exponents.n1, e2 = 2 / shape.exponents.n2;
  return 2 * shape.half_axes.prod() * e1 * e2 * beta(e1 / 2 + 1, e1) * beta(e2 / 2, e2 / 2);
}

/// Radius of the sphere of equal volume [m].
inline double volume_radius(const Superquadric& shape) {
  return std::cbrt(volume(shape) * 0.75 / 3.14159265358979323846);
}

}  // namespace osculate::validation::plain
