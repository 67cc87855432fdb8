// The common normal of two convex bodies, as a template over the number type and the kinds of surface.
//
// Newton's method moves a point on each body so that the outward normals become opposite and the points lie on one
// line along them. A surface tells how its normal turns as its point moves: by its shape operator K where curvatures
// are bounded; else by its response A, a matrix between 0 (flat) and 1 (sharp): a displacement y of the surface blown
// up by the length L turns the normal by A y and moves the point by L (1 − A) y. A = LK (1 + LK)⁻¹ stays finite and
// well conditioned on rims too, where K = ∞.
#if defined(OSCULATE_GEOMETRY_COMMON_NORMAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_GEOMETRY_COMMON_NORMAL_INL
#undef OSCULATE_GEOMETRY_COMMON_NORMAL_INL
#else
#define OSCULATE_GEOMETRY_COMMON_NORMAL_INL
#endif

#include "shapes/superquadric_surface-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// The outward normal where `lift` finds the point, for surfaces that have no cheaper way to it.
template <class Surface, class Real>
HWY_INLINE V3<Real> normal_at(const Surface& surface, const V3<Real>& point, const V3<Real>& normal) {
  return surface.lift(point, normal).normal;
}
template <class Real, class Power>
HWY_INLINE V3<Real> normal_at(const ImplicitSurface<Real, Power>& surface, const V3<Real>& point, const V3<Real>&) {
  return surface.normal(point);
}

/// Two surfaces in the frame of the first.
template <class Real, class Surface1, class Surface2>
struct SurfacePair {
  using Number = Real;

  Surface1 surface_1;
  Surface2 surface_2;
  Rotation<Real> rotation;  ///< frame of body 2 → frame of body 1
  V3<Real> centre_2;
  Real length, inverse_length;  ///< L, of the order of the smaller body
  Real share_1, share_2;        ///< L over each body's own size
  Real round_off;               ///< of coordinates, over L

  HWY_INLINE auto lift_1(const V3<Real>& point, const V3<Real>& normal) const { return surface_1.lift(point, normal); }
  HWY_INLINE auto lift_2(const V3<Real>& point, const V3<Real>& normal) const {
    return in_frame_1(surface_2.lift(rotation.apply_inverse(point - centre_2), rotation.apply_inverse(normal)));
  }
  /// The outward normal only.
  HWY_INLINE V3<Real> normal_1(const V3<Real>& point, const V3<Real>& normal) const {
    return normal_at(surface_1, point, normal);
  }
  HWY_INLINE V3<Real> normal_2(const V3<Real>& point, const V3<Real>& normal) const {
    return rotation.apply(
        normal_at(surface_2, rotation.apply_inverse(point - centre_2), rotation.apply_inverse(normal)));
  }
  HWY_INLINE auto support_1(const V3<Real>& normal) const { return surface_1.support(normal); }
  HWY_INLINE auto support_2(const V3<Real>& normal) const {
    return in_frame_1(surface_2.support(rotation.apply_inverse(normal)));
  }
  /// Second-order parts of a jet stay in the body frame; bases are turned to meet them.
  HWY_INLINE TangentBasis<Real> basis_in_2(const TangentBasis<Real>& basis) const {
    return {rotation.apply_inverse(basis.e1), rotation.apply_inverse(basis.e2)};
  }

 private:
  template <class Jet>
  HWY_INLINE Jet in_frame_1(Jet jet) const {
    jet.point = rotation.apply(jet.point) + centre_2;
    jet.normal = rotation.apply(jet.normal);
    return jet;
  }
};

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

/// One Newton step. In the plane normal to body 1's normal, lengths over L.
template <class Real>
struct Step {
  V2<Real> mismatch;        ///< n1 + n2: zero at the answer
  V2<Real> offset;          ///< p1 − p2: zero at the answer
  Real depth;               ///< (p1 − p2)·n1
  V2<Real> turn_1, turn_2;  ///< changes of the normals
  V2<Real> move_1, move_2;  ///< changes of the points
  Real trust_1, trust_2;    ///< weight of each body's normal where they differ: its radii of curvature
  MaskType<Real> descends;  ///< the second variation of the overlap is not negative: a minimum lies ahead
};

