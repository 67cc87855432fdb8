#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "osculate/osculate.h"

namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(std::string(OSCULATE_SOURCE_DIR) + "/" + file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// All that an expression's groups find, in order.
std::vector<std::smatch> matches(const std::string& text, const char* expression) {
  const std::regex regex(expression);
  return {std::sregex_iterator(text.begin(), text.end(), regex), {}};
}

std::map<std::string, std::string> values(const std::string& text, const char* expression) {
  std::map<std::string, std::string> found;
  for (const auto& match : matches(text, expression)) found[match[1]] = match[2];
  return found;
}

/// Members of each struct, in order.
std::map<std::string, std::vector<std::string>> members(const std::string& text, const char* block,
                                                        const char* member) {
  std::map<std::string, std::vector<std::string>> found;
  for (const auto& type : matches(text, block)) {
    const std::string body = type[2];  // matches point into their text
    for (const auto& match : matches(body, member)) found[type[1]].push_back(match[1]);
  }
  return found;
}

}  // namespace

TEST_CASE("The Fortran module has every function, constant and member of the header") {
  const std::string header = text_of("include/osculate/osculate.h"), module = text_of("src/fortran/osculate.f90");

  std::set<std::string> functions, in_module;
  for (const auto& match : matches(header, R"(OSCULATE_API [^;]*?\b(osculate_\w+)\()")) functions.insert(match[1]);
  for (const auto& match : matches(module, R"(\n *(?:function|subroutine) (osculate_\w+)\()"))
    in_module.insert(match[1]);
  CHECK(functions.size() > 20);
  for (const std::string& name : functions) {
    INFO(name);
    CHECK(in_module.count(name) == 1);
  }

  const auto constants = values(header, R"(\n  (OSCULATE_\w+) = (\d+))");
  CHECK(constants.size() > 20);
  CHECK(values(module, R"(parameter :: (OSCULATE_(?!MODULE_)\w+) = (\d+))") == constants);
  CHECK(values(module, R"(parameter :: (OSCULATE_MODULE_ABI_VERSION) = (\d+))").begin()->second ==
        std::to_string(OSCULATE_ABI_VERSION));

  const auto types = members(header, R"(typedef struct (osculate_\w+) \{([^}]*)\})",
                             R"(\n  (?:const )?[\w]+\*?(?: const\*)? (\w+)(?:\[\d\])?;)");
  auto types_of_module =
      members(module, R"(type, bind\(C\) :: (osculate_\w+)((?:\n    .*)*)\n  end type)", R"(:: (\w+))");
  CHECK(types.size() == 10);
  for (const auto& [name, names] : types) {
    INFO(name);
    CHECK(types_of_module[name] == names);
  }
}

#ifdef OSCULATE_FORTRAN
extern "C" void osculate_test_sizes(std::size_t* sizes);

TEST_CASE("The Fortran module's types are as long as those of C") {
  std::array<std::size_t, 10> sizes{};
  osculate_test_sizes(sizes.data());
  CHECK(sizes == std::array{sizeof(osculate_pose), sizeof(osculate_contact), sizeof(osculate_bodies),
                            sizeof(osculate_contact_columns), sizeof(osculate_material), sizeof(osculate_law_setting),
                            sizeof(osculate_approach), sizeof(osculate_force), sizeof(osculate_approach_columns),
                            sizeof(osculate_force_columns)});
}
#endif
