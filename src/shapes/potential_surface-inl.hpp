// Potential particles as the contact solver sees them: surface points to second order, in the body frame.
#if defined(OSCULATE_SHAPES_POTENTIAL_SURFACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_SHAPES_POTENTIAL_SURFACE_INL
#undef OSCULATE_SHAPES_POTENTIAL_SURFACE_INL
#else
#define OSCULATE_SHAPES_POTENTIAL_SURFACE_INL
#endif

#include <limits>
#include <vector>

#include "core/vector-inl.hpp"
#include "osculate/core/aligned_allocator.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Symmetric 3×3 matrix.
template <class Real>
struct Sym3 {
  Real xx, yy, zz, xy, yz, zx;

  /// + weight · a aᵀ
  HWY_INLINE void add(const Real& weight, const V3<Real>& a) {
    const V3<Real> w = weight * a;
    xx += w.x * a.x;
    yy += w.y * a.y;
    zz += w.z * a.z;
    xy += w.x * a.y;
    yz += w.y * a.z;
    zx += w.z * a.x;
  }
};
template <class Real>
HWY_INLINE Sym3<Real> select(MaskType<Real> condition, const Sym3<Real>& yes, const Sym3<Real>& no) {
  return {select(condition, yes.xx, no.xx), select(condition, yes.yy, no.yy), select(condition, yes.zz, no.zz),
          select(condition, yes.xy, no.xy), select(condition, yes.yz, no.yz), select(condition, yes.zx, no.zx)};
}
template <class Real>
HWY_INLINE V3<Real> operator*(const Sym3<Real>& m, const V3<Real>& v) {
  return {fma(m.xx, v.x, fma(m.xy, v.y, m.zx * v.z)), fma(m.xy, v.x, fma(m.yy, v.y, m.yz * v.z)),
          fma(m.zx, v.x, fma(m.yz, v.y, m.zz * v.z))};
}
/// The solution of m x = v for a positive definite matrix, by m = L D Lᵀ: a flat face makes m too ill-conditioned for
/// its adjugate.
template <class Real>
HWY_INLINE V3<Real> solve(const Sym3<Real>& m, const V3<Real>& v) {
  const Real one(1.0);
  const Real over_x = one / m.xx, l_yx = m.xy * over_x, l_zx = m.zx * over_x;
  const Real over_y = one / (m.yy - l_yx * m.xy), below = m.yz - l_yx * m.zx, l_zy = below * over_y;
  const Real over_z = one / (m.zz - l_zx * m.zx - l_zy * below);
  const Real y = v.y - l_yx * v.x, z = (v.z - l_zx * v.x - l_zy * y) * over_z;
  const Real solved_y = y * over_y - l_zy * z;
  return {v.x * over_x - l_yx * solved_y - l_zx * z, solved_y, z};
}

/// A surface point whose shape operator is a full symmetric matrix of tangents.
template <class Real>
struct ImplicitJet {
  V3<Real> point, normal;
  Sym3<Real> curvature;
};
template <class Real>
HWY_INLINE ImplicitJet<Real> select(MaskType<Real> condition, const ImplicitJet<Real>& yes,
                                    const ImplicitJet<Real>& no) {
  return {select(condition, yes.point, no.point), select(condition, yes.normal, no.normal),
          select(condition, yes.curvature, no.curvature)};
}
template <class Real>
HWY_INLINE Sym2<Real> shape_operator(const ImplicitJet<Real>& jet, const TangentBasis<Real>& basis) {
  const V3<Real> c1 = jet.curvature * basis.e1, c2 = jet.curvature * basis.e2;
  return {dot(basis.e1, c1), dot(basis.e1, c2), dot(basis.e2, c2)};
}

template <class Real>
struct PotentialPlane {
  V3<Real> normal;
  Real distance;
};

/// A potential particle's numbers: f = of_planes Σ⟨a·x − d⟩² + of_sphere |x|² − 1. Each lane may hold another shape;
/// those with fewer planes are filled up with planes of zero normal, which are never in play.
template <class Real>
struct PotentialNumbers {
  std::vector<PotentialPlane<Real>, AlignedAllocator<PotentialPlane<Real>>> planes;
  Real of_planes, of_sphere;
  Real face_offset;  ///< no plane lets the surface further out than d + this; ∞ for spheres
  Real farthest;     ///< R/√k: no point is further out
  mutable std::vector<Real, AlignedAllocator<Real>>
      in_play;  ///< 1 or 0 for each plane, while the support point is sought
};

template <class Real>
class PotentialSurface {
 public:
  using Jet = ImplicitJet<Real>;

  HWY_INLINE explicit PotentialSurface(const PotentialNumbers<Real>& body) : body_(&body) {}

  /// The surface point on the ray through `point` ≠ 0.
  HWY_NOINLINE Jet lift(const V3<Real>& point, const V3<Real>&) const { return jet_at(stretch(point) * point); }

  HWY_NOINLINE Jet support(const V3<Real>& normal) const {
    const V3<Real> point = follow_to_support_point(normal);
    return jet_at(stretch(point) * point);
  }

