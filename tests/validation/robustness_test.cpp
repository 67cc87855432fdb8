// A small part of `osculate validate narrow`, which runs as many pairs as one has time for.
#include "validation/narrow_phase/robustness.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "validation/narrow_phase/contact_checks.hpp"

using namespace osculate;
using namespace osculate::validation;

namespace {

const BulkSolver batched = [](const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts) {
  common_normals(pairs, caches, contacts);
};

RobustnessResult stress(const RobustnessRun& run) {
  return robustness(run, batched, [](std::size_t) {});
}

std::size_t count_of(const RobustnessResult& result, Trouble trouble) {
  return result.row.counts[static_cast<std::size_t>(trouble)];
}

void check_none(const RobustnessResult& result, Trouble trouble) {
  std::string which;
  for (const Finding& finding : result.findings)
    if (finding.trouble == trouble) which += "\n  " + finding.label;
  INFO(result.row.family << ": " << meaning(trouble) << which);
  CHECK(count_of(result, trouble) == 0);
}

/// Everything but the solver's own admission that it did not converge.
void check_answers(const RobustnessResult& result) {
  for (std::size_t k = 0; k < troubles; ++k)
    if (static_cast<Trouble>(k) != Trouble::not_converged) check_none(result, static_cast<Trouble>(k));
}

PairFamily family_named(const std::string& name) {
  for (const PairFamily& family : pair_families())
    if (family.name == name) return family;
  FAIL("no family " << name);
  return {};
}

}  // namespace

TEST_CASE("Random pairs with n >= 2 converge, each to a self-consistent, symmetric and global answer") {
  const std::string name = GENERATE("ellipsoid", "even", "n >= 2");
  RobustnessRun run = random_run(family_named(name), 5, 1000);
  run.references = 50;
  const RobustnessResult result = stress(run);
  check_answers(result);
  check_none(result, Trouble::not_converged);
}

TEST_CASE("Random pairs with sharp rims get a right answer or an honest status") {
  const std::string name = GENERATE("n < 2", "any");
  RobustnessRun run = random_run(family_named(name), 5, 1000);
  run.references = 50;
  const RobustnessResult result = stress(run);
  check_answers(result);
}

// Tips of n = 1.05 on one another have minima that differ by 1e-9 of the overlap or are too flat for Newton's method;
// how many of 6318 are met depends on round-off.
TEST_CASE("Nasty poses get a right answer or an honest status") {
  const RobustnessResult result = stress(nasty_run());
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < troubles; ++k) {
    const auto trouble = static_cast<Trouble>(k);
    if (trouble == Trouble::world)
      wrong += count_of(result, trouble);
    else if (trouble != Trouble::not_converged)
      check_none(result, trouble);
  }
  CHECK(wrong <= 6);
  CHECK(count_of(result, Trouble::not_converged) <= 30);  // 11 here, all with exponents below 2
}

TEST_CASE("The checks find a wrong contact") {
  const Candidate candidate = random_run(family_named("even"), 3, 1).pair(0);
  const Tolerance tolerance = tolerance_of(candidate.pair);
  SuperquadricPairs pairs;
  pairs.resize(1);
  pairs.set(0, candidate.pair.shape_1, candidate.pair.pose_1, candidate.pair.shape_2, candidate.pair.pose_2);
  ContactCaches caches;
  ContactColumns contacts;
  common_normals(pairs, caches, contacts);
  const ContactGeometry right = contacts.get(0);
  const SelfConsistency good = self_consistency(candidate.pair, tolerance, right);
  CHECK(std::max({good.off_surface, good.off_support, good.off_overlap, good.off_line}) <= 1.0);

  ContactGeometry wrong = right;
  wrong.overlap += 3.0 * tolerance.point;
  CHECK(self_consistency(candidate.pair, tolerance, wrong).off_overlap > 1.0);
  wrong = right;
  wrong.on_1 += 3.0 * tolerance.point * right.normal;
  CHECK(self_consistency(candidate.pair, tolerance, wrong).off_support > 1.0);
  wrong = right;
  wrong.on_2 += 3.0 * tolerance.offset * right.normal.unitOrthogonal();
  CHECK(self_consistency(candidate.pair, tolerance, wrong).off_line > 1.0);
  wrong = right;
  wrong.normal.x() = std::nan("");
  CHECK_FALSE(is_finite(wrong));
  CHECK_FALSE(self_consistency(candidate.pair, tolerance, wrong).off_overlap <= 1.0);
}
