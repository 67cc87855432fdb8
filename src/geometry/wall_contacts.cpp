// Particles against walls: what the template solver polishes is found from the particle's support points.
#include <algorithm>
#include <cstdint>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/wall_contacts.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "geometry/pair_lanes-inl.hpp"
#include "osculate/geometry/plane_contacts.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// A batch of particles of one kind against walls of one kind, in the particles' frames.
template <class Real, class Kind>
class WallPair {
 public:
  using Lift = typename Kind::template Lift<Real>;
  using Support = typename Kind::template Support<Real>;

  HWY_INLINE WallPair(const Jobs& jobs, const Real& wall_radius)
      : radius(wall_radius), placement(placement_of<Real>(jobs)), wall_origin(placement.centre_2) {
    read_numbers(
        jobs, [](const PairJob& job) -> const Shape& { return *job.shape_1; }, numbers_);
    size = size_of(numbers_);
    length = min(size, Real(0.5) * radius);
  }

  HWY_INLINE V3<Real> axis() const { return placement.rotation.column_z; }
  HWY_INLINE Real tolerance() const { return overlap_tolerance(length, coordinate_size()); }
  HWY_INLINE const V3<Real>& centre() const { return placement.centre_2; }

  /// The wall is the same seen from any of its symmetric points: that next to the particle loses no digits.
  HWY_INLINE void slide_along_plane() { placement.centre_2 = dot(centre(), axis()) * axis(); }
  HWY_INLINE void slide_along_axis() { placement.centre_2 = centre() - dot(centre(), axis()) * axis(); }

  HWY_INLINE Support supports() const { return Support(numbers_); }

  template <class Wall>
  HWY_INLINE SurfacePair<Real, Lift, Wall> with(const Wall& wall) const {
    const Real inverse_length = Real(1.0) / length, share = length / size;
    return {.surface_1 = Lift(numbers_),
            .surface_2 = wall,
            .rotation = placement.rotation,
            .centre_2 = centre(),
            .length = length,
            .inverse_length = inverse_length,
            .share_1 = share,
            .share_2 = share,
            .round_off = Real(round_off) * coordinate_size() * inverse_length};
  }

  Real radius;  ///< of the wall; ∞ for a plane
  Placement<Real> placement;
  V3<Real> wall_origin;  ///< where the wall's frame really stands
  Real size, length;

 private:
  HWY_INLINE Real coordinate_size() const {
    const MaskType<Real> curved = radius < Real(std::numeric_limits<double>::infinity());
    return size + select(curved, radius, Real(0.0)) + norm(centre());
  }

  typename Kind::template Numbers<Real> numbers_;
};

template <class Real, class Kind>
HWY_INLINE void finish(const Jobs& jobs, const WallPair<Real, Kind>& pair, const Answer<Real>& answer,
                       std::uint64_t ambiguous, std::uint64_t wanted) {
  write_answer(jobs, pair.placement, pair.wall_origin, pair.length, answer, ambiguous, wanted);
}

// ------------------------------------------------------------------------------------------------------ half-space

template <class Real, class Kind>
void solve_plane(const Jobs& jobs, Gap gap) {
  WallPair<Real, Kind> pair(jobs, Real(std::numeric_limits<double>::infinity()));
  pair.slide_along_plane();
  const auto surfaces = pair.with(PlaneSurface<Real>());
  const auto jet_1 = pair.supports().support(-pair.axis());
  const auto jet_2 = surfaces.lift_2(jet_1.point, -jet_1.normal);
  const Answer<Real> answer = answer_at<Real>(surfaces, jet_1, jet_2);
  std::uint64_t apart = 0;
  if (gap == Gap::skip) {
    apart = bits(answer.overlap < Real(0.0)) & jobs.all();
    write_direction(jobs, pair.placement, answer.normal, answer.overlap, ContactStatus::separated, apart);
  }
  finish(jobs, pair, answer, 0, jobs.all() & ~apart);
}

// ------------------------------------------------------------------------------------------------------------- rod

/// The overlap with a rod over the particle's normals around the axis.
template <class Real, class Kind>
class RodSearch {
 public:
  HWY_INLINE explicit RodSearch(const WallPair<Real, Kind>& pair)
      : pair_(pair),
        support_(pair.supports()),
        x_(pair.placement.rotation.column_x),
        y_(pair.placement.rotation.column_y) {}

