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

/// Powers r^exponent for r in (0, 1] and roots sum^(1/exponent) for sum in [1, 2].
struct RealPower {
  template <class Real>
  static HWY_INLINE Real power(const Real& r, const Real& exponent) {
    return osculate::HWY_NAMESPACE::power(r, exponent);
  }
  template <class Real>
  static HWY_INLINE Real root(const Real& sum, const Real& exponent) {
    return osculate::HWY_NAMESPACE::power(sum, reciprocal(exponent));
  }
};

/// r^0: all exponents are 2.
struct SquarePower {
  template <class Real>
  static HWY_INLINE Real power(const Real&, const Real&) {
    return Real(1.0);
  }
  template <class Real>
  static HWY_INLINE Real root(const Real& sum, const Real&) {
    return sqrt(sum);
  }
};

/// v = (p^e + q^e)^(1/e) for p, q ≥ 0, with everything the nested norm needs of it.
/// hat: (p, q)/v. slope: ∂v/∂(p, q) = hat^(e−1). The Hessian is bend/v · (hat_q, −hat_p)(hat_q, −hat_p)ᵀ.
/// Duality exchanges hat with slope and bend with 1/bend.
template <class Real>
struct PairNorm {
  Real value;
  V2<Real> hat, slope;
  Real bend;
  Real slope_over_hat;  ///< of p, finite where both are zero
};

/// In powers a ratio below this counts as this: they stay finite, and so do bends.
constexpr double smallest_ratio = 1e-60;
/// A bend below this counts as this: radii of curvature reach 1e100 body sizes on a flat face instead of ∞.
constexpr double smallest_bend = 1e-100;

/// The largest term is factored out, so that no power overflows for any exponent. A pair of zeros counts as (1, 0).
template <class Power, class Real>
HWY_INLINE PairNorm<Real> pair_norm(const Real& p, const Real& q, const Real& e) {
  const MaskType<Real> p_is_larger = p >= q;
  const Real larger = max(p, q), r = min(p, q) * reciprocal(max(larger, Real(1e-300)));
  const Real w = Power::power(max(r, Real(smallest_ratio)), e - Real(2.0));
  const Real sum = fma(w * r, r, Real(1.0));
  const Real root = Power::root(sum, e);
  const Real hat_larger = reciprocal(root), hat_smaller = r * hat_larger;
  const Real slope_larger = root * reciprocal(sum), slope_smaller = slope_larger * (w * r);
  const Real steep = slope_larger * root;
  return {larger * root,
          {select(p_is_larger, hat_larger, hat_smaller), select(p_is_larger, hat_smaller, hat_larger)},
          {select(p_is_larger, slope_larger, slope_smaller), select(p_is_larger, slope_smaller, slope_larger)},
          (e - Real(1.0)) * w * square(steep),
          select(p_is_larger, steep, w * steep)};
}

/// The pair norm seen from its other side.
template <class Real>
HWY_INLINE PairNorm<Real> dual(const PairNorm<Real>& jet) {
  const Real one(1.0), smallest(smallest_bend);
  return {jet.value, jet.slope, jet.hat, one / max(jet.bend, smallest), one / max(jet.slope_over_hat, smallest)};
}
template <class Real>
HWY_INLINE PairNorm<Real> select(MaskType<Real> condition, const PairNorm<Real>& yes, const PairNorm<Real>& no) {
  return {select(condition, yes.value, no.value), select(condition, yes.hat, no.hat),
          select(condition, yes.slope, no.slope), select(condition, yes.bend, no.bend),
          select(condition, yes.slope_over_hat, no.slope_over_hat)};
}

/// A superquadric's numbers, and those of its dual.
template <class Real>
struct NestedNorm {
  V3<Real> scale;  ///< multiplies the coordinates
  Real e1, e2;     ///< exponents: e1 joins z to the x–y norm, e2 joins x to y
};

template <class Real>
HWY_INLINE NestedNorm<Real> gauge_norm(const V3<Real>& half_axes, const Real& n1, const Real& n2) {
  return {inverse(half_axes), n1, n2};
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

template <class Power, class Real>
HWY_INLINE NestedJet<Real> evaluate(const NestedNorm<Real>& norm, const V3<Real>& x) {
  const V3<Real> y = times(absolute(x), norm.scale);
  NestedJet<Real> jet;
  jet.inner = pair_norm<Power>(y.x, y.y, norm.e2);
  jet.outer = pair_norm<Power>(jet.inner.value, y.z, norm.e1);
  jet.value = jet.outer.value;
  jet.sign = sign_of(x);
  jet.gradient = {jet.outer.slope.p * jet.inner.slope.p * norm.scale.x * jet.sign.x,
                  jet.outer.slope.p * jet.inner.slope.q * norm.scale.y * jet.sign.y,
                  jet.outer.slope.q * norm.scale.z * jet.sign.z};
  return jet;
}

/// Hessian of the norm itself, at the point on its unit level (value 1) on the ray through x.
template <class Real>
HWY_INLINE RankTwo<Real> unit_hessian(const NestedJet<Real>& jet, const V3<Real>& scale) {
  const V3<Real> s{jet.sign.x * scale.x, jet.sign.y * scale.y, jet.sign.z * scale.z};
  return {
      jet.inner.bend * jet.outer.slope_over_hat,
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
      Real(1.0) / (jet.inner.bend * jet.outer.slope_over_hat),
      Real(1.0) / jet.outer.bend,
      {jet.inner.slope.q * s.x, -jet.inner.slope.p * s.y, Real(0.0)},
      {jet.outer.slope.q * jet.inner.hat.p * s.x, jet.outer.slope.q * jet.inner.hat.q * s.y, -jet.outer.slope.p * s.z}};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