/// Curvatures below this (times L) are round-off: a flat direction is left alone instead of being searched.
constexpr double flat_limit = 1e-14;

/// M y = right with M = sum − (factor + depth) product, the second variation of the overlap seen from body 1.
/// Of convex bodies M = K2 S K1, S = R1 + R2 − δ: S is positive where det M and tr S are; tr M need not be. Inside a
/// wall tr M tells. Traces and determinants are those of the two matrices that M is made of; the trusts are set
/// already. Where the variation is not positive, the overlap term is left out: what remains leads downhill.
template <class Real>
HWY_INLINE V2<Real> solve_second_variation(const Mat2<Real>& sum, const Mat2<Real>& product, double factor,
                                           const Real& trace_1, const Real& trace_2, const Real& determinants,
                                           const V2<Real>& right, Step<Real>& step) {
  const Real zero(0.0), floor_value(flat_limit);
  const auto variation = [&](const Real& depth) {
    Mat2<Real> M = sum + (-(Real(factor) + depth)) * product;
    M.column_1.p += floor_value;
    M.column_2.q += floor_value;
    return M;
  };
  Mat2<Real> M = variation(step.depth);
  Real det = determinant(M);
  const Real trace_of_S = step.trust_1 + step.trust_2 - Real(2.0) * step.depth * determinants;  // times determinants
  const Real noise = floor_value * trace_1 * trace_2 * (trace_1 + trace_2);
  const Real telling = select(min(trace_1, trace_2) >= zero, trace_of_S + noise, trace(M));
  step.descends = (det > zero) & (telling >= zero);
  if (any(!step.descends)) {
    // Lanes that descend keep their very numbers: compiled a second time, a formula may round otherwise.
    const Mat2<Real> without = variation(min(step.depth, zero));
    M = {select(step.descends, M.column_1, without.column_1), select(step.descends, M.column_2, without.column_2)};
    det = select(step.descends, det, max(determinant(without), Real(flat_limit * flat_limit)));
  }
  return reciprocal(det) * (adjugate(M) * right);
}

template <class Real>
HWY_INLINE Mat2<Real> matrix(const Sym2<Real>& m) {
  return {{m.pp, m.pq}, {m.pq, m.qq}};
}

/// From shape operators: (K1 + K2 − δ K2 K1) t1 = −e − K2 r, t2 = t1 − δ K1 t1 + r.
template <class Real>
HWY_INLINE void solve(const Sym2<Real>& shape_1, const Sym2<Real>& shape_2, const Real& length, Step<Real>& step) {
  const Sym2<Real> K1 = length * shape_1, K2 = length * shape_2;
  const V2<Real>&e = step.mismatch, &r = step.offset;
  const Real trace_1 = K1.pp + K1.qq, trace_2 = K2.pp + K2.qq, det_1 = determinant(K1), det_2 = determinant(K2);
  step.trust_1 = trace_1 * det_2;
  step.trust_2 = trace_2 * det_1;
  const V2<Real> t1 = solve_second_variation(matrix(K1 + K2), matrix(K2) * matrix(K1), 0.0, trace_1, trace_2,
                                             det_1 * det_2, Real(-1.0) * (e + K2 * r), step);
  const V2<Real> turn = K1 * t1;
  const V2<Real> t2 = t1 - step.depth * turn + r;
  step.turn_1 = turn;
  step.turn_2 = K2 * t2;
  step.move_1 = t1;
  step.move_2 = t2;
}

/// From responses: (A1 + A2 − (2 + δ) A2 A1) y1 = −e − A2 (r − e), y2 = y1 − (2 + δ) A1 y1 + r − e.
template <class Real>
HWY_INLINE void solve(const Mat2<Real>& A1, const Mat2<Real>& A2, const Real&, Step<Real>& step) {
  const Real two(2.0);
  const V2<Real> e = step.mismatch, d = step.offset - step.mismatch;
  const Real trace_1 = trace(A1), trace_2 = trace(A2), det_1 = determinant(A1), det_2 = determinant(A2);
  step.trust_1 = (trace_1 - two * det_1) * det_2;
  step.trust_2 = (trace_2 - two * det_2) * det_1;
  const V2<Real> y1 =
      solve_second_variation(A1 + A2, A2 * A1, 2.0, trace_1, trace_2, det_1 * det_2, Real(-1.0) * (e + A2 * d), step);
  const V2<Real> turn = A1 * y1;
  const V2<Real> y2 = y1 - (two + step.depth) * turn + d;
  step.turn_1 = turn;
  step.turn_2 = A2 * y2;
  step.move_1 = y1 - step.turn_1;
  step.move_2 = y2 - step.turn_2;
}

