#include "io/number_table.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "osculate/core/error.hpp"
#include "temporary.hpp"

using namespace osculate;
using Catch::Matchers::Contains;
using osculate::test::temporary;

namespace {

const std::vector<std::string> known{"time", "overlap"};

std::string file_with(const std::string& text) {
  const auto path = temporary("number_table.csv");
  std::ofstream(path) << text;
  return path.string();
}

void refused(const std::string& text, const std::string& reason) {
  CHECK_THROWS_WITH(io::read_numbers(file_with(text), known), Contains(reason));
}

}  // namespace

TEST_CASE("A table of numbers comes back as it was written, to the last digit") {
  const io::NumberTable table{known, {{0.0, 0.1, 1.0 / 3.0}, {1e-300, -2.5e17, 6.02214076e23}}};
  const auto again = io::read_numbers(file_with(io::to_csv(table)), known);
  CHECK(again.names == table.names);
  CHECK(again.columns == table.columns);
  CHECK(again.find("force") == nullptr);
  CHECK(*again.find("overlap") == table.columns[1]);
}

TEST_CASE("Columns may come in any order, with blanks and empty lines") {
  const auto table = io::read_numbers(file_with(" overlap , time\r\n 1 , 2 \r\n\n3,4"), known);
  CHECK(*table.find("time") == std::vector<double>{2.0, 4.0});
}

TEST_CASE("A bad table of numbers is refused with its place") {
  refused("", "empty");
  refused("time,overlp\n0,1\n", "overlap");
  refused("time,time\n0,1\n", "twice");
  refused("time,overlap\n", "no line");
  refused("time,overlap\n0,1\n2\n", "line 3");
  refused("time,overlap\n0,one\n", "line 2, overlap");
  refused("time,overlap\n0,nan\n", "finite");
  refused("time,overlap\n0,1e999\n", "finite");
  CHECK_THROWS_AS(io::read_numbers("/no/such/file.csv", known), InputError);
}
