#include "osculate/geometry/superquadric_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/superquadric_contacts.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "geometry/common_normal-inl.hpp"
#include "geometry/penetration_hull.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

using Index = std::size_t;

/// Up to one batch of pairs, by their rows.
struct Rows {
  const Index* index;
  Index count;
  bool consecutive;
};

template <class Real>
Rows rows_from(const std::vector<Index>& list, Index start) {
  const Index count = std::min(lanes<Real>(), list.size() - start);
  const Index* index = list.data() + start;
  return {index, count, index[count - 1] - index[0] == count - 1};
}

template <class Real>
HWY_INLINE Real read(const double* column, const Rows& rows) {
  if (rows.consecutive) return load<Real>(column + rows.index[0], rows.count);
  HWY_ALIGN double gathered[lanes<Real>()] = {};
  for (Index i = 0; i < rows.count; ++i) gathered[i] = column[rows.index[i]];
  return load<Real>(gathered, rows.count);
}

/// Writes the lanes whose bit is set.
template <class Real>
HWY_INLINE void write(const Real& value, std::uint64_t wanted, double* column, const Rows& rows) {
  if (rows.consecutive && wanted + 1 == std::uint64_t{1} << rows.count)
    return store(value, column + rows.index[0], rows.count);
  HWY_ALIGN double values[lanes<Real>()];
  store(value, values, lanes<Real>());
  for (Index i = 0; i < rows.count; ++i)
    if ((wanted >> i & 1U) != 0) column[rows.index[i]] = values[i];
}

/// Columns first … of a table, three of them a vector.
template <class Real, std::size_t N>
HWY_INLINE V3<Real> read3(const Columns<N>& columns, std::size_t first, const Rows& rows) {
  return {read<Real>(columns[first], rows), read<Real>(columns[first + 1], rows), read<Real>(columns[first + 2], rows)};
}
template <class Real, std::size_t N>
HWY_INLINE void write3(const V3<Real>& v, std::uint64_t wanted, Columns<N>& columns, std::size_t first,
                       const Rows& rows) {
  write(v.x, wanted, columns[first], rows);
  write(v.y, wanted, columns[first + 1], rows);
  write(v.z, wanted, columns[first + 2], rows);
}

template <class Real>
struct Body {
  V3<Real> half_axes;
  V2<Real> exponents;
  V3<Real> position;
  Real w;
  V3<Real> v;  ///< vector part of the quaternion
};
template <class Real>
HWY_INLINE Body<Real> select(MaskType<Real> condition, const Body<Real>& yes, const Body<Real>& no) {
  return {select(condition, yes.half_axes, no.half_axes), select(condition, yes.exponents, no.exponents),
          select(condition, yes.position, no.position), select(condition, yes.w, no.w), select(condition, yes.v, no.v)};
}
template <class Real>
HWY_INLINE Body<Real> read_body(const SuperquadricPairs& pairs, std::size_t first, const Rows& rows) {
  const auto& columns = pairs.columns;
  return {read3<Real>(columns, first, rows),
          {read<Real>(columns[first + 3], rows), read<Real>(columns[first + 4], rows)},
          read3<Real>(columns, first + 5, rows),
          read<Real>(columns[first + 8], rows),
          read3<Real>(columns, first + 9, rows)};
}

/// Lexicographic order of bodies, so that a pair is always computed from the same side: swapping swaps exactly.
template <class Real>
HWY_INLINE MaskType<Real> precedes(const Body<Real>& a, const Body<Real>& b) {
  MaskType<Real> less = a.position.x < b.position.x, equal = a.position.x == b.position.x;
  const auto then = [&](const Real& p, const Real& q) {
    less = less | (equal & (p < q));
    equal = equal & (p == q);
  };
  if (any(equal)) {
    then(a.position.y, b.position.y);
    then(a.position.z, b.position.z);
    then(a.half_axes.x, b.half_axes.x);
    then(a.half_axes.y, b.half_axes.y);
    then(a.half_axes.z, b.half_axes.z);
    then(a.exponents.p, b.exponents.p);
    then(a.exponents.q, b.exponents.q);
    then(a.w, b.w);
    then(a.v.x, b.v.x);
    then(a.v.y, b.v.y);
    then(a.v.z, b.v.z);
  }
  return less;
}

