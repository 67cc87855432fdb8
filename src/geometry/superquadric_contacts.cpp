#include "osculate/geometry/superquadric_contacts.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/superquadric_contacts.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "geometry/penetration_hull.hpp"
#include "geometry/superquadric_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// How far from the contact its curvatures may have been found, over the bodies' sizes: see Curvatures.
HWY_INLINE double late_step(const Rows& rows) {
  return rows.tables.curvatures == Curvatures::relative ? 1e-8 : 0.0;
}

/// Shape operators that were cached predict the first step.
template <class Real, class Power>
HWY_INLINE Answer<Real> warm_answer(
    const SurfacePair<Real, ImplicitSurface<Real, Power>, ImplicitSurface<Real, Power>>& pair,
    const Problem<Real>& problem, const Rows& rows) {
  const Cached<Real> last = read_cached<Real>(problem, rows);
  return polish(pair, predict(pair, last.touch, last.basis, last.shape_1, last.shape_2), 8, late_step(rows));
}
template <class Real, class Surface>
HWY_INLINE Answer<Real> warm_answer(const SurfacePair<Real, Surface, Surface>& pair, const Problem<Real>& problem,
                                    const Rows& rows) {
  return polish(pair, {read_touch<Real>(problem, rows), Real(0.0)}, 8, late_step(rows));
}

template <class Real, class Lift>
HWY_NOINLINE std::uint64_t solve_warm(const Rows& rows) {
  const auto problem = problem_of<Real>(rows);
  const Answer<Real> answer = warm_answer(problem.template as<Lift>(), problem, rows);
  return bits(write_answer(problem, answer, answer.converged, rows));
}

/// Pairs whose cache holds a direction and the support points in it. The bodies turn by d against each other; along the
/// mean m of what became of the direction on both, the overlap is at most
///   h1 + h2 + (r1 + r2) |d|/2 − m·(c2 − c1),   r the bodies' radii:
/// most pairs are proved still separated without a look at their surfaces.
template <class Real>
HWY_NOINLINE std::uint64_t check_apart(const Rows& rows) {
  constexpr std::size_t second = SuperquadricPairs::per_body;
  const auto& pairs = rows.tables.pairs.columns;
  const auto& caches = rows.tables.caches.columns;
  const auto in_world = [&](std::size_t body, const V3<Real>& v) HWY_ATTR {
    const Real w = read<Real>(pairs, body + 8, rows);
    const V3<Real> q = read3<Real>(pairs, body + 9, rows), t = Real(2.0) * cross(q, v);
    return v + w * t + cross(q, t);
  };
  const auto sum = [](const V3<Real>& v) HWY_ATTR { return v.x + v.y + v.z; };
  const V3<Real> u1 = read3<Real>(caches, 3, rows), u2 = read3<Real>(caches, 9, rows);
  const Real h1 = dot(read3<Real>(caches, 0, rows), u1), h2 = dot(read3<Real>(caches, 6, rows), u2);
  const V3<Real> n1 = in_world(0, u1), n2 = in_world(second, u2);
  const Real half(0.5), turn = sum(absolute(n1 + n2));
  const V3<Real> mean = half * (n1 - n2);
  const V3<Real> between = read3<Real>(pairs, second + 5, rows) - read3<Real>(pairs, 5, rows);
  const Real reach = sum(read3<Real>(pairs, 0, rows)) + sum(read3<Real>(pairs, second, rows));
  const Real overlap = (h1 + h2) + half * reach * turn - dot(mean, between);
  const MaskType<Real> apart = overlap < Real(-1e-14) * (reach + sum(absolute(between)));
  write_direction(normalised(mean), overlap, ContactStatus::separated, apart, rows);
  return bits(apart);
}

/// The same with the surfaces' answer to the direction.
template <class Real, class Support>
HWY_NOINLINE std::uint64_t check_direction(const Rows& rows) {
  const auto problem = problem_of<Real>(rows);
  const auto supports = problem.template as<Support>();
  const Touch<Real> last = read_touch<Real>(problem, rows);
  const V3<Real> direction = normalised(last.normal_1 - last.normal_2);
  const V3<Real> point_1 = supports.support_1(direction).point, point_2 = supports.support_2(-direction).point;
  const Real overlap = dot(point_1 - point_2, direction);
  const MaskType<Real> apart = overlap < Real(0.0);
  write_separation(problem, Touch<Real>{point_1, direction, point_2, -direction}, overlap, apart, rows);
  return bits(apart);
}

