#include "io/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "io/nearest_name.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',')
      fields.emplace_back();
    else if (c != ' ' && c != '\t' && c != '\r')
      fields.back() += c;
  }
  return fields;
}

double number_of(const std::string& text, const std::string& where) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(where, fmt::format("\"{}\"", text), "a finite number");
  return value;
}

}  // namespace

const std::vector<double>* NumberTable::find(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

NumberTable read_numbers(const std::string& path, std::span<const std::string> known) {
  std::ifstream file(path);
  if (!file) throw InputError(path, "cannot be opened", "a table of comma-separated numbers under a header");
  const std::vector<std::string> all(known.begin(), known.end());
  NumberTable table;
  std::string line;
  if (!std::getline(file, line))
    throw InputError(path, "an empty file", "a header: " + fmt::format("{}", fmt::join(all, ", ")));
  for (const std::string& name : fields_of(line)) {
    if (std::ranges::find(all, name) == all.end())
      throw InputError(path + " line 1", fmt::format("a column \"{}\"{}", name, suggestion(name, all)),
                       fmt::format("one of {}", fmt::join(all, ", ")));
    if (std::ranges::find(table.names, name) != table.names.end())
      throw InputError(path + " line 1", fmt::format("the column \"{}\" twice", name), "it once");
    table.names.push_back(name);
  }
  table.columns.resize(table.names.size());
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() == 1 && fields.front().empty()) continue;
    const std::string where = fmt::format("{} line {}", path, number);
    if (fields.size() != table.names.size())
      throw InputError(where, fmt::format("{} values", fields.size()), fmt::format("{}", table.names.size()));
    for (std::size_t k = 0; k < fields.size(); ++k)
      table.columns[k].push_back(number_of(fields[k], fmt::format("{}, {}", where, table.names[k])));
  }
  if (table.rows() == 0) throw InputError(path, "no line of numbers", "at least one below the header");
  return table;
}

std::string to_csv(const NumberTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.names, ","));
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (std::size_t k = 0; k < table.columns.size(); ++k)
      text += fmt::format("{}{}", table.columns[k][row], k + 1 < table.columns.size() ? "," : "\n");
  return text;
}

}  // namespace osculate::io
