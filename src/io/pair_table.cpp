#include "io/pair_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

constexpr std::size_t first_reference = pair_columns.size();
constexpr std::size_t class_column = first_reference + reference_columns.size();
constexpr std::size_t ignored_column = class_column + 1;
constexpr std::size_t buffer_bytes = std::size_t{1} << 20U;
constexpr double largest_exponent = 64.0;
// Quaternions written with six digits are off by this much; what is further off was never meant as a rotation.
constexpr double quaternion_tolerance = 1e-6;

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view take_field(std::string_view& rest) {
  const std::size_t comma = rest.find(',');
  const std::string_view field = rest.substr(0, comma);
  rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
  return trimmed(field);
}

std::size_t count_fields(std::string_view line) {
  return 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
}

std::size_t meaning_of(std::string_view column) {
  if (column == "class") return class_column;
  const auto* pair = std::find(pair_columns.begin(), pair_columns.end(), column);
  if (pair != pair_columns.end()) return static_cast<std::size_t>(pair - pair_columns.begin());
  const auto* known = std::find(reference_columns.begin(), reference_columns.end(), column);
  if (known != reference_columns.end())
    return first_reference + static_cast<std::size_t>(known - reference_columns.begin());
  return ignored_column;
}

std::string_view name_of(std::size_t meaning) {
  return meaning < first_reference ? pair_columns[meaning] : reference_columns[meaning - first_reference];
}

std::string shortest(double value) {
  return fmt::format("{}", value);
}

std::string quoted(std::string_view text) {
  return "\"" + std::string(text) + "\"";
}

}  // namespace

Superquadric PairBlock::shape(std::size_t i, std::size_t body) const {
  const auto at = [&](std::size_t column) { return pairs.columns[body + column][i]; };
  return {.half_axes = {at(0), at(1), at(2)}, .exponents = {.n1 = at(3), .n2 = at(4)}};
}

Pose PairBlock::pose(std::size_t i, std::size_t body) const {
  const auto at = [&](std::size_t column) { return pairs.columns[body + column][i]; };
  return {.position = {at(5), at(6), at(7)}, .orientation = {at(8), at(9), at(10), at(11)}};
}

PairTableReader::PairTableReader(const std::string& path, ReferenceColumns reference)
    : path_(path), with_reference_(reference == ReferenceColumns::require), file_(std::fopen(path.c_str(), "rb")) {
  if (!file_)
    throw InputError(path_, std::string("cannot be opened (") + std::strerror(errno) + ")", "a table of pairs");
  if (std::fseek(file_.get(), 0, SEEK_END) == 0) {
    file_bytes_ = static_cast<double>(std::ftell(file_.get()));
    std::rewind(file_.get());
  }
  buffer_.resize(buffer_bytes);
  read_header();
}

double PairTableReader::progress() const {
  return file_bytes_ > 0.0 ? std::clamp((read_bytes_ - static_cast<double>(end_ - begin_)) / file_bytes_, 0.0, 1.0)
                           : 0.0;
}

std::optional<std::string_view> PairTableReader::next_line() {
  std::size_t searched = begin_;
  while (true) {
    const void* found = end_ > searched ? std::memchr(buffer_.data() + searched, '\n', end_ - searched) : nullptr;
    if (found != nullptr) {
      const auto newline = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data());
      const std::string_view line(buffer_.data() + begin_, newline - begin_);
      begin_ = newline + 1;
      ++line_;
      return line;
    }
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    searched = end_;
    if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
    const std::size_t got = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, file_.get());
    if (got == 0) {
      if (std::ferror(file_.get()) != 0) throw InputError(path_, "cannot be read", "a table of pairs");
      if (end_ == 0) return std::nullopt;
      const std::string_view line(buffer_.data(), end_);
      begin_ = end_;
      ++line_;
      return line;
    }
    end_ += got;
    read_bytes_ += static_cast<double>(got);
  }
}