/// What `solve` takes from a jet whose curvature is bounded …
template <class Jet, class Real>
HWY_INLINE Sym2<Real> stiffness(const Jet& jet, const TangentBasis<Real>& basis, const Real&) {
  return shape_operator(jet, basis);
}
/// … and from one whose curvature is not.
template <class Real>
HWY_INLINE Mat2<Real> stiffness(const SharpJet<Real>& jet, const TangentBasis<Real>& basis, const Real& length) {
  const Real one(1.0), inverse_length = one / length;
  const Real flat_a = one / (one + jet.weight_a), flat_b = one / (one + jet.weight_b), flatness = one / jet.steepness;
  const Mat2<Real> normals{(jet.weight_a * flat_a * flatness) * coordinates(basis, jet.curvature.a),
                           (jet.weight_b * flat_b * flatness) * coordinates(basis, jet.curvature.b)};
  const Mat2<Real> blown_up{(flat_a * inverse_length) * coordinates(basis, jet.point_a) + normals.column_1,
                            (flat_b * inverse_length) * coordinates(basis, jet.point_b) + normals.column_2};
  return (one / determinant(blown_up)) * (normals * adjugate(blown_up));
}

/// What is wrong with two points.
template <class Pair, class At1, class At2, class Real = typename Pair::Number>
HWY_INLINE Step<Real> residual(const Pair& pair, const At1& at_1, const At2& at_2, const TangentBasis<Real>& basis) {
  const V3<Real> gap = pair.inverse_length * (at_1.point - at_2.point);
  Step<Real> step;
  step.depth = dot(gap, at_1.normal);
  step.mismatch = coordinates(basis, at_2.normal);
  step.offset = coordinates(basis, gap);
  return step;
}
template <class Pair, class Jet1, class Jet2, class Real = typename Pair::Number>
HWY_INLINE void solve(const Pair& pair, const Jet1& jet_1, const Jet2& jet_2, const TangentBasis<Real>& basis,
                      Step<Real>& step) {
  solve(stiffness(jet_1, basis, pair.length), stiffness(jet_2, pair.basis_in_2(basis), pair.length), pair.length, step);
}

template <class Jet1, class Jet2, class Real>
HWY_INLINE Touch<Real> advance(const Jet1& jet_1, const Jet2& jet_2, const TangentBasis<Real>& basis,
                               const Step<Real>& step, const Real& length) {
  return {jet_1.point + length * lift(basis, step.move_1), jet_1.normal + lift(basis, step.turn_1),
          jet_2.point + length * lift(basis, step.move_2), jet_2.normal + lift(basis, step.turn_2)};
}

/// Turns in radians, moves over each body's own size.
template <class Pair, class Real>
HWY_INLINE Real squared_size(const Pair& pair, const Step<Real>& step) {
  return dot(step.turn_1, step.turn_1) + dot(step.turn_2, step.turn_2) +
         square(pair.share_1) * dot(step.move_1, step.move_1) + square(pair.share_2) * dot(step.move_2, step.move_2);
}

/// Cuts a step to this size.
template <class Real>
HWY_INLINE void limit(Step<Real>& step, const Real& squared, const Real& longest) {
  if (!any(squared > longest * longest)) return;
  const Real factor = longest / max(sqrt(squared), longest);
  step.turn_1 = factor * step.turn_1;
  step.turn_2 = factor * step.turn_2;
  step.move_1 = factor * step.move_1;
  step.move_2 = factor * step.move_2;
}

