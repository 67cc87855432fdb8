#pragma once
// TOML files read so that nothing wrong passes in silence: every error names file, line, column and key, what was found
// and what was expected; a key nobody asked for is an error that suggests the nearest known one.
//
//   const io::TomlTable file = io::read_toml(path);
//   const double ratio = file.number("poissons_ratio", io::Range::between(-1.0, 0.5));
//   const double modulus = file.quantity("youngs_modulus", io::pressure(), io::Range::positive());   // 71e9 or "71
//   GPa" file.reject_unknown_keys();

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/units.hpp"
#include "osculate/core/error.hpp"
#include "osculate/core/types.hpp"

namespace osculate::io {

/// The finite numbers a key takes, in SI. NaN and infinities are never taken.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  enum class Lower { included, excluded } lower_end = Lower::included;
  /// Added to what was expected when a number falls outside: the likely reason.
  std::string hint = {};

  static Range any() { return {}; }
  static Range positive() { return {.lower = 0.0, .lower_end = Lower::excluded}; }
  static Range not_negative() { return {.lower = 0.0}; }
  static Range between(double lower, double upper) { return {.lower = lower, .upper = upper}; }
  /// (lower, upper]
  static Range above(double lower, double upper) {
    return {.lower = lower, .upper = upper, .lower_end = Lower::excluded};
  }

  bool holds(double value) const;
  std::string describe(std::string_view unit) const;
};

/// One table of a file: the file itself, a [section], an inline {table} or an element of an array of tables.
/// A cheap handle; copies share the record of the keys asked for.
class TomlTable {
 public:
  /// True if the key is there. Asking makes the key a known one.
  bool has(std::string_view key) const;

  double number(std::string_view key, const Range& range = Range::any()) const;
  double number_or(std::string_view key, double otherwise, const Range& range = Range::any()) const;
  int integer(std::string_view key, int lower, int upper) const;
  /// true or false; false where the key is missing.
  bool flag(std::string_view key) const;
  std::string text(std::string_view key) const;
  std::string text_or(std::string_view key, std::string_view otherwise) const;
  /// A string out of a closed list.
  std::string choice(std::string_view key, const std::vector<std::string>& choices) const;

  /// A number in `default_unit` (the SI unit if empty), or a string with its unit: 3.5 or "3.5 mm". Returns SI.
  double quantity(std::string_view key, const Dimension& dimension, const Range& range,
                  std::string_view default_unit = "") const;
  /// Three of them.
  Vec3 vector(std::string_view key, const Dimension& dimension, const Range& range,
              std::string_view default_unit = "") const;
  Vec3 vector(std::string_view key, const Range& range = Range::any()) const;
  /// Exactly `count` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count, const Range& range = Range::any()) const;
  /// Any number of strings.
  std::vector<std::string> texts(std::string_view key) const;
  /// Any number of rows of exactly `columns` numbers.
  std::vector<std::vector<double>> rows(std::string_view key, std::size_t columns) const;
  /// [w, x, y, z], a unit quaternion within 1e-6; returned normalised.
  Quat quaternion(std::string_view key) const;

  TomlTable table(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  ///< an array of tables
  bool is_table(std::string_view key) const;                  ///< the key is there and holds a table
  bool is_text(std::string_view key) const;                   ///< the key is there and holds a string

  /// Throws for the first key of this table that nobody has asked for. Call it when a table has been read.
  void reject_unknown_keys() const;

  /// "file:line:col: key a.b", of the key's value if it is there, else of the table. An element of an array or of an
  /// inner table is named as "planes[2]" or "material.density".
  std::string where(std::string_view key) const;
  /// "file:line:col: table a", or "file".
  std::string where() const;
  /// An error about the value of a key, for checks that only the caller can make.
  InputError error(std::string_view key, const std::string& found, const std::string& expected) const;

  /// The file this table was read from: paths in it are relative to its folder.
  const std::filesystem::path& file() const;

 private:
  struct Content;
  explicit TomlTable(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
  std::shared_ptr<const Content> content_;

  friend TomlTable read_toml(const std::filesystem::path& path);
  friend TomlTable parse_toml(std::string_view text, const std::filesystem::path& name);
};

/// Reads a file; throws InputError if it is missing, unreadable or no TOML.
TomlTable read_toml(const std::filesystem::path& path);

/// Reads text; `name` stands for the file in errors.
TomlTable parse_toml(std::string_view text, const std::filesystem::path& name);

}  // namespace osculate::io