  struct Value {
    V3<Real> normal;
    Real overlap, slope;
  };
  HWY_NOINLINE Value at(const V3<Real>& normal) const {
    const V3<Real> from_axis = support_.support(normal).point - pair_.centre();
    return {normal, pair_.radius + dot(from_axis, normal), dot(from_axis, cross(pair_.axis(), normal))};
  }
  HWY_INLINE V3<Real> sample(int k) const {
    const double angle = (k % samples) * (2.0 * 3.14159265358979323846 / samples);
    return Real(std::cos(angle)) * x_ + Real(std::sin(angle)) * y_;
  }
  /// The cached normal, turned into the plane around the axis.
  HWY_INLINE V3<Real> around_axis(const V3<Real>& v) const {
    return normalised(v - dot(v, pair_.axis()) * pair_.axis());
  }

  /// The minimum next to a sample that is not above its neighbours: between it and the neighbour that lies downhill.
  HWY_NOINLINE Value refine(const Value& lowest, const V3<Real>& before, const V3<Real>& after, int most_steps) const {
    const Real zero(0.0);
    const MaskType<Real> rises = lowest.slope > zero;
    V3<Real> low = select(rises, before, lowest.normal), high = select(rises, lowest.normal, after);
    Value value = lowest;
    for (int i = 0; i < most_steps; ++i) {
      value = at(normalised(low + high));
      const MaskType<Real> right = value.slope > zero;
      high = select(right, value.normal, high);
      low = select(right, low, value.normal);
    }
    return value;
  }

  static constexpr int samples = 24;

 private:
  const WallPair<Real, Kind>& pair_;
  typename Kind::template Support<Real> support_;
  V3<Real> x_, y_;
};

/// Newton's method from there; where it fails, what halving the angle found stands by itself.
template <class Real, class Surfaces, class Kind, class Value>
HWY_NOINLINE Answer<Real> polish_rod(const Surfaces& surfaces, const WallPair<Real, Kind>& pair, const Value& value) {
  const auto jet_1 = pair.supports().support(value.normal);
  const auto jet_2 =
      surfaces.lift_2(pair.centre() - value.normal + dot(jet_1.point, pair.axis()) * pair.axis(), -value.normal);
  const Answer<Real> found = answer_at<Real>(surfaces, jet_1, jet_2);
  const Answer<Real> polished = newton(surfaces, found.touch, usual.newtons);
  return select(polished.converged & (polished.overlap <= found.overlap + pair.tolerance()), polished, found);
}

constexpr double rod_side = 1.0, drum_side = -1.0;

template <class Real>
HWY_INLINE Real cylinder_radius(const Jobs& jobs) {
  return gather<Real>(jobs, [](const PairJob& job) { return std::get<Cylinder>(*job.shape_2).radius; });
}
template <class Real>
HWY_INLINE Real container_radius(const Jobs& jobs) {
  return gather<Real>(jobs, [](const PairJob& job) { return std::get<SphereContainer>(*job.shape_2).radius; });
}

template <class Real, class Kind>
void solve_rod_warm(const Jobs& jobs, std::vector<PairJob*>& unsolved) {
  WallPair<Real, Kind> pair(jobs, cylinder_radius<Real>(jobs));
  pair.slide_along_axis();
  const auto surfaces = pair.with(CylinderSurface<Real>{pair.radius, Real(rod_side)});
  const Answer<Real> answer = newton(surfaces, read_touch<Real>(jobs, pair.placement, pair.wall_origin), usual.newtons);
  const std::uint64_t converged = bits(answer.converged) & jobs.all();
  finish(jobs, pair, answer, 0, converged);
  for (std::size_t i = 0; i < jobs.count; ++i)
    if (!has(converged, i)) unsolved.push_back(jobs.job[i]);
}

template <class Real, class Kind>
void check_rod_separation(const Jobs& jobs, std::vector<PairJob*>& unsolved) {
  WallPair<Real, Kind> pair(jobs, cylinder_radius<Real>(jobs));
  pair.slide_along_axis();
  const RodSearch<Real, Kind> search(pair);
  const auto value =
      search.at(search.around_axis(gather3<Real>(jobs, [](const PairJob& job) { return job.cache->normal_1; })));
  const std::uint64_t apart = bits(value.overlap < Real(0.0)) & jobs.all();
  write_direction(jobs, pair.placement, value.normal, value.overlap, ContactStatus::separated, apart);
  for (std::size_t i = 0; i < jobs.count; ++i)
    if (!has(apart, i)) unsolved.push_back(jobs.job[i]);
}