constexpr double longest_step = 0.7;
/// A step of this size is the last: what it leaves undone is its square.
constexpr double small_step = 1e-12;
/// Normals that differ by this are equal (they are known to n units in the last place): points on flat sets move no
/// further.
constexpr double equal_normals = 1e-14;
/// Coordinates of a small body beside a large one have the round-off of the large one's, and its curvature makes
/// normals of it: from this step on normals that differ by less than such round-off, and no longer come closer, are
/// equal …
constexpr int patient_steps = 4;
/// … but never if they differ by more than this.
constexpr double blurred_normals = 1e-9;
/// From steps below this on, the error falls with the square of the step.
constexpr double quadratic_step = 1e-3;
/// An error below this is left, in radians seen from the larger body's size; the surfaces are evaluated once more, for
/// their curvatures.
constexpr double negligible = 1e-13;
/// Below this, steps that no longer shrink are round-off: sharp tips magnify it.
constexpr double stalled_step = 1e-8;

template <class Real>
struct Answer {
  Touch<Real> touch;
  TangentBasis<Real> basis;
  Sym2<Real> shape_1, shape_2;  ///< shape operators in `basis`
  V3<Real> normal;
  Real overlap;
  MaskType<Real> converged;
};

template <class Real>
HWY_INLINE Answer<Real> select(MaskType<Real> condition, const Answer<Real>& yes, const Answer<Real>& no) {
  return {select(condition, yes.touch, no.touch),        select(condition, yes.basis, no.basis),
          select(condition, yes.shape_1, no.shape_1),    select(condition, yes.shape_2, no.shape_2),
          select(condition, yes.normal, no.normal),      select(condition, yes.overlap, no.overlap),
          select(condition, yes.converged, no.converged)};
}

/// Whether the point is on the surface to round-off.
template <class Jet, class Real>
HWY_INLINE MaskType<Real> is_settled(const Jet&, const Real& any_number) {
  return any_number == any_number;
}
template <class Real>
HWY_INLINE MaskType<Real> is_settled(const LevelJet<Real>& jet, const Real&) {
  return abs(jet.excess) < Real(1e-5);
}

/// A start near the answer, and the squared size of the step that led there; 0 if none did.
template <class Real>
struct Start {
  Touch<Real> touch;
  Real last_move;
};

