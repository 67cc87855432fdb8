#include "io/toml_reader.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include "io/nearest_name.hpp"

namespace osculate::io {
namespace {

struct Document {
  std::filesystem::path path;
  toml::table root;
};

/// A value with the way to it, for messages.
struct Place {
  const Document* document;
  const toml::node* node;
  std::string key;  ///< "a.b[2]"
};

std::string position(const Document& document, const toml::source_position& at) {
  if (at.line == 0) return document.path.string();
  return fmt::format("{}:{}:{}", document.path.string(), at.line, at.column);
}

std::string where(const Place& place) {
  return fmt::format("{}: key {}", position(*place.document, place.node->source().begin), place.key);
}

InputError error_at(const Place& place, const std::string& found, const std::string& expected) {
  return {where(place), "found " + found, expected};
}

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("the string \"{}\"", text->get());
  if (const auto* number = node.as_integer()) return fmt::format("the integer {}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("the number {}", number->get());
  if (const auto* boolean = node.as_boolean()) return boolean->get() ? "true" : "false";
  if (const auto* array = node.as_array()) {
    return fmt::format("an array of {} value{}", array->size(), array->size() == 1 ? "" : "s");
  }
  if (node.is_table()) return "a table";
  return "a date or time";
}

double number_at(const Place& place) {
  const auto value = place.node->is_number() ? place.node->value<double>() : std::nullopt;
  if (!value) throw error_at(place, describe(*place.node), "a number");
  if (!std::isfinite(*value)) throw error_at(place, fmt::format("{}", *value), "a finite number");
  return *value;
}

double ranged(const Place& place, double value, const Range& range, std::string_view unit) {
  if (range.holds(value)) return value;
  const std::string found = unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
  throw error_at(place, found, range.describe(unit) + range.hint);
}

/// "3.5 mm" in SI.
double quantity_in_text(const Place& place, const std::string& text, const Dimension& dimension) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, status] = std::from_chars(text.data(), end, value);
  const std::string_view after(rest, static_cast<std::size_t>(end - rest));
  const std::size_t start = after.find_first_not_of(' ');
  const auto unit = start == std::string_view::npos ? std::nullopt : dimension.in_si(after.substr(start));
  if (status != std::errc{} || !unit || !std::isfinite(value)) {
    throw error_at(place, fmt::format("\"{}\"", text),
                   fmt::format("a {} such as \"1.5 {}\"; its units are {}", dimension.name,
                               dimension.units.front().symbol, dimension.symbols()));
  }
  return value * *unit;
}

double quantity_at(const Place& place, const Dimension& dimension, const Range& range, std::string_view default_unit) {
  const std::string_view si = dimension.units.front().symbol;
  if (const auto* text = place.node->as_string()) {
    return ranged(place, quantity_in_text(place, text->get(), dimension), range, si);
  }
  if (!place.node->is_number()) {
    throw error_at(place, describe(*place.node),
                   fmt::format("a {}: a number or a string with a unit ({})", dimension.name, dimension.symbols()));
  }
  const auto unit = dimension.in_si(default_unit.empty() ? si : default_unit);
  if (!unit) throw error_at(place, fmt::format("the unit \"{}\"", default_unit), dimension.symbols());
  return ranged(place, number_at(place) * *unit, range, si);
}

Place element(const Place& array, std::size_t index) {
  return {array.document, array.node->as_array()->get(index), fmt::format("{}[{}]", array.key, index)};
}

/// The elements of an array of a given length.
std::vector<Place> elements(const Place& place, std::optional<std::size_t> count, const std::string& expected) {
  const toml::array* array = place.node->as_array();
  if (array == nullptr || (count && array->size() != *count)) {
    throw error_at(place, describe(*place.node), expected);
  }
  std::vector<Place> found;
  for (std::size_t i = 0; i < array->size(); ++i) found.push_back(element(place, i));
  return found;
}

}  // namespace

bool Range::holds(double value) const {
  const bool above = lower_end == Lower::included ? value >= lower : value > lower;
  return above && value <= upper && std::isfinite(value);
}

std::string Range::describe(std::string_view unit) const {
  const std::string suffix = unit.empty() ? "" : fmt::format(" {}", unit);
  const std::string relation = lower_end == Lower::included ? "at least" : "above";
  if (lower == 0.0 && std::isinf(upper)) {
    return lower_end == Lower::included ? "a number that is not negative" : "a positive number";
  }
  if (std::isinf(lower) && std::isinf(upper)) return "a finite number";
  if (std::isinf(lower)) return fmt::format("a number of at most {}{}", upper, suffix);
  if (std::isinf(upper)) return fmt::format("a number {} {}{}", relation, lower, suffix);
  return fmt::format("a number {} {}{} and at most {}{}", relation, lower, suffix, upper, suffix);
}

