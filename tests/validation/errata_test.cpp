// docs/errata.md names for each erratum the test that shows it.

#include <catch2/catch.hpp>
#include <sstream>

#include "validation/test_names.hpp"

namespace {

struct Erratum {
  std::string line;
  std::vector<std::string> tests;
};

/// Rows of the page's tables; a name stands in quotes in the last column.
std::vector<Erratum> errata() {
  std::istringstream page(file_content(std::filesystem::path(OSCULATE_SOURCE_DIR) / "docs" / "errata.md"));
  static const std::regex quoted(R"re("([^"]+)")re");
  std::vector<Erratum> found;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| equation", 0) == 0 || line.rfind("| place", 0) == 0) continue;
    const std::size_t end = line.rfind('|'), column = line.rfind('|', end - 1);
    const std::string last = line.substr(column, end - column);
    Erratum erratum{line, {}};
    for (std::sregex_iterator name(last.begin(), last.end(), quoted), none; name != none; ++name)
      erratum.tests.push_back((*name)[1]);
    found.push_back(erratum);
  }
  return found;
}

}  // namespace

TEST_CASE("Every erratum names a test, and every test it names exists") {
  const auto names = test_names();
  const auto found = errata();
  CHECK(found.size() > 40);
  for (const auto& erratum : found) {
    INFO(erratum.line);
    CHECK_FALSE(erratum.tests.empty());
    for (const auto& test : erratum.tests) {
      INFO(test);
      CHECK(names.count(test) == 1);
    }
  }
}
