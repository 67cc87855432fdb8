#pragma once
// The narrow phase under stress: many random pairs, and every nasty pose, through checks that need no reference.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "osculate/geometry/superquadric_contacts.hpp"
#include "validation/narrow_phase/random_pairs.hpp"

namespace osculate::validation {

/// What can be wrong with an answer. All but `not_converged` are errors in the answer; that one is its own admission.
enum class Trouble : std::size_t {
  not_converged,  ///< the status says so
  degenerate,     ///< the status says so, though the input is finite
  not_finite,     ///< NaN or ∞ in the answer
  off_surface,    ///< a point is not on its surface, or not extreme along the normal
  off_overlap,    ///< the overlap is not that of the points, or of the normal
  off_line,       ///< the points do not lie on one line along the normal
  not_deepest,    ///< another direction has a smaller overlap
  reference,      ///< the plain multi-start solver finds another depth (asked for the first pairs only)
  wrong_sign,     ///< touching with a gap or separated with an overlap
  neighbour,      ///< alone in a call the pair gets other bits than among others
  swap,           ///< exchanged bodies give other bits
  scale,          ///< lengths times a power of two give other bits
  world,          ///< a turned and shifted world gives another overlap
  warm,           ///< started from its own answer it gives another overlap
  moved,  ///< started from the answer of a pose 1e-4 away it fails, or is deeper by more than that move explains
  count
};
constexpr std::size_t troubles = static_cast<std::size_t>(Trouble::count);
std::string_view name(Trouble trouble);
std::string_view meaning(Trouble trouble);

struct Finding {
  Trouble trouble;
  std::string label;  ///< the pair, to make it again
  double size;        ///< over the tolerance, where it is a number; 0 otherwise
};

/// The outcome for one family of pairs.
struct RobustnessRow {
  std::string family;
  std::size_t pairs = 0;
  std::size_t references = 0;             ///< pairs compared with the plain multi-start solver
  std::array<std::size_t, 6> statuses{};  ///< by ContactStatus
  std::array<std::size_t, troubles> counts{};
  std::array<double, troubles> worst{};  ///< over the tolerance
  /// Pairs that a move of 1e-4 left in a minimum which was the least before it and no longer is: a warm start follows
  /// its contact.
  std::size_t passed_over = 0;
  double mean_ns = 0.0;   ///< cold, in batches
  double worst_us = 0.0;  ///< cold, one pair a call
  std::string slowest;    ///< which
};

/// The narrow phase under test.
using BulkSolver = std::function<void(const SuperquadricPairs&, ContactCaches&, ContactColumns&)>;

/// A pair to test; `overlap` is a known upper bound of its depth [m], or ∞.
struct Candidate {
  Pair pair;
  double overlap;
};

struct RobustnessRun {
  std::string family;
  std::size_t pairs = 0;
  std::function<Candidate(std::size_t)> pair;  ///< pair number i
  std::size_t references = 0;                  ///< so many of the first pairs are given to `reference_depth` too
  std::size_t most_findings = 20;              ///< kept of each kind of trouble; all are counted
};

struct RobustnessResult {
  RobustnessRow row;
  std::vector<Finding> findings;
};

/// Runs all checks on all pairs. `progress` is called now and then with the number of pairs done.
RobustnessResult robustness(const RobustnessRun& run, const BulkSolver& solve,
                            const std::function<void(std::size_t)>& progress);

/// `pairs` random pairs of a family.
RobustnessRun random_run(const PairFamily& family, std::uint64_t seed, std::size_t pairs);

/// Every nasty pose (nasty_pairs.hpp).
RobustnessRun nasty_run();

}  // namespace osculate::validation