/// Newton's method on points and normals from a start that is near: the warm path, and the end of the cold one.
/// A lane that has arrived stands still, so that its answer does not depend on its neighbours.
/// @param late_step  the surfaces are not evaluated once more after a step shorter than this that brought the points
///                   home: their curvatures are those of where it began
template <class Pair, class Real = typename Pair::Number>
HWY_INLINE Answer<Real> polish(const Pair& pair, const Start<Real>& start, int most_steps, double late_step = 0.0) {
  const Real zero(0.0);
  Answer<Real> answer;
  answer.touch = start.touch;
  answer.converged = !(zero == zero);
  MaskType<Real> closing = answer.converged, blurred = closing;
  Real last_move = start.last_move, last_mismatch = zero;
  const Real left_undone = square(max(Real(negligible) * pair.share_1 * pair.share_2, Real(equal_normals)));
  for (int i = 0; i < most_steps; ++i) {
    const auto jet_1 = pair.lift_1(answer.touch.point_1, answer.touch.normal_1);
    const auto jet_2 = pair.lift_2(answer.touch.point_2, answer.touch.normal_2);
    const TangentBasis<Real> basis = tangent_basis(jet_1.normal);
    const Sym2<Real> shape_1 = shape_operator(jet_1, basis), shape_2 = shape_operator(jet_2, pair.basis_in_2(basis));
    const MaskType<Real> settled = is_settled(jet_1, zero) & is_settled(jet_2, zero);
    Step<Real> step = residual(pair, jet_1, jet_2, basis);
    const Real mismatch = dot(step.mismatch, step.mismatch), offset = dot(step.offset, step.offset);
    const Touch<Real> here{jet_1.point, jet_1.normal, jet_2.point, jet_2.normal};
    if (i == 0) {
      answer.basis = basis;
      answer.shape_1 = shape_1;
      answer.shape_2 = shape_2;
    } else {
      const MaskType<Real>& done = answer.converged;
      answer.basis = select(done, answer.basis, basis);
      answer.shape_1 = select(done, answer.shape_1, shape_1);
      answer.shape_2 = select(done, answer.shape_2, shape_2);
      if (any(closing)) {
        closing = closing & settled & (mismatch < left_undone) & (offset < left_undone) & !done;
        answer.touch = select(closing, here, answer.touch);
        answer.converged = done | closing;
        if (all(answer.converged)) break;
      }
    }
    solve(pair, jet_1, jet_2, basis, step);
    const Real moved = squared_size(pair, step);
    const Real blur = Real(16.0) * pair.round_off;
    MaskType<Real> solved = (mismatch < Real(equal_normals * equal_normals)) & (offset < square(blur));
    if (i >= patient_steps) {
      const Real noise =
          min(Real(3.0) * pair.round_off * pair.length * trace(matrix(shape_1 + shape_2)), Real(blurred_normals));
      const MaskType<Real> lost = (mismatch < square(noise)) & (mismatch >= last_mismatch) & (offset < square(blur));
      blurred = (lost & !solved & !answer.converged) | (blurred & answer.converged);
      solved = solved | lost;
    }
    last_mismatch = mismatch;
    limit(step, moved, Real(longest_step));
    const Touch<Real> next = advance(jet_1, jet_2, basis, step, pair.length);
    // Parallel normals have no tangential mismatch either.
    const MaskType<Real> sound = settled & step.descends & (dot(jet_1.normal, jet_2.normal) < zero);
    const MaskType<Real> stalled =
        (last_move > zero) & (last_move < Real(stalled_step * stalled_step)) & (last_move < Real(4.0) * moved);
    // Of a step s there is left s³/s_last².
    closing = sound & (last_move < Real(quadratic_step * quadratic_step)) &
              (moved * square(moved) < left_undone * square(last_move));
    const MaskType<Real> arrived = (((moved < Real(small_step * small_step)) | solved | stalled) & sound) |
                                   (closing & (moved < Real(late_step * late_step)));
    last_move = moved;
    // What is solved stays: on flat sets the step means nothing.
    answer.touch = select(answer.converged, answer.touch, select(solved & sound, here, next));
    answer.converged = answer.converged | arrived;
    if (all(answer.converged)) break;
  }
  answer.normal = normalised(answer.touch.normal_1 - answer.touch.normal_2);
  if (any(blurred)) {
    // The flatter body knows the normal better, and its support point depends on it more.
    const MaskType<Real> by_1 = trace(matrix(answer.shape_1)) <= trace(matrix(answer.shape_2));
    answer.normal = select(blurred, select(by_1, answer.touch.normal_1, -answer.touch.normal_2), answer.normal);
  }
  answer.overlap = dot(answer.touch.point_1 - answer.touch.point_2, answer.normal);
  return answer;
}

template <class Pair, class Real = typename Pair::Number>
HWY_INLINE Real overlap_along(const Pair& pair, const V3<Real>& direction) {
  return dot(pair.support_1(direction).point - pair.support_2(-direction).point, direction);
}

/// Two ways to the same minimum agree on the overlap within this: relative to L, and to the numbers it is made of.
template <class Real>
HWY_INLINE Real overlap_tolerance(const Real& length, const Real& extent) {
  return Real(1e-12) * length + Real(1e-14) * extent;
}

/// The best of the centre line and both bodies' normals on it.
template <class Lifts, class Supports, class Real = typename Lifts::Number>
HWY_INLINE V3<Real> first_direction(const Lifts& lifts, const Supports& supports) {
  const Real zero(0.0);
  // From coincident centres any direction is as good a start.
  const V3<Real> toward =
      select(dot(lifts.centre_2, lifts.centre_2) > zero, lifts.centre_2, V3<Real>{zero, zero, lifts.length});
  const V3<Real> centre_line = normalised(toward);
  const V3<Real> origin{zero, zero, zero};
  const V3<Real> others[] = {lifts.normal_1(toward, toward), -lifts.normal_2(origin, -toward)};
  V3<Real> best = centre_line;
  Real least = overlap_along(supports, best);
  for (const V3<Real>& other : others) {
    const Real overlap = overlap_along(supports, other);
    const MaskType<Real> better = overlap < least;
    best = select(better, other, best);
    least = select(better, overlap, least);
  }
  return best;
}