/// A rod whose axis runs through the particle may have several minima: such lanes are left to `solve_rod_inside`.
template <class Real, class Kind>
void solve_rod(const Jobs& jobs, Gap gap, std::vector<PairJob*>& inside) {
  WallPair<Real, Kind> pair(jobs, cylinder_radius<Real>(jobs));
  pair.slide_along_axis();
  const RodSearch<Real, Kind> search(pair);
  auto lowest = search.at(search.sample(0));
  V3<Real> before = search.sample(RodSearch<Real, Kind>::samples - 1), after = search.sample(1);
  for (int k = 1; k < RodSearch<Real, Kind>::samples; ++k) {
    const auto value = search.at(search.sample(k));
    const MaskType<Real> lower = value.overlap < lowest.overlap;
    lowest = {select(lower, value.normal, lowest.normal), select(lower, value.overlap, lowest.overlap),
              select(lower, value.slope, lowest.slope)};
    before = select(lower, search.sample(k - 1), before);
    after = select(lower, search.sample(k + 1), after);
  }
  std::uint64_t done = 0;
  if (gap == Gap::skip) {
    done = bits(lowest.overlap < Real(0.0)) & jobs.all();
    write_direction(jobs, pair.placement, lowest.normal, lowest.overlap, ContactStatus::separated, done);
    if (done == jobs.all()) return;
  }
  const std::uint64_t deep = bits(!(lowest.overlap < pair.radius)) & jobs.all() & ~done;
  constexpr int halvings = 24;
  const auto surfaces = pair.with(CylinderSurface<Real>{pair.radius, Real(rod_side)});
  const Answer<Real> answer = polish_rod<Real>(surfaces, pair, search.refine(lowest, before, after, halvings));
  finish(jobs, pair, answer, 0, jobs.all() & ~done & ~deep);
  for (std::size_t i = 0; i < jobs.count; ++i)
    if (has(deep, i)) inside.push_back(jobs.job[i]);
}

template <class Kind>
void solve_rod_inside(const Jobs& jobs) {
  WallPair<double, Kind> pair(jobs, cylinder_radius<double>(jobs));
  pair.slide_along_axis();
  using Search = RodSearch<double, Kind>;
  const Search search(pair);
  const auto surfaces = pair.with(CylinderSurface<double>{pair.radius, rod_side});
  typename Search::Value values[Search::samples];
  for (int k = 0; k < Search::samples; ++k) values[k] = search.at(search.sample(k));
  Answer<double> best;
  best.converged = false;
  bool ambiguous = false;
  for (int k = 0; k < Search::samples; ++k) {
    const auto& before = values[(k + Search::samples - 1) % Search::samples];
    const auto& after = values[(k + 1) % Search::samples];
    if (!(values[k].overlap <= before.overlap && values[k].overlap <= after.overlap)) continue;
    constexpr int halvings = 60;
    const Answer<double> answer =
        polish_rod<double>(surfaces, pair, search.refine(values[k], before.normal, after.normal, halvings));
    if (!best.converged || answer.overlap < best.overlap - pair.tolerance()) {
      best = answer;
      ambiguous = false;
    } else if (answer.overlap <= best.overlap + pair.tolerance()) {
      constexpr double another = 1e-6;
      ambiguous = ambiguous || norm(answer.normal - best.normal) > another;
    }
  }
  if (best.converged)
    finish(jobs, pair, best, ambiguous ? 1 : 0, 1);
  else
    give_up(jobs[0]);
}

template <class Kind>
void solve_rods(const std::vector<PairJob*>& group, Gap gap) {
  std::vector<PairJob*> warm, apart, cold, inside;
  for (PairJob* job : group) {
    if (job->cache->state == ContactCache::State::contact)
      warm.push_back(job);
    else if (job->cache->state == ContactCache::State::separation && gap == Gap::skip)
      apart.push_back(job);
    else
      cold.push_back(job);
  }
  in_batches(warm,
             [&](const Jobs& jobs, auto real) { solve_rod_warm<typename decltype(real)::type, Kind>(jobs, cold); });
  in_batches(apart, [&](const Jobs& jobs, auto real) {
    check_rod_separation<typename decltype(real)::type, Kind>(jobs, cold);
  });
  in_batches(cold,
             [&](const Jobs& jobs, auto real) { solve_rod<typename decltype(real)::type, Kind>(jobs, gap, inside); });
  for (PairJob* job : inside) solve_rod_inside<Kind>(Jobs{&job, 1});
}

