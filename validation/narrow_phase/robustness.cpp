#include "validation/narrow_phase/robustness.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>

#include "validation/narrow_phase/contact_checks.hpp"
#include "validation/narrow_phase/nasty_pairs.hpp"
#include "validation/narrow_phase/superquadric_reference.hpp"

namespace osculate::validation {
namespace {

struct TroubleText {
  std::string_view name, meaning;
};
constexpr std::array<TroubleText, troubles> texts{{
    {"not converged", "the status says so"},
    {"degenerate", "the status says so, though the input is finite"},
    {"not finite", "NaN or infinity in the answer"},
    {"off surface", "a point is not on its surface, or not the extreme one along the normal"},
    {"off overlap", "the overlap is not that of the points and the normal"},
    {"off line", "the points do not lie on one line along the normal"},
    {"not deepest", "another direction separates the bodies with less movement"},
    {"reference", "the overlap is not the depth that the plain multi-start solver finds"},
    {"wrong sign", "touching with a gap, or separated with an overlap"},
    {"neighbour", "alone in a call the pair gets other bits than among others"},
    {"swap", "exchanged bodies give other bits"},
    {"scale", "lengths times a power of two give other bits"},
    {"world", "a turned and shifted world gives another overlap"},
    {"warm", "started from its own answer the pair gets another overlap"},
    {"moved",
     "started from the answer of a pose 1e-4 away the overlap exceeds that from nothing by more than the move"},
}};

Pair swapped(const Pair& pair) {
  return {pair.shape_2, pair.pose_2, pair.shape_1, pair.pose_1, pair.label};
}

Pair scaled(Pair pair, double factor) {
  pair.shape_1.half_axes *= factor;
  pair.shape_2.half_axes *= factor;
  pair.pose_1.position *= factor;
  pair.pose_2.position *= factor;
  return pair;
}

/// Two bodies of the same shape in the same pose: exchanged they are what they were, and no answer can turn about.
bool is_its_own_swap(const Pair& pair) {
  return pair.shape_1.half_axes == pair.shape_2.half_axes && pair.shape_1.exponents.n1 == pair.shape_2.exponents.n1 &&
         pair.shape_1.exponents.n2 == pair.shape_2.exponents.n2 && pair.pose_1.position == pair.pose_2.position &&
         pair.pose_1.orientation.coeffs() == pair.pose_2.orientation.coeffs();
}

/// False where scaling loses digits: denormal coordinates.
bool survives_scaling(const Pair& pair, double power_of_two) {
  const Pair back = scaled(scaled(pair, power_of_two), 1.0 / power_of_two);
  return back.pose_1.position == pair.pose_1.position && back.pose_2.position == pair.pose_2.position;
}

/// The world turned about body 1 and shifted: body 1 goes to `place`.
Pair in_other_world(Pair pair, const Quat& rotation, const Vec3& place) {
  pair.pose_2.position = rotation * (pair.pose_2.position - pair.pose_1.position) + place;
  pair.pose_1.position = place;
  pair.pose_1.orientation = (rotation * pair.pose_1.orientation).normalized();
  pair.pose_2.orientation = (rotation * pair.pose_2.orientation).normalized();
  return pair;
}

constexpr double change = 1e-4;

double nudge_size(const Pair& pair) {
  return std::min(pair.shape_1.half_axes.minCoeff(), pair.shape_2.half_axes.minCoeff());
}

/// Body 2 moved by 1e-4 of the smaller body and turned by 1e-4 about its centre.
Pair nudged(Pair pair, Random& random) {
  const double size = nudge_size(pair);
  pair.pose_2.position += change * size * random.direction();
  pair.pose_2.orientation =
      (Quat(Eigen::AngleAxisd(change, random.direction())) * pair.pose_2.orientation).normalized();
  return pair;
}

/// By how much, at most, the least overlap before lies above the least one after the nudge, if it is followed through
/// it: along no direction does the overlap change by more than the way of body 2's points.
double passed_over(const Pair& pair) {
  return 2.0 * change * (nudge_size(pair) + pair.shape_2.half_axes.norm());
}

SuperquadricPairs columns_of(const std::vector<Pair>& pairs) {
  SuperquadricPairs columns;
  columns.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
    columns.set(i, pairs[i].shape_1, pairs[i].pose_1, pairs[i].shape_2, pairs[i].pose_2);
  return columns;
}

/// Processor time, which other programs do not disturb.
double processor_seconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const std::function<void()>& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

class Study {
 public:
  Study(const RobustnessRun& run, const BulkSolver& solve) : run_(run), solve_(solve) {
    result.row.family = run.family;
  }

