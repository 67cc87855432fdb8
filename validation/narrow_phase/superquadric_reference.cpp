#include "validation/narrow_phase/superquadric_reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "validation/narrow_phase/plain_superquadric.hpp"

namespace osculate::validation {
namespace {

template <class Real>
using V = plain::Vector<Real>;
template <class Real>
using V2 = Eigen::Matrix<Real, 2, 1>;
template <class Real>
using M = Eigen::Matrix<Real, 3, 3>;

/// Both bodies relative to body 1's centre, lengths in units of the larger body.
template <class Real>
struct Problem {
  V<Real> axes_1, axes_2, offset;
  Real q1_1, q2_1, q1_2, q2_2;
  M<Real> rotation_1, rotation_2;

  V<Real> on_1(const V<Real>& u) const {
    return rotation_1 * plain::support<Real>(axes_1, q1_1, q2_1, rotation_1.transpose() * u).point;
  }
  V<Real> on_2(const V<Real>& u) const {
    return rotation_2 * plain::support<Real>(axes_2, q1_2, q2_2, rotation_2.transpose() * -u).point + offset;
  }
  plain::Support<Real> operator()(const V<Real>& u) const {
    const plain::Support<Real> first = plain::support<Real>(axes_1, q1_1, q2_1, rotation_1.transpose() * u);
    const plain::Support<Real> second = plain::support<Real>(axes_2, q1_2, q2_2, rotation_2.transpose() * -u);
    return {first.value + second.value - u.dot(offset), rotation_1 * first.point - rotation_2 * second.point - offset};
  }
};

template <class Real>
M<Real> rotation_matrix(const Quat& q) {
  const Eigen::Quaternion<Real> exact(static_cast<Real>(q.w()), static_cast<Real>(q.x()), static_cast<Real>(q.y()),
                                      static_cast<Real>(q.z()));
  return exact.normalized().toRotationMatrix();
}

template <class Real>
Problem<Real> problem(const Superquadric& shape_1, const Pose& pose_1, const Superquadric& shape_2, const Pose& pose_2,
                      double unit) {
  const auto dual = [](double n) { return static_cast<Real>(n) / (static_cast<Real>(n) - 1); };
  const Real length = static_cast<Real>(unit);
  return {shape_1.half_axes.cast<Real>() / length,
          shape_2.half_axes.cast<Real>() / length,
          (pose_2.position.cast<Real>() - pose_1.position.cast<Real>()) / length,
          dual(shape_1.exponents.n1),
          dual(shape_1.exponents.n2),
          dual(shape_2.exponents.n1),
          dual(shape_2.exponents.n2),
          rotation_matrix<Real>(pose_1.orientation),
          rotation_matrix<Real>(pose_2.orientation)};
}

/// g in the gnomonic chart about a direction: f(v) = g(ŵ), w = centre + v_1 e_1 + v_2 e_2.
template <class Real>
struct Chart {
  const Problem<Real>* g;
  V<Real> centre, e1, e2;

