#pragma once
// The sources as text: what the tests are called, for pages and tables that name them.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

inline std::string file_content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// All files below a folder of the sources with the given ending, sorted.
inline std::vector<std::filesystem::path> source_files(const char* folder, const char* ending) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(OSCULATE_SOURCE_DIR) / folder)) {
    if (entry.path().extension() == ending) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Names of every TEST_CASE, adjacent string literals joined.
inline std::set<std::string> test_names() {
  static const std::regex test(R"re(TEST_CASE\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+))re"),
      literal(R"re("((?:[^"\\]|\\.)*)")re");
  std::set<std::string> names;
  for (const auto& path : source_files("tests", ".cpp")) {
    const std::string text = file_content(path);
    for (std::sregex_iterator found(text.begin(), text.end(), test), end; found != end; ++found) {
      const std::string literals = (*found)[1];
      std::string name;
      for (std::sregex_iterator part(literals.begin(), literals.end(), literal); part != end; ++part)
        name += (*part)[1];
      names.insert(name);
    }
  }
  return names;
}
