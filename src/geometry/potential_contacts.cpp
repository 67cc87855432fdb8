// Potential particles against any particle: the template solver on their implicit surfaces.
#include <cstdint>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/potential_contacts.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "geometry/pair_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// A batch of pairs of one kind.
template <class Real, class Kind1, class Kind2>
class ParticlePair {
 public:
  using Lifts = SurfacePair<Real, typename Kind1::template Lift<Real>, typename Kind2::template Lift<Real>>;
  using Supports = SurfacePair<Real, typename Kind1::template Support<Real>, typename Kind2::template Support<Real>>;

  HWY_INLINE explicit ParticlePair(const Jobs& jobs) : placement(placement_of<Real>(jobs)) {
    read_numbers(
        jobs, [](const PairJob& job) -> const Shape& { return *job.shape_1; }, numbers_1);
    read_numbers(
        jobs, [](const PairJob& job) -> const Shape& { return *job.shape_2; }, numbers_2);
    size_1_ = size_of(numbers_1);
    size_2_ = size_of(numbers_2);
    length = min(size_1_, size_2_);
    tolerance = overlap_tolerance(length, coordinate_size());
  }

  HWY_INLINE Lifts lifts() const { return as<Lifts>(); }
  HWY_INLINE Supports supports() const { return as<Supports>(); }

  typename Kind1::template Numbers<Real> numbers_1;
  typename Kind2::template Numbers<Real> numbers_2;
  Placement<Real> placement;
  Real length, tolerance;

 private:
  HWY_INLINE Real coordinate_size() const { return size_1_ + size_2_ + norm(placement.centre_2); }

  template <class Pair>
  HWY_INLINE Pair as() const {
    const Real inverse_length = Real(1.0) / length;
    return {.surface_1 = decltype(Pair::surface_1)(numbers_1),
            .surface_2 = decltype(Pair::surface_2)(numbers_2),
            .rotation = placement.rotation,
            .centre_2 = placement.centre_2,
            .length = length,
            .inverse_length = inverse_length,
            .share_1 = length / size_1_,
            .share_2 = length / size_2_,
            .round_off = Real(round_off) * coordinate_size() * inverse_length};
  }

  Real size_1_, size_2_;
};

/// The deepest minimum of those found so far.
template <class Pair>
class Candidates {
 public:
  HWY_INLINE explicit Candidates(const Pair& pair) : pair_(pair), lifts_(pair.lifts()), supports_(pair.supports()) {
    best_.converged = false;
  }

  HWY_NOINLINE void consider(const V3<double>& start, const Effort& effort) {
    double lowest = 0.0;
    const Touch<double> touch = descend(lifts_, supports_, start, effort, lowest);
    if (!(lowest == lowest)) return;
    if (lowest < least_) {
      least_ = lowest;
      direction_ = touch.normal_1;
    }
    Answer<double> answer = newton(lifts_, touch, effort.newtons);
    if (!(answer.converged && answer.overlap <= lowest + pair_.tolerance)) {
      // Where planes come into play at the contact itself Newton's method may cycle, though the direction is found.
      answer = answer_at<double>(supports_, supports_.support_1(touch.normal_1), supports_.support_2(-touch.normal_1));
      const V3<double> apart = answer.touch.point_1 - answer.touch.point_2 - answer.overlap * answer.normal;
      constexpr double found = 1e-9;
      if (!(norm(apart) <= found * pair_.length)) return;
    }
    if (!best_.converged || answer.overlap < best_.overlap - pair_.tolerance) {
      best_ = answer;
      ambiguous_ = false;
    } else if (answer.overlap <= best_.overlap + pair_.tolerance) {
      constexpr double another = 1e-6;
      ambiguous_ = ambiguous_ || norm(answer.normal - best_.normal) > another;
    }
  }

  bool found() const { return best_.converged && best_.overlap <= least_ + pair_.tolerance; }

  void write(const Jobs& jobs) const {
    if (found())
      write_answer(jobs, pair_.placement, pair_.placement.centre_2, pair_.length, best_, ambiguous_ ? 1 : 0, 1);
    else if (std::isfinite(least_))
      write_direction(jobs, pair_.placement, direction_, least_, ContactStatus::not_converged, 1);
    else
      give_up(jobs[0]);
  }

 private:
  const Pair& pair_;
  typename Pair::Lifts lifts_;
  typename Pair::Supports supports_;
  Answer<double> best_;
  V3<double> direction_{0.0, 0.0, 0.0};
  double least_ = std::numeric_limits<double>::infinity();
  bool ambiguous_ = false;
};

inline void add_normals(const SuperquadricNumbers<double>&, std::vector<V3<double>>& normals) {
  for (const double side : {1.0, -1.0}) {
    normals.push_back({side, 0.0, 0.0});
    normals.push_back({0.0, side, 0.0});
    normals.push_back({0.0, 0.0, side});
  }
}
inline void add_normals(const PotentialNumbers<double>& numbers, std::vector<V3<double>>& normals) {
  for (const auto& plane : numbers.planes) normals.push_back(plane.normal);
}