/// A batch of pairs in the order in which they are computed, and the way back to the caller's.
template <class Real>
struct Problem {
  MaskType<Real> swapped;
  Rotation<Real> frame;  ///< of the first body → world
  V3<Real> origin;
  SuperquadricNumbers<Real> body_1, body_2;
  Rotation<Real> rotation;      ///< frame of the second body → frame of the first
  V3<Real> centre_2;            ///< in the frame of the first
  Real size_1, size_2, length;  ///< largest half-axes, and the smaller of the two

  HWY_INLINE Real coordinate_size() const { return size_1 + size_2 + norm(centre_2); }

  template <class Surface>
  HWY_INLINE SurfacePair<Real, Surface, Surface> as() const {
    const Real inverse_length = Real(1.0) / length;
    return {.surface_1 = Surface(body_1),
            .surface_2 = Surface(body_2),
            .rotation = rotation,
            .centre_2 = centre_2,
            .length = length,
            .inverse_length = inverse_length,
            .share_1 = length / size_1,
            .share_2 = length / size_2,
            .round_off = Real(2.2e-16) * coordinate_size() * inverse_length};
  }
};

template <class Real>
HWY_NOINLINE Problem<Real> problem_of(const SuperquadricPairs& pairs, const Rows& rows) {
  const Body<Real> given_1 = read_body<Real>(pairs, 0, rows);
  const Body<Real> given_2 = read_body<Real>(pairs, SuperquadricPairs::per_body, rows);
  const MaskType<Real> swapped = precedes(given_2, given_1);
  const Body<Real> one = select(swapped, given_2, given_1), two = select(swapped, given_1, given_2);
  const Rotation<Real> frame = rotation_of(one.w, one.v);
  const Real w = one.w * two.w + dot(one.v, two.v);
  const V3<Real> v = one.w * two.v - two.w * one.v - cross(one.v, two.v);
  const auto largest = [](const V3<Real>& axes) { return max(max(axes.x, axes.y), axes.z); };
  const Real size_1 = largest(one.half_axes), size_2 = largest(two.half_axes);
  return {swapped,
          frame,
          one.position,
          {one.half_axes, one.exponents.p, one.exponents.q},
          {two.half_axes, two.exponents.p, two.exponents.q},
          rotation_of(w, v),
          frame.apply_inverse(two.position - one.position),
          size_1,
          size_2,
          min(size_1, size_2)};
}

template <class Real>
HWY_INLINE Touch<Real> read_touch(const ContactCaches& caches, const Problem<Real>& problem, const Rows& rows) {
  const V3<Real> point_1 = read3<Real>(caches.columns, 0, rows), normal_1 = read3<Real>(caches.columns, 3, rows);
  const V3<Real> point_2 = read3<Real>(caches.columns, 6, rows), normal_2 = read3<Real>(caches.columns, 9, rows);
  const auto& swapped = problem.swapped;
  const auto& pair = problem;
  return {select(swapped, point_2, point_1), select(swapped, normal_2, normal_1),
          pair.rotation.apply(select(swapped, point_1, point_2)) + pair.centre_2,
          pair.rotation.apply(select(swapped, normal_1, normal_2))};
}

/// A surface that is flatter than this (curvature times length) leaves the contact point to round-off.
constexpr double flat_curvature = 1e-9;