/// The first Newton step of a warm start. The bodies have moved, but each surface is what it was at its cached point:
/// the shape operators found there serve again, unevaluated. In the tangent plane `basis` of normal 1.
template <class Pair, class Real = typename Pair::Number>
HWY_INLINE Start<Real> predict(const Pair& pair, const Touch<Real>& last, const TangentBasis<Real>& basis,
                               const Sym2<Real>& shape_1, const Sym2<Real>& shape_2) {
  struct At {
    V3<Real> point, normal;
  };
  const At at_1{last.point_1, last.normal_1}, at_2{last.point_2, last.normal_2};
  Step<Real> step = residual(pair, at_1, at_2, basis);
  solve(shape_1, shape_2, pair.length, step);
  const Real moved = squared_size(pair, step);
  limit(step, moved, Real(longest_step));
  return {advance(at_1, at_2, basis, step, pair.length), moved};
}

/// Below this (curvature times length) a number only stands for the zero curvature in the middle of a face.
constexpr double vanishing_curvature = 1e-30;
/// The principal curvatures of a convex body: those below `vanishing`, where directions are those of underflowing
/// squares, are none.
template <class Real>
HWY_INLINE Eigen2<Real> convex(const Eigen2<Real>& curvature, const Real& vanishing) {
  const Real zero(0.0), one(1.0);
  const MaskType<Real> flat = curvature.max < vanishing;
  return {select(flat, zero, curvature.max),
          select(curvature.min < vanishing, zero, curvature.min),
          {select(flat, one, curvature.direction.p), select(flat, zero, curvature.direction.q)}};
}
/// A surface that is flatter than this (curvature times length) leaves the contact point to round-off.
constexpr double flat_curvature = 1e-9;

/// How hard to try.
struct Effort {
  int descents;          ///< most steps over directions
  double near_step;      ///< a step of this size ends the descent: Newton's method on points and normals does the rest
  double shortest_step;  ///< so does a failure to descend with steps of this size
  int newtons;           ///< most Newton steps
};
constexpr Effort hasty{1, 0.7, 1e-3, 10};
constexpr Effort brisk{6, 0.5, 1e-3, 10};
constexpr Effort usual{16, 0.05, 1e-3, 10};
constexpr Effort stubborn{150, 1e-3, 1e-7, 40};

/// From a unit direction down to the nearest minimum of the overlap. Every step that is kept lowers the overlap.
/// The lifted candidate moves both points along their tangents and blends the normals found there: it crosses faces,
/// where the direction alone is blind. The direct candidate turns the direction: it crosses rims, where the points are.
/// `lifts` answers from a guess of the point, `supports` from the normal.
template <class Lifts, class Supports, class Real = typename Lifts::Number>
HWY_NOINLINE Touch<Real> descend(const Lifts& lifts, const Supports& supports, V3<Real> direction, const Effort& effort,
                                 Real& overlap) {
  const Real one(1.0);
  Real radius(longest_step);
  auto jet_1 = supports.support_1(direction);
  auto jet_2 = supports.support_2(-direction);
  overlap = dot(jet_1.point - jet_2.point, direction);
  MaskType<Real> done = !(overlap == overlap);
  for (int i = 0; i < effort.descents; ++i) {
    const TangentBasis<Real> basis = tangent_basis(jet_1.normal);
    Step<Real> step = residual(supports, jet_1, jet_2, basis);
    solve(supports, jet_1, jet_2, basis, step);
    const Real squared = squared_size(supports, step);
    limit(step, squared, radius);
    const Touch<Real> ahead = advance(jet_1, jet_2, basis, step, lifts.length);
    const V3<Real> normal_1 = lifts.normal_1(ahead.point_1, ahead.normal_1);
    const V3<Real> normal_2 = lifts.normal_2(ahead.point_2, ahead.normal_2);
    const Real share = (step.trust_1 + Real(1e-300)) / (step.trust_1 + step.trust_2 + Real(2e-300));
    V3<Real> next = normalised(share * normal_1 - (one - share) * normal_2);
    auto next_1 = supports.support_1(next);
    auto next_2 = supports.support_2(-next);
    Real next_overlap = dot(next_1.point - next_2.point, next);
    const MaskType<Real> failed = !((next_overlap < overlap) | done);
    if (any(failed)) {
      const V3<Real> direct = normalised(ahead.normal_1 - ahead.normal_2);
      const auto direct_1 = supports.support_1(direct);
      const auto direct_2 = supports.support_2(-direct);
      next_1 = select(failed, direct_1, next_1);
      next_2 = select(failed, direct_2, next_2);
      next = select(failed, direct, next);
      next_overlap = select(failed, dot(direct_1.point - direct_2.point, direct), next_overlap);
    }
    const MaskType<Real> better = (next_overlap < overlap) & !done;
    // Across flat faces an overlap changes by less than its round-off: only points can tell the rest.
    const MaskType<Real> level = next_overlap - overlap < Real(4.0) * lifts.round_off * lifts.length;
    const MaskType<Real> near = (better & (squared < Real(effort.near_step * effort.near_step))) | (level & !better);
    radius = select(better, radius, Real(0.25) * radius);
    direction = select(better, next, direction);
    overlap = select(better, next_overlap, overlap);
    jet_1 = select(better, next_1, jet_1);
    jet_2 = select(better, next_2, jet_2);
    done = done | near | (radius < Real(effort.shortest_step));
    if (all(done)) break;
  }
  return {jet_1.point, jet_1.normal, jet_2.point, jet_2.normal};
}

