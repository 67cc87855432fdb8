#include "validation/comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace osculate::validation {

Interval rounded(double value, int decimals) {
  const double half = 0.5 * std::pow(10.0, -decimals);
  return {value - half, value + half};
}

bool overlap(const Interval& a, const Interval& b) {
  return a.low <= b.high && b.low <= a.high;
}

std::string name(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::differs:
      return "DIFFERS";
    case Verdict::contradiction:
      return "contradiction";
    case Verdict::not_available:
      return "not available";
  }
  return "unknown";
}

Comparison compare(std::string item, std::string quantity, std::optional<Printed> printed,
                   std::optional<double> computed, std::optional<Interval> range) {
  Verdict verdict = Verdict::not_available;
  if (printed && range)
    verdict = overlap(rounded(printed->value, printed->decimals), *range) ? Verdict::reproduced : Verdict::differs;
  return {std::move(item), std::move(quantity), printed, computed, range, verdict, {}};
}

io::Table columns_of(const ReproducedTable& table) {
  io::Table columns{{"case", "quantity", "printed", "computed", "range", "difference", "verdict", "note"}, {}, 2};
  for (const auto& row : table.rows) {
    const bool both = row.printed && row.computed;
    columns.rows.push_back({row.item, row.quantity,
                            row.printed ? fmt::format("{:.{}f}", row.printed->value, row.printed->decimals) : "–",
                            row.computed ? fmt::format("{:.5f}", *row.computed) : "–",
                            row.range ? fmt::format("{:.5f} … {:.5f}", row.range->low, row.range->high) : "–",
                            both ? fmt::format("{:+.3f} %", 100.0 * (*row.computed / row.printed->value - 1.0)) : "–",
                            name(row.verdict), row.remark});
  }
  return columns;
}

std::string to_text(const ReproducedTable& table) {
  const auto lines = [](const std::vector<std::string>& of) { return fmt::format("{}\n", fmt::join(of, "\n")); };
  return fmt::format("{}\n\n{}\n{}\n{}", table.title, lines(table.preamble), io::to_text(columns_of(table)),
                     lines(table.notes));
}

std::string to_json(const ReproducedTable& table) {
  using nlohmann::json;
  json rows = json::array();
  for (const auto& row : table.rows) {
    rows.push_back(
        {{"case", row.item},
         {"quantity", row.quantity},
         {"printed", row.printed ? json(row.printed->value) : json()},
         {"computed", row.computed ? json(*row.computed) : json()},
         {"range", row.range ? json{row.range->low, row.range->high} : json()},
         {"difference", row.printed && row.computed ? json(*row.computed / row.printed->value - 1.0) : json()},
         {"verdict", name(row.verdict)},
         {"note", row.remark}});
  }
  return json{{"title", table.title}, {"preamble", table.preamble}, {"rows", rows}, {"notes", table.notes}}.dump(2);
}

}  // namespace osculate::validation
