// The common normal of two convex bodies, as a template over the number type and the kind of body.
//
// A body answers with a jet: a surface point, its outward normal and the response A of its surface, a matrix between 0
// (flat) and 1 (sharp) in the tangent plane: a displacement y on the surface blown up by the length L turns the normal
// by A y and moves the point by L (1 − A) y. With curvature K, A = LK (1 + LK)⁻¹, but A stays finite and well
// conditioned for faces (K = 0) and for rims (K = ∞) alike, so that one Newton step serves every shape.
#if defined(OSCULATE_GEOMETRY_COMMON_NORMAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_GEOMETRY_COMMON_NORMAL_INL
#undef OSCULATE_GEOMETRY_COMMON_NORMAL_INL
#else
#define OSCULATE_GEOMETRY_COMMON_NORMAL_INL
#endif

#include "core/vector-inl.hpp"
#include "geometry/curvature-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Response of a surface along which the point moves by `points` and the normal turns by `normals` (columns).
template <class Real>
HWY_INLINE Mat2<Real> response(const Mat2<Real>& points, const Mat2<Real>& normals, const Real& length) {
  const Real inverse_length = Real(1.0) / length;
  const Mat2<Real> blown_up = inverse_length * points + normals;
  return (Real(1.0) / determinant(blown_up)) * (normals * adjugate(blown_up));
}

/// A point of each body and the outward normals there, in the frame of body 1.
template <class Real>
struct Touch {
  V3<Real> point_1, normal_1, point_2, normal_2;
};

template <class Real>
HWY_INLINE Touch<Real> select(MaskType<Real> condition, const Touch<Real>& yes, const Touch<Real>& no) {
  return {select(condition, yes.point_1, no.point_1), select(condition, yes.normal_1, no.normal_1),
          select(condition, yes.point_2, no.point_2), select(condition, yes.normal_2, no.normal_2)};
}

/// One Newton step towards n1 = −n2 and (p1 − p2) ∥ n1, and what it was computed from.
template <class Real>
struct Step {
  V3<Real> normal;            ///< of both bodies, from 1 to 2
  TangentBasis<Real> basis;   ///< perpendicular to `normal`
  Real overlap;               ///< (p1 − p2)·normal
  V2<Real> mismatch, offset;  ///< tangential parts of n1 + n2 and (p1 − p2)/L: zero at the answer
  V2<Real> turn_1, turn_2;    ///< changes of the normals
  V2<Real> move_1, move_2;    ///< changes of the points over L
  Real weight_1, weight_2;    ///< trust in each body's normal when they differ: trace of its radii of curvature
  MaskType<Real> descends;    ///< the second variation of the overlap is positive: a minimum lies ahead
};

/// Weights are proportional to tr(1/A − 1), cleared of denominators.
template <class Real>
HWY_INLINE void solve(const Mat2<Real>& A1, const Mat2<Real>& A2, const Real& length, Step<Real>& step) {
  const Real one(1.0), two(2.0);
  const Real det_1 = determinant(A1), det_2 = determinant(A2);
  const Real radii_1 = (trace(A1) - two * det_1) * det_2, radii_2 = (trace(A2) - two * det_2) * det_1;
  step.weight_1 = radii_1;
  step.weight_2 = radii_2;

  // M = A1 + A2 − (2 + δ/L) A2 A1; A2⁻¹ M A1⁻¹ is the second variation R1 + R2 − δ over L.
  const Mat2<Real> product = A2 * A1, sum = A1 + A2;
  Real depth = step.overlap / length;
  Mat2<Real> M = sum + (-two - depth) * product;
  Real det_M = determinant(M);
  step.descends = (det_M > Real(0.0)) & (radii_1 + radii_2 - two * depth * det_1 * det_2 > Real(0.0));
  if (any(!step.descends)) {
    // Without the overlap term the second variation is positive: a descent direction of the overlap.
    depth = select(step.descends, depth, min(depth, Real(0.0)));
    M = sum + (-two - depth) * product;
    det_M = determinant(M);
  }
  const V2<Real>& e = step.mismatch;
  const V2<Real> rho = step.offset - (Real(0.5) * depth) * e;
  const V2<Real> right = -one * (e + A2 * (rho - e));
  const Real tiny(1e-290);
  const V2<Real> y1 = (one / max(det_M, tiny)) * (adjugate(M) * right);
  const V2<Real> A1y1 = A1 * y1;
  const V2<Real> y2 = y1 - (two + depth) * A1y1 + rho - e;
  step.turn_1 = A1y1;
  step.turn_2 = A2 * y2;
  step.move_1 = y1 - step.turn_1;
  step.move_2 = y2 - step.turn_2;
}