// ------------------------------------------------------------------------------------- drums and sphere containers

/// The particle's point furthest from the axis of a drum.
template <class Real>
struct Drum {
  using Surface = CylinderSurface<Real>;
  static HWY_INLINE Real radius_of(const Jobs& jobs) { return cylinder_radius<Real>(jobs); }
  static HWY_INLINE Surface surface(const Real& radius) { return {radius, Real(drum_side)}; }
  static HWY_INLINE V3<Real> across(const V3<Real>& v, const V3<Real>& axis) { return v - dot(v, axis) * axis; }
  template <class Pair>
  static HWY_INLINE void slide(Pair& pair) {
    pair.slide_along_axis();
  }
};

/// The particle's point furthest from the centre of a container.
template <class Real>
struct Container {
  using Surface = ContainerSurface<Real>;
  static HWY_INLINE Real radius_of(const Jobs& jobs) { return container_radius<Real>(jobs); }
  static HWY_INLINE Surface surface(const Real& radius) { return {radius}; }
  static HWY_INLINE V3<Real> across(const V3<Real>& v, const V3<Real>&) { return v; }
  template <class Pair>
  static HWY_INLINE void slide(Pair&) {}
};

/// Looks for the particle's point furthest from a line or point: from a normal to the support point, and from that to
/// the direction in which it lies. Each step goes further out, since the support function is convex.
template <class Real, class Kind, class Wall>
class FurthestSearch {
 public:
  HWY_INLINE explicit FurthestSearch(const WallPair<Real, Kind>& pair) : pair_(pair), support_(pair.supports()) {}

  struct Place {
    V3<Real> normal, point;
    Real distance;
  };
  /// From a direction of any length; one without a part across the axis leads nowhere.
  HWY_NOINLINE Place at(const V3<Real>& direction) const {
    const V3<Real> across = Wall::across(direction, pair_.axis());
    const Real length = norm(across), one(1.0), zero(0.0);
    const MaskType<Real> none = !(length > Real(1e-12) * norm(direction));
    const V3<Real> normal = (one / select(none, one, length)) * across;
    const V3<Real> point = support_.support(select(none, pair_.placement.rotation.column_x, normal)).point;
    return {normal, point, select(none, zero, norm(outward(point)))};
  }
  HWY_INLINE V3<Real> outward(const V3<Real>& point) const {
    return Wall::across(point - pair_.centre(), pair_.axis());
  }
  HWY_NOINLINE Place climb(Place place, int most_steps) const {
    for (int i = 0; i < most_steps; ++i) {
      const Place next = at(outward(place.point));
      const MaskType<Real> further = next.distance > place.distance;
      if (!any(further)) break;
      place = chosen(further, next, place);
    }
    return place;
  }
  static HWY_INLINE Place chosen(MaskType<Real> condition, const Place& yes, const Place& no) {
    return {select(condition, yes.normal, no.normal), select(condition, yes.point, no.point),
            select(condition, yes.distance, no.distance)};
  }

  /// The way from the wall's middle to the particle, and the particle's faces, edges and corners.
  static constexpr int starts = 27;
  HWY_INLINE V3<Real> start(int k) const {
    if (k == 0) return -pair_.centre();
    const int j = k <= 13 ? k - 1 : k;  // of 0 … 26, leaving out the middle
    return {Real(j % 3 - 1.0), Real(j / 3 % 3 - 1.0), Real(j / 9 - 1.0)};
  }

 private:
  const WallPair<Real, Kind>& pair_;
  typename Kind::template Support<Real> support_;
};

/// True if the particle reaches out along the answer's normal as far as the answer says.
template <class Real, class Kind, class Wall>
HWY_INLINE MaskType<Real> reaches_out(const FurthestSearch<Real, Kind, Wall>& search, const Real& tolerance,
                                      const WallPair<Real, Kind>& pair, const Answer<Real>& answer) {
  const Real reach = dot(search.outward(search.at(answer.normal).point), answer.normal) - pair.radius;
  return abs(reach - answer.overlap) <= tolerance;
}

