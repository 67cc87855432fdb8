// Tables 2 and 3 of the review; Table 1 has a file of its own.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "osculate/mechanics/contact_ellipse.hpp"
#include "validation/kildashti2023/cases.hpp"
#include "validation/kildashti2023/tables.hpp"

namespace validation = osculate::validation;
using validation::Verdict;

namespace {

const validation::Comparison& row(const validation::ReproducedTable& table, const std::string& item,
                                  const std::string& quantity) {
  const auto found = std::find_if(table.rows.begin(), table.rows.end(), [&](const validation::Comparison& candidate) {
    return candidate.item == item && candidate.quantity == quantity;
  });
  if (found == table.rows.end()) FAIL("no row " + item + ", " + quantity);
  return *found;
}

}  // namespace

TEST_CASE("Every printed number of the review's tables is reproduced or a contradiction with a note that proves it") {
  int printed = 0;
  for (const auto& entry : validation::kildashti2023::tables()) {
    const auto table = entry.compute();
    for (const auto& comparison : table.rows) {
      if (!comparison.printed) continue;
      ++printed;
      INFO(entry.name << ", case " << comparison.item << ", " << comparison.quantity);
      CHECK(comparison.verdict != Verdict::not_available);
      CHECK(comparison.verdict != Verdict::differs);
      if (comparison.verdict != Verdict::contradiction) continue;
      REQUIRE_FALSE(comparison.remark.empty());
      CHECK(std::any_of(table.notes.begin(), table.notes.end(),
                        [&](const std::string& note) { return note.rfind(comparison.remark, 0) == 0; }));
    }
  }
  CHECK(printed == 14);  // 8 of Table 1, 3 of Table 2, 3 of Table 3
}

TEST_CASE("Table 2 without adhesion is Hertz with the exact ellipse, and adhesion takes from the force") {
  const auto table = validation::kildashti2023::table2();
  for (const auto& pose : validation::kildashti2023::cases) {
    const std::string item(pose.name);
    const auto ellipse = osculate::contact_ellipse(pose.R_i.value, pose.R_j.value);
    const double free = *row(table, item, "W → 0").computed;
    CHECK(free == Approx(std::sqrt(ellipse.R_c) * ellipse.gamma()).epsilon(1e-12));
    CHECK(*row(table, item, "W = 1e-05 Ê R_vol").computed < free);
    CHECK(*row(table, item, "W = 0.0001 Ê R_vol").computed < *row(table, item, "W = 1e-05 Ê R_vol").computed);
  }
}

TEST_CASE("Table 3's entry for case 1 contradicts its own factors, which are reproduced") {
  const auto table = validation::kildashti2023::table3();
  const auto& radius = row(table, "1", "R_c/R_vol");
  const auto& gamma = row(table, "1", "γ F_3/2, h = 1");
  const auto& force = row(table, "1", "force, h = 1");
  CHECK(radius.verdict == Verdict::reproduced);
  CHECK(gamma.verdict == Verdict::reproduced);
  CHECK(force.verdict == Verdict::contradiction);
  // By the printed digits alone: even the smallest numbers that round to the factors give six times the entry.
  const double least =
      std::sqrt(validation::rounded(radius.printed->value, 3).low) * validation::rounded(gamma.printed->value, 3).low;
  CHECK(least > 6.0 * validation::rounded(force.printed->value, 4).high);
  CHECK(*force.computed == Approx(std::sqrt(0.222) * 0.255).epsilon(3e-3));  // the factors' own rounding
}
