// Pairs of superquadrics side by side in the lanes of a Real: what goes into the contact solver and what comes out.
#if defined(OSCULATE_GEOMETRY_SUPERQUADRIC_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_GEOMETRY_SUPERQUADRIC_LANES_INL
#undef OSCULATE_GEOMETRY_SUPERQUADRIC_LANES_INL
#else
#define OSCULATE_GEOMETRY_SUPERQUADRIC_LANES_INL
#endif

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/float_pair-inl.hpp"
#include "geometry/common_normal-inl.hpp"
#include "geometry/superquadric_narrow.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

using Index = std::size_t;

/// The tables of a call.
struct Tables {
  const SuperquadricPairs& pairs;
  ContactCaches& caches;
  ContactColumns& contacts;
  Gap gap;
  Curvatures curvatures;
  ReadAhead& ahead;
};

/// A batch of their rows, one after another.
struct Rows {
  Tables tables;
  Index first;
};

/// Rows that do not stand together, or are fewer than a batch, are copied to where they do.
class Gathered {
 public:
  explicit Gathered(Index width) {
    pairs_.resize(width);
    caches_.resize(width);
    contacts_.resize(width);
  }

  /// Lanes beyond the last row repeat it.
  Rows take(const Tables& tables, std::span<const Index> rows) {
    for (Index i = 0; i < pairs_.size(); ++i) {
      const Index row = rows[std::min(i, rows.size() - 1)];
      copy(tables.pairs.columns, row, pairs_.columns, i);
      copy(tables.caches.columns, row, caches_.columns, i);
      caches_.states[i] = tables.caches.states[row];
    }
    return {{pairs_, caches_, contacts_, tables.gap, tables.curvatures, tables.ahead}, 0};
  }

  /// What was found goes back, lane by lane, and what may help to find the rest.
  void give_back(std::uint64_t found, const Tables& tables, std::span<const Index> rows) const {
    for (Index i = 0; i < rows.size(); ++i) {
      copy(caches_.columns, i, tables.caches.columns, rows[i]);
      if ((found >> i & 1U) == 0) continue;
      copy(contacts_.columns, i, tables.contacts.columns, rows[i]);
      tables.caches.states[rows[i]] = caches_.states[i];
      tables.contacts.statuses[rows[i]] = contacts_.statuses[i];
    }
  }

 private:
  template <std::size_t N>
  static void copy(const Columns<N>& from, Index row, Columns<N>& to, Index other) {
    for (std::size_t k = 0; k < N; ++k) to[k][other] = from[k][row];
  }

  SuperquadricPairs pairs_;
  ContactCaches caches_;
  ContactColumns contacts_;
};

/// What a stage has to do: whole batches of rows that stand together, by their first rows, and single rows.
struct Work {
  std::vector<Index> batches, rows;
};

/// Calls `found = solve(rows)` a batch at a time; rows that are not found go on `unsolved`.
template <class Real, class Solve>
void in_batches(const Tables& tables, const Work& work, std::vector<Index>& unsolved, const Solve& solve) {
  constexpr Index width = lanes<Real>();
  const auto collect = [&](std::uint64_t found, Index count, const auto& row) {
    for (Index i = 0; i < count; ++i)
      if ((found >> i & 1U) == 0) unsolved.push_back(row(i));
  };
  constexpr std::uint64_t all = (std::uint64_t{1} << width) - 1;
  for (const Index first : work.batches) {
    if (const std::uint64_t found = solve(Rows{tables, first}); found != all)
      collect(found, width, [&](Index i) { return first + i; });
    tables.ahead.proceed(passes_of_a_contact * width);
  }
  if (work.rows.empty()) return;
  Gathered gathered(width);
  for (Index start = 0; start < work.rows.size(); start += width) {
    const auto rows = std::span(work.rows).subspan(start, std::min(width, work.rows.size() - start));
    const std::uint64_t found = solve(gathered.take(tables, rows));
    gathered.give_back(found, tables, rows);
    collect(found, rows.size(), [&](Index i) { return rows[i]; });
  }
}

