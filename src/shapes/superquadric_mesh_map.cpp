#include <algorithm>
#include <cmath>

#include "shapes/mesh_map.hpp"

namespace osculate {
namespace {

constexpr double full_margin = 0.4;  // of a half-axis: a quarter of the vertices go to the edges of a box

/// A point p, q ≥ 0 of the curve p^n + q^n = 1, and the point it has on the curve grown by the margin.
struct CurvePoint {
  double p, q;
  double grown_p, grown_q;
};

/// The curve's point whose grown point lies along (u, v), u and v ≥ 0 and not both zero. The normal's components are
/// p^(n−1), q^(n−1); an exponent near 0 (n → 1) would collapse vertices on the rims and is kept off it.
CurvePoint curve_point(double n, double margin, double u, double v) {
  const double bend = std::max(n - 1.0, 0.4);
  const auto grown = [&](double p) { return p > 0.0 ? p + margin * std::pow(p, bend) : 0.0; };
  if (u == 0.0) return {0.0, 1.0, 0.0, grown(1.0)};
  if (v == 0.0) return {1.0, 0.0, grown(1.0), 0.0};
  // Unknown: s = log(q/p). The grown ratio's logarithm rises with a slope between min(1, bend) and max(1, bend).
  const auto point = [&](double s) {
    const double larger = std::exp(-std::log1p(std::exp(-n * std::fabs(s))) / n);
    const double smaller = larger * std::exp(-std::fabs(s));
    const double p = s > 0.0 ? smaller : larger, q = s > 0.0 ? larger : smaller;
    return CurvePoint{p, q, grown(p), grown(q)};
  };
  const double wanted = std::log(v / u);
  double low = std::min(wanted / std::min(1.0, bend), wanted / std::max(1.0, bend));
  double high = std::max(wanted / std::min(1.0, bend), wanted / std::max(1.0, bend));
  constexpr int enough_halvings = 45;  // any s gives a point of the curve: its last digits only place the vertex
  for (int halving = 0; halving < enough_halvings; ++halving) {
    const double middle = 0.5 * (low + high);
    const CurvePoint at = point(middle);
    (std::log(at.grown_q / at.grown_p) < wanted ? low : high) = middle;
  }
  return point(0.5 * (low + high));
}

}  // namespace

Vec3 mesh_point(const Superquadric& shape, const Vec3& w) {
  const double u = std::fabs(w.x()), v = std::fabs(w.y());
  double across = 0.0;  // of (u, v), measured so that it is u on the x axis and v on the y axis
  CurvePoint inner{0.0, 0.0, 0.0, 0.0};
  if (u > 0.0 || v > 0.0) {
    // Edges along z need no vertices where they fade out on the faces towards z.
    const double steepness = std::min(1.0, std::max(u, v) / std::fabs(w.z()));
    const double margin = full_margin * steepness * steepness;
    inner = curve_point(shape.exponents.n2, margin, u, v);
    across = std::hypot(u, v) * (1.0 + margin) / std::hypot(inner.grown_p, inner.grown_q);
  }
  const CurvePoint outer = curve_point(shape.exponents.n1, full_margin, across, std::fabs(w.z()));
  const Vec3 x(std::copysign(outer.p * inner.p * shape.half_axes.x(), w.x()),
               std::copysign(outer.p * inner.q * shape.half_axes.y(), w.y()),
               std::copysign(outer.q * shape.half_axes.z(), w.z()));
  return x / gauge(shape, x).value;
}

}  // namespace osculate
