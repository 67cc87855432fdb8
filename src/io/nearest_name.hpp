#pragma once
// What the user may have meant: the names nearest to a misspelt one.

#include <string>
#include <string_view>
#include <vector>

namespace osculate::io {

/// Number of single-letter edits (insert, delete, replace, swap of neighbours) from one word to the other.
int edit_distance(std::string_view from, std::string_view to);

/// The names close enough to be a slip of the pen, nearest first.
std::vector<std::string> nearest_names(std::string_view name, const std::vector<std::string>& known);

/// " (did you mean …?)", or nothing when no known name is near.
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

}  // namespace osculate::io
