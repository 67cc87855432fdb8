// Superquadrics as the contact solver sees them: surface points to second order, in the body frame. A surface finds the
// point nearest to a guess of point and normal, each kind from the side that is well conditioned for it:
//   GaugeSurface    from the point, by the gauge: exponents ≥ 2, where normals are insensitive to errors of a point
//   ImplicitSurface the same near the surface, without roots; whole exponents need no transcendental function
//   MixedSurface    each pair norm from the side on which it is Lipschitz: any exponents
//   SupportSurface  from the normal alone: the support function
#if defined(OSCULATE_SHAPES_SUPERQUADRIC_SURFACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_SHAPES_SUPERQUADRIC_SURFACE_INL
#undef OSCULATE_SHAPES_SUPERQUADRIC_SURFACE_INL
#else
#define OSCULATE_SHAPES_SUPERQUADRIC_SURFACE_INL
#endif

#include "shapes/superquadric-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

template <class Real>
struct SuperquadricNumbers {
  V3<Real> half_axes;
  Real n1, n2;
};

/// How the normal turns as the point moves, when curvatures are bounded: n ≥ 2 and everything that is not a
/// superquadric. The tangent-plane part of the matrix is the shape operator.
template <class Real>
struct BluntJet {
  V3<Real> point, normal;
  RankTwo<Real> curvature;
};
template <class Real>
HWY_INLINE BluntJet<Real> select(MaskType<Real> condition, const BluntJet<Real>& yes, const BluntJet<Real>& no) {
  return {select(condition, yes.point, no.point), select(condition, yes.normal, no.normal),
          select(condition, yes.curvature, no.curvature)};
}
template <class Real>
HWY_INLINE Sym2<Real> shape_operator(const BluntJet<Real>& jet, const TangentBasis<Real>& basis) {
  return project(jet.curvature, basis);
}

/// The same where curvatures may be infinite: moving along the level parameter of the inner (a) or outer (b) pair norm
/// changes the point by points.x and the normal by weight_x · curvature.x / |∇N|.
template <class Real>
struct SharpJet {
  V3<Real> point, normal;
  RankTwo<Real> curvature;
  V3<Real> point_a, point_b;
  Real weight_a, weight_b, steepness;  ///< steepness: |∇N|
};
template <class Real>
HWY_INLINE SharpJet<Real> select(MaskType<Real> condition, const SharpJet<Real>& yes, const SharpJet<Real>& no) {
  return {select(condition, yes.point, no.point),         select(condition, yes.normal, no.normal),
          select(condition, yes.curvature, no.curvature), select(condition, yes.point_a, no.point_a),
          select(condition, yes.point_b, no.point_b),     select(condition, yes.weight_a, no.weight_a),
          select(condition, yes.weight_b, no.weight_b),   select(condition, yes.steepness, no.steepness)};
}
template <class Real>
HWY_INLINE Sym2<Real> shape_operator(const SharpJet<Real>& jet, const TangentBasis<Real>& basis) {
  return project(jet.curvature, basis);
}

/// At a sharp tip curvatures reach this over the body's size instead of ∞: their squares are finite.
constexpr double largest_weight = 1e100;

