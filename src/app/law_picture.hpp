#pragma once
// What a law says, drawn over what was varied.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/number_table.hpp"
#include "io/plot.hpp"
#include "io/quantity_text.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::app {

/// In words, and the SI unit, of a column of `along` and `swept`; the name itself and no unit for others.
std::string_view answer_title(std::string_view column);
std::string_view answer_unit(std::string_view column);

/// The column to draw over: the swept one, or that of the path which moves most often.
std::string law_axis(const io::NumberTable& numbers, const std::string& swept_key);

/// The unit in which numbers of this size are told; an area takes the prefix of its side, other powers
/// and pure numbers none.
io::PrefixedUnit unit_for(double size, std::string_view unit);

/// What is drawn over.
struct AxisText {
  std::string column, title, unit;
};
/// Titles and SI units of columns.
struct ColumnWords {
  std::function<std::string_view(std::string_view)> title, unit;
};
/// Columns of one unit over the axis; those that are zero throughout are left out, unless all are.
io::Panel panel_over(const io::NumberTable& numbers, const AxisText& axis, const std::string& label,
                     std::vector<std::string> names, const ColumnWords& words);

/// @param axis  a column of `numbers`, in `unit`
io::Plot law_plot(const LawDescription& law, const io::NumberTable& numbers, const std::string& axis,
                  const std::string& unit);

}  // namespace osculate::app
