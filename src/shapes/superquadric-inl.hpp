// The superquadric as a nested p-norm: one formula for its gauge (exponents n, scales 1/a) and for its support
// function (dual exponents n/(n−1), scales a), each with the vectors that span its Hessian.
#if defined(OSCULATE_SHAPES_SUPERQUADRIC_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_SHAPES_SUPERQUADRIC_INL
#undef OSCULATE_SHAPES_SUPERQUADRIC_INL
#else
#define OSCULATE_SHAPES_SUPERQUADRIC_INL
#endif

#include "core/batch-inl.hpp"
#include "core/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// r^power by exponential and logarithm; r in (0, 1].
struct RealPower {
  template <class Real>
  static HWY_INLINE Real power(const Real& r, const Real& exponent) {
    return exp(exponent * log(r));
  }
};

/// r^power for even integers 0 … 62 by repeated squaring: no transcendental function.
struct EvenPower {
  static constexpr int bits = 5;

  template <class Real>
  static HWY_INLINE Real power(const Real& r, const Real& exponent) {
    Real base = r * r, rest = Real(0.5) * exponent, result(1.0);
    for (int bit = 0; bit < bits; ++bit) {
      const Real half = floor(Real(0.5) * rest);
      result = select(half + half < rest, result * base, result);
      rest = half;
      base = base * base;
    }
    return result;
  }
};

/// v = (p^e + q^e)^(1/e) for p, q > 0, with everything the nested norm needs of it.
/// hat: (p, q)/v. slope: ∂v/∂(p, q) = hat^(e−1). The Hessian is bend/v · (hat_q, −hat_p)(hat_q, −hat_p)ᵀ.
/// Duality exchanges hat with slope and bend with 1/bend.
template <class Real>
struct PairNorm {
  Real value;
  V2<Real> hat, slope;
  Real bend;
};

/// The largest term is factored out, so that no power overflows for any exponent.
template <class Power, class Real>
HWY_INLINE PairNorm<Real> pair_norm(const Real& p, const Real& q, const Real& e) {
  const MaskType<Real> p_is_larger = p >= q;
  const Real larger = max(p, q), r = min(p, q) / larger;
  const Real w = Power::power(r, e - Real(2.0));
  const Real sum = fma(w * r, r, Real(1.0));
  const Real root = exp(log(sum) / e);
  const Real hat_larger = Real(1.0) / root, hat_smaller = r * hat_larger;
  const Real slope_larger = root / sum, slope_smaller = slope_larger * (w * r);
  return {larger * root,
          {select(p_is_larger, hat_larger, hat_smaller), select(p_is_larger, hat_smaller, hat_larger)},
          {select(p_is_larger, slope_larger, slope_smaller), select(p_is_larger, slope_smaller, slope_larger)},
          (e - Real(1.0)) * w * square(slope_larger * root)};
}

/// A superquadric's numbers, and those of its dual.
template <class Real>
struct NestedNorm {
  V3<Real> scale;  ///< multiplies the coordinates
  Real e1, e2;     ///< exponents: e1 joins z to the x–y norm, e2 joins x to y
};

template <class Real>
HWY_INLINE NestedNorm<Real> gauge_norm(const V3<Real>& half_axes, const Real& n1, const Real& n2) {
  const Real one(1.0);
  return {{one / half_axes.x, one / half_axes.y, one / half_axes.z}, n1, n2};
}
template <class Real>
HWY_INLINE NestedNorm<Real> support_norm(const V3<Real>& half_axes, const Real& n1, const Real& n2) {
  return {half_axes, n1 / (n1 - Real(1.0)), n2 / (n2 - Real(1.0))};
}

/// Value and gradient of a nested norm at x, and what its Hessian and the Hessian of the dual norm are made of.
template <class Real>
struct NestedJet {
  Real value;
  V3<Real> gradient;
  PairNorm<Real> inner, outer;  ///< inner: (x, y); outer: (inner, z)
  V3<Real> sign;
};

/// A coordinate of exactly zero counts as this fraction of the largest one, so that every ratio stays positive.
constexpr double smallest_ratio = 1e-60;

template <class Power, class Real>
HWY_INLINE NestedJet<Real> evaluate(const NestedNorm<Real>& norm, const V3<Real>& x) {
  const Real one(1.0);
  V3<Real> y{abs(x.x) * norm.scale.x, abs(x.y) * norm.scale.y, abs(x.z) * norm.scale.z};
  const Real smallest = Real(smallest_ratio) * max(max(y.x, y.y), y.z);
  y = {max(y.x, smallest), max(y.y, smallest), max(y.z, smallest)};
  NestedJet<Real> jet;
  jet.inner = pair_norm<Power>(y.x, y.y, norm.e2);
  jet.outer = pair_norm<Power>(jet.inner.value, y.z, norm.e1);
  jet.value = jet.outer.value;
  jet.sign = {copysign(one, x.x), copysign(one, x.y), copysign(one, x.z)};
  jet.gradient = {jet.outer.slope.p * jet.inner.slope.p * norm.scale.x * jet.sign.x,
                  jet.outer.slope.p * jet.inner.slope.q * norm.scale.y * jet.sign.y,
                  jet.outer.slope.q * norm.scale.z * jet.sign.z};
  return jet;
}

/// A symmetric matrix of rank two: weight_a a aᵀ + weight_b b bᵀ.
template <class Real>
struct RankTwo {
  Real weight_a, weight_b;
  V3<Real> a, b;
};

/// Hessian of the norm itself, at the point on its unit level (value 1) on the ray through x.
template <class Real>
HWY_INLINE RankTwo<Real> unit_hessian(const NestedJet<Real>& jet, const V3<Real>& scale) {
  const V3<Real> s{jet.sign.x * scale.x, jet.sign.y * scale.y, jet.sign.z * scale.z};
  return {
      jet.outer.slope.p * jet.inner.bend / jet.outer.hat.p,
      jet.outer.bend,
      {jet.inner.hat.q * s.x, -jet.inner.hat.p * s.y, Real(0.0)},
      {jet.outer.hat.q * jet.inner.slope.p * s.x, jet.outer.hat.q * jet.inner.slope.q * s.y, -jet.outer.hat.p * s.z}};
}

/// Hessian of the dual norm at its unit level, where its gradient points along x: the same with hats and slopes
/// exchanged. For the jet of a support function this is the gauge's Hessian at the support point, and conversely.
template <class Real>
HWY_INLINE RankTwo<Real> unit_hessian_of_dual(const NestedJet<Real>& jet, const V3<Real>& scale) {
  const V3<Real> s{jet.sign.x / scale.x, jet.sign.y / scale.y, jet.sign.z / scale.z};
  return {
      jet.outer.hat.p / (jet.inner.bend * jet.outer.slope.p),
      Real(1.0) / jet.outer.bend,
      {jet.inner.slope.q * s.x, -jet.inner.slope.p * s.y, Real(0.0)},
      {jet.outer.slope.q * jet.inner.hat.p * s.x, jet.outer.slope.q * jet.inner.hat.q * s.y, -jet.outer.slope.p * s.z}};
}

/// Projection on a tangent plane.
template <class Real>
HWY_INLINE Sym2<Real> project(const RankTwo<Real>& m, const TangentBasis<Real>& basis) {
  const V2<Real> a = coordinates(basis, m.a), b = coordinates(basis, m.b);
  const V2<Real> wa = m.weight_a * a, wb = m.weight_b * b;
  return {fma(wa.p, a.p, wb.p * b.p), fma(wa.p, a.q, wb.p * b.q), fma(wa.q, a.q, wb.q * b.q)};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