/// The surface point with these pair norms, and its normal and curvature: K = ∇∇N/|∇N| in the tangent plane.
template <class Jet, class Real>
HWY_INLINE Jet jet_of(const PairNorm<Real>& inner, const PairNorm<Real>& outer, const V3<Real>& sign,
                      const V3<Real>& half_axes, const V3<Real>& inverse_axes) {
  const V3<Real> s{sign.x * half_axes.x, sign.y * half_axes.y, sign.z * half_axes.z};
  const V3<Real> i{sign.x * inverse_axes.x, sign.y * inverse_axes.y, sign.z * inverse_axes.z};
  const V3<Real> gradient{outer.slope.p * inner.slope.p * i.x, outer.slope.p * inner.slope.q * i.y,
                          outer.slope.q * i.z};
  const Real squared = dot(gradient, gradient), flatness = inverse_sqrt(squared), steepness = squared * flatness;
  const Real weight_a = inner.bend * outer.slope_over_hat, weight_b = outer.bend;
  const Real most(largest_weight);
  Jet jet;
  jet.point = {outer.hat.p * inner.hat.p * s.x, outer.hat.p * inner.hat.q * s.y, outer.hat.q * s.z};
  jet.normal = flatness * gradient;
  jet.curvature = {min(weight_a, most) * flatness,
                   min(weight_b, most) * flatness,
                   {inner.hat.q * i.x, -inner.hat.p * i.y, Real(0.0)},
                   {outer.hat.q * inner.slope.p * i.x, outer.hat.q * inner.slope.q * i.y, -outer.hat.p * i.z}};
  if constexpr (requires { jet.point_a; }) {
    jet.point_a = {inner.slope.q * s.x, -inner.slope.p * s.y, Real(0.0)};
    jet.point_b = {outer.slope.q * inner.hat.p * s.x, outer.slope.q * inner.hat.q * s.y, -outer.slope.p * s.z};
    jet.weight_a = weight_a;
    jet.weight_b = weight_b;
    jet.steepness = steepness;
  }
  return jet;
}

template <class Real, class Power>
class GaugeSurface {
 public:
  using Jet = BluntJet<Real>;

  HWY_INLINE explicit GaugeSurface(const SuperquadricNumbers<Real>& body)
      : half_axes_(body.half_axes), norm_(gauge_norm(body.half_axes, body.n1, body.n2)) {}

  HWY_NOINLINE Jet lift(const V3<Real>& point, const V3<Real>&) const {
    const NestedJet<Real> jet = evaluate<Power>(norm_, point);
    return jet_of<Jet>(jet.inner, jet.outer, jet.sign, half_axes_, norm_.scale);
  }

 private:
  V3<Real> half_axes_;
  NestedNorm<Real> norm_;
};

/// Jet of `JetType`: SharpJet where the exponents may be below 2.
template <class JetType, class Real, class Power>
class SupportSurface {
 public:
  using Jet = JetType;

  HWY_INLINE explicit SupportSurface(const SuperquadricNumbers<Real>& body)
      : inverse_axes_(inverse(body.half_axes)), norm_(support_norm(body.half_axes, body.n1, body.n2)) {}

  HWY_NOINLINE Jet support(const V3<Real>& normal) const {
    const NestedJet<Real> jet = evaluate<Power>(norm_, normal);
    return jet_of<Jet>(dual(jet.inner), dual(jet.outer), jet.sign, norm_.scale, inverse_axes_);
  }

 private:
  V3<Real> inverse_axes_;
  NestedNorm<Real> norm_;
};

template <class Real>
class MixedSurface {
 public:
  using Jet = SharpJet<Real>;

  HWY_INLINE explicit MixedSurface(const SuperquadricNumbers<Real>& body)
      : half_axes_(body.half_axes),
        inverse_axes_(inverse(body.half_axes)),
        outer_is_dual_(body.n1 < Real(2.0)),
        inner_exponent_(body.n2),
        inner_dual_(dual_exponent(body.n2)),
        outer_exponent_(select(outer_is_dual_, dual_exponent(body.n1), body.n1)),
        inner_bias_(select(body.n2 < Real(2.0), Real(1.0 / bias), Real(bias))) {}