  Chart(const Problem<Real>& problem, const V<Real>& u) : g(&problem), centre(u.normalized()) {
    e1 = centre.unitOrthogonal();
    e2 = centre.cross(e1);
  }
  V<Real> direction(const V2<Real>& v) const { return (centre + v.x() * e1 + v.y() * e2).normalized(); }
  struct Point {
    V2<Real> v;
    Real value;
    V2<Real> gradient;
  };
  Point at(const V2<Real>& v) const {
    const V<Real> w = centre + v.x() * e1 + v.y() * e2;
    const Real length = w.norm();
    const V<Real> u = w / length;
    const plain::Support<Real> here = (*g)(u);
    const V<Real> tangential = (here.point - here.value * u) / length;
    return {v, here.value, {tangential.dot(e1), tangential.dot(e2)}};
  }
};

template <class Real>
struct Descent {
  V<Real> u;
  Real value;
};

/// BFGS with a bisecting weak-Wolfe line search (Lewis & Overton 2013: it also converges on kinks). Where values no
/// longer differ, the slope alone decides (Hager & Zhang 2005).
template <class Real>
Descent<Real> descend(const Problem<Real>& g, V<Real> u, int budget) {
  using Matrix2 = Eigen::Matrix<Real, 2, 2>;
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  const Real armijo = Real(1e-4), wolfe = Real(0.5), chart_size = Real(0.7);
  int used = 0;
  while (used < budget) {
    const Chart<Real> chart(g, u);
    auto here = chart.at(V2<Real>::Zero());
    ++used;
    Matrix2 inverse = Matrix2::Identity() * (Real(0.1) / std::max(here.gradient.norm(), Real(1e-3)));
    bool first = true, stalled = false;
    while (used < budget && !stalled && here.v.norm() < chart_size) {
      V2<Real> step = -(inverse * here.gradient);
      Real slope = step.dot(here.gradient);
      if (!(slope < 0)) {
        stalled = true;
        break;
      }
      if (step.norm() > Real(0.5)) step *= Real(0.5) / step.norm(), slope = step.dot(here.gradient);
      Real low = 0, high = std::numeric_limits<Real>::infinity(), t = 1;
      auto next = here;
      bool accepted = false;
      for (int trial = 0; trial < 60 && used < budget; ++trial) {
        next = chart.at(here.v + t * step);
        ++used;
        const Real slope_there = next.gradient.dot(step);
        const bool decreases = next.value <= here.value + armijo * t * slope;
        const bool as_low = next.value <= here.value + 4 * epsilon && slope_there <= (2 * armijo - 1) * slope;
        if (!decreases && !as_low) {
          high = t;
        } else if (slope_there < wolfe * slope) {
          low = t;
        } else {
          accepted = true;
          break;
        }
        t = std::isinf(high) ? 2 * low : (low + high) / 2;
        if (!(t * step.norm() > epsilon / 8)) break;
      }
      if (!accepted) {
        if (next.value < here.value) here = next;
        stalled = true;
        break;
      }
      const V2<Real> s = next.v - here.v, y = next.gradient - here.gradient;
      const Real sy = s.dot(y);
      if (sy > 0) {
        if (first) inverse = Matrix2::Identity() * (sy / y.squaredNorm());
        const Matrix2 left = Matrix2::Identity() - s * y.transpose() / sy;
        inverse = left * inverse * left.transpose() + s * s.transpose() / sy;
        first = false;
      }
      stalled = next.gradient.norm() < 4 * epsilon || s.norm() < epsilon / 4;
      here = next;
    }
    u = chart.direction(here.v);
    if (stalled) return {u, here.value};
  }
  return {u, g(u).value};
}

/// Directions that between them fall into every basin: a Fibonacci lattice, the same lattice as normals of the
/// inscribed ellipsoids (dense where flat bodies are flat), the bodies' axes, the crossings of their edges, the centre
/// line.
std::vector<Vec3> starts(const Problem<double>& g) {
  std::vector<Vec3> found;
  const auto add = [&found](const Vec3& u) {
    const double length = u.norm();
    if (length > 0 && std::isfinite(length)) found.push_back(u / length);
  };
  const auto lattice = [](int i, int count) {
    const double z = 1 - (2 * i + 1.0) / count, turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    return Vec3(r * std::cos(turn), r * std::sin(turn), z);
  };
  for (int i = 0; i < 200; ++i) add(lattice(i, 200));
  for (int i = 0; i < 60; ++i) {
    const Vec3 s = lattice(i, 60);
    add(g.rotation_1 * s.cwiseQuotient(g.axes_1));
    add(g.rotation_2 * s.cwiseQuotient(g.axes_2));
  }
  add(g.offset);
  for (int i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0}) {
      add(sign * g.rotation_1.col(i));
      add(sign * g.rotation_2.col(i));
      for (int j = 0; j < 3; ++j) add(sign * g.rotation_1.col(i).cross(g.rotation_2.col(j)));
    }
  return found;
}

}  // namespace

Depth reference_depth(const Superquadric& shape_1, const Pose& pose_1, const Superquadric& shape_2,
                      const Pose& pose_2) {
  const double unit = std::max(shape_1.half_axes.maxCoeff(), shape_2.half_axes.maxCoeff());
  const Problem<double> rough = problem<double>(shape_1, pose_1, shape_2, pose_2, unit);
  const Problem<long double> fine = problem<long double>(shape_1, pose_1, shape_2, pose_2, unit);

  constexpr int rough_evaluations = 40, fine_evaluations = 200;
  std::vector<Descent<double>> candidates;
  for (const Vec3& u : starts(rough)) candidates.push_back(descend<double>(rough, u, rough_evaluations));
  const auto lower = [](const auto& a, const auto& b) { return a.value < b.value; };
  std::sort(candidates.begin(), candidates.end(), lower);

  constexpr std::size_t polished_at_most = 24;
  constexpr double same_basin = 1e-3;          // [rad] before polishing: nearer candidates are taken for one
  constexpr long double same_minimum = 1e-6L;  // [rad] after polishing
  std::vector<Vec3> taken;
  std::vector<Descent<long double>> minima;
  for (const Descent<double>& candidate : candidates) {
    if (minima.size() == polished_at_most) break;
    const bool near =
        std::any_of(taken.begin(), taken.end(), [&](const Vec3& u) { return (u - candidate.u).norm() < same_basin; });
    if (near) continue;
    minima.push_back(descend<long double>(fine, candidate.u.cast<long double>().normalized(), fine_evaluations));
    taken.push_back(candidate.u);
    taken.push_back(minima.back().u.cast<double>());
  }
  std::sort(minima.begin(), minima.end(), lower);

  Depth result;
  const V<long double> u = minima.front().u;
  const V<long double> on_1 = fine.on_1(u), on_2 = fine.on_2(u), apart = on_1 - on_2;
  const auto length = static_cast<long double>(unit);
  const auto to_world = [&](const V<long double>& x) {
    return Vec3((x * length + pose_1.position.cast<long double>()).cast<double>());
  };
  result.minimum = {u.cast<double>(), static_cast<double>(minima.front().value * length), to_world(on_1),
                    to_world(on_2), static_cast<double>((apart - apart.dot(u) * u).norm() * length)};
  for (const Descent<long double>& other : minima)
    if ((other.u - u).norm() > same_minimum) {
      result.next = static_cast<double>(other.value * length);
      break;
    }
  return result;
}

double overlap_along(const Vec3& normal, const Superquadric& shape_1, const Pose& pose_1, const Superquadric& shape_2,
                     const Pose& pose_2) {
  return static_cast<double>(
      problem<long double>(shape_1, pose_1, shape_2, pose_2, 1.0)(normal.cast<long double>().normalized()).value);
}

}  // namespace osculate::validation