struct TomlTable::Content {
  std::shared_ptr<const Document> document;
  const toml::table* table;
  std::string key;  ///< way from the root, empty for the root
  std::shared_ptr<std::set<std::string, std::less<>>> asked = std::make_shared<std::set<std::string, std::less<>>>();

  std::string key_of(std::string_view name) const {
    return key.empty() ? std::string(name) : fmt::format("{}.{}", key, name);
  }

  const toml::node* find(std::string_view name) const {
    asked->emplace(name);
    return table->get(name);
  }

  Place require(std::string_view name, std::string_view expected) const {
    const toml::node* node = find(name);
    if (node == nullptr) throw missing(name, expected);
    return {document.get(), node, key_of(name)};
  }

  InputError missing(std::string_view name, std::string_view expected) const {
    std::vector<std::string> unasked;
    for (const auto& [present, node] : *table) {
      if (!asked->contains(present.str())) unasked.emplace_back(present.str());
    }
    const std::vector<std::string> near = nearest_names(name, unasked);
    if (!near.empty()) {
      return {fmt::format("{}: key {}", position(*document, table->get(near.front())->source().begin), key_of(name)),
              fmt::format("found no such key, but the similar \"{}\"", near.front()), std::string(expected)};
    }
    return {fmt::format("{}: key {}", position(*document, table->source().begin), key_of(name)), "found no such key",
            std::string(expected)};
  }

  std::shared_ptr<const Content> child(const Place& place) const {
    const toml::table* inner = place.node->as_table();
    if (inner == nullptr) throw error_at(place, describe(*place.node), "a table");
    return std::make_shared<const Content>(Content{document, inner, place.key});
  }
};

bool TomlTable::has(std::string_view key) const {
  return content_->find(key) != nullptr;
}

double TomlTable::number(std::string_view key, const Range& range) const {
  const Place place = content_->require(key, range.describe(""));
  return ranged(place, number_at(place), range, "");
}

double TomlTable::number_or(std::string_view key, double otherwise, const Range& range) const {
  return has(key) ? number(key, range) : otherwise;
}

int TomlTable::integer(std::string_view key, int lower, int upper) const {
  const std::string expected = fmt::format("an integer from {} to {}", lower, upper);
  const Place place = content_->require(key, expected);
  const auto* value = place.node->as_integer();
  if (value == nullptr || value->get() < lower || value->get() > upper) {
    throw error_at(place, describe(*place.node), expected);
  }
  return static_cast<int>(value->get());
}

bool TomlTable::flag(std::string_view key) const {
  if (!has(key)) return false;
  const Place place = content_->require(key, "true or false");
  const auto* value = place.node->as_boolean();
  if (value == nullptr) throw error_at(place, describe(*place.node), "true or false");
  return value->get();
}

std::string TomlTable::text(std::string_view key) const {
  const Place place = content_->require(key, "a string");
  const auto* value = place.node->as_string();
  if (value == nullptr) throw error_at(place, describe(*place.node), "a string");
  return value->get();
}

std::string TomlTable::text_or(std::string_view key, std::string_view otherwise) const {
  return has(key) ? text(key) : std::string(otherwise);
}

std::string TomlTable::choice(std::string_view key, const std::vector<std::string>& choices) const {
  std::string expected = "one of ";
  for (std::size_t i = 0; i < choices.size(); ++i) expected += (i > 0 ? ", \"" : "\"") + choices[i] + "\"";
  const Place place = content_->require(key, expected);
  const auto* value = place.node->as_string();
  if (value == nullptr) throw error_at(place, describe(*place.node), expected);
  for (const std::string& allowed : choices) {
    if (value->get() == allowed) return allowed;
  }
  throw error_at(place, describe(*place.node) + suggestion(value->get(), choices), expected);
}

double TomlTable::quantity(std::string_view key, const Dimension& dimension, const Range& range,
                           std::string_view default_unit) const {
  return quantity_at(content_->require(key, fmt::format("a {}", dimension.name)), dimension, range, default_unit);
}

Vec3 TomlTable::vector(std::string_view key, const Dimension& dimension, const Range& range,
                       std::string_view default_unit) const {
  const std::string expected = fmt::format("an array of three {}s", dimension.name);
  const auto parts = elements(content_->require(key, expected), 3, expected);
  Vec3 value;
  for (int i = 0; i < 3; ++i) {
    value[i] = quantity_at(parts[static_cast<std::size_t>(i)], dimension, range, default_unit);
  }
  return value;
}

Vec3 TomlTable::vector(std::string_view key, const Range& range) const {
  const std::vector<double> parts = numbers(key, 3, range);
  return {parts[0], parts[1], parts[2]};
}

