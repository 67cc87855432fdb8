#pragma once
// Tables of numbers under named columns, as comma-separated text with a header.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace osculate::io {

struct NumberTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< one a name, all of one length

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// The column of this name, or nullptr.
  const std::vector<double>* find(std::string_view name) const;
};

/// Throws InputError with file, line and column: no such file, no rows, a column that is not `known` or comes twice, a
/// field that is no finite number, lines of another length than the header.
NumberTable read_numbers(const std::string& path, std::span<const std::string> known);

/// Every number with all its digits.
std::string to_csv(const NumberTable& table);

}  // namespace osculate::io