/// The body that leads gives its normal beneath the point where the other supports that normal, and so on: the error
/// falls by the ratio of their curvatures. Reaches a flat face of a large body, where Newton's method has nothing to go
/// by.
template <class Lift, class Support, class Real>
HWY_INLINE Touch<Real> follow(const Lift& lift, const Support& support, V3<Real> point, V3<Real> normal) {
  constexpr int rounds = 12, corrections = 3;
  for (int i = 1;; ++i) {
    const auto follower = support(-normal);
    for (int k = 0; k < corrections; ++k) {
      const V3<Real> apart = follower.point - point;
      const auto leader = lift(point + apart - dot(apart, normal) * normal, normal);
      point = leader.point;
      normal = leader.normal;
    }
    if (i == rounds) return {point, normal, follower.point, follower.normal};
  }
}

/// Newton's method, damped: every step that is kept lessens what is wrong with normals and points together. Where
/// normals turn with a high power of the way, a whole step from a face goes over its rim.
template <class Pair, class Real = typename Pair::Number>
HWY_NOINLINE Touch<Real> approach(const Pair& pair, const Touch<Real>& start) {
  constexpr int most_steps = 100;
  constexpr double shortest = 1e-12;
  const Real zero(0.0);
  auto jet_1 = pair.lift_1(start.point_1, start.normal_1);
  auto jet_2 = pair.lift_2(start.point_2, start.normal_2);
  const auto wrong_in = [](const Step<Real>& step) {
    return dot(step.mismatch, step.mismatch) + dot(step.offset, step.offset);
  };
  Real reach(longest_step);
  for (int i = 0; i < most_steps; ++i) {
    const TangentBasis<Real> basis = tangent_basis(jet_1.normal);
    Step<Real> step = residual(pair, jet_1, jet_2, basis);
    const Real wrong = wrong_in(step);
    solve(pair, jet_1, jet_2, basis, step);
    limit(step, squared_size(pair, step), reach);
    const Touch<Real> ahead = advance(jet_1, jet_2, basis, step, pair.length);
    const auto next_1 = pair.lift_1(ahead.point_1, ahead.normal_1);
    const auto next_2 = pair.lift_2(ahead.point_2, ahead.normal_2);
    const Real left = wrong_in(residual(pair, next_1, next_2, tangent_basis(next_1.normal)));
    const MaskType<Real> moving = reach >= Real(shortest);
    const MaskType<Real> better = moving & (left < wrong) & (dot(next_1.normal, next_2.normal) < zero);
    jet_1 = select(better, next_1, jet_1);
    jet_2 = select(better, next_2, jet_2);
    reach = select(better, min(Real(2.0) * reach, Real(longest_step)), Real(0.25) * reach);
    if (!any(moving)) break;
  }
  return {jet_1.point, jet_1.normal, jet_2.point, jet_2.normal};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