/// Both bodies' jets at a pair of surface points, and the step from there.
template <class Pair, class Jet1, class Jet2, class Real = typename Pair::Number>
HWY_INLINE Step<Real> newton_step(const Pair& pair, const Jet1& jet_1, const Jet2& jet_2) {
  Step<Real> step;
  step.normal = normalised(jet_1.normal - jet_2.normal);
  step.basis = tangent_basis(step.normal);
  const V3<Real> gap = jet_1.point - jet_2.point;
  step.overlap = dot(gap, step.normal);
  step.mismatch = coordinates(step.basis, jet_1.normal + jet_2.normal);
  step.offset = (Real(1.0) / pair.length) * coordinates(step.basis, gap);
  solve(pair.response_1(jet_1, step.basis), pair.response_2(jet_2, step.basis), pair.length, step);
  return step;
}

template <class Real>
HWY_INLINE Touch<Real> advance(const Touch<Real>& from, const Step<Real>& step, const Real& length) {
  return {from.point_1 + length * step.basis.lift(step.move_1.p, step.move_1.q),
          from.normal_1 + step.basis.lift(step.turn_1.p, step.turn_1.q),
          from.point_2 + length * step.basis.lift(step.move_2.p, step.move_2.q),
          from.normal_2 + step.basis.lift(step.turn_2.p, step.turn_2.q)};
}

template <class Real>
HWY_INLINE Real largest(const V2<Real>& a) {
  return max(abs(a.p), abs(a.q));
}

/// Steps are cut to this in radians and in lengths L.
constexpr double longest_step = 0.7;

template <class Real>
HWY_INLINE Real size(const Step<Real>& step) {
  return max(max(largest(step.turn_1), largest(step.turn_2)), max(largest(step.move_1), largest(step.move_2)));
}

template <class Real>
HWY_INLINE void limit(Step<Real>& step, const Real& longest) {
  const Real factor = longest / max(size(step), longest);
  step.turn_1 = factor * step.turn_1;
  step.turn_2 = factor * step.turn_2;
  step.move_1 = factor * step.move_1;
  step.move_2 = factor * step.move_2;
}

/// The step is negligible: what it leaves undone is its square.
constexpr double small_step = 1e-10;
/// Both residuals are round-off: points on flat sets move no further.
constexpr double round_off = 4e-16;

template <class Real>
struct Answer {
  Touch<Real> touch;
  TangentBasis<Real> basis;
  Curvature<Real> curvature_1, curvature_2;  ///< in `basis`
  V3<Real> normal;
  Real overlap;
  MaskType<Real> converged;
};

