#include "validation/kildashti2023/coverage.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <sstream>

#include "validation/test_names.hpp"

namespace kildashti2023 = osculate::validation::kildashti2023;

namespace {

/// A place in a public header whose comment carries an equation's key.
struct Place {
  std::string header;
  std::string comment;      ///< its text up to the end
  std::string declaration;  ///< what the comment stands at: the code after it up to the next empty line or comment
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool is_comment(const std::string& line) {
  static const std::regex opens(R"( *(//|/\*|\*).*)");
  return std::regex_match(line, opens);
}

/// The public headers, those for C++ and the one for C.
std::vector<std::filesystem::path> public_headers() {
  auto headers = source_files("include", ".hpp");
  const auto for_c = source_files("include", ".h");
  headers.insert(headers.end(), for_c.begin(), for_c.end());
  return headers;
}

/// Numbers in the keys of a comment: "[KDY23 (5)–(7),(9); Moes00]" has 5, 6, 7, 9.
std::vector<int> equations_in(const std::string& comment) {
  static const std::regex key(R"(KDY23 ((?:\(\d+\)(?:,|–)? ?)+))"), range(R"(\((\d+)\)(?:–\((\d+)\))?)");
  std::vector<int> equations;
  for (std::sregex_iterator found(comment.begin(), comment.end(), key), end; found != end; ++found) {
    const std::string numbers = (*found)[1];
    for (std::sregex_iterator part(numbers.begin(), numbers.end(), range); part != end; ++part) {
      const int first = std::stoi((*part)[1]), last = (*part)[2].matched ? std::stoi((*part)[2]) : first;
      for (int equation = first; equation <= last; ++equation) equations.push_back(equation);
    }
  }
  return equations;
}

std::multimap<int, Place> keys_in_headers() {
  std::multimap<int, Place> keys;
  for (const auto& path : public_headers()) {
    const auto lines = lines_of(file_content(path));
    for (std::size_t i = 0; i < lines.size();) {
      Place place{path.filename().string(), {}, {}};
      if (!is_comment(lines[i])) {
        // A comment behind a member is about that member, and may go on in the lines below.
        const std::size_t behind = std::min(lines[i].find("///<"), lines[i].find("/**<"));
        if (behind == std::string::npos) {
          ++i;
          continue;
        }
        place.declaration = lines[i].substr(0, behind);
        place.comment = lines[i].substr(behind);
        ++i;
        while (i < lines.size() && lines[i].find("  ///< ") != std::string::npos && is_comment(lines[i]))
          place.comment += lines[i++];
      } else {
        while (i < lines.size() && is_comment(lines[i])) place.comment += lines[i++] + ' ';
        for (std::size_t k = i; k < lines.size() && !lines[k].empty() && !is_comment(lines[k]); ++k)
          place.declaration += lines[k] + ' ';
      }
      for (const int equation : equations_in(place.comment)) keys.emplace(equation, place);
    }
  }
  return keys;
}

}  // namespace

TEST_CASE(
    "Every equation of the review has its key in exactly one public comment, at the function that coverage names") {
  const auto keys = keys_in_headers();
  for (const auto& row : kildashti2023::coverage()) {
    INFO("equation (" << row.equation << "), " << row.function);
    std::string headers;
    for (auto [at, end] = keys.equal_range(row.equation); at != end; ++at) headers += at->second.header + ' ';
    INFO("keys in " << headers);
    REQUIRE(keys.count(row.equation) == 1);
    const std::string name(row.function.substr(row.function.rfind(':') + 1));  // npos + 1 is 0
    const Place& place = keys.find(row.equation)->second;
    INFO("stands at " << place.declaration);
    CHECK(std::regex_search(place.declaration, std::regex("\\b" + name + "\\b")));
  }
}

TEST_CASE("Coverage lists the equations in order, each with a test that exists") {
  const auto names = test_names();
  int expected = 0;
  for (const auto& row : kildashti2023::coverage()) {
    CHECK(row.equation == ++expected);
    INFO("equation (" << row.equation << "): " << row.test);
    CHECK(names.count(std::string(row.test)) == 1);
  }
  CHECK(expected == kildashti2023::equations);
}

TEST_CASE("Keys outside the review's equations would be a slip of the pen") {
  for (const auto& [equation, place] : keys_in_headers()) {
    INFO(place.header);
    CHECK((equation >= 1 && equation <= kildashti2023::equations));
  }
}
