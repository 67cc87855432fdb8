#include "io/pair_table.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "osculate/core/error.hpp"
#include "temporary.hpp"

namespace {

using osculate::io::PairBlock;
using osculate::io::PairTableReader;
using osculate::io::ReferenceColumns;
using osculate::test::temporary;

const std::string header = "a1,b1,c1,n1_1,n2_1,x1,y1,z1,qw1,qx1,qy1,qz1,a2,b2,c2,n1_2,n2_2,x2,y2,z2,qw2,qx2,qy2,qz2";
const std::string line = "1,2,3,4,5,6,7,8,1,0,0,0,9,10,11,12,13,14,15,16,0,0,0.6,0.8";

std::string table(const std::string& text) {
  const auto path = temporary("pair_table_test.csv");
  std::ofstream(path) << text;
  return path.string();
}

std::string error_of(const std::string& text) {
  try {
    PairTableReader reader(table(text));
    PairBlock block;
    while (reader.read(block, 2)) {
    }
  } catch (const osculate::InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The line with one of its numbers replaced.
std::string with(std::size_t column, const std::string& value) {
  std::string changed;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < osculate::io::pair_columns.size(); ++i) {
    const std::size_t comma = line.find(',', begin);
    changed += (i > 0 ? "," : "") + (i == column ? value : line.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return changed;
}

}  // namespace

TEST_CASE("A pair is read into both bodies' shapes and poses") {
  PairTableReader reader(table(header + "\n" + line + "\n"));
  PairBlock block;
  REQUIRE(reader.read(block, 10));
  REQUIRE(block.size() == 1);
  CHECK(block.lines[0] == 2);
  CHECK(block.shape_1(0).half_axes == osculate::Vec3(1, 2, 3));
  CHECK(block.shape_1(0).exponents.n1 == 4);
  CHECK(block.shape_1(0).exponents.n2 == 5);
  CHECK(block.shape_2(0).half_axes == osculate::Vec3(9, 10, 11));
  CHECK(block.shape_2(0).exponents.n2 == 13);
  CHECK(block.pose_1(0).position == osculate::Vec3(6, 7, 8));
  CHECK(block.pose_1(0).orientation.w() == 1);
  CHECK(block.pose_2(0).position == osculate::Vec3(14, 15, 16));
  CHECK(block.pose_2(0).orientation.y() == 0.6);
  CHECK(block.pose_2(0).orientation.z() == 0.8);
  CHECK_FALSE(reader.read(block, 10));
}

TEST_CASE("Columns come in any order, others are ignored, and lines may end as Windows ends them") {
  PairTableReader reader(table("colour, class ," + header + ",weight\r\nblue, rice ," + line +
                               ",heavy\r\n\r\nred,egg," + line + ",light"));
  PairBlock block;
  REQUIRE(reader.read(block, 10));
  REQUIRE(block.size() == 2);
  CHECK(block.classes == std::vector<std::string>{"rice", "egg"});
  CHECK(block.lines == std::vector<std::size_t>{2, 4});
  CHECK(block.pose_2(1).orientation.z() == 0.8);
}

TEST_CASE("A table longer than the reader's memory comes in blocks, every line once") {
  const std::size_t lines = 40000;  // about 2.3 MB, more than two buffers
  std::string text = header + "\n";
  for (std::size_t i = 0; i < lines; ++i) text += with(5, std::to_string(i)) + "\n";
  PairTableReader reader(table(text));
  PairBlock block;
  std::size_t next = 0;
  while (reader.read(block, 4096))
    for (std::size_t i = 0; i < block.size(); ++i, ++next) {
      REQUIRE(block.lines[i] == next + 2);
      REQUIRE(block.pose_1(i).position.x() == static_cast<double>(next));
    }
  CHECK(next == lines);
  CHECK(reader.progress() == 1.0);
}

TEST_CASE("A quaternion with six digits is made unit; one that is no rotation is refused") {
  PairTableReader reader(table(header + "\n" + with(8, "1.0000001") + "\n"));
  PairBlock block;
  REQUIRE(reader.read(block, 1));
  CHECK(block.pose_1(0).orientation.norm() == Approx(1.0).epsilon(1e-15));
  CHECK_THAT(error_of(header + "\n" + with(8, "1.01") + "\n"),
             Catch::Contains("test.csv:2: column qw1..qz1: a quaternion of length 1.01; expected a unit quaternion"));
}

TEST_CASE("Every kind of bad table is refused with its file, line, column and what was expected") {
  using Catch::Contains;
  CHECK_THAT(error_of(""), Contains("test.csv:1: no header; expected"));
  CHECK_THAT(error_of("a1,b1\n"), Contains("missing column c1, n1_1") && Contains("in any order"));
  CHECK_THAT(error_of(header + ",a1\n"), Contains("column a1 appears twice"));
  CHECK_THAT(error_of(header + "\n" + line + "\n1,2,3\n"),
             Contains("test.csv:3: 3 fields; expected 24 as in the header"));
  CHECK_THAT(error_of(header + "\n" + with(6, "abc")),
             Contains("test.csv:2: column y1: \"abc\"; expected a finite number"));
  CHECK_THAT(error_of(header + "\n" + with(6, "1.5e")), Contains("column y1: \"1.5e\"; expected a finite number"));
  CHECK_THAT(error_of(header + "\n" + with(6, "")), Contains("column y1: \"\"; expected a finite number"));
  CHECK_THAT(error_of(header + "\n" + with(6, "nan")), Contains("column y1: \"nan\"; expected a finite number"));
  CHECK_THAT(error_of(header + "\n" + with(6, "inf")), Contains("column y1: \"inf\"; expected a finite number"));
  CHECK_THAT(error_of(header + "\n" + with(13, "-2")), Contains("column b2: -2; expected a half-axis above 0"));
  CHECK_THAT(error_of(header + "\n" + with(3, "1")),
             Contains("column n1_1: 1; expected an exponent n = 2/eta in (1, 64]"));
  CHECK_THAT(error_of(header + "\n" + with(16, "65")), Contains("column n2_2: 65; expected an exponent"));
  CHECK_THROWS_WITH(PairTableReader("no_such_table.csv"), Contains("no_such_table.csv: cannot be opened"));
  CHECK_THROWS_WITH(PairTableReader(table(header + "\n"), ReferenceColumns::require),
                    Contains("missing column nx, ny, nz, depth"));
}