/// Newton's method from there; where it fails (a particle that fits the wall snugly), what climbing found stands.
template <class Real, class Surfaces, class Kind, class Wall>
HWY_NOINLINE Answer<Real> polish_furthest(const Surfaces& surfaces, const WallPair<Real, Kind>& pair,
                                          const FurthestSearch<Real, Kind, Wall>& search,
                                          const typename FurthestSearch<Real, Kind, Wall>::Place& place) {
  const auto jet_1 = pair.supports().support(place.normal);
  const auto jet_2 = surfaces.lift_2(jet_1.point, -jet_1.normal);
  const Answer<Real> found = answer_at<Real>(surfaces, jet_1, jet_2);
  const Answer<Real> polished = newton(surfaces, found.touch, usual.newtons);
  const Real tolerance = pair.tolerance();
  return select(polished.converged & (polished.overlap >= found.overlap - tolerance) &
                    reaches_out(search, tolerance, pair, polished),
                polished, found);
}

/// Warm contacts are followed, but another part of the particle may have come further out meanwhile.
template <class Real, class Kind, class Wall>
void solve_furthest_warm(const Jobs& jobs, std::vector<PairJob*>& unsolved) {
  WallPair<Real, Kind> pair(jobs, Wall::radius_of(jobs));
  Wall::slide(pair);
  const Answer<Real> answer = newton(pair.with(Wall::surface(pair.radius)),
                                     read_touch<Real>(jobs, pair.placement, pair.wall_origin), usual.newtons);
  const FurthestSearch<Real, Kind, Wall> search(pair);
  MaskType<Real> good = answer.converged & reaches_out(search, pair.tolerance(), pair, answer);
  for (int k = 0; k < search.starts; ++k)
    good = good & (search.at(search.start(k)).distance <= pair.radius + answer.overlap + pair.tolerance());
  const std::uint64_t solved = bits(good) & jobs.all();
  finish(jobs, pair, answer, 0, solved);
  for (std::size_t i = 0; i < jobs.count; ++i)
    if (!has(solved, i)) unsolved.push_back(jobs.job[i]);
}

template <class Real, class Kind, class Wall>
void solve_furthest(const Jobs& jobs, Gap gap) {
  WallPair<Real, Kind> pair(jobs, Wall::radius_of(jobs));
  Wall::slide(pair);
  const FurthestSearch<Real, Kind, Wall> search(pair);
  constexpr int first_steps = 6, last_steps = 60;
  const Real another = Real(1e-3) * pair.size;
  auto best = search.climb(search.at(search.start(0)), first_steps);
  auto rival = best;
  rival.distance = Real(0.0);
  for (int k = 1; k < search.starts; ++k) {
    const auto place = search.climb(search.at(search.start(k)), first_steps);
    const MaskType<Real> elsewhere = norm(place.point - best.point) > another;
    const MaskType<Real> further = place.distance > best.distance + pair.tolerance();
    rival = search.chosen(further & elsewhere, best, rival);
    rival = search.chosen((!further) & elsewhere & (place.distance > rival.distance), place, rival);
    best = search.chosen(further, place, best);
  }
  best = search.climb(best, last_steps);
  rival = search.climb(rival, last_steps);
  std::uint64_t done = 0;
  if (gap == Gap::skip) {
    const Real overlap = max(best.distance, rival.distance) - pair.radius;
    done = bits(overlap < -Real(1e-3) * pair.length) & jobs.all();
    write_direction(jobs, pair.placement, best.normal, overlap, ContactStatus::separated, done);
    if (done == jobs.all()) return;
  }
  const auto surfaces = pair.with(Wall::surface(pair.radius));
  Answer<Real> answer = polish_furthest(surfaces, pair, search, best);
  MaskType<Real> ambiguous = answer.overlap < answer.overlap;
  if (any(rival.distance > best.distance - another)) {
    const Answer<Real> other = polish_furthest(surfaces, pair, search, rival);
    const MaskType<Real> elsewhere =
        (norm(other.touch.point_1 - answer.touch.point_1) > another) & (rival.distance > Real(0.0));
    const MaskType<Real> further = elsewhere & (other.overlap > answer.overlap + pair.tolerance());
    ambiguous = elsewhere & (!further) & (other.overlap >= answer.overlap - pair.tolerance());
    answer = select(further, other, answer);
  }
  finish(jobs, pair, answer, bits(ambiguous), jobs.all() & ~done);
}