 private:
  /// The t > 0 with f(t x) = 0. f is convex along the ray: whatever the first step of Newton's method gives is not
  /// below, and from above the steps decrease monotonically until rounding stops them.
  HWY_NOINLINE Real stretch(const V3<Real>& x) const {
    const Real zero(0.0), two(2.0);
    const Real sphere = body_->of_sphere * dot(x, x), inverse_length = Real(1.0) / norm(x);
    Real t(1.0), above = body_->farthest * inverse_length;
    constexpr int enough_steps = 100;
    for (int step = 0; step < enough_steps; ++step) {
      Real value = sphere * t * t - Real(1.0), slope = two * sphere * t;
      for (const PotentialPlane<Real>& plane : body_->planes) {
        const Real along = dot(plane.normal, x), beyond = max(along * t - plane.distance, zero);
        const Real weight = body_->of_planes * beyond;
        value += weight * beyond;
        slope += two * weight * along;
        if (step == 0) above = select(along > zero, min(above, (plane.distance + body_->face_offset) / along), above);
      }
      const Real next = min(t - value / slope, above);
      const MaskType<Real> moves = step == 0 ? next == next : next < t;
      t = select(moves, next, t);
      if (step > 0 && !any(moves)) break;
    }
    return t;
  }

  HWY_NOINLINE Jet jet_at(const V3<Real>& point) const {
    const Real zero(0.0), two(2.0);
    V3<Real> gradient = (two * body_->of_sphere) * point;
    for (const PotentialPlane<Real>& plane : body_->planes) {
      const Real beyond = max(dot(plane.normal, point) - plane.distance, zero);
      gradient = gradient + (two * body_->of_planes * beyond) * plane.normal;
    }
    const Real flatness = Real(1.0) / norm(gradient);
    const V3<Real> normal = flatness * gradient;
    const Real of_sphere = two * body_->of_sphere * flatness, of_planes = two * body_->of_planes * flatness;
    Jet jet{point, normal, {of_sphere, of_sphere, of_sphere, zero, zero, zero}};
    // Only tangential parts count. On a face they are zero, which a sum of whole terms would leave to round-off.
    for (const PotentialPlane<Real>& plane : body_->planes) {
      const Real weight = select(dot(plane.normal, point) > plane.distance, of_planes, zero);
      jet.curvature.add(weight, plane.normal - dot(plane.normal, normal) * normal);
    }
    return jet;
  }

  /// The point with ∇f(x) = μ u moves along straight pieces from the centre (μ = 0) to the support point (f = 0): f is
  /// quadratic between the values of μ where a plane comes into play or leaves it.
  HWY_INLINE V3<Real> follow_to_support_point(const V3<Real>& u) const {
    const Real zero(0.0), half(0.5), two(2.0);
    const auto& planes = body_->planes;
    auto& in_play = body_->in_play;
    const Real of_planes = two * body_->of_planes, of_sphere = two * body_->of_sphere;
    for (Real& state : in_play) state = zero;
    Sym3<Real> hessian{of_sphere, of_sphere, of_sphere, zero, zero, zero};
    V3<Real> x{zero, zero, zero};
    Real multiplier(0.0), value(-1.0);
    MaskType<Real> arrived = zero > zero;
    const std::size_t enough_pieces = 4 * planes.size() + 16;
    for (std::size_t piece = 0; piece < enough_pieces; ++piece) {
      const V3<Real> velocity = solve(hessian, u);
      const Real rate = dot(u, velocity);  // f = value + rate (multiplier s + s²/2), s being the increase of μ
      Real length = sqrt(max(multiplier * multiplier - two * value / rate, zero)) - multiplier;
      length = select(arrived, zero, max(length, zero));
      Real turning(-1.0), weight(0.0);
      V3<Real> normal = x;
      for (std::size_t i = 0; i < planes.size(); ++i) {
        const Real approach = dot(planes[i].normal, velocity);
        const MaskType<Real> inside = in_play[i] == zero;
        const MaskType<Real> turns = select(inside, approach > zero, approach < zero);
        const Real until = max((planes[i].distance - dot(planes[i].normal, x)) / approach, zero);
        const MaskType<Real> first = turns & (until < length);
        length = select(first, until, length);
        turning = select(first, Real(static_cast<double>(i)), turning);
        weight = select(first, select(inside, of_planes, -of_planes), weight);
        normal = select(first, planes[i].normal, normal);
      }
      x = x + length * velocity;
      arrived = arrived | (turning < zero);
      if (all(arrived)) break;
      value += rate * length * (multiplier + half * length);
      multiplier += length;
      hessian.add(weight, normal);
      for (std::size_t i = 0; i < planes.size(); ++i) {
        const MaskType<Real> turned = turning == Real(static_cast<double>(i));
        in_play[i] = select(turned, Real(1.0) - in_play[i], in_play[i]);
      }
    }
    return x;
  }

  const PotentialNumbers<Real>* body_;
};

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
