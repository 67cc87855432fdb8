#pragma once
// Tables of superquadric pairs as comma-separated text: one pair a line, columns found by the names in the header.
//   a1,b1,c1,n1_1,n2_1  half-axes [m] and exponents of body 1;  a2,b2,c2,n1_2,n2_2  of body 2
//   x1,y1,z1,qw1,qx1,qy1,qz1  centre [m] and unit quaternion (body → world) of body 1;  x2,…,qz2  of body 2
// Any order, other columns are ignored; `class` names groups of lines if it is there.

#include <array>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate::io {

/// The columns that define a pair, in the order of the columns of SuperquadricPairs.
inline constexpr std::array<std::string_view, 2 * SuperquadricPairs::per_body> pair_columns{
    "a1", "b1", "c1", "n1_1", "n2_1", "x1", "y1", "z1", "qw1", "qx1", "qy1", "qz1",
    "a2", "b2", "c2", "n1_2", "n2_2", "x2", "y2", "z2", "qw2", "qx2", "qy2", "qz2"};

/// The columns with a known answer that a computed one can be compared with.
inline constexpr std::array<std::string_view, 15> reference_columns{
    "nx",    "ny",    "nz",    "depth", "p1x",
    "p1y",   "p1z",   "p2x",   "p2y",   "p2z",
    "k1max", "k1min", "k2max", "k2min", "gap_to_next_minimum"};

/// Consecutive pairs of a table, column by column (structure of arrays).
struct PairBlock {
  SuperquadricPairs pairs;
  Columns<reference_columns.size()> reference;  ///< zeros unless asked for
  std::vector<std::string> classes;             ///< empty without a `class` column
  std::vector<std::size_t> lines;               ///< line numbers in the file, from 1

  std::size_t size() const { return lines.size(); }
  Superquadric shape_1(std::size_t i) const { return shape(i, 0); }
  Superquadric shape_2(std::size_t i) const { return shape(i, SuperquadricPairs::per_body); }
  Pose pose_1(std::size_t i) const { return pose(i, 0); }
  Pose pose_2(std::size_t i) const { return pose(i, SuperquadricPairs::per_body); }

 private:
  Superquadric shape(std::size_t i, std::size_t body) const;
  Pose pose(std::size_t i, std::size_t body) const;
};

enum class ReferenceColumns { ignore, require };

/// Reads a table block by block, so that its length is bounded by the disk only.
/// Throws InputError with file, line and column: missing columns, text that is no finite number, half-axes ≤ 0,
/// exponents outside (1, 64], quaternions further than 1e-6 from unit length (nearer ones are made unit).
class PairTableReader {
 public:
  explicit PairTableReader(const std::string& path, ReferenceColumns reference = ReferenceColumns::ignore);

  /// Up to `count` further pairs; false when none is left.
  bool read(PairBlock& block, std::size_t count);

  /// How much of the file has been read, from 0 to 1.
  double progress() const;

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::optional<std::string_view> next_line();
  void read_header();
  void read_pair(std::string_view line, PairBlock& block);
  void check_pair(std::size_t i, SuperquadricPairs& pairs) const;
  std::string where(std::string_view column) const;

  std::string path_;
  bool with_reference_;
  std::unique_ptr<std::FILE, CloseFile> file_;
  double file_bytes_ = 0.0;
  double read_bytes_ = 0.0;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // the unread part of the buffer
  std::size_t line_ = 0;
  std::size_t field_count_ = 0;
  // What each column of the file is: an index into pair_columns, then reference_columns, then `class`; or nothing.
  std::vector<std::size_t> meaning_;
  bool has_class_ = false;
};

}  // namespace osculate::io