/// Column k of a table; three of them from there on are a vector.
template <class Real, std::size_t N>
HWY_INLINE Real read(const Columns<N>& columns, std::size_t k, const Rows& rows) {
  return load<Real>(columns[k] + rows.first, lanes<Real>());
}
template <class Real, std::size_t N>
HWY_INLINE V3<Real> read3(const Columns<N>& columns, std::size_t k, const Rows& rows) {
  return {read<Real>(columns, k, rows), read<Real>(columns, k + 1, rows), read<Real>(columns, k + 2, rows)};
}
template <class Real, std::size_t N>
HWY_INLINE void write(const Real& value, MaskType<Real> wanted, Columns<N>& columns, std::size_t k, const Rows& rows) {
  store(value, wanted, columns[k] + rows.first);
}
template <class Real, std::size_t N>
HWY_INLINE void write3(const V3<Real>& v, MaskType<Real> wanted, Columns<N>& columns, std::size_t k, const Rows& rows) {
  write(v.x, wanted, columns, k, rows);
  write(v.y, wanted, columns, k + 1, rows);
  write(v.z, wanted, columns, k + 2, rows);
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
HWY_INLINE Body<Real> read_body(const Rows& rows, std::size_t first) {
  const auto& columns = rows.tables.pairs.columns;
  return {read3<Real>(columns, first, rows),
          {read<Real>(columns, first + 3, rows), read<Real>(columns, first + 4, rows)},
          read3<Real>(columns, first + 5, rows),
          read<Real>(columns, first + 8, rows),
          read3<Real>(columns, first + 9, rows)};
}

/// Lexicographic order of bodies, so that a pair is always computed from the same side: swapping swaps exactly.
template <class Real>
HWY_INLINE MaskType<Real> precedes(const Body<Real>& a, const Body<Real>& b) {
  MaskType<Real> less = a.position.x < b.position.x, equal = a.position.x == b.position.x;
  const auto then = [&](const Real& p, const Real& q) HWY_ATTR {
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
  Rotation<Real> rotation;  ///< frame of the second body → frame of the first
  V3<Real> centre_2;        ///< in the frame of the first
  Real size_1, size_2;      ///< largest half-axes
  Real length;              ///< the smaller of the two

  HWY_INLINE Real coordinate_size() const { return size_1 + size_2 + norm(centre_2); }
  HWY_INLINE Real overlap_tolerance() const {
    const auto mean_axis = [](const V3<Real>& axes, const Real& size) HWY_ATTR {
      return size * power(axes.x / size * (axes.y / size) * (axes.z / size), Real(1.0 / 3.0));
    };
    return HWY_NAMESPACE::overlap_tolerance(
        min(mean_axis(body_1.half_axes, size_1), mean_axis(body_2.half_axes, size_2)), coordinate_size());
  }

  template <class Surface>
  HWY_INLINE SurfacePair<Real, Surface, Surface> as() const {
    const Real inverse_1 = reciprocal(size_1), inverse_2 = reciprocal(size_2);
    const Real inverse_length = max(inverse_1, inverse_2);
    return {.surface_1 = Surface(body_1),
            .surface_2 = Surface(body_2),
            .rotation = rotation,
            .centre_2 = centre_2,
            .length = length,
            .inverse_length = inverse_length,
            .share_1 = length * inverse_1,
            .share_2 = length * inverse_2,
            .round_off = Real(2.2e-16) * coordinate_size() * inverse_length};
  }
};

template <class Real>
HWY_NOINLINE Problem<Real> problem_of(const Rows& rows) {
  const Body<Real> given_1 = read_body<Real>(rows, 0);
  const Body<Real> given_2 = read_body<Real>(rows, SuperquadricPairs::per_body);
  Problem<Real> problem;
  problem.swapped = precedes(given_2, given_1);
  const Body<Real> one = select(problem.swapped, given_2, given_1), two = select(problem.swapped, given_1, given_2);
  problem.frame = rotation_of(one.w, one.v);
  problem.origin = one.position;
  problem.body_1 = {one.half_axes, one.exponents.p, one.exponents.q};
  problem.body_2 = {two.half_axes, two.exponents.p, two.exponents.q};
  problem.rotation =
      rotation_of(one.w * two.w + dot(one.v, two.v), one.w * two.v - two.w * one.v - cross(one.v, two.v));
  problem.centre_2 = problem.frame.apply_inverse(two.position - one.position);
  const auto largest = [](const V3<Real>& axes) HWY_ATTR { return max(max(axes.x, axes.y), axes.z); };
  problem.size_1 = largest(one.half_axes);
  problem.size_2 = largest(two.half_axes);
  problem.length = min(problem.size_1, problem.size_2);
  return problem;
}

/// A cached contact, in the frame of the first body.
template <class Real>
struct Cached {
  Touch<Real> touch;
  TangentBasis<Real> basis;     ///< of the first normal
  Sym2<Real> shape_1, shape_2;  ///< in `basis`
};

template <class Real>
HWY_INLINE Touch<Real> read_touch(const Problem<Real>& problem, const Rows& rows) {
  const auto& columns = rows.tables.caches.columns;
  const V3<Real> point_1 = read3<Real>(columns, 0, rows), normal_1 = read3<Real>(columns, 3, rows);
  const V3<Real> point_2 = read3<Real>(columns, 6, rows), normal_2 = read3<Real>(columns, 9, rows);
  const auto& swapped = problem.swapped;
  return {select(swapped, point_2, point_1), select(swapped, normal_2, normal_1),
          problem.rotation.apply(select(swapped, point_1, point_2)) + problem.centre_2,
          problem.rotation.apply(select(swapped, normal_1, normal_2))};
}

/// Shape operators are kept in the basis of the first normal: as the bodies turn about it, that of the second body is
/// off by as little as the surfaces' curvatures vary on the way.
template <class Real>
HWY_INLINE Cached<Real> read_cached(const Problem<Real>& problem, const Rows& rows) {
  const auto& columns = rows.tables.caches.columns;
  Sym2<Real> shape_1, shape_2;
  unpack_floats(read<Real>(columns, 12, rows), shape_1.pp, shape_2.pp);
  unpack_floats(read<Real>(columns, 13, rows), shape_1.pq, shape_2.pq);
  unpack_floats(read<Real>(columns, 14, rows), shape_1.qq, shape_2.qq);
  const auto& swapped = problem.swapped;
  const Touch<Real> touch = read_touch<Real>(problem, rows);
  return {touch, tangent_basis(touch.normal_1), select(swapped, shape_2, shape_1), select(swapped, shape_1, shape_2)};
}

/// Points and normals go into the cache, each in the frame of its body.
template <class Real>
HWY_INLINE void write_touch(const Problem<Real>& problem, const Touch<Real>& touch, MaskType<Real> wanted,
                            const Rows& rows) {
  auto& columns = rows.tables.caches.columns;
  const auto& swapped = problem.swapped;
  const V3<Real> point_b = problem.rotation.apply_inverse(touch.point_2 - problem.centre_2);
  const V3<Real> normal_b = problem.rotation.apply_inverse(touch.normal_2);
  write3(select(swapped, point_b, touch.point_1), wanted, columns, 0, rows);
  write3(select(swapped, normal_b, touch.normal_1), wanted, columns, 3, rows);
  write3(select(swapped, touch.point_1, point_b), wanted, columns, 6, rows);
  write3(select(swapped, touch.normal_1, normal_b), wanted, columns, 9, rows);
}

/// Gives the rows whose lane is wanted this value.
template <class Value, class MaskOfReal>
HWY_INLINE void set_rows(Value value, MaskOfReal wanted, std::vector<Value>& values, const Rows& rows) {
  Value* row = values.data() + rows.first;
  if (all(wanted)) {
    std::fill_n(row, lanes_of(wanted), value);
    return;
  }
  for (std::uint64_t set = bits(wanted); set != 0; set &= set - 1) row[std::countr_zero(set)] = value;
}

/// [1/m] Floats hold it.
constexpr double largest_kept_curvature = 1e37;

/// Returns the lanes that were written: those wanted whose numbers are all finite.
/// With Gap::skip a gap's points and normals serve as a proof of separation from now on.
template <class Real>
HWY_NOINLINE MaskType<Real> write_answer(const Problem<Real>& problem, const Answer<Real>& answer,
                                         MaskType<Real> converged, const Rows& rows) {
  const auto& swapped = problem.swapped;
  const auto& frame = problem.frame;
  auto& columns = rows.tables.contacts.columns;
  const Real zero(0.0), one(1.0);
  const V3<Real> normal = frame.apply(answer.normal);
  const V3<Real> point_1 = frame.apply(answer.touch.point_1) + problem.origin;
  const V3<Real> point_2 = frame.apply(answer.touch.point_2) + problem.origin;
  const auto in_world = [&](const V2<Real>& t) HWY_ATTR { return frame.apply(lift(answer.basis, t)); };
  const Real vanishing = Real(vanishing_curvature) * reciprocal(problem.length);
  const auto principal = [&](const Sym2<Real>& shape) HWY_ATTR { return convex(eigen(shape), vanishing); };
  const Eigen2<Real> relative = principal(answer.shape_1 + answer.shape_2);
  const V3<Real> major_axis = in_world({-relative.direction.q, relative.direction.p});
  // A sum is finite if all its terms are.
  const V3<Real> all = normal + point_1 + point_2 + major_axis;
  Real sum = all.x + all.y + all.z + answer.overlap + relative.max;
  Eigen2<Real> first = relative, second = relative;
  V3<Real> axis_1 = major_axis, axis_2 = major_axis;
  const bool of_bodies = rows.tables.curvatures == Curvatures::all;
  if (of_bodies) {
    first = principal(answer.shape_1), second = principal(answer.shape_2);
    axis_1 = in_world(first.direction), axis_2 = in_world(second.direction);
    const V3<Real> axes = axis_1 + axis_2;
    sum = sum + axes.x + axes.y + axes.z;
  }
  const MaskType<Real> wanted = converged & (sum - sum == zero);

  write3(select(swapped, -normal, normal), wanted, columns, 0, rows);
  write(answer.overlap, wanted, columns, 3, rows);
  write3(select(swapped, point_2, point_1), wanted, columns, 4, rows);
  write3(select(swapped, point_1, point_2), wanted, columns, 7, rows);
  if (of_bodies) {
    const auto write_curvature = [&](const Eigen2<Real>& curvature, const V3<Real>& direction, std::size_t k) HWY_ATTR {
      write(curvature.max, wanted, columns, k, rows);
      write(curvature.min, wanted, columns, k + 1, rows);
      write3(direction, wanted, columns, k + 2, rows);
    };
    write_curvature(select(swapped, second, first), select(swapped, axis_2, axis_1), 10);
    write_curvature(select(swapped, first, second), select(swapped, axis_1, axis_2), 15);
  }
  write(one / relative.min, wanted, columns, 20, rows);
  write(one / relative.max, wanted, columns, 21, rows);
  write3(major_axis, wanted, columns, 22, rows);

  write_touch(problem, answer.touch, wanted, rows);
  // Where curvatures are unbounded they are no start.
  const auto finite = [&](const Sym2<Real>& shape) HWY_ATTR {
    const MaskType<Real> usable = abs(shape.pp) + abs(shape.qq) < Real(largest_kept_curvature);
    return V3<Real>{select(usable, shape.pp, zero), select(usable, shape.pq, zero), select(usable, shape.qq, zero)};
  };
  const V3<Real> kept_a = finite(answer.shape_1), kept_b = finite(answer.shape_2);
  const V3<Real> kept_1 = select(swapped, kept_b, kept_a), kept_2 = select(swapped, kept_a, kept_b);
  write3(V3<Real>{pack_floats(kept_1.x, kept_2.x), pack_floats(kept_1.y, kept_2.y), pack_floats(kept_1.z, kept_2.z)},
         wanted, rows.tables.caches.columns, 12, rows);

  const MaskType<Real> gap = answer.overlap < zero, flat = relative.min * problem.length < Real(flat_curvature);
  set_rows(ContactCache::State::contact, wanted, rows.tables.caches.states, rows);
  if (rows.tables.gap == Gap::skip)
    set_rows(ContactCache::State::separation, wanted & gap, rows.tables.caches.states, rows);
  set_rows(ContactStatus::touching, wanted, rows.tables.contacts.statuses, rows);
  set_rows(ContactStatus::flat, wanted & flat, rows.tables.contacts.statuses, rows);
  set_rows(ContactStatus::separated, wanted & gap, rows.tables.contacts.statuses, rows);
  return wanted;
}

/// A direction and the overlap along it, without points.
template <class Real>
HWY_NOINLINE void write_direction(const V3<Real>& normal, const Real& overlap, ContactStatus status,
                                  MaskType<Real> wanted, const Rows& rows) {
  auto& columns = rows.tables.contacts.columns;
  write3(normal, wanted, columns, 0, rows);
  write(overlap, wanted, columns, 3, rows);
  for (std::size_t k = 4; k < 25; ++k) write(Real(0.0), wanted, columns, k, rows);
  set_rows(status, wanted, rows.tables.contacts.statuses, rows);
}

/// The support points in a direction that separates the bodies.
template <class Real>
HWY_NOINLINE void write_separation(const Problem<Real>& problem, const Touch<Real>& supports, const Real& overlap,
                                   MaskType<Real> wanted, const Rows& rows) {
  const V3<Real> normal = problem.frame.apply(supports.normal_1);
  write_direction(select(problem.swapped, -normal, normal), overlap, ContactStatus::separated, wanted, rows);
  write_touch(problem, supports, wanted, rows);
  set_rows(ContactCache::State::separation, wanted, rows.tables.caches.states, rows);
}

/// The best direction that was found, or zeros.
template <class Real>
HWY_NOINLINE void write_failure(const Problem<Real>& problem, const V3<Real>& direction, const Real& overlap,
                                ContactStatus status, MaskType<Real> wanted, const Rows& rows) {
  const V3<Real> normal = problem.frame.apply(direction);
  write_direction(select(problem.swapped, -normal, normal), overlap, status, wanted, rows);
  set_rows(ContactCache::State::empty, wanted, rows.tables.caches.states, rows);
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