/// Where a descent starts.
enum class Origin {
  nothing,  ///< the best of a few directions
  cache,    ///< of these and the cached one
};

/// Leaves the best direction in the cache where it finds no answer.
template <class Real, class Lift, class Support>
HWY_NOINLINE std::uint64_t solve_cold(const Rows& rows, const Effort& effort, Origin origin) {
  const auto problem = problem_of<Real>(rows);
  const auto lifts = problem.template as<Lift>();
  const auto supports = problem.template as<Support>();
  V3<Real> start = first_direction(lifts, supports);
  if (origin == Origin::cache) {
    const Touch<Real> last = read_touch<Real>(problem, rows);
    const V3<Real> cached = normalised(last.normal_1 - last.normal_2);
    start = select(overlap_along(supports, cached) < overlap_along(supports, start), cached, start);
  }
  Real least(0.0);
  const Touch<Real> touch = descend(lifts, supports, start, effort, least);
  MaskType<Real> solved = !(least == least);
  if (rows.tables.gap == Gap::skip) {
    solved = least < Real(0.0);
    write_separation(problem, touch, least, solved, rows);
    if (all(solved)) return bits(solved);
  }
  const Answer<Real> answer = polish(lifts, {touch, Real(0.0)}, effort.newtons);
  const MaskType<Real> good = answer.converged & (answer.overlap <= least + problem.overlap_tolerance()) & !solved;
  solved = solved | write_answer(problem, answer, good, rows);
  if (!all(solved)) write_touch(problem, touch, (least == least) & !solved, rows);
  return bits((least == least) & solved);
}

/// The axes of both bodies, both ways: where the usual start fails.
constexpr int axis_directions = 12;
template <class Real>
HWY_INLINE V3<Real> axis_direction(const Problem<Real>& problem, int k) {
  const Real zero(0.0), side(k % 2 == 0 ? 1.0 : -1.0);
  const int axis = k / 2 % 3;
  const V3<Real> unit{axis == 0 ? side : zero, axis == 1 ? side : zero, axis == 2 ? side : zero};
  return k < 6 ? unit : problem.rotation.apply(unit);
}

/// Directions in each octant of both bodies, off their planes of symmetry: where two tips meet, a maximum of the
/// overlap lies on these planes, with minima around it.
constexpr int oblique_directions = 16;
template <class Real>
HWY_INLINE V3<Real> oblique_direction(const Problem<Real>& problem, int k) {
  const auto side = [&](int bit, double size) HWY_ATTR { return Real((k >> bit & 1) == 0 ? size : -size); };
  const V3<Real> unit = normalised(V3<Real>{side(0, 0.5), side(1, 0.3), side(2, 0.8)});
  return k < 8 ? unit : problem.rotation.apply(unit);
}

