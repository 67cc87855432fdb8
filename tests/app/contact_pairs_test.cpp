#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>
#include <vector>

#include "app/program.hpp"

namespace {

using Catch::Contains;
using osculate::test::content_of;
using osculate::test::fresh_folder;
using osculate::test::run;

const std::string reference = OSCULATE_TEST_DATA "/superquadric_common_normal.csv";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// The header and the lines of one class of the reference table.
std::string lines_of_class(const std::string& name) {
  std::string text;
  for (const std::string& line : split(content_of(reference), '\n'))
    if (text.empty() || line.starts_with(name + ",")) text += line + "\n";
  return text;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// The table with one field of one line (from 1) replaced.
std::string with_field(const std::string& table, std::size_t line, const std::string& column,
                       const std::string& value) {
  std::vector<std::string> lines = split(table, '\n');
  const std::vector<std::string> header = split(lines[0], ',');
  std::vector<std::string> fields = split(lines[line - 1], ',');
  for (std::size_t i = 0; i < header.size(); ++i)
    if (header[i] == column) fields[i] = value;
  lines[line - 1].clear();
  for (const std::string& field : fields) lines[line - 1] += (lines[line - 1].empty() ? "" : ",") + field;
  std::string changed;
  for (const std::string& text : lines) changed += text + "\n";
  return changed;
}

std::vector<std::vector<double>> numbers_of(const std::filesystem::path& path) {
  std::vector<std::vector<double>> rows;
  for (const std::string& line : split(content_of(path), '\n')) {
    if (line.starts_with("status")) continue;
    std::vector<double> row;
    const std::vector<std::string> fields = split(line, ',');
    for (std::size_t i = 1; i < fields.size(); ++i) row.push_back(std::stod(fields[i]));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_CASE("A table of pairs gives a line of 17 columns for every pair, and passes against its reference") {
  const auto folder = fresh_folder("pairs");
  write(folder / "in.csv", lines_of_class("ellipsoid"));
  for (const std::string mode : {"", " --scalar", " --warm", " --warm --scalar"}) {
    INFO(mode);
    const auto result = run(folder, "contact --pairs in.csv --out out.csv --compare" + mode);
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, Contains("70 pairs") && Contains("70 touching") && Contains("All 70 lines pass."));
    const std::vector<std::string> lines = split(content_of(folder / "out.csv"), '\n');
    REQUIRE(lines.size() == 71);
    CHECK(lines[0] == "status,nx,ny,nz,depth,p1x,p1y,p1z,p2x,p2y,p2z,k1max,k1min,k2max,k2min,Ri,Rj");
    for (std::size_t i = 1; i < lines.size(); ++i) REQUIRE(split(lines[i], ',').size() == 17);
  }
}

TEST_CASE("A warm start changes the answer by round-off only, and by something") {
  const auto folder = fresh_folder("pairs_warm");
  write(folder / "in.csv", lines_of_class("blocky"));
  REQUIRE(run(folder, "contact --pairs in.csv --out cold.csv").exit_code == 0);
  REQUIRE(run(folder, "contact --pairs in.csv --out warm.csv --warm").exit_code == 0);
  const auto cold = numbers_of(folder / "cold.csv");
  const auto warm = numbers_of(folder / "warm.csv");
  REQUIRE(cold.size() == warm.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < cold.size(); ++i) {
    constexpr std::size_t depth = 3;
    // Bar of the reference: 1e-12 of R_vol; these bodies are at least 1 mm large.
    CHECK(std::fabs(cold[i][depth] - warm[i][depth]) < 1e-12 * 1e-1);
    if (cold[i] != warm[i]) ++different;
  }
  // Two paths to the same minimum seldom round the same way: equal answers everywhere would mean no warm start at all.
  CHECK(different > cold.size() / 2);
}

TEST_CASE("A falsified reference fails the comparison and its line is named") {
  const auto folder = fresh_folder("pairs_false");
  write(folder / "in.csv", with_field(lines_of_class("ellipsoid"), 5, "depth", "0.0005"));
  const auto depth = run(folder, "contact --pairs in.csv --compare");
  CHECK(depth.exit_code == 1);
  CHECK_THAT(depth.out, Contains("1 of 70 lines fail: line 5"));
  write(folder / "in.csv", with_field(lines_of_class("ellipsoid"), 7, "k2min", "1e9"));
  CHECK_THAT(run(folder, "contact --pairs in.csv --compare").out, Contains("1 of 70 lines fail: line 7"));
  // A claim that a second minimum is as deep demands the status "ambiguous", which an ellipsoid's contact is not.
  write(folder / "in.csv", with_field(lines_of_class("ellipsoid"), 9, "gap_to_next_minimum", "0"));
  CHECK_THAT(run(folder, "contact --pairs in.csv --compare").out, Contains("1 of 70 lines fail: line 9"));
}

TEST_CASE("A bad table is exit code 2, an error with line and column, and no output file") {
  const auto folder = fresh_folder("pairs_bad");
  write(folder / "out.csv", "what was here before\n");
  write(folder / "in.csv", with_field(lines_of_class("box"), 60, "qx2", "0.5o"));
  const auto result = run(folder, "contact --pairs in.csv --out out.csv");
  CHECK(result.exit_code == 2);
  CHECK(result.err == "osculate: in.csv:60: column qx2: \"0.5o\"; expected a finite number\n");
  CHECK(content_of(folder / "out.csv") == "what was here before\n");
  CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 2);

  CHECK_THAT(run(folder, "contact --pairs none.csv").err, Contains("none.csv: cannot be opened"));
  CHECK(run(folder, "contact --pairs none.csv").exit_code == 2);
  CHECK_THAT(run(folder, "contact --pairs in.csv --out no/such/folder.csv").err, Contains("no/such/folder.csv"));
  CHECK(run(folder, "contact --out out.csv").exit_code != 0);
}

TEST_CASE("The command line without a contact or a table says what it wants") {
  const auto folder = fresh_folder("pairs_none");
  const auto result = run(folder, "contact");
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Contains("a contact file, or --pairs"));
}