  HWY_NOINLINE Jet lift(const V3<Real>& point, const V3<Real>& normal) const {
    const V3<Real> c = times(absolute(point), inverse_axes_), m = times(absolute(normal), half_axes_);
    // Near a sharp tip the normals know the direction in the x–y plane, near a flat pole the points, and on the flat
    // side of a pyramid the points up to its tip: there normals turn by (n2 − 1) r^(n2 − 2), r^(n2 − 1) the ratio of
    // the normal's coordinates, r that of the point's.
    const Real c_most = max(c.x, c.y), m_most = max(m.x, m.y);
    const Real turn =
        (inner_exponent_ - Real(1.0)) * (min(m.x, m.y) * c_most) / max(min(c.x, c.y) * m_most, Real(1e-300));
    const Real known = select(inner_exponent_ > Real(4.0), min(square(turn), Real(1.0)), Real(1.0));
    const MaskType<Real> i = known * m_most * max(c_most, c.z) > inner_bias_ * (c_most * max(m_most, m.z));
    const MaskType<Real>& o = outer_is_dual_;
    const PairNorm<Real> inner_seen =
        pair_norm<RealPower>(select(i, m.x, c.x), select(i, m.y, c.y), select(i, inner_dual_, inner_exponent_));
    const PairNorm<Real> inner = select(i, dual(inner_seen), inner_seen);
    // By homogeneity a pair's value is its gradient times its coordinates, whichever side the gradient came from.
    const Real rho = select(o, dot(inner.hat, V2<Real>{m.x, m.y}), dot(inner.slope, V2<Real>{c.x, c.y}));
    const PairNorm<Real> outer_seen = pair_norm<RealPower>(rho, select(o, m.z, c.z), outer_exponent_);
    const PairNorm<Real> outer = select(o, dual(outer_seen), outer_seen);
    const V3<Real> sign =
        sign_of(V3<Real>{select(i, normal.x, point.x), select(i, normal.y, point.y), select(o, normal.z, point.z)});
    return jet_of<Jet>(inner, outer, sign, half_axes_, inverse_axes_);
  }

 private:
  /// How much better the other side must know the inner direction before it is asked.
  static constexpr double bias = 100.0;

  static HWY_INLINE Real dual_exponent(const Real& n) { return n / (n - Real(1.0)); }

  V3<Real> half_axes_, inverse_axes_;
  MaskType<Real> outer_is_dual_;
  Real inner_exponent_, inner_dual_, outer_exponent_, inner_bias_;
};

/// t^power for whole powers 0 … 62, by repeated squaring, as long as any lane needs.
template <class Real>
class WholePower {
 public:
  HWY_INLINE explicit WholePower(const Real& power) : power_(power) {
    for (Real rest = power; any(rest >= Real(1.0)); rest = Real(0.5) * rest) end_ *= 2;
  }
  HWY_INLINE Real operator()(const Real& t) const {
    Real result(1.0), base = t;
    for (std::int64_t bit = 1; bit < end_; bit *= 2) {
      result = select(has_bit(power_, bit), result * base, result);
      base = base * base;
    }
    return result;
  }
  static HWY_INLINE Real quotient(const Real& a) { return floor(a + Real(0.5)); }

 private:
  Real power_;
  std::int64_t end_ = 1;  ///< above the highest bit of any lane
};

/// t^power for any power; 0^0 = 1.
template <class Real>
class AnyPower {
 public:
  HWY_INLINE explicit AnyPower(const Real& power) : power_(power) {}
  HWY_INLINE Real operator()(const Real& t) const {
    return osculate::HWY_NAMESPACE::power(max(t, Real(1e-300)), power_);
  }
  static HWY_INLINE Real quotient(const Real& a) { return a; }

 private:
  Real power_;
};

/// Shape operator: diagonal + mixed · across acrossᵀ, projected.
template <class Real>
struct LevelJet {
  V3<Real> point, normal, diagonal;
  V2<Real> across;  ///< has no z
  Real mixed;
  Real excess;  ///< F − 1 where the guess was: the point is right to its third power
};
template <class Real>
HWY_INLINE Sym2<Real> shape_operator(const LevelJet<Real>& jet, const TangentBasis<Real>& basis) {
  const V3<Real> d1 = times(jet.diagonal, basis.e1), d2 = times(jet.diagonal, basis.e2);
  const Real a1 = fma(jet.across.p, basis.e1.x, jet.across.q * basis.e1.y);
  const Real a2 = fma(jet.across.p, basis.e2.x, jet.across.q * basis.e2.y), m1 = jet.mixed * a1;
  return {fma(m1, a1, dot(d1, basis.e1)), fma(m1, a2, dot(d1, basis.e2)), fma(jet.mixed * a2, a2, dot(d2, basis.e2))};
}

