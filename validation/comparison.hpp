#pragma once
// What every reproduction of a published table ends in: printed | computed | difference | verdict.

#include <optional>
#include <string>
#include <vector>

#include "io/table.hpp"

namespace osculate::validation {

/// A number known only to lie between two bounds, such as a printed one.
struct Interval {
  double low;
  double high;
};

/// All numbers that print as `value` with so many decimals.
Interval rounded(double value, int decimals);

bool overlap(const Interval& a, const Interval& b);

enum class Verdict {
  reproduced,     ///< the computed interval meets the printed one
  differs,        ///< it does not
  contradiction,  ///< it does not and cannot: a note below the table proves which other known numbers it contradicts
  not_available,  ///< the printed or the computed number is missing: the remark says which, and why
};

std::string name(Verdict verdict);

/// A printed number: its value and its decimals.
struct Printed {
  double value;
  int decimals;
};

/// One number of a table.
struct Comparison {
  std::string item;                ///< which row of the source
  std::string quantity;            ///< which column, or how it was computed
  std::optional<Printed> printed;  ///< nothing: not available to the project
  std::optional<double> computed;  ///< nothing: only the range is known
  std::optional<Interval> range;   ///< what the inputs' own rounding makes of the computed number
  Verdict verdict;
  std::string remark;  ///< why it differs or is missing; a key into the notes below the table
};

/// A number set against its printed form: reproduced, different, or not available.
Comparison compare(std::string item, std::string quantity, std::optional<Printed> printed,
                   std::optional<double> computed, std::optional<Interval> range);

struct ReproducedTable {
  std::string title;
  std::vector<std::string> preamble;  ///< what the numbers are: units, inputs
  std::vector<Comparison> rows;
  std::vector<std::string> notes;  ///< each discrepancy and gap, explained
};

/// case | quantity | printed | computed | range | difference | verdict | note
io::Table columns_of(const ReproducedTable& table);

std::string to_text(const ReproducedTable& table);
std::string to_json(const ReproducedTable& table);

}  // namespace osculate::validation