/// One pair that the usual start failed on, or so deep that it may have several minima: from the faces of both bodies
/// too, and at last with patience.
template <class Kind1, class Kind2>
void solve_with_care(const Jobs& jobs) {
  const ParticlePair<double, Kind1, Kind2> pair(jobs);
  Candidates<ParticlePair<double, Kind1, Kind2>> candidates(pair);
  std::vector<V3<double>> starts{first_direction(pair.lifts(), pair.supports())}, of_body_2;
  add_normals(pair.numbers_1, starts);
  add_normals(pair.numbers_2, of_body_2);
  for (const V3<double>& normal : of_body_2) starts.push_back(-pair.placement.rotation.apply(normal));
  for (const V3<double>& start : starts) candidates.consider(start, usual);
  if (!candidates.found()) {
    for (const V3<double>& start : starts) {
      candidates.consider(start, stubborn);
      if (candidates.found()) break;
    }
  }
  candidates.write(jobs);
}

/// An overlap above this (over L) may have several minima.
constexpr double deep = 0.1;

template <class Kind1, class Kind2, class Real>
void solve_cold(const Jobs& jobs, Gap gap, std::vector<PairJob*>& unsolved) {
  const ParticlePair<Real, Kind1, Kind2> pair(jobs);
  const auto lifts = pair.lifts();
  const auto supports = pair.supports();
  std::uint64_t solved = 0;
  Real least(0.0);
  const Touch<Real> touch = descend(lifts, supports, first_direction(lifts, supports), usual, least);
  if (gap == Gap::skip) {
    solved = bits(least < Real(0.0)) & jobs.all();
    write_direction(jobs, pair.placement, touch.normal_1, least, ContactStatus::separated, solved);
  }
  if (solved != jobs.all()) {
    const Answer<Real> answer = newton(lifts, touch, usual.newtons);
    const auto good =
        answer.converged & (answer.overlap <= least + pair.tolerance) & (answer.overlap <= Real(deep) * pair.length);
    const std::uint64_t converged = bits(good) & jobs.all() & ~solved;
    write_answer(jobs, pair.placement, pair.placement.centre_2, pair.length, answer, 0, converged);
    solved |= converged;
  }
  for (std::size_t i = 0; i < jobs.count; ++i)
    if (!has(solved, i)) unsolved.push_back(jobs.job[i]);
}

template <class Kind1, class Kind2, class Real>
void solve_warm(const Jobs& jobs, std::vector<PairJob*>& unsolved) {
  const ParticlePair<Real, Kind1, Kind2> pair(jobs);
  const V3<Real>& centre_2 = pair.placement.centre_2;
  const Answer<Real> answer = newton(pair.lifts(), read_touch<Real>(jobs, pair.placement, centre_2), usual.newtons);
  const std::uint64_t converged = bits(answer.converged) & jobs.all();
  write_answer(jobs, pair.placement, centre_2, pair.length, answer, 0, converged);
  for (std::size_t i = 0; i < jobs.count; ++i)
    if (!has(converged, i)) unsolved.push_back(jobs.job[i]);
}

/// One evaluation along the cached direction proves most pairs still separated.
template <class Kind1, class Kind2, class Real>
void check_separation(const Jobs& jobs, std::vector<PairJob*>& unsolved) {
  const ParticlePair<Real, Kind1, Kind2> pair(jobs);
  const V3<Real> direction = gather3<Real>(jobs, [](const PairJob& job) { return job.cache->normal_1; });
  const Real overlap = overlap_along(pair.supports(), direction);
  const std::uint64_t apart = bits(overlap < Real(0.0)) & jobs.all();
  write_direction(jobs, pair.placement, direction, overlap, ContactStatus::separated, apart);
  for (std::size_t i = 0; i < jobs.count; ++i)
    if (!has(apart, i)) unsolved.push_back(jobs.job[i]);
}

template <class Kind1, class Kind2>
void solve_group(const std::vector<PairJob*>& group, Gap gap) {
  std::vector<PairJob*> warm, apart, cold, hard;
  for (PairJob* job : group) {
    if (job->cache->state == ContactCache::State::contact)
      warm.push_back(job);
    else if (job->cache->state == ContactCache::State::separation && gap == Gap::skip)
      apart.push_back(job);
    else
      cold.push_back(job);
  }
  in_batches(warm,
             [&](const Jobs& jobs, auto real) { solve_warm<Kind1, Kind2, typename decltype(real)::type>(jobs, cold); });
  in_batches(apart, [&](const Jobs& jobs, auto real) {
    check_separation<Kind1, Kind2, typename decltype(real)::type>(jobs, cold);
  });
  in_batches(cold, [&](const Jobs& jobs, auto real) {
    solve_cold<Kind1, Kind2, typename decltype(real)::type>(jobs, gap, hard);
  });
  for (PairJob* job : hard) solve_with_care<Kind1, Kind2>(Jobs{&job, 1});
}

void potential_pairs(std::span<PairJob> jobs, Gap gap) {
  std::vector<PairJob*> groups[particle_kinds];
  for (PairJob& job : jobs) groups[particle_kind(*job.shape_1)].push_back(&job);
  for (std::size_t kind = 0; kind < particle_kinds; ++kind) {
    if (groups[kind].empty()) continue;
    visit_kind(kind, [&](auto kind_1) { solve_group<decltype(kind_1), ImplicitParticle>(groups[kind], gap); });
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {

HWY_EXPORT(potential_pairs);

void solve_potential_pairs(std::span<PairJob> jobs, Gap gap) {
  HWY_DYNAMIC_DISPATCH(potential_pairs)(jobs, gap);
}

}  // namespace osculate
#endif
