#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "osculate/mechanics/contact_ellipse.hpp"
#include "validation/kildashti2023/tables.hpp"

namespace validation = osculate::validation;
using validation::Verdict;

namespace {
validation::Comparison row(const std::string& item, const std::string& quantity) {
  for (const auto& candidate : validation::kildashti2023::table1().rows)
    if (candidate.item == item && candidate.quantity == quantity) return candidate;
  FAIL("no row " + item + ", " + quantity);
  return {};
}
}  // namespace

TEST_CASE("A printed number is reproduced when its rounding meets the range of the computed one") {
  const validation::Printed printed{1.5911, 4};
  const auto verdict = [&](double low, double high) {
    return validation::compare("", "", printed, low, validation::Interval{low, high}).verdict;
  };
  REQUIRE(verdict(1.5910, 1.59106) == Verdict::reproduced);
  REQUIRE(verdict(1.5910, 1.59104) == Verdict::differs);
  REQUIRE(verdict(1.59114, 1.60) == Verdict::reproduced);
  REQUIRE(verdict(1.59116, 1.60) == Verdict::differs);
  REQUIRE(validation::compare("", "", std::nullopt, 1.0, validation::Interval{1, 1}).verdict == Verdict::not_available);
  REQUIRE(validation::compare("", "", printed, std::nullopt, std::nullopt).verdict == Verdict::not_available);
}

TEST_CASE("Table 1: one minor radius reproduces the printed forces of Tables 1 and 2 in cases 1 and 2") {
  for (const auto* item : {"1", "2"}) {
    const auto by_14 = row(item, "accurate, axes by (14)"), by_13 = row(item, "accurate, axes by (13)");
    REQUIRE(by_14.verdict == Verdict::reproduced);
    REQUIRE(by_13.verdict == Verdict::reproduced);
    // Neither would be by the other equation: they are 40 units of the last printed digit apart.
    REQUIRE_FALSE(overlap(validation::rounded(by_14.printed->value, 4), *by_13.range));
    REQUIRE_FALSE(overlap(validation::rounded(by_13.printed->value, 4), *by_14.range));
  }
}

TEST_CASE("Table 1: the printed forces of case 3 contradict the decoded radii, and the table says so") {
  for (const auto* quantity : {"accurate, axes by (14)", "accurate, axes by (13)"}) {
    const auto comparison = row("3", quantity);
    REQUIRE(comparison.verdict == Verdict::contradiction);
    REQUIRE(comparison.remark == "[b]");
    REQUIRE(*comparison.computed == Approx(comparison.printed->value).epsilon(5e-3));  // as the note claims
  }
  // Their order is reversed: (14) lies below (13) for nearly circular contacts, above it in print.
  REQUIRE(*row("3", "accurate, axes by (14)").computed < *row("3", "accurate, axes by (13)").computed);
  REQUIRE(row("3", "accurate, axes by (14)").printed->value > row("3", "accurate, axes by (13)").printed->value);
}

TEST_CASE("Table 1: the radii said to give both printed forces of case 3 do") {
  const auto notes = validation::kildashti2023::table1().notes;
  REQUIRE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("(1.08, 0.0293) R_vol would") != std::string::npos;
  }));
  const auto exact = osculate::contact_ellipse(1.08, 0.0293);
  const auto approximate = osculate::contact_ellipse_approximate(1.08, 0.0293);
  // The radii are given to three digits, and the force goes with their root.
  REQUIRE(std::sqrt(exact.R_c) * exact.gamma() == Approx(0.5334).epsilon(2e-3));
  REQUIRE(approximate.gamma() / exact.gamma() == Approx(0.5345 / 0.5334).epsilon(1e-4));
}

TEST_CASE("Table 1: two radii at the cap make the simplified model root five") {
  for (const auto* item : {"1", "2"}) {
    REQUIRE(*row(item, "simplified").computed == Approx(std::sqrt(5.0)).epsilon(1e-15));
    REQUIRE(row(item, "simplified").verdict == Verdict::reproduced);
  }
}

TEST_CASE("Table 1: what is not known is not made up") {
  REQUIRE_FALSE(row("3", "simplified").printed);
  REQUIRE_FALSE(row("3", "simplified").computed);
  REQUIRE(row("3", "simplified").range->low < row("3", "simplified").range->high);
  for (const auto* item : {"1", "2", "3"}) {
    REQUIRE(row(item, "FEM").verdict == Verdict::not_available);
    REQUIRE_FALSE(row(item, "FEM").printed);
  }
}

TEST_CASE("The table as JSON carries every row, with null for what is missing") {
  const auto table = validation::kildashti2023::table1();
  const auto json = nlohmann::json::parse(validation::to_json(table));
  REQUIRE(json.at("rows").size() == table.rows.size());
  REQUIRE(json.at("rows").at(3).at("quantity") == "FEM");
  REQUIRE(json.at("rows").at(3).at("printed").is_null());
  REQUIRE(json.at("rows").at(0).at("printed") == 1.5911);
}
