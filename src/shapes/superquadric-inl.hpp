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

/// Powers r^exponent for r in (0, 1] and roots sum^(1/exponent) for sum in [1, 2], by exponential and logarithm.
struct RealPower {
  template <class Real>
  static HWY_INLINE Real power(const Real& r, const Real& exponent) {
    return exp(exponent * log(r));
  }
  template <class Real>
  static HWY_INLINE Real root(const Real& sum, const Real& exponent) {
    return exp(log(sum) / exponent);
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
  template <class Real>
  static HWY_INLINE Real root(const Real& sum, const Real& exponent) {
    return RealPower::root(sum, exponent);
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

/// A bend below this counts as this: radii of curvature reach 1e100 body sizes on a flat face instead of ∞.
constexpr double smallest_bend = 1e-100;

/// The largest term is factored out, so that no power overflows for any exponent.
template <class Power, class Real>
HWY_INLINE PairNorm<Real> pair_norm(const Real& p, const Real& q, const Real& e) {
  const MaskType<Real> p_is_larger = p >= q;
  const Real larger = max(p, q), r = min(p, q) / larger;
  const Real w = Power::power(r, e - Real(2.0));
  const Real sum = fma(w * r, r, Real(1.0));
  const Real root = Power::root(sum, e);
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

/// One surface point of a superquadric to second order, body frame. Moving it along the unit level parameter of the
/// inner (a) or outer (b) pair norm changes the point by point_x and ∇N by weight_x · gradient_x.
template <class Real>
struct SurfaceJet {
  V3<Real> point, gradient;
  V3<Real> point_a, point_b, gradient_a, gradient_b;
  Real weight_a, weight_b;
};

/// How a surface point is found from a guess of the point and of the normal there.
enum class View {
  from_point,   ///< radially: the ratios of the coordinates; normals are insensitive to errors of a point on a face
  from_normal,  ///< the support point: the ratios of the normal; points are insensitive to errors of a normal on a rim
  mixed,        ///< each pair norm from the side on which it is Lipschitz: points for exponents ≥ 2, normals below
};

/// A superquadric prepared for one view: scales, and exponents of each level as that view sees them.
template <class Real>
struct ViewedSuperquadric {
  V3<Real> half_axes, inverse_axes;
  Real inner, outer;                                    ///< n or its dual n/(n−1)
  MaskType<Real> inner_from_normal, outer_from_normal;  ///< which of the two
};

template <View view, class Real>
HWY_INLINE ViewedSuperquadric<Real> viewed(const V3<Real>& half_axes, const Real& n1, const Real& n2) {
  const Real one(1.0);
  ViewedSuperquadric<Real> body;
  body.half_axes = half_axes;
  body.inverse_axes = {one / half_axes.x, one / half_axes.y, one / half_axes.z};
  if constexpr (view == View::from_point) {
    body.inner_from_normal = body.outer_from_normal = n1 < Real(0.0);
  } else if constexpr (view == View::from_normal) {
    body.inner_from_normal = body.outer_from_normal = n1 > Real(0.0);
  } else {
    body.inner_from_normal = n2 < Real(2.0);
    body.outer_from_normal = n1 < Real(2.0);
  }
  if constexpr (view == View::from_point) {
    body.inner = n2;
    body.outer = n1;
  } else {
    body.inner = select(body.inner_from_normal, n2 / (n2 - one), n2);
    body.outer = select(body.outer_from_normal, n1 / (n1 - one), n1);
  }
  return body;
}

/// The pair norm seen from its other side: hats and slopes exchanged.
template <class Real>
HWY_INLINE PairNorm<Real> dual_where(MaskType<Real> condition, const PairNorm<Real>& jet) {
  return {jet.value, select(condition, jet.slope, jet.hat), select(condition, jet.hat, jet.slope),
          select(condition, Real(1.0) / max(jet.bend, Real(smallest_bend)), jet.bend)};
}

template <View view, class Power, class Real>
HWY_INLINE SurfaceJet<Real> locate(const ViewedSuperquadric<Real>& body, const V3<Real>& point_guess,
                                   const V3<Real>& normal_guess) {
  const V3<Real>&a = body.half_axes, &inverse = body.inverse_axes;
  const Real one(1.0);
  const auto lifted_from_zero = [](const V3<Real>& c) -> V3<Real> {
    const Real smallest = Real(smallest_ratio) * max(max(c.x, c.y), c.z);
    return {max(c.x, smallest), max(c.y, smallest), max(c.z, smallest)};
  };
  V3<Real> c, m, sign;
  if constexpr (view != View::from_normal)
    c = lifted_from_zero(
        {abs(point_guess.x) * inverse.x, abs(point_guess.y) * inverse.y, abs(point_guess.z) * inverse.z});
  if constexpr (view != View::from_point)
    m = lifted_from_zero({abs(normal_guess.x) * a.x, abs(normal_guess.y) * a.y, abs(normal_guess.z) * a.z});

  PairNorm<Real> inner, outer;
  if constexpr (view == View::from_point) {
    inner = pair_norm<Power>(c.x, c.y, body.inner);
    outer = pair_norm<Power>(inner.value, c.z, body.outer);
    sign = {copysign(one, point_guess.x), copysign(one, point_guess.y), copysign(one, point_guess.z)};
  } else if constexpr (view == View::from_normal) {
    const MaskType<Real> all = body.inner_from_normal;
    const PairNorm<Real> inner_dual = pair_norm<Power>(m.x, m.y, body.inner);
    inner = dual_where(all, inner_dual);
    outer = dual_where(all, pair_norm<Power>(inner_dual.value, m.z, body.outer));
    sign = {copysign(one, normal_guess.x), copysign(one, normal_guess.y), copysign(one, normal_guess.z)};
  } else {
    const MaskType<Real> dual_i = body.inner_from_normal, dual_o = body.outer_from_normal;
    inner = dual_where(dual_i, pair_norm<Power>(select(dual_i, m.x, c.x), select(dual_i, m.y, c.y), body.inner));
    // By homogeneity a pair's value is its gradient times its coordinates, whichever side the gradient came from.
    const Real rho = select(dual_o, dot(inner.hat, V2<Real>{m.x, m.y}), dot(inner.slope, V2<Real>{c.x, c.y}));
    outer = dual_where(dual_o, pair_norm<Power>(rho, select(dual_o, m.z, c.z), body.outer));
    sign = {copysign(one, select(dual_i, normal_guess.x, point_guess.x)),
            copysign(one, select(dual_i, normal_guess.y, point_guess.y)),
            copysign(one, select(dual_o, normal_guess.z, point_guess.z))};
  }

  const V3<Real> s{sign.x * a.x, sign.y * a.y, sign.z * a.z};
  const V3<Real> i{sign.x * inverse.x, sign.y * inverse.y, sign.z * inverse.z};
  SurfaceJet<Real> jet;
  jet.point = {outer.hat.p * inner.hat.p * s.x, outer.hat.p * inner.hat.q * s.y, outer.hat.q * s.z};
  jet.gradient = {outer.slope.p * inner.slope.p * i.x, outer.slope.p * inner.slope.q * i.y, outer.slope.q * i.z};
  jet.point_a = {inner.slope.q * s.x, -inner.slope.p * s.y, Real(0.0)};
  jet.point_b = {outer.slope.q * inner.hat.p * s.x, outer.slope.q * inner.hat.q * s.y, -outer.slope.p * s.z};
  jet.gradient_a = {inner.hat.q * i.x, -inner.hat.p * i.y, Real(0.0)};
  jet.gradient_b = {outer.hat.q * inner.slope.p * i.x, outer.hat.q * inner.slope.q * i.y, -outer.hat.p * i.z};
  jet.weight_a = inner.bend * outer.slope.p / outer.hat.p;
  jet.weight_b = outer.bend;
  return jet;
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