/// Whether an answer that Newton's method did not come to rest at is one all the same: its points lie on the surfaces
/// and on one line along the normal, no point of a body lies further along it, and no direction near it has less
/// overlap. Round-off hides the rest where a rim or a tip meets a face, or where one body is far larger than the other.
template <class Real, class Lifts, class Supports>
HWY_NOINLINE MaskType<Real> is_contact(const Lifts& lifts, const Supports& supports, const Answer<Real>& answer,
                                       const Real& tolerance) {
  constexpr double on_one_line = 1e-9;  // over the smaller body
  constexpr int directions = 8;
  constexpr double eighth = 0.70710678118654752;
  constexpr double ring[directions][2] = {{1, 0},  {eighth, eighth},   {0, 1},  {-eighth, eighth},
                                          {-1, 0}, {-eighth, -eighth}, {0, -1}, {eighth, -eighth}};
  const auto& [point_1, normal_1, point_2, normal_2] = answer.touch;
  const V3<Real>& normal = answer.normal;
  const V3<Real> off_1 = lifts.lift_1(point_1, normal_1).point - point_1;
  const V3<Real> off_2 = lifts.lift_2(point_2, normal_2).point - point_2;
  const V3<Real> apart = point_1 - point_2, off_line = apart - answer.overlap * normal;
  const Real line = Real(on_one_line) * lifts.length;
  MaskType<Real> right = (dot(off_1, off_1) < square(tolerance)) & (dot(off_2, off_2) < square(tolerance)) &
                         (dot(off_line, off_line) < square(line)) &
                         (dot(supports.support_1(normal).point - point_1, normal) < tolerance) &
                         (dot(point_2 - supports.support_2(-normal).point, normal) < tolerance);
  const TangentBasis<Real> basis = tangent_basis(normal);
  for (double turn = 0.1; turn > 1e-6; turn *= 0.4)
    for (int k = 0; k < directions && any(right); ++k) {
      const V2<Real> aside{Real(turn * ring[k][0]), Real(turn * ring[k][1])};
      right = right & (overlap_along(supports, normalised(normal + lift(basis, aside))) > answer.overlap - tolerance);
    }
  return right;
}

/// The few pairs that are left: with patience, then from many starts. The deepest minimum of those found is the answer.
template <class Real>
HWY_NOINLINE std::uint64_t solve_hard(const Rows& rows) {
  const auto problem = problem_of<Real>(rows);
  const auto lifts = problem.template as<MixedSurface<Real>>();
  const auto supports = problem.template as<SupportSurface<SharpJet<Real>, Real, RealPower>>();
  V3<Real> best_direction = first_direction(lifts, supports);
  Real least = overlap_along(supports, best_direction);
  const auto finish = [&](const Touch<Real>& touch, const Real& lowest, MaskType<Real> open) HWY_ATTR {
    Answer<Real> answer = polish(lifts, {touch, Real(0.0)}, stubborn.newtons);
    if (any(open & !answer.converged))
      answer.converged =
          answer.converged | is_contact(lifts, supports, answer, Real(0.5) * problem.overlap_tolerance());
    answer.converged = answer.converged & (answer.overlap <= lowest + problem.overlap_tolerance()) & open;
    const MaskType<Real> lower = open & (lowest < least);
    best_direction = select(lower, touch.normal_1, best_direction);
    least = select(lower, lowest, least);
    return answer;
  };
  const auto attempt = [&](const V3<Real>& direction, MaskType<Real> open) HWY_ATTR {
    Real lowest(0.0);
    const Touch<Real> touch = descend(lifts, supports, direction, stubborn, lowest);
    return finish(touch, lowest, open);
  };
  Answer<Real> best = attempt(best_direction, least == least);
  const auto improve = [&](const Answer<Real>& answer) HWY_ATTR {
    best = select(answer.converged & ((answer.overlap < best.overlap) | !(best.converged)), answer, best);
  };
  if (const MaskType<Real> open = !best.converged; any(open)) {
    const V3<Real> normal = best_direction;
    const auto lift_1 = [&](const V3<Real>& p, const V3<Real>& n) HWY_ATTR { return lifts.lift_1(p, n); };
    const auto lift_2 = [&](const V3<Real>& p, const V3<Real>& n) HWY_ATTR { return lifts.lift_2(p, n); };
    const auto support_1 = [&](const V3<Real>& n) HWY_ATTR { return supports.support_1(n); };
    const auto support_2 = [&](const V3<Real>& n) HWY_ATTR { return supports.support_2(n); };
    const Touch<Real> on_1 = follow(lift_1, support_2, support_1(normal).point, normal);
    const Touch<Real> on_2 = follow(lift_2, support_1, support_2(-normal).point, -normal);
    const Touch<Real> swapped{on_2.point_2, on_2.normal_2, on_2.point_1, on_2.normal_1};
    Real lowest(0.0);
    const Touch<Real> lowered = descend(lifts, supports, normal, usual, lowest);
    for (const Touch<Real>& touch : {on_1, swapped, approach(lifts, lowered)})
      improve(finish(touch, overlap_along(supports, touch.normal_1), open));
  }
  if (const MaskType<Real> open = !best.converged; any(open))
    for (int k = 0; k < axis_directions; ++k) improve(attempt(axis_direction(problem, k), open));
  if (const MaskType<Real> open = !best.converged; any(open))
    for (int k = 0; k < oblique_directions; ++k) improve(attempt(oblique_direction(problem, k), open));
  const MaskType<Real> found =
      write_answer(problem, best, best.converged & (best.overlap <= least + problem.overlap_tolerance()), rows);
  const MaskType<Real> finite = least == least;
  const Real zero(0.0);
  write_failure(problem, best_direction, least, ContactStatus::not_converged, finite & !found, rows);
  write_failure(problem, V3<Real>{zero, zero, zero}, zero, ContactStatus::degenerate, !(finite | found), rows);
  return bits(zero == zero);
}