template <class Real>
HWY_NOINLINE void write_answer(const Problem<Real>& problem, const Answer<Real>& answer, std::uint64_t wanted,
                               ContactColumns& contacts, ContactCaches& caches, const Rows& rows) {
  const auto& swapped = problem.swapped;
  const auto& frame = problem.frame;
  const auto& pair = problem;
  const Real one(1.0);
  const V3<Real> normal = frame.apply(answer.normal);
  const V3<Real> point_1 = frame.apply(answer.touch.point_1) + problem.origin;
  const V3<Real> point_2 = frame.apply(answer.touch.point_2) + problem.origin;
  auto& columns = contacts.columns;
  write3(select(swapped, -normal, normal), wanted, columns, 0, rows);
  write(answer.overlap, wanted, columns[3], rows);
  write3(select(swapped, point_2, point_1), wanted, columns, 4, rows);
  write3(select(swapped, point_1, point_2), wanted, columns, 7, rows);

  const auto in_world = [&](const V2<Real>& t) { return frame.apply(lift(answer.basis, t)); };
  const Real zero(0.0);
  const auto convex = [&](const Sym2<Real>& shape) {
    Eigen2<Real> curvature = eigen(shape);
    curvature.min = max(curvature.min, zero);
    return curvature;
  };
  const Eigen2<Real> first = convex(select(swapped, answer.shape_2, answer.shape_1));
  const Eigen2<Real> second = convex(select(swapped, answer.shape_1, answer.shape_2));
  write(first.max, wanted, columns[10], rows);
  write(first.min, wanted, columns[11], rows);
  write3(in_world(first.direction), wanted, columns, 12, rows);
  write(second.max, wanted, columns[15], rows);
  write(second.min, wanted, columns[16], rows);
  write3(in_world(second.direction), wanted, columns, 17, rows);

  const Eigen2<Real> relative = convex(answer.shape_1 + answer.shape_2);
  write(one / relative.min, wanted, columns[20], rows);
  write(one / relative.max, wanted, columns[21], rows);
  write3(in_world({-relative.direction.q, relative.direction.p}), wanted, columns, 22, rows);

  const V3<Real> point_b = pair.rotation.apply_inverse(answer.touch.point_2 - pair.centre_2);
  const V3<Real> normal_b = pair.rotation.apply_inverse(answer.touch.normal_2);
  write3(select(swapped, point_b, answer.touch.point_1), wanted, caches.columns, 0, rows);
  write3(select(swapped, normal_b, answer.touch.normal_1), wanted, caches.columns, 3, rows);
  write3(select(swapped, answer.touch.point_1, point_b), wanted, caches.columns, 6, rows);
  write3(select(swapped, answer.touch.normal_1, normal_b), wanted, caches.columns, 9, rows);

  const std::uint64_t gaps = bits(answer.overlap < Real(0.0));
  const std::uint64_t flats = bits(relative.min * pair.length < Real(flat_curvature));
  for (Index i = 0; i < rows.count; ++i) {
    if ((wanted >> i & 1U) == 0) continue;
    const bool gap = (gaps >> i & 1U) != 0, flat = (flats >> i & 1U) != 0;
    contacts.statuses[rows.index[i]] = flat  ? ContactStatus::flat
                                       : gap ? ContactStatus::separated
                                             : ContactStatus::touching;
    caches.states[rows.index[i]] = ContactCache::State::contact;
  }
}

