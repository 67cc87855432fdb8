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
    read_numbers(jobs, [](const PairJob& job) -> const Shape& { return *job.shape_1; }, numbers_1_);
    read_numbers(jobs, [](const PairJob& job) -> const Shape& { return *job.shape_2; }, numbers_2_);
    size_1_ = size_of(numbers_1_);
    size_2_ = size_of(numbers_2_);
    length = min(size_1_, size_2_);
    tolerance = overlap_tolerance(length, size_1_ + size_2_ + norm(placement.centre_2));
  }

  HWY_INLINE Lifts lifts() const { return as<Lifts>(); }
  HWY_INLINE Supports supports() const { return as<Supports>(); }

  Placement<Real> placement;
  Real length, tolerance;

 private:
  template <class Pair>
  HWY_INLINE Pair as() const {
    return {decltype(Pair::surface_1)(numbers_1_), decltype(Pair::surface_2)(numbers_2_),
            placement.rotation,                    placement.centre_2,
            length,                                Real(1.0) / length,
            length / size_1_,                      length / size_2_};
  }

  typename Kind1::template Numbers<Real> numbers_1_;
  typename Kind2::template Numbers<Real> numbers_2_;
  Real size_1_, size_2_;
};

/// The best of the centre line and both bodies' normals on it.
template <class Lifts, class Supports, class Real = typename Lifts::Number>
HWY_INLINE V3<Real> starting_direction(const Lifts& lifts, const Supports& supports) {
  const V3<Real> toward = lifts.centre_2;
  const Real zero(0.0);
  const V3<Real> others[] = {lifts.lift_1(toward, toward).normal,
                             -lifts.lift_2(V3<Real>{zero, zero, zero}, -toward).normal};
  V3<Real> best = normalised(toward);
  Real least = overlap_along(supports, best);
  for (const V3<Real>& other : others) {
    const Real overlap = overlap_along(supports, other);
    const MaskType<Real> better = overlap < least;
    best = select(better, other, best);
    least = select(better, overlap, least);
  }
  return best;
}

/// One pair that the usual start failed on: from many starts and with patience. The deepest minimum is the answer.
template <class Kind1, class Kind2>
void solve_hard(const Jobs& jobs) {
  const ParticlePair<double, Kind1, Kind2> pair(jobs);
  const auto lifts = pair.lifts();
  const auto supports = pair.supports();
  std::vector<V3<double>> starts;
  if (dot(lifts.centre_2, lifts.centre_2) > 0.0) starts.push_back(starting_direction(lifts, supports));
  for (int k = 0; k < 12; ++k) {
    const double side = k % 2 == 0 ? 1.0 : -1.0;
    const int axis = k / 2 % 3;
    const V3<double> unit{axis == 0 ? side : 0.0, axis == 1 ? side : 0.0, axis == 2 ? side : 0.0};
    starts.push_back(k < 6 ? unit : pair.placement.rotation.apply(unit));
  }
  double least = std::numeric_limits<double>::infinity();
  V3<double> best_direction = starts.front();
  Answer<double> best;
  best.converged = false;
  bool ambiguous = false;
  for (const V3<double>& start : starts) {
    double lowest = 0.0;
    const Touch<double> touch = descend(lifts, supports, start, stubborn, lowest);
    if (!(lowest == lowest)) continue;
    if (lowest < least) {
      least = lowest;
      best_direction = touch.normal_1;
    }
    Answer<double> answer = polish(lifts, touch, stubborn.newtons);
    if (!(answer.converged && answer.overlap <= lowest + pair.tolerance)) {
      // Where planes come into play at the contact itself Newton's method may cycle, though the direction is found.
      answer = answer_at<double>(supports, supports.support_1(touch.normal_1), supports.support_2(-touch.normal_1));
      const V3<double> apart = answer.touch.point_1 - answer.touch.point_2 - answer.overlap * answer.normal;
      constexpr double found = 1e-9;
      if (!(norm(apart) <= found * pair.length)) continue;
    }
    if (!best.converged || answer.overlap < best.overlap - pair.tolerance) {
      best = answer;
      ambiguous = false;
    } else if (answer.overlap <= best.overlap + pair.tolerance) {
      constexpr double another = 1e-6;
      ambiguous = ambiguous || norm(answer.normal - best.normal) > another;
    }
  }
  if (best.converged && best.overlap <= least + pair.tolerance)
    write_answer(jobs, pair.placement, pair.placement.centre_2, pair.length, best, ambiguous ? 1 : 0, 1);
  else if (std::isfinite(least))
    write_direction(jobs, pair.placement, best_direction, least, ContactStatus::not_converged, 1);
  else
    give_up(jobs[0]);
}

template <class Kind1, class Kind2, class Real>
void solve_cold(const Jobs& jobs, Gap gap, std::vector<PairJob*>& unsolved) {
  const ParticlePair<Real, Kind1, Kind2> pair(jobs);
  const auto lifts = pair.lifts();
  const auto supports = pair.supports();
  std::uint64_t solved = 0;
  Real least(0.0);
  const Touch<Real> touch = descend(lifts, supports, starting_direction(lifts, supports), usual, least);
  if (gap == Gap::skip) {
    solved = bits(least < Real(0.0)) & jobs.all();
    write_direction(jobs, pair.placement, touch.normal_1, least, ContactStatus::separated, solved);
  }
  if (solved != jobs.all()) {
    const Answer<Real> answer = polish(lifts, touch, usual.newtons);
    const auto good = answer.converged & (answer.overlap <= least + pair.tolerance);
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
  const Answer<Real> answer = polish(pair.lifts(), read_touch<Real>(jobs, pair.placement, centre_2), usual.newtons);
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
  in_batches(warm, [&](const Jobs& jobs, auto real) { solve_warm<Kind1, Kind2, typename decltype(real)::type>(jobs, cold); });
  in_batches(apart, [&](const Jobs& jobs, auto real) { check_separation<Kind1, Kind2, typename decltype(real)::type>(jobs, cold); });
  in_batches(cold, [&](const Jobs& jobs, auto real) { solve_cold<Kind1, Kind2, typename decltype(real)::type>(jobs, gap, hard); });
  for (PairJob* job : hard) solve_hard<Kind1, Kind2>(Jobs{&job, 1});
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
