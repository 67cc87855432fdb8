#pragma once
// What a law says, drawn over what was varied.

#include <string>
#include <string_view>

#include "io/number_table.hpp"
#include "io/plot.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::app {

/// In words, and the SI unit, of a column of `along` and `swept`; the name itself and no unit for others.
std::string_view answer_title(std::string_view column);
std::string_view answer_unit(std::string_view column);

/// The column to draw over: the swept one, or that of the path which moves most often.
std::string law_axis(const io::NumberTable& numbers, const std::string& swept_key);

/// @param axis  a column of `numbers`, in `unit`
io::Plot law_plot(const LawDescription& law, const io::NumberTable& numbers, const std::string& axis,
                  const std::string& unit);

}  // namespace osculate::app
