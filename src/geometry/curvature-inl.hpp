// Principal curvatures over Real (double or Batch).
#if defined(OSCULATE_GEOMETRY_CURVATURE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_GEOMETRY_CURVATURE_INL
#undef OSCULATE_GEOMETRY_CURVATURE_INL
#else
#define OSCULATE_GEOMETRY_CURVATURE_INL
#endif

#include "core/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Principal curvatures, and the shape operator that they diagonalise, in a basis of the tangent plane.
template <class Real>
struct Curvature {
  Sym2<Real> shape_operator;
  Eigen2<Real> principal;
};
template <class Real>
HWY_INLINE Curvature<Real> select(MaskType<Real> condition, const Curvature<Real>& yes, const Curvature<Real>& no) {
  return {select(condition, yes.shape_operator, no.shape_operator), select(condition, yes.principal, no.principal)};
}
/// The determinant of a rank-two sum is w_a w_b (a × b)²: no cancellation for flat faces beside sharp edges.
template <class Real>
HWY_INLINE Curvature<Real> principal(const RankTwo<Real>& m, const TangentBasis<Real>& basis) {
  const V2<Real> a = coordinates(basis, m.a), b = coordinates(basis, m.b);
  const Sym2<Real> projected = project(m, basis);
  const Real area = fma(a.p, b.q, -(a.q * b.p));
  return {projected, eigen(projected, m.weight_a * area * (m.weight_b * area))};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