/// The implicit form F = (X^n2 + Y^n2)^k + Z^n1 = N^n1, X = |x|/a …, k = n1/n2: no roots. Its level sets are those of
/// the gauge, so normals are right off the surface too; the point is brought back to second order in F − 1, which
/// is good near the surface only. Near a pole with n1 < n2, where the powers of the sum overflow, it gives NaN.
template <class Real, class Power>
class ImplicitSurface {
 public:
  using Jet = LevelJet<Real>;

  HWY_INLINE explicit ImplicitSurface(const SuperquadricNumbers<Real>& body)
      : ImplicitSurface(body, reciprocal(body.half_axes.x * body.half_axes.y * body.half_axes.z),
                        reciprocal(body.n1 * body.n2)) {}

  HWY_INLINE Jet lift(const V3<Real>& point, const V3<Real>&) const {
    const Real one(1.0), zero(0.0);
    const V3<Real> c = times(point, inverse_axes_), r = absolute(c);
    const Real wx = inner_(r.x), wy = inner_(r.y), wz = outer_(r.z);
    const Real sum = fma(wx * r.x, r.x, wy * r.y * r.y);  // X^n2 + Y^n2
    Real steeper = zero, steep = one;                     // sum^(k−2), sum^(k−1)
    if (any(nested_)) {
      steeper = multiple_(sum);
      steep = select(nested_, steeper * sum, one);
    }
    const Real excess = fma(steep, sum, fma(wz * r.z, r.z, -one));
    // ∇F/n1
    const V2<Real> along{wx * c.x * inverse_axes_.x, wy * c.y * inverse_axes_.y};
    const V3<Real> gradient{steep * along.p, steep * along.q, wz * c.z * inverse_axes_.z};
    // Level sets are homothetic: curvatures at the surface are those at the guess times N.
    // (1 + excess)^(−1/n1)
    const Real half(0.5), step = excess * inverse_n1_;
    const Real back = fma(step * half, fma(step, one, excess), one - step);
    const Real unit = inverse_sqrt(dot(gradient, gradient)), flatness = unit * reciprocal(back);
    const Real inner_weight = flatness * steep * (n2_ - one);
    Jet jet;
    jet.point = back * point;
    jet.normal = unit * gradient;
    jet.diagonal = {inner_weight * wx * square(inverse_axes_.x), inner_weight * wy * square(inverse_axes_.y),
                    flatness * (n1_ - one) * wz * square(inverse_axes_.z)};
    jet.across = along;
    jet.mixed = select(nested_, flatness * (n1_ - n2_) * steeper, zero);
    jet.excess = excess;
    return jet;
  }

  /// The outward normal of the level set through any point ≠ 0.
  HWY_INLINE V3<Real> normal(const V3<Real>& point) const {
    const V3<Real> far = times(point, inverse_axes_), size = absolute(far);
    const V3<Real> c = reciprocal(max(max(size.x, size.y), size.z)) * far, r = absolute(c);
    const Real wx = inner_(r.x), wy = inner_(r.y), wz = outer_(r.z);
    const Real sum = fma(wx * r.x, r.x, wy * r.y * r.y);
    const Real steep = any(nested_) ? select(nested_, multiple_(sum) * sum, Real(1.0)) : Real(1.0);
    return normalised(times({steep * wx * c.x, steep * wy * c.y, wz * c.z}, inverse_axes_));
  }

 private:
  HWY_INLINE ImplicitSurface(const SuperquadricNumbers<Real>& body, const Real& inverse_product, const Real& share)
      : inverse_axes_{body.half_axes.y * body.half_axes.z * inverse_product,
                      body.half_axes.z * body.half_axes.x * inverse_product,
                      body.half_axes.x * body.half_axes.y * inverse_product},
        n1_(body.n1),
        n2_(body.n2),
        inverse_n1_(body.n2 * share),
        inner_(body.n2 - Real(2.0)),
        outer_(body.n1 - Real(2.0)),
        nested_(!(body.n1 == body.n2)),
        multiple_(Power::quotient(body.n1 * body.n1 * share) - Real(2.0)) {}

  V3<Real> inverse_axes_;
  Real n1_, n2_, inverse_n1_;
  Power inner_, outer_;
  MaskType<Real> nested_;
  Power multiple_;
};

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