std::vector<double> TomlTable::numbers(std::string_view key, std::size_t count, const Range& range) const {
  const std::string expected = fmt::format("an array of {} numbers", count);
  std::vector<double> values;
  for (const Place& place : elements(content_->require(key, expected), count, expected)) {
    values.push_back(ranged(place, number_at(place), range, ""));
  }
  return values;
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
  std::vector<std::string> values;
  for (const Place& place :
       elements(content_->require(key, "an array of strings"), std::nullopt, "an array of strings")) {
    const auto* value = place.node->as_string();
    if (value == nullptr) throw error_at(place, describe(*place.node), "a string");
    values.push_back(value->get());
  }
  return values;
}

std::vector<std::vector<double>> TomlTable::rows(std::string_view key, std::size_t columns) const {
  const std::string expected_row = fmt::format("an array of {} numbers", columns);
  const std::string expected = "an array of such: " + expected_row;
  std::vector<std::vector<double>> table;
  for (const Place& row : elements(content_->require(key, expected), std::nullopt, expected)) {
    std::vector<double>& values = table.emplace_back();
    for (const Place& place : elements(row, columns, expected_row)) values.push_back(number_at(place));
  }
  return table;
}

Quat TomlTable::quaternion(std::string_view key) const {
  constexpr double tolerance = 1e-6;  // six digits are what a person writes
  const std::vector<double> parts = numbers(key, 4);
  const Quat value(parts[0], parts[1], parts[2], parts[3]);
  if (std::abs(value.norm() - 1.0) > tolerance) {
    throw error(key, fmt::format("a quaternion of norm {:.7g}", value.norm()),
                "a unit quaternion [w, x, y, z], its norm 1 within 1e-6");
  }
  return value.normalized();
}

TomlTable TomlTable::table(std::string_view key) const {
  return TomlTable(content_->child(content_->require(key, "a table")));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  std::vector<TomlTable> found;
  for (const Place& place :
       elements(content_->require(key, "an array of tables"), std::nullopt, "an array of tables")) {
    found.push_back(TomlTable(content_->child(place)));
  }
  return found;
}

bool TomlTable::is_table(std::string_view key) const {
  const toml::node* node = content_->find(key);
  return node != nullptr && node->is_table();
}

bool TomlTable::is_text(std::string_view key) const {
  const toml::node* node = content_->find(key);
  return node != nullptr && node->is_string();
}

void TomlTable::reject_unknown_keys() const {
  const std::vector<std::string> known(content_->asked->begin(), content_->asked->end());
  for (const auto& [key, node] : *content_->table) {
    if (content_->asked->contains(key.str())) continue;
    std::string expected = "one of the keys ";
    for (std::size_t i = 0; i < known.size(); ++i) expected += (i > 0 ? ", " : "") + known[i];
    throw InputError(
        fmt::format("{}: key {}", position(*content_->document, key.source().begin), content_->key_of(key.str())),
        fmt::format("found an unknown key \"{}\"{}", key.str(), suggestion(key.str(), known)), expected);
  }
}

std::string TomlTable::where(std::string_view key) const {
  const toml::node* node = content_->table->at_path(key).node();
  if (node != nullptr) return io::where({content_->document.get(), node, content_->key_of(key)});
  return fmt::format("{}: key {}", position(*content_->document, content_->table->source().begin),
                     content_->key_of(key));
}

std::string TomlTable::where() const {
  if (content_->key.empty()) return content_->document->path.string();
  return fmt::format("{}: table {}", position(*content_->document, content_->table->source().begin), content_->key);
}

InputError TomlTable::error(std::string_view key, const std::string& found, const std::string& expected) const {
  return {where(key), "found " + found, expected};
}

const std::filesystem::path& TomlTable::file() const {
  return content_->document->path;
}

TomlTable parse_toml(std::string_view text, const std::filesystem::path& name) {
  auto document = std::make_shared<Document>(Document{name, {}});
  try {
    document->root = toml::parse(text, name.string());
  } catch (const toml::parse_error& error) {
    throw InputError(position(*document, error.source().begin), fmt::format("found {}", error.description()),
                     "valid TOML (https://toml.io)");
  }
  const toml::table* root = &document->root;
  return TomlTable(std::make_shared<const TomlTable::Content>(TomlTable::Content{std::move(document), root, ""}));
}

TomlTable read_toml(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) {
    const bool there = std::filesystem::exists(path);
    throw InputError(path.string(), there ? "found no regular file" : "found no such file", "a TOML file");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string(), "found a file that cannot be opened", "a readable TOML file");
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  return parse_toml(text, path);
}

}  // namespace osculate::io