/// Newton's method on points and normals from a start that is near: the warm path, and the end of the cold one.
template <class Pair, class Real = typename Pair::Number>
HWY_INLINE Answer<Real> polish(const Pair& pair, const Touch<Real>& start, MaskType<Real> wanted, int most_steps) {
  Answer<Real> answer;
  answer.touch = start;
  answer.converged = !(wanted | !wanted);
  MaskType<Real> done = !wanted;
  for (int i = 0;; ++i) {
    const auto jet_1 = pair.lift_1(answer.touch.point_1, answer.touch.normal_1);
    const auto jet_2 = pair.lift_2(answer.touch.point_2, answer.touch.normal_2);
    Step<Real> step = newton_step<Pair>(pair, jet_1, jet_2);
    const Real moved = size(step);
    const Real residual = max(largest(step.mismatch), largest(step.offset));
    limit(step, Real(longest_step));
    const Touch<Real> here{jet_1.point, jet_1.normal, jet_2.point, jet_2.normal};
    answer.touch = select(done, answer.touch, advance(here, step, pair.length));
    answer.basis = select(done, answer.basis, step.basis);

    const MaskType<Real> arrived = ((moved < Real(small_step)) | (residual < Real(round_off))) & step.descends & !done;
    answer.converged = answer.converged | arrived;
    const bool last = i + 1 == most_steps || all(done | arrived);
    if (any(arrived)) {
      answer.curvature_1 = select(arrived, pair.curvature_1(jet_1, step.basis), answer.curvature_1);
      answer.curvature_2 = select(arrived, pair.curvature_2(jet_2, step.basis), answer.curvature_2);
    }
    done = done | arrived;
    if (last) break;
  }
  answer.normal = normalised(answer.touch.normal_1 - answer.touch.normal_2);
  answer.overlap = dot(answer.touch.point_1 - answer.touch.point_2, answer.normal);
  return answer;
}

template <class Pair, class Real = typename Pair::Number>
HWY_INLINE Real overlap_along(const Pair& pair, const V3<Real>& direction) {
  return dot(pair.support_1(direction).point - pair.support_2(-direction).point, direction);
}

/// From a unit direction down to the nearest minimum of the overlap. Every step that is kept lowers the overlap.
/// The lifted candidate moves both points along their tangents and blends the normals found there: it crosses faces,
/// where the direction alone is blind. The direct candidate turns the direction: it crosses rims, where the points are.
template <class Pair, class Real = typename Pair::Number>
HWY_INLINE Touch<Real> descend(const Pair& pair, V3<Real> direction, int most_steps, Real& overlap) {
  Real radius(longest_step);
  auto jet_1 = pair.support_1(direction);
  auto jet_2 = pair.support_2(-direction);
  overlap = dot(jet_1.point - jet_2.point, direction);
  MaskType<Real> done = !(overlap == overlap);
  for (int i = 0; i < most_steps; ++i) {
    Step<Real> step = newton_step<Pair>(pair, jet_1, jet_2);
    limit(step, radius);
    const Touch<Real> ahead =
        advance(Touch<Real>{jet_1.point, jet_1.normal, jet_2.point, jet_2.normal}, step, pair.length);
    const V3<Real> normal_1 = pair.lift_1(ahead.point_1, ahead.normal_1).normal;
    const V3<Real> normal_2 = pair.lift_2(ahead.point_2, ahead.normal_2).normal;
    const Real share = step.weight_1 / (step.weight_1 + step.weight_2);
    const V3<Real> lifted = normalised(share * normal_1 - (Real(1.0) - share) * normal_2);
    auto next_1 = pair.support_1(lifted);
    auto next_2 = pair.support_2(-lifted);
    Real next_overlap = dot(next_1.point - next_2.point, lifted);
    V3<Real> next = lifted;
    const MaskType<Real> failed = !((next_overlap < overlap) | done);
    if (any(failed)) {
      const V3<Real> direct = normalised(ahead.normal_1 - ahead.normal_2);
      const auto direct_1 = pair.support_1(direct);
      const auto direct_2 = pair.support_2(-direct);
      const Real direct_overlap = dot(direct_1.point - direct_2.point, direct);
      next_1 = select(failed, direct_1, next_1);
      next_2 = select(failed, direct_2, next_2);
      next = select(failed, direct, next);
      next_overlap = select(failed, direct_overlap, next_overlap);
    }
    const MaskType<Real> better = (next_overlap < overlap) & !done;
    const V3<Real> turned = next - direction;
    const MaskType<Real> near = better & (dot(turned, turned) < Real(1e-4));
    radius = select(better, radius, Real(0.25) * radius);
    direction = select(better, next, direction);
    overlap = select(better, next_overlap, overlap);
    jet_1 = select(better, next_1, jet_1);
    jet_2 = select(better, next_2, jet_2);
    done = done | near | (radius < Real(1e-3));
    if (all(done)) break;
  }
  return {jet_1.point, jet_1.normal, jet_2.point, jet_2.normal};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