/// A lower bound of a body's radii of curvature: a_min²/((n − 1) a_max); zero where an exponent is below 2.
inline double least_radius(const double* half_axes, const double* exponents) {
  const auto [smallest, largest] = std::minmax({half_axes[0], half_axes[1], half_axes[2]});
  if (std::min(exponents[0], exponents[1]) < 2.0) return 0.0;
  return smallest * smallest / ((std::max(exponents[0], exponents[1]) - 1.0) * largest);
}

/// A ball of radius R1 + R2, the least radii of curvature, rolls inside the difference body. A minimum of the overlap
/// that is no deeper than that is the only one so shallow, hence the global one.
inline bool is_certainly_global(const SuperquadricPairs& pairs, double overlap, Index i) {
  double radii = 0.0;
  for (const std::size_t body : {std::size_t{0}, SuperquadricPairs::per_body}) {
    double numbers[5];
    for (std::size_t k = 0; k < 5; ++k) numbers[k] = pairs.columns[body + k][i];
    radii += least_radius(numbers, numbers + 3);
  }
  return overlap <= radii;
}

inline Vec3 vec3(const V3<double>& v) {
  return {v.x, v.y, v.z};
}
inline V3<double> v3(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Proves the answers of deep contacts global, or replaces them by deeper-lying minima that the proof comes across;
/// where it meets one that Newton's method cannot settle, the contact is not converged. Pairs that are not converged so
/// far get another chance. A second minimum as shallow as the first within round-off makes the contact ambiguous.
void confirm(const Tables& tables, Index i) {
  constexpr int most_supports = 300, most_searches = 30;
  constexpr std::size_t most_others = 16;
  constexpr double tolerance = 1e-5;    // minima closer than this in overlap are not told apart
  constexpr double same_normal = 0.98;  // cosine: faces nearer than this belong to the minimum itself
  constexpr double same_image = 1.0 - 1e-12, same_basin = 1.0 - 1e-4;
  const Rows rows{tables, i};
  const auto& contacts = tables.contacts;
  const auto problem = problem_of<double>(rows);
  const auto lifts = problem.as<MixedSurface<double>>();
  const auto supports = problem.as<SupportSurface<SharpJet<double>, double, RealPower>>();
  const double equal = problem.overlap_tolerance();
  const V3<double> world{contacts.columns[0][i], contacts.columns[1][i], contacts.columns[2][i]};
  bool found = is_resolved(contacts.statuses[i]);
  double least = contacts.columns[3][i];  // of minima, or of directions if none is found
  V3<double> normal = problem.frame.apply_inverse(problem.swapped ? -world : world);
  double least_seen = least;
  V3<double> direction_seen = normal;

  const auto difference_point = [&](const V3<double>& u) {
    return supports.support_1(u).point - supports.support_2(-u).point;
  };
  const V3<double> centre = -problem.centre_2;
  const auto arm = [&](const V3<double>& u) { return vec3(difference_point(u) - centre); };
  const std::array<Vec3, 3> arms{arm({1.0, 0.0, 0.0}), arm({0.0, 1.0, 0.0}), arm({0.0, 0.0, 1.0})};
  PenetrationHull hull(vec3(centre), arms, problem.size_1 + problem.size_2);
  /// Takes the minimum below a direction if it is lower, or as low and none was found. Returns whether it is one as
  /// low.
  int searches = 0;
  const auto search = [&](const V3<double>& direction) {
    if (++searches > most_searches) return false;
    Answer<double> answer;
    for (const Effort& effort : {usual, stubborn}) {
      double lowest = 0.0;
      const Touch<double> touch = descend(lifts, supports, direction, effort, lowest);
      answer = polish(lifts, {touch, 0.0}, effort.newtons);
      answer.converged =
          (answer.converged || is_contact(lifts, supports, answer, 0.5 * equal)) && answer.overlap <= lowest + equal;
      if (lowest < least_seen) {
        least_seen = lowest;
        direction_seen = touch.normal_1;
      }
      if (answer.converged) break;
    }
    if (!answer.converged || answer.overlap > least + equal) return false;
    if (found && answer.overlap >= least - equal) return dot(answer.normal, normal) <= same_normal;
    write_answer(problem, answer, true, rows);
    found = true;
    least = answer.overlap;
    normal = answer.normal;
    return false;
  };
  for (int k = 0; k < most_supports; ++k) {
    const PenetrationHull::Face* face = hull.lowest();
    if (face == nullptr || face->offset >= (1.0 - tolerance) * least) break;
    const V3<double> direction = v3(face->normal), support_point = difference_point(direction);
    if (dot(support_point, direction) < least - equal) search(direction);
    hull.expand(*face, vec3(support_point));
  }
  // Where tips or rims meet there are several minima, nearly mirror images about the planes of symmetry of a body.
  const V3<double> one_of_them = normal;
  for (int k = 1; k < 8; ++k) {
    const auto mirrored = [&](const V3<double>& n) {
      return V3<double>{(k & 1) != 0 ? -n.x : n.x, (k & 2) != 0 ? -n.y : n.y, (k & 4) != 0 ? -n.z : n.z};
    };
    const auto& rotation = problem.rotation;
    for (const V3<double>& direction :
         {mirrored(one_of_them), rotation.apply(mirrored(rotation.apply_inverse(one_of_them)))})
      if (dot(difference_point(direction), direction) < (1.0 + tolerance) * least &&
          dot(direction, one_of_them) < same_image)
        search(direction);
  }
  // Of the faces as low as the minimum the furthest from it may belong to a neighbour that is hardly lower.
  const PenetrationHull::Face* furthest = nullptr;
  for (const auto& face : hull.faces())
    if (face.offset <= least && dot(v3(face.normal), normal) > same_normal &&
        (furthest == nullptr || dot(v3(face.normal), normal) < dot(v3(furthest->normal), normal)))
      furthest = &face;
  if (furthest != nullptr && dot(v3(furthest->normal), normal) < same_basin) search(v3(furthest->normal));
  // Faces as low as the minimum, elsewhere: one more minimum as good?
  std::vector<V3<double>> elsewhere;
  const auto is_new = [&](const V3<double>& direction) {
    return dot(direction, normal) < same_normal &&
           std::all_of(elsewhere.begin(), elsewhere.end(),
                       [&](const V3<double>& other) { return dot(direction, other) < same_normal; });
  };
  // The difference body is symmetric about its centre: both ways along an axis it reaches as far.
  for (int k = 0; k < axis_directions; k += 2) {
    const V3<double> axis = axis_direction(problem, k);
    const Vec3 along = vec3(axis), reach = k < 6 ? arms[static_cast<std::size_t>(k / 2)] : arm(axis);
    for (const double side : {1.0, -1.0})
      if (reach.dot(along) + side * dot(centre, axis) <= least + equal && is_new(side * axis))
        elsewhere.push_back(side * axis);
  }
  for (const auto& face : hull.faces())
    if (face.offset <= least + equal && elsewhere.size() < most_others && is_new(v3(face.normal)))
      elsewhere.push_back(v3(face.normal));
  for (const V3<double>& direction : elsewhere)
    if (search(direction)) tables.contacts.statuses[i] = ContactStatus::ambiguous;
  if (least_seen < least - equal)
    write_failure(problem, direction_seen, least_seen, ContactStatus::not_converged, true, rows);
}

/// What is done with a pair first: by what its cache holds and by what its exponents allow. `blunt`: none is below 2;
/// `whole`: moreover they are whole numbers, n1 a multiple of n2.
enum Stage : std::uint8_t {
  warm_whole,
  warm_blunt,
  warm_sharp,
  apart,
  cold_twos,
  cold_whole,
  cold_blunt,
  cold_sharp,
  stages
};

/// Sorts the pairs by their first stage.
template <class Real>
std::array<Work, stages> sort_out(const SuperquadricPairs& pairs, const ContactCaches& caches, Gap gap) {
  constexpr Index width = lanes<Real>();
  const Real two(2.0);
  const auto& columns = pairs.columns;
  std::array<Work, stages> work;
  for (Index start = 0; start < pairs.size(); start += width) {
    const Index count = std::min(width, pairs.size() - start);
    const auto exponent = [&](std::size_t column) HWY_ATTR { return load<Real>(columns[column] + start, count); };
    const auto is_whole = [&](const Real& n1, const Real& n2) HWY_ATTR {
      // The quotient is rounded: that it is whole is known by the product.
      const Real multiple = floor(n1 * reciprocal(n2) + Real(0.5));
      return (floor(n2) == n2) & (multiple * n2 == n1);
    };
    const Real n1_1 = exponent(3), n2_1 = exponent(4), n1_2 = exponent(15), n2_2 = exponent(16);
    const Real least = min(min(n1_1, n2_1), min(n1_2, n2_2)), most = max(max(n1_1, n2_1), max(n1_2, n2_2));
    const std::uint64_t blunt = bits(least >= two), twos = bits((least == two) & (most == two));
    const std::uint64_t whole = bits(is_whole(n1_1, n2_1) & is_whole(n1_2, n2_2)) & blunt;
    const auto stage_of = [&](Index i) {
      const auto in = [&](std::uint64_t set) { return (set >> i & 1U) != 0; };
      const ContactCache::State state = caches.states[start + i];
      if (state == ContactCache::State::contact) return in(whole) ? warm_whole : in(blunt) ? warm_blunt : warm_sharp;
      if (state == ContactCache::State::separation && gap == Gap::skip) return apart;
      return in(twos) ? cold_twos : in(whole) ? cold_whole : in(blunt) ? cold_blunt : cold_sharp;
    };
    std::array<Stage, width> stage{};
    for (Index i = 0; i < count; ++i) stage[i] = stage_of(i);
    const bool alike =
        count == width && std::all_of(stage.begin(), stage.end(), [&](Stage s) { return s == stage[0]; });
    if (alike) work[stage[0]].batches.push_back(start);
    for (Index i = 0; i < count && !alike; ++i) work[stage[i]].rows.push_back(start + i);
  }
  return work;
}

/// The stage of a pair whose first one has failed.
inline Stage second_stage(const SuperquadricPairs& pairs, Index i) {
  const double n[] = {pairs.columns[3][i], pairs.columns[4][i], pairs.columns[15][i], pairs.columns[16][i]};
  const auto [least, most] = std::minmax({n[0], n[1], n[2], n[3]});
  return least == 2.0 && most == 2.0 ? cold_twos : least >= 2.0 ? cold_blunt : cold_sharp;
}

template <class Real>
void solve_all(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap,
               Curvatures curvatures, ReadAhead& ahead) {
  using Whole = ImplicitSurface<Real, WholePower<Real>>;
  using Implicit = ImplicitSurface<Real, AnyPower<Real>>;
  using Ellipsoid = GaugeSurface<Real, SquarePower>;
  using Blunt = GaugeSurface<Real, RealPower>;
  using Sharp = MixedSurface<Real>;
  using EllipsoidSupport = SupportSurface<BluntJet<Real>, Real, SquarePower>;
  using BluntSupport = SupportSurface<BluntJet<Real>, Real, RealPower>;
  using SharpSupport = SupportSurface<SharpJet<Real>, Real, RealPower>;

  const Tables tables{pairs, caches, contacts, gap, curvatures, ahead};
  const std::array<Work, stages> first = sort_out<Real>(pairs, caches, gap);
  const auto by_stage = [&](const std::vector<Index>& rows) {
    std::array<Work, stages> work;
    for (const Index i : rows) work[second_stage(pairs, i)].rows.push_back(i);
    return work;
  };
  std::vector<Index> turned_far, unsolved, hard, none;
  Work off_implicit;
  in_batches<Real>(tables, first[warm_whole], off_implicit.rows, solve_warm<Real, Whole>);
  in_batches<Real>(tables, first[warm_blunt], off_implicit.rows, solve_warm<Real, Implicit>);
  in_batches<Real>(tables, off_implicit, unsolved, solve_warm<Real, Blunt>);
  in_batches<Real>(tables, first[warm_sharp], unsolved, solve_warm<Real, Sharp>);

  in_batches<Real>(tables, first[apart], turned_far, check_apart<Real>);
  const auto turned = by_stage(turned_far);
  in_batches<Real>(tables, turned[cold_twos], unsolved, check_direction<Real, EllipsoidSupport>);
  in_batches<Real>(tables, turned[cold_blunt], unsolved, check_direction<Real, BluntSupport>);
  in_batches<Real>(tables, turned[cold_sharp], unsolved, check_direction<Real, SharpSupport>);

  const std::vector<Index> no_longer = unsolved;  // in contact, or apart, as their caches said

  const auto cold = [&]<class Lift, class Support>(const Work& work, const Effort& effort, Origin origin,
                                                   std::vector<Index>& left) {
    in_batches<Real>(tables, work, left,
                     [&](const Rows& rows) { return solve_cold<Real, Lift, Support>(rows, effort, origin); });
  };
  cold.template operator()<Ellipsoid, EllipsoidSupport>(first[cold_twos], usual, Origin::nothing, hard);
  cold.template operator()<Whole, BluntSupport>(first[cold_whole], hasty, Origin::nothing, unsolved);
  cold.template operator()<Implicit, BluntSupport>(first[cold_blunt], hasty, Origin::nothing, unsolved);
  cold.template operator()<Sharp, SharpSupport>(first[cold_sharp], usual, Origin::nothing, hard);
  const auto again = by_stage(unsolved);
  cold.template operator()<Ellipsoid, EllipsoidSupport>(again[cold_twos], usual, Origin::cache, hard);
  Work third;
  cold.template operator()<Implicit, BluntSupport>(again[cold_blunt], brisk, Origin::cache, third.rows);
  cold.template operator()<Blunt, BluntSupport>(third, usual, Origin::cache, hard);
  cold.template operator()<Sharp, SharpSupport>(again[cold_sharp], usual, Origin::cache, hard);
  in_batches<Real>(tables, {{}, hard}, none, solve_hard<Real>);

  const auto prove = [&](Index i) {
    const double overlap = contacts.columns[3][i];
    const ContactStatus status = contacts.statuses[i];
    if (overlap > 0.0 &&
        (status == ContactStatus::not_converged || (is_resolved(status) && !is_certainly_global(pairs, overlap, i))))
      confirm(tables, i);
  };
  for (const Stage stage : {cold_twos, cold_whole, cold_blunt, cold_sharp}) {
    for (const Index batch : first[stage].batches)
      for (Index i = batch; i < batch + lanes<Real>(); ++i) prove(i);
    for (const Index i : first[stage].rows) prove(i);
  }
  for (const Index i : no_longer) prove(i);
}

void batched(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap,
             Curvatures curvatures, ReadAhead& ahead) {
  solve_all<Batch>(pairs, caches, contacts, gap, curvatures, ahead);
}
void scalar(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap,
            Curvatures curvatures, ReadAhead& ahead) {
  solve_all<double>(pairs, caches, contacts, gap, curvatures, ahead);
}
const char* target_name() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {

HWY_EXPORT(batched);
HWY_EXPORT(scalar);
HWY_EXPORT(target_name);

void SuperquadricPairs::set(std::size_t i, const Superquadric& shape_1, const Pose& pose_1, const Superquadric& shape_2,
                            const Pose& pose_2) {
  const auto fill = [&](std::size_t first, const Superquadric& shape, const Pose& pose) {
    const double values[per_body] = {shape.half_axes.x(),  shape.half_axes.y(),  shape.half_axes.z(),
                                     shape.exponents.n1,   shape.exponents.n2,   pose.position.x(),
                                     pose.position.y(),    pose.position.z(),    pose.orientation.w(),
                                     pose.orientation.x(), pose.orientation.y(), pose.orientation.z()};
    for (std::size_t k = 0; k < per_body; ++k) columns[first + k][i] = values[k];
  };
  fill(0, shape_1, pose_1);
  fill(per_body, shape_2, pose_2);
}

namespace {
template <std::size_t N>
Vec3 vector_at(const Columns<N>& columns, std::size_t first, std::size_t i) {
  return {columns[first][i], columns[first + 1][i], columns[first + 2][i]};
}

constexpr std::size_t first_shape = 12;

/// Shape operator `which` of a row.
Vec3 floats_at(const Columns<ContactCaches::width>& columns, std::size_t i, std::size_t which) {
  Vec3 shape;
  for (std::size_t k = 0; k < 3; ++k) {
    float both[2];
    std::memcpy(both, columns[first_shape + k] + i, sizeof both);
    shape[static_cast<Eigen::Index>(k)] = static_cast<double>(both[which]);
  }
  return shape;
}
}  // namespace

void ContactCaches::resize(std::size_t size) {
  states.resize(size, ContactCache::State::empty);
  columns.resize(size);
}

ContactCache ContactCaches::get(std::size_t i) const {
  return {states[i],
          vector_at(columns, 0, i),
          vector_at(columns, 3, i),
          vector_at(columns, 6, i),
          vector_at(columns, 9, i),
          floats_at(columns, i, 0),
          floats_at(columns, i, 1)};
}

void ContactCaches::set(std::size_t i, const ContactCache& cache) {
  states[i] = cache.state;
  const Vec3* vectors[] = {&cache.point_1, &cache.normal_1, &cache.point_2, &cache.normal_2};
  for (std::size_t k = 0; k < first_shape; ++k) columns[k][i] = (*vectors[k / 3])[static_cast<Eigen::Index>(k % 3)];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const float both[] = {static_cast<float>(cache.shape_1[axis]), static_cast<float>(cache.shape_2[axis])};
    std::memcpy(columns[first_shape + k] + i, both, sizeof both);
  }
}

void ContactColumns::resize(std::size_t size) {
  statuses.resize(size, ContactStatus::degenerate);
  columns.resize(size);
}

ContactGeometry ContactColumns::get(std::size_t i) const {
  ContactGeometry contact;
  contact.status = statuses[i];
  contact.normal = vector_at(columns, 0, i);
  contact.overlap = columns[3][i];
  contact.on_1 = vector_at(columns, 4, i);
  contact.on_2 = vector_at(columns, 7, i);
  contact.curvature_1 = {columns[10][i], columns[11][i], vector_at(columns, 12, i)};
  contact.curvature_2 = {columns[15][i], columns[16][i], vector_at(columns, 17, i)};
  contact.relative = {columns[20][i], columns[21][i], vector_at(columns, 22, i), false};
  return contact;
}

void common_normals(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap,
                    Curvatures curvatures) {
  ReadAhead nothing;
  common_normals(pairs, caches, contacts, gap, curvatures, nothing);
}

void common_normals(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap,
                    Curvatures curvatures, ReadAhead& ahead) {
  caches.resize(pairs.size());
  contacts.resize(pairs.size());
  HWY_DYNAMIC_DISPATCH(batched)(pairs, caches, contacts, gap, curvatures, ahead);
}

void common_normals_scalar(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap,
                           Curvatures curvatures) {
  caches.resize(pairs.size());
  contacts.resize(pairs.size());
  ReadAhead nothing;
  HWY_DYNAMIC_DISPATCH(scalar)(pairs, caches, contacts, gap, curvatures, nothing);
}

const char* batch_instruction_set() {
  return HWY_DYNAMIC_DISPATCH(target_name)();
}

}  // namespace osculate
#endif