template <class Kind, template <class> class Wall>
void solve_furthest_group(const std::vector<PairJob*>& group, Gap gap) {
  std::vector<PairJob*> warm, cold;
  for (PairJob* job : group) (job->cache->state == ContactCache::State::contact ? warm : cold).push_back(job);
  in_batches(warm, [&](const Jobs& jobs, auto real) {
    using Real = typename decltype(real)::type;
    solve_furthest_warm<Real, Kind, Wall<Real>>(jobs, cold);
  });
  in_batches(cold, [&](const Jobs& jobs, auto real) {
    using Real = typename decltype(real)::type;
    solve_furthest<Real, Kind, Wall<Real>>(jobs, gap);
  });
}

// -------------------------------------------------------------------------------------------------------- dispatch

enum WallKind : std::size_t { half_space, rod, drum, container, wall_kinds };

inline WallKind wall_kind(const Shape& shape) {
  if (std::holds_alternative<HalfSpace>(shape)) return half_space;
  if (std::holds_alternative<SphereContainer>(shape)) return container;
  return std::get<Cylinder>(shape).solid == Cylinder::Solid::inside ? rod : drum;
}

template <class Kind>
void solve_group(WallKind wall, const std::vector<PairJob*>& group, Gap gap) {
  switch (wall) {
    case half_space:
      // Superquadrics on planes have been solved in closed form.
      if constexpr (std::is_same_v<Kind, ImplicitParticle>)
        in_batches(group,
                   [&](const Jobs& jobs, auto real) { solve_plane<typename decltype(real)::type, Kind>(jobs, gap); });
      return;
    case rod:
      return solve_rods<Kind>(group, gap);
    case drum:
      return solve_furthest_group<Kind, Drum>(group, gap);
    default:
      return solve_furthest_group<Kind, Container>(group, gap);
  }
}

void wall_pairs(std::span<PairJob> jobs, Gap gap) {
  std::vector<PairJob*> groups[particle_kinds][wall_kinds];
  for (PairJob& job : jobs) groups[particle_kind(*job.shape_1)][wall_kind(*job.shape_2)].push_back(&job);
  for (std::size_t kind = 0; kind < particle_kinds; ++kind) {
    for (std::size_t wall = 0; wall < wall_kinds; ++wall) {
      const auto& group = groups[kind][wall];
      if (group.empty()) continue;
      visit_kind(kind,
                 [&](auto particle) { solve_group<decltype(particle)>(static_cast<WallKind>(wall), group, gap); });
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {

HWY_EXPORT(wall_pairs);

namespace {
void solve_superquadrics_on_planes(std::span<PairJob> jobs, Gap gap) {
  SuperquadricPairs pairs;
  ContactColumns contacts;
  pairs.resize(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i)
    pairs.set(i, superquadric_of(*jobs[i].shape_1), jobs[i].pose_1, half_space_numbers, jobs[i].pose_2);
  plane_contacts(pairs, contacts);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto& [shape_1, pose_1, shape_2, pose_2, cache, contact] = jobs[i];
    *contact = contacts.get(i);
    const bool skipped = gap == Gap::skip && contact->overlap < 0.0;
    *cache = {.state = skipped ? ContactCache::State::separation : ContactCache::State::contact,
              .point_1 = pose_1.to_body(contact->on_1),
              .normal_1 = pose_1.rotate_to_body(contact->normal),
              .point_2 = pose_2.to_body(contact->on_2),
              .normal_2 = pose_2.rotate_to_body(-contact->normal)};
  }
}
}  // namespace

void solve_wall_pairs(std::span<PairJob> jobs, Gap gap) {
  const auto rest = std::partition(jobs.begin(), jobs.end(), [](const PairJob& job) {
    return pair_kind(*job.shape_1) == PairKind::superquadrics && std::holds_alternative<HalfSpace>(*job.shape_2);
  });
  solve_superquadrics_on_planes({jobs.begin(), rest}, gap);
  HWY_DYNAMIC_DISPATCH(wall_pairs)({rest, jobs.end()}, gap);
}

}  // namespace osculate
#endif