/// A direction and the overlap along it, without points: a proof of separation, or the best that was found.
template <class Real>
HWY_NOINLINE void write_direction(const Problem<Real>& problem, const V3<Real>& direction, const Real& overlap,
                                  ContactStatus status, std::uint64_t wanted, ContactColumns& contacts,
                                  ContactCaches& caches, const Rows& rows) {
  const V3<Real> normal = problem.frame.apply(direction);
  auto& columns = contacts.columns;
  write3(select(problem.swapped, -normal, normal), wanted, columns, 0, rows);
  write(overlap, wanted, columns[3], rows);
  for (std::size_t k = 4; k < 25; ++k) write(Real(0.0), wanted, columns[k], rows);
  const V3<Real> normal_b = problem.rotation.apply_inverse(-direction);
  write3(select(problem.swapped, normal_b, direction), wanted, caches.columns, 3, rows);
  for (Index i = 0; i < rows.count; ++i) {
    if ((wanted >> i & 1U) == 0) continue;
    contacts.statuses[rows.index[i]] = status;
    caches.states[rows.index[i]] =
        status == ContactStatus::separated ? ContactCache::State::separation : ContactCache::State::empty;
  }
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
  const V3<Real> others[] = {lifts.lift_1(toward, toward).normal, -lifts.lift_2(origin, -toward).normal};
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

/// Two ways to the same minimum agree on the overlap within this: relative to L, and to the numbers it is made of.
template <class Real>
HWY_INLINE Real overlap_tolerance(const Problem<Real>& problem) {
  return Real(1e-12) * problem.length + Real(1e-14) * problem.coordinate_size();
}

inline std::uint64_t used_lanes(const Rows& rows) {
  return (std::uint64_t{1} << rows.count) - 1;
}

/// Rows whose bit is not set go on the list.
inline void collect(std::vector<Index>& list, std::uint64_t solved, const Rows& rows) {
  for (Index i = 0; i < rows.count; ++i)
    if ((solved >> i & 1U) == 0) list.push_back(rows.index[i]);
}

template <class Real, class Lift>
void solve_warm(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts,
                const std::vector<Index>& list, std::vector<Index>& unsolved) {
  for (Index start = 0; start < list.size(); start += lanes<Real>()) {
    const Rows rows = rows_from<Real>(list, start);
    const auto problem = problem_of<Real>(pairs, rows);
    const Answer<Real> answer = polish(problem.template as<Lift>(), read_touch<Real>(caches, problem, rows), 8);
    const std::uint64_t used = used_lanes(rows);
    const std::uint64_t converged = bits(answer.converged) & used;
    write_answer(problem, answer, converged, contacts, caches, rows);
    if (converged != used) collect(unsolved, converged, rows);
  }
}

/// Pairs whose cache holds a direction: one evaluation proves most of them still separated.
template <class Real, class Support>
void check_separation(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts,
                      const std::vector<Index>& list, std::vector<Index>& unsolved) {
  for (Index start = 0; start < list.size(); start += lanes<Real>()) {
    const Rows rows = rows_from<Real>(list, start);
    const auto problem = problem_of<Real>(pairs, rows);
    const V3<Real> direction_1 = read3<Real>(caches.columns, 3, rows);
    const V3<Real> direction = select(problem.swapped, -problem.rotation.apply(direction_1), direction_1);
    const Real overlap = overlap_along(problem.template as<Support>(), direction);
    const std::uint64_t used = used_lanes(rows), apart = bits(overlap < Real(0.0)) & used;
    write_direction(problem, direction, overlap, ContactStatus::separated, apart, contacts, caches, rows);
    if (apart != used) collect(unsolved, apart, rows);
  }
}

template <class Real, class Lift, class Support>
void solve_cold(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap,
                const std::vector<Index>& list, std::vector<Index>& unsolved) {
  for (Index start = 0; start < list.size(); start += lanes<Real>()) {
    const Rows rows = rows_from<Real>(list, start);
    const auto problem = problem_of<Real>(pairs, rows);
    const auto lifts = problem.template as<Lift>();
    const auto supports = problem.template as<Support>();
    const std::uint64_t used = used_lanes(rows);
    std::uint64_t solved = 0;
    Real least(0.0);
    const Touch<Real> touch = descend(lifts, supports, first_direction(lifts, supports), usual, least);
    if (gap == Gap::skip) {
      solved = bits(least < Real(0.0)) & used;
      write_direction(problem, touch.normal_1, least, ContactStatus::separated, solved, contacts, caches, rows);
    }
    if (solved != used) {
      const Answer<Real> answer = polish(lifts, touch, usual.newtons);
      const auto good = answer.converged & (answer.overlap <= least + overlap_tolerance(problem));
      const std::uint64_t converged = bits(good) & used & ~solved;
      write_answer(problem, answer, converged, contacts, caches, rows);
      solved |= converged;
    }
    if (solved != used) collect(unsolved, solved, rows);
  }
}

/// The axes of both bodies, both ways: where the usual start fails.
template <class Real>
HWY_INLINE V3<Real> axis_direction(const Problem<Real>& problem, int k) {
  const Real zero(0.0), side(k % 2 == 0 ? 1.0 : -1.0);
  const int axis = k / 2 % 3;
  const V3<Real> unit{axis == 0 ? side : zero, axis == 1 ? side : zero, axis == 2 ? side : zero};
  return k < 6 ? unit : problem.rotation.apply(unit);
}

/// The few pairs that are left: with patience, then from many starts. The deepest minimum of those found is the answer.
template <class Real>
void solve_hard(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts,
                const std::vector<Index>& list) {
  for (Index start = 0; start < list.size(); start += lanes<Real>()) {
    const Rows rows = rows_from<Real>(list, start);
    const auto problem = problem_of<Real>(pairs, rows);
    const auto lifts = problem.template as<MixedSurface<Real>>();
    const auto supports = problem.template as<SupportSurface<SharpJet<Real>, Real, RealPower>>();
    const std::uint64_t used = used_lanes(rows);
    V3<Real> best_direction = first_direction(lifts, supports);
    Real least = overlap_along(supports, best_direction);
    const auto attempt = [&](const V3<Real>& direction, MaskType<Real> open) {
      Real lowest(0.0);
      const Touch<Real> touch = descend(lifts, supports, direction, stubborn, lowest);
      Answer<Real> answer = polish(lifts, touch, stubborn.newtons);
      answer.converged = answer.converged & (answer.overlap <= lowest + overlap_tolerance(problem)) & open;
      const MaskType<Real> lower = open & (lowest < least);
      best_direction = select(lower, touch.normal_1, best_direction);
      least = select(lower, lowest, least);
      return answer;
    };
    Answer<Real> best = attempt(best_direction, least == least);
    const MaskType<Real> open = !best.converged;
    for (int k = 0; k < 12 && (bits(open) & used) != 0; ++k) {
      const Answer<Real> answer = attempt(axis_direction(problem, k), open);
      best = select(answer.converged & ((answer.overlap < best.overlap) | !(best.converged)), answer, best);
    }
    const auto found = best.converged & (best.overlap <= least + overlap_tolerance(problem));
    const std::uint64_t converged = bits(found) & used;
    write_answer(problem, best, converged, contacts, caches, rows);
    const std::uint64_t finite = bits(least == least) & used & ~converged;
    write_direction(problem, best_direction, least, ContactStatus::not_converged, finite, contacts, caches, rows);
    const Real zero(0.0);
    write_direction(problem, V3<Real>{zero, zero, zero}, zero, ContactStatus::degenerate, used & ~converged & ~finite,
                    contacts, caches, rows);
  }
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

/// Proves the answers of deep contacts global, or replaces them by deeper-lying minima that the proof comes across.
/// A second minimum as shallow as the first within round-off makes the contact ambiguous.
void confirm(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts,
             const std::vector<Index>& list) {
  constexpr int most_supports = 300;
  constexpr std::size_t most_others = 8;
  constexpr double tolerance = 1e-4;    // minima closer than this in overlap are not told apart
  constexpr double same_normal = 0.95;  // cosine: faces nearer than this belong to the minimum itself
  for (Index start = 0; start < list.size(); ++start) {
    const Rows rows = rows_from<double>(list, start);
    const Index i = list[start];
    const auto problem = problem_of<double>(pairs, rows);
    const auto lifts = problem.as<MixedSurface<double>>();
    const auto supports = problem.as<SupportSurface<SharpJet<double>, double, RealPower>>();
    const double equal = overlap_tolerance(problem);
    double least = contacts.columns[3][i];
    const V3<double> world{contacts.columns[0][i], contacts.columns[1][i], contacts.columns[2][i]};
    V3<double> normal = problem.frame.apply_inverse(problem.swapped ? -world : world);

    const auto difference_point = [&](const V3<double>& u) {
      return supports.support_1(u).point - supports.support_2(-u).point;
    };
    const V3<double> centre = -problem.centre_2;
    const auto arm = [&](const V3<double>& u) { return vec3(difference_point(u) - centre); };
    PenetrationHull hull(vec3(centre), {arm({1.0, 0.0, 0.0}), arm({0.0, 1.0, 0.0}), arm({0.0, 0.0, 1.0})},
                         problem.size_1 + problem.size_2);
    const auto minimum_from = [&](const V3<double>& direction) {
      Answer<double> answer;
      for (const Effort& effort : {usual, stubborn}) {
        double lowest = 0.0;
        const Touch<double> touch = descend(lifts, supports, direction, effort, lowest);
        answer = polish(lifts, touch, effort.newtons);
        answer.converged = answer.converged && answer.overlap <= lowest + equal;
        if (answer.converged) break;
      }
      return answer;
    };
    for (int k = 0; k < most_supports; ++k) {
      const PenetrationHull::Face* face = hull.lowest();
      if (face == nullptr || face->offset >= (1.0 - tolerance) * least) break;
      const V3<double> direction = v3(face->normal), support_point = difference_point(direction);
      if (dot(support_point, direction) < least - equal) {
        const Answer<double> answer = minimum_from(direction);
        if (answer.converged && answer.overlap < least - equal) {
          write_answer(problem, answer, 1, contacts, caches, rows);
          least = answer.overlap;
          normal = answer.normal;
        }
      }
      hull.expand(*face, vec3(support_point));
    }
    // Faces as low as the minimum, elsewhere: one more minimum as good?
    std::vector<V3<double>> elsewhere;
    const auto is_new = [&](const V3<double>& direction) {
      return dot(direction, normal) < same_normal &&
             std::all_of(elsewhere.begin(), elsewhere.end(),
                         [&](const V3<double>& other) { return dot(direction, other) < same_normal; });
    };
    for (const auto& face : hull.faces())
      if (face.offset <= least + equal && elsewhere.size() < most_others && is_new(v3(face.normal)))
        elsewhere.push_back(v3(face.normal));
    for (const V3<double>& direction : elsewhere) {
      const Answer<double> answer = minimum_from(direction);
      if (!answer.converged || answer.overlap > least + equal || dot(answer.normal, normal) > same_normal) continue;
      contacts.statuses[i] = ContactStatus::ambiguous;
      break;
    }
  }
}

/// What the exponents of a pair allow.
enum Exponents : int { all_two, all_blunt, some_sharp };

inline Exponents exponents_of(const SuperquadricPairs& pairs, Index i) {
  const double n[] = {pairs.columns[3][i], pairs.columns[4][i], pairs.columns[15][i], pairs.columns[16][i]};
  if (n[0] == 2.0 && n[1] == 2.0 && n[2] == 2.0 && n[3] == 2.0) return all_two;
  return std::min(std::min(n[0], n[1]), std::min(n[2], n[3])) >= 2.0 ? all_blunt : some_sharp;
}

/// Even exponents, n1 a multiple of n2, in both bodies.
inline bool is_even(const SuperquadricPairs& pairs, Index i) {
  const auto whole = [](double x) { return x == std::floor(x); };
  const auto even = [&](double n1, double n2) { return whole(0.5 * n2) && whole(n1 / n2); };
  return even(pairs.columns[3][i], pairs.columns[4][i]) && even(pairs.columns[15][i], pairs.columns[16][i]);
}

template <class Real>
void solve_all(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap) {
  using Ellipsoid = GaugeSurface<Real, SquarePower>;
  using Blunt = GaugeSurface<Real, RealPower>;
  using Sharp = MixedSurface<Real>;
  using EllipsoidSupport = SupportSurface<BluntJet<Real>, Real, SquarePower>;
  using BluntSupport = SupportSurface<BluntJet<Real>, Real, RealPower>;
  using SharpSupport = SupportSurface<SharpJet<Real>, Real, RealPower>;

  std::vector<Index> warm_even, warm[3], apart[3], unsolved, cold[3], hard;
  for (Index i = 0; i < pairs.size(); ++i) {
    const Exponents exponents = exponents_of(pairs, i);
    if (caches.states[i] == ContactCache::State::contact)
      (exponents != some_sharp && is_even(pairs, i) ? warm_even : warm[exponents]).push_back(i);
    else if (caches.states[i] == ContactCache::State::separation && gap == Gap::skip)
      apart[exponents].push_back(i);
    else
      cold[exponents].push_back(i);
  }
  solve_warm<Real, EvenSurface<Real>>(pairs, caches, contacts, warm_even, unsolved);
  solve_warm<Real, Blunt>(pairs, caches, contacts, warm[all_blunt], unsolved);
  solve_warm<Real, Sharp>(pairs, caches, contacts, warm[some_sharp], unsolved);
  check_separation<Real, EllipsoidSupport>(pairs, caches, contacts, apart[all_two], unsolved);
  check_separation<Real, BluntSupport>(pairs, caches, contacts, apart[all_blunt], unsolved);
  check_separation<Real, SharpSupport>(pairs, caches, contacts, apart[some_sharp], unsolved);
  for (Index i : unsolved) cold[exponents_of(pairs, i)].push_back(i);
  solve_cold<Real, Ellipsoid, EllipsoidSupport>(pairs, caches, contacts, gap, cold[all_two], hard);
  solve_cold<Real, Blunt, BluntSupport>(pairs, caches, contacts, gap, cold[all_blunt], hard);
  solve_cold<Real, Sharp, SharpSupport>(pairs, caches, contacts, gap, cold[some_sharp], hard);
  solve_hard<Real>(pairs, caches, contacts, hard);
  std::vector<Index> deep;
  for (const auto& solved : cold)
    for (Index i : solved)
      if (is_resolved(contacts.statuses[i]) && contacts.columns[3][i] > 0.0 &&
          !is_certainly_global(pairs, contacts.columns[3][i], i))
        deep.push_back(i);
  confirm(pairs, caches, contacts, deep);
}

void batched(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap) {
  solve_all<Batch>(pairs, caches, contacts, gap);
}
void scalar(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap) {
  solve_all<double>(pairs, caches, contacts, gap);
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
}  // namespace

void ContactCaches::resize(std::size_t size) {
  states.resize(size, ContactCache::State::empty);
  columns.resize(size);
}

ContactCache ContactCaches::get(std::size_t i) const {
  return {states[i], vector_at(columns, 0, i), vector_at(columns, 3, i), vector_at(columns, 6, i),
          vector_at(columns, 9, i)};
}

void ContactCaches::set(std::size_t i, const ContactCache& cache) {
  states[i] = cache.state;
  const Vec3* vectors[] = {&cache.point_1, &cache.normal_1, &cache.point_2, &cache.normal_2};
  for (std::size_t k = 0; k < 12; ++k) columns[k][i] = (*vectors[k / 3])[static_cast<Eigen::Index>(k % 3)];
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

void common_normals(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap) {
  caches.resize(pairs.size());
  contacts.resize(pairs.size());
  HWY_DYNAMIC_DISPATCH(batched)(pairs, caches, contacts, gap);
}

void common_normals_scalar(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap) {
  caches.resize(pairs.size());
  contacts.resize(pairs.size());
  HWY_DYNAMIC_DISPATCH(scalar)(pairs, caches, contacts, gap);
}

const char* batch_instruction_set() {
  return HWY_DYNAMIC_DISPATCH(target_name)();
}

}  // namespace osculate
#endif
