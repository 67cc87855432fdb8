#include "validation/contact_mechanics/reference_errors.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "osculate/core/error.hpp"
#include "temporary.hpp"
#include "validation/test_names.hpp"

namespace reference = osculate::validation::contact_mechanics;
using Catch::Matchers::Contains;
using osculate::test::temporary;

namespace {

const std::filesystem::path file = OSCULATE_TEST_DATA "/contact_mechanics.json";

/// The file with one text replaced by another, in a place of its own.
std::filesystem::path changed(const std::string& from, const std::string& to) {
  std::string content = file_content(file);
  const std::size_t at = content.find(from);
  REQUIRE(at != std::string::npos);
  content.replace(at, from.size(), to);
  const auto path = temporary("reference.json");
  std::ofstream(path) << content;
  return path;
}

}  // namespace

TEST_CASE("Every family of the reference values is met to eleven digits, and far better where nothing cancels") {
  std::set<std::string> families;
  for (const auto& error : reference::reference_errors(file)) {
    INFO(error.family << ", " << error.quantity);
    families.insert(error.family);
    CHECK(error.values >= 3);
    CHECK(error.worst < reference::bar);
    if (error.lost_digits.empty()) CHECK(error.worst < 1e-14);
  }
  CHECK(families.size() == 5);
}

TEST_CASE("A reference value that is off is seen") {
  const auto path = changed("\"K\": 1.5707963267948966", "\"K\": 1.5707963268948966");
  for (const auto& error : reference::reference_errors(path)) {
    const bool touched = error.family == "hertz" && error.quantity == "K";
    CHECK((error.worst > reference::bar) == touched);
  }
  std::filesystem::remove(path);
}

TEST_CASE("A reference file that lacks something is refused by its name") {
  CHECK_THROWS_WITH(reference::reference_errors("nowhere.json"), Contains("nowhere.json"));
  const auto path = changed("\"johnson_greenwood\"", "\"jkr\"");
  CHECK_THROWS_WITH(reference::reference_errors(path), Contains("johnson_greenwood"));
  std::filesystem::remove(path);
}