  void examine(std::size_t first, std::size_t count);

  RobustnessResult result;

 private:
  void note(Trouble trouble, const Pair& pair, double size = 0.0) {
    const auto k = static_cast<std::size_t>(trouble);
    if (result.row.counts[k]++ < run_.most_findings) result.findings.push_back({trouble, pair.label, size});
    if (!(size <= result.row.worst[k])) result.row.worst[k] = size;
  }
  /// NaN counts as trouble.
  void demand(Trouble trouble, const Pair& pair, double size) {
    if (!(size <= 1.0)) note(trouble, pair, size);
  }

  ContactColumns cold(const std::vector<Pair>& pairs) const {
    ContactCaches caches;
    ContactColumns contacts;
    solve_(columns_of(pairs), caches, contacts);
    return contacts;
  }

  void examine_answer(const Candidate& candidate, const Tolerance& tolerance, const ContactGeometry& contact);
  void compare_with_reference(const Pair& pair, const Tolerance& tolerance, const ContactGeometry& contact);

  const RobustnessRun& run_;
  const BulkSolver& solve_;
};

void Study::examine_answer(const Candidate& candidate, const Tolerance& tolerance, const ContactGeometry& contact) {
  const Pair& pair = candidate.pair;
  ++result.row.statuses[static_cast<std::size_t>(contact.status)];
  if (!is_finite(contact)) note(Trouble::not_finite, pair);
  if (contact.status == ContactStatus::not_converged) note(Trouble::not_converged, pair);
  if (contact.status == ContactStatus::degenerate) note(Trouble::degenerate, pair);
  if (!is_resolved(contact.status)) return;

  const SelfConsistency off = self_consistency(pair, tolerance, contact);
  demand(Trouble::off_surface, pair,
         std::isnan(off.off_surface) ? off.off_surface : std::max(off.off_surface, off.off_support));
  demand(Trouble::off_overlap, pair, off.off_overlap);
  demand(Trouble::off_line, pair, off.off_line);
  const double bound = std::min(candidate.overlap, least_of_samples(pair));
  demand(Trouble::not_deepest, pair, (contact.overlap - bound) / tolerance.overlap);
  const bool gap = contact.overlap < 0.0;
  if ((contact.status == ContactStatus::touching && gap) || (contact.status == ContactStatus::separated && !gap))
    note(Trouble::wrong_sign, pair);
}

void Study::compare_with_reference(const Pair& pair, const Tolerance& tolerance, const ContactGeometry& contact) {
  const double depth = reference_depth(pair.shape_1, pair.pose_1, pair.shape_2, pair.pose_2).minimum.depth;
  ++result.row.references;
  demand(Trouble::reference, pair, std::fabs(contact.overlap - depth) / tolerance.overlap);
}

void Study::examine(std::size_t first, std::size_t count) {
  constexpr double power_of_two = 0x1p-20;  // metres to about a micrometre
  std::vector<Candidate> candidates;
  std::vector<Pair> pairs, exchanged, small, elsewhere, near;
  for (std::size_t i = first; i < first + count; ++i) {
    Random random(0x5DEECE66DU + i);
    candidates.push_back(run_.pair(i));
    const Pair& pair = candidates.back().pair;
    pairs.push_back(pair);
    exchanged.push_back(swapped(pair));
    small.push_back(scaled(pair, power_of_two));
    const double size = std::min(pair.shape_1.half_axes.maxCoeff(), pair.shape_2.half_axes.maxCoeff());
    elsewhere.push_back(in_other_world(pair, random.orientation(), 3.0 * size * random.direction()));
    near.push_back(nudged(pair, random));
  }

  const SuperquadricPairs columns = columns_of(pairs);
  ContactCaches caches;
  ContactColumns here;
  result.row.mean_ns += 1e9 * seconds_of([&] { solve_(columns, caches, here); });
  const ContactColumns there = cold(exchanged), shrunk = cold(small), turned = cold(elsewhere), fresh = cold(near);
  ContactCaches own = caches, moved = std::move(caches);
  ContactColumns again, followed;
  solve_(columns, own, again);
  solve_(columns_of(near), moved, followed);

  for (std::size_t i = 0; i < count; ++i) {
    const Pair& pair = pairs[i];
    const Tolerance tolerance = tolerance_of(pair);
    const ContactGeometry contact = here.get(i);
    examine_answer(candidates[i], tolerance, contact);

    ContactCaches one_cache;
    ContactColumns one_contact;
    const SuperquadricPairs one = columns_of({pair});
    const double seconds = seconds_of([&] { solve_(one, one_cache, one_contact); });
    if (1e6 * seconds > result.row.worst_us) {
      result.row.worst_us = 1e6 * seconds;
      result.row.slowest = pair.label;
    }
    const ContactGeometry alone = one_contact.get(0);
    if (!is_finite(contact)) continue;
    if (!is_same(contact, alone)) note(Trouble::neighbour, pair);
    if (!is_its_own_swap(pair) && !is_exact_swap(contact, there.get(i))) note(Trouble::swap, pair);
    if (survives_scaling(pair, power_of_two) && !is_exact_scaling(contact, shrunk.get(i), power_of_two))
      note(Trouble::scale, pair);

    if (!is_resolved(contact.status)) continue;
    if (first + i < run_.references) compare_with_reference(pair, tolerance, contact);
    const auto differs = [&](const ContactGeometry& other) {
      return is_resolved(other.status) ? (other.overlap - contact.overlap) / tolerance.overlap
                                       : std::numeric_limits<double>::infinity();
    };
    // Positions were rounded anew.
    demand(Trouble::world, pair, std::fabs(differs(turned.get(i))) / 2.0);
    demand(Trouble::warm, pair, std::fabs(differs(again.get(i))));
    const ContactGeometry from_nothing = fresh.get(i), from_near = followed.get(i);
    if (!is_resolved(from_nothing.status)) continue;
    const double above = is_resolved(from_near.status) ? from_near.overlap - from_nothing.overlap
                                                       : std::numeric_limits<double>::infinity();
    if (above > tolerance.overlap && above <= passed_over(pair)) ++result.row.passed_over;
    demand(Trouble::moved, pair, (above - passed_over(pair)) / tolerance.overlap);
  }
  result.row.pairs += count;
}

}  // namespace

std::string_view name(Trouble trouble) {
  return texts[static_cast<std::size_t>(trouble)].name;
}
std::string_view meaning(Trouble trouble) {
  return texts[static_cast<std::size_t>(trouble)].meaning;
}

RobustnessResult robustness(const RobustnessRun& run, const BulkSolver& solve,
                            const std::function<void(std::size_t)>& progress) {
  constexpr std::size_t block = 512;
  Study study(run, solve);
  for (std::size_t first = 0; first < run.pairs; first += block) {
    study.examine(first, std::min(block, run.pairs - first));
    progress(std::min(first + block, run.pairs));
  }
  study.result.row.mean_ns /= static_cast<double>(std::max<std::size_t>(run.pairs, 1));
  return std::move(study.result);
}

RobustnessRun random_run(const PairFamily& family, std::uint64_t seed, std::size_t pairs) {
  return {.family = family.name, .pairs = pairs, .pair = [family, seed](std::size_t i) {
            RandomPair random = random_pair(family, seed, i);
            return Candidate{std::move(random.pair), random.overlap};
          }};
}

RobustnessRun nasty_run() {
  const auto pairs = std::make_shared<const std::vector<Candidate>>(nasty_pairs());
  return {.family = "nasty poses", .pairs = pairs->size(), .pair = [pairs](std::size_t i) { return (*pairs)[i]; }};
}

}  // namespace osculate::validation