void PairTableReader::read_header() {
  const std::optional<std::string_view> header = next_line();
  if (!header || trimmed(*header).empty())
    throw InputError(path_ + ":1", "no header", "a line with the names of the columns");
  std::string_view rest = *header;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest.starts_with(byte_order_mark)) rest.remove_prefix(byte_order_mark.size());
  field_count_ = count_fields(rest);
  std::array<bool, ignored_column + 1> seen{};
  for (std::size_t i = 0; i < field_count_; ++i) {
    const std::string_view column = take_field(rest);
    std::size_t meaning = meaning_of(column);
    if (meaning != ignored_column && seen[meaning])
      throw InputError(path_ + ":1", "column " + std::string(column) + " appears twice", "each column once");
    seen[meaning] = true;
    if (!with_reference_ && meaning >= first_reference && meaning < class_column) meaning = ignored_column;
    meaning_.push_back(meaning);
  }
  has_class_ = seen[class_column];

  std::vector<std::string_view> needed;
  std::vector<std::string_view> missing;
  for (std::size_t meaning = 0; meaning < (with_reference_ ? class_column : first_reference); ++meaning) {
    needed.push_back(name_of(meaning));
    if (!seen[meaning]) missing.push_back(name_of(meaning));
  }
  if (!missing.empty())
    throw InputError(path_ + ":1", fmt::format("missing column {}", fmt::join(missing, ", ")),
                     fmt::format("the columns {} in any order", fmt::join(needed, ",")));
}

bool PairTableReader::read(PairBlock& block, std::size_t count) {
  block.pairs.resize(count);
  block.reference.resize(count);
  block.classes.clear();
  block.lines.clear();
  while (block.size() < count) {
    const std::optional<std::string_view> line = next_line();
    if (!line) break;
    if (trimmed(*line).empty()) continue;
    read_pair(*line, block);
    check_pair(block.size() - 1, block.pairs);
  }
  block.pairs.resize(block.size());
  block.reference.resize(block.size());
  return block.size() > 0;
}

void PairTableReader::read_pair(std::string_view line, PairBlock& block) {
  const std::size_t found = count_fields(line);
  if (found != field_count_)
    throw InputError(path_ + ":" + std::to_string(line_), std::to_string(found) + " fields",
                     std::to_string(field_count_) + " as in the header");
  const std::size_t i = block.size();
  block.lines.push_back(line_);
  std::string_view rest = line;
  for (const std::size_t meaning : meaning_) {
    const std::string_view field = take_field(rest);
    if (meaning == ignored_column) continue;
    if (meaning == class_column) {
      block.classes.emplace_back(field);
      continue;
    }
    double value = 0.0;
    const char* const end = field.data() + field.size();
    const auto [stopped, error] = std::from_chars(field.data() + (field.starts_with('+') ? 1 : 0), end, value);
    if (error != std::errc() || stopped != end || !std::isfinite(value))
      throw InputError(where(name_of(meaning)), quoted(field), "a finite number");
    if (meaning < first_reference)
      block.pairs.columns[meaning][i] = value;
    else
      block.reference[meaning - first_reference][i] = value;
  }
}

void PairTableReader::check_pair(std::size_t i, SuperquadricPairs& pairs) const {
  const auto demand = [&](std::size_t column, bool good, const char* expected) {
    if (!good) throw InputError(where(pair_columns[column]), shortest(pairs.columns[column][i]), expected);
  };
  constexpr std::size_t first_exponent = 3, past_exponents = 5, first_quaternion = 8;
  for (std::size_t body = 0; body < pair_columns.size(); body += SuperquadricPairs::per_body) {
    for (std::size_t axis = body; axis < body + first_exponent; ++axis)
      demand(axis, pairs.columns[axis][i] > 0.0, "a half-axis above 0 [m]");
    for (std::size_t exponent = body + first_exponent; exponent < body + past_exponents; ++exponent)
      demand(exponent, pairs.columns[exponent][i] > 1.0 && pairs.columns[exponent][i] <= largest_exponent,
             "an exponent n = 2/eta in (1, 64]");

    double square = 0.0;
    const std::size_t first = body + first_quaternion, past = body + SuperquadricPairs::per_body;
    for (std::size_t part = first; part < past; ++part) square += pairs.columns[part][i] * pairs.columns[part][i];
    const double length = std::sqrt(square);
    if (!(std::fabs(length - 1.0) <= quaternion_tolerance))
      throw InputError(where(std::string(pair_columns[first]) + ".." + std::string(pair_columns[past - 1])),
                       "a quaternion of length " + shortest(length), "a unit quaternion w, x, y, z");
    constexpr double round_off = 1e-15;
    if (std::fabs(length - 1.0) > round_off)
      for (std::size_t part = first; part < past; ++part) pairs.columns[part][i] /= length;
  }
}

std::string PairTableReader::where(std::string_view column) const {
  return path_ + ":" + std::to_string(line_) + ": column " + std::string(column);
}

}  // namespace osculate::io
