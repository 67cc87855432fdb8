#include "io/polyhedron.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

struct Line {
  std::string where;  ///< "file:line"
  std::vector<std::string_view> words;
};

/// A file's lines in words, without comments and empty lines.
class Lines {
 public:
  Lines(const std::filesystem::path& path, std::string_view text) : path_(path), rest_(text) {}

  std::optional<Line> next() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view text = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
      text = text.substr(0, text.find('#'));
      if (Line line{where(), split(text)}; !line.words.empty()) return line;
    }
    return std::nullopt;
  }

  Line require(const std::string& expected) {
    if (auto line = next()) return *line;
    throw InputError(where(), "found the end of the file", expected);
  }

  std::string where() const { return fmt::format("{}:{}", path_.string(), number_); }

 private:
  static std::vector<std::string_view> split(std::string_view text) {
    constexpr std::string_view space = " \t\r";
    std::vector<std::string_view> words;
    for (std::size_t start = text.find_first_not_of(space); start != std::string_view::npos;) {
      const std::size_t end = std::min(text.find_first_of(space, start), text.size());
      words.push_back(text.substr(start, end - start));
      start = text.find_first_not_of(space, end);
    }
    return words;
  }

  std::filesystem::path path_;
  std::string_view rest_;
  int number_ = 0;
};

template <class Number>
Number number(const Line& line, std::string_view word, const char* expected) {
  Number value{};
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (status != std::errc{} || end != word.data() + word.size()) {
    throw InputError(line.where, fmt::format("found \"{}\"", word), expected);
  }
  return value;
}

Vec3 point(const Line& line, std::size_t first) {
  if (line.words.size() < first + 3) {
    throw InputError(line.where, fmt::format("found {} words", line.words.size()), "three coordinates");
  }
  Vec3 value;
  for (std::size_t i = 0; i < 3; ++i) {
    const double coordinate = number<double>(line, line.words[first + i], "a coordinate");
    if (!std::isfinite(coordinate)) {
      throw InputError(line.where, fmt::format("found the coordinate {}", coordinate), "a finite coordinate");
    }
    value[static_cast<Eigen::Index>(i)] = coordinate;
  }
  return value;
}

void require_vertex(const Line& line, long index, std::size_t count) {
  if (index < 0 || index >= static_cast<long>(count)) {
    throw InputError(line.where, fmt::format("found a polygon with vertex {} (counted from 0)", index),
                     fmt::format("one of the {} vertices", count));
  }
}

Polyhedron read_off(Lines lines) {
  Line line = lines.require("the word OFF");
  if (line.words.front() != "OFF") {
    throw InputError(line.where, fmt::format("found \"{}\"", line.words.front()), "the word OFF");
  }
  line.words.erase(line.words.begin());
  if (line.words.empty()) line = lines.require("the numbers of vertices and faces");
  if (line.words.size() < 2) throw InputError(line.where, "found one number", "the numbers of vertices and faces");
  const auto vertices = number<unsigned>(line, line.words[0], "the number of vertices");
  const auto faces = number<unsigned>(line, line.words[1], "the number of faces");

  Polyhedron solid;
  for (unsigned i = 0; i < vertices; ++i) {
    solid.vertices.push_back(point(lines.require(fmt::format("vertex {} of {}", i + 1, vertices)), 0));
  }
  for (unsigned i = 0; i < faces; ++i) {
    const Line face = lines.require(fmt::format("face {} of {}", i + 1, faces));
    const auto corners = number<unsigned>(face, face.words[0], "the number of corners");
    if (corners < 3 || face.words.size() < corners + 1) {
      throw InputError(face.where, fmt::format("found {} corners and {} indices", corners, face.words.size() - 1),
                       "at least three corners and an index for each");
    }
    std::vector<int>& polygon = solid.polygons.emplace_back();
    for (unsigned k = 1; k <= corners; ++k) {
      polygon.push_back(number<int>(face, face.words[k], "a vertex index"));
      require_vertex(face, polygon.back(), solid.vertices.size());
    }
  }
  return solid;
}

Polyhedron read_obj(Lines lines) {
  Polyhedron solid;
  while (const auto line = lines.next()) {
    if (line->words.front() == "v") solid.vertices.push_back(point(*line, 1));
    if (line->words.front() != "f") continue;
    if (line->words.size() < 4) throw InputError(line->where, "found a face of fewer corners", "at least three");
    std::vector<int>& polygon = solid.polygons.emplace_back();
    for (std::size_t k = 1; k < line->words.size(); ++k) {
      const std::string_view word = line->words[k].substr(0, line->words[k].find('/'));
      const long index = number<long>(*line, word, "a vertex index");
      // From 1; negative ones count from the latest vertex.
      const long from_zero = index > 0 ? index - 1 : static_cast<long>(solid.vertices.size()) + index;
      require_vertex(*line, index == 0 ? -1 : from_zero, solid.vertices.size());
      polygon.push_back(static_cast<int>(from_zero));
    }
  }
  return solid;
}

void close_triangle(Polyhedron& solid) {
  const int last = static_cast<int>(solid.vertices.size()) - 1;
  solid.polygons.push_back({last - 2, last - 1, last});
}

Polyhedron read_stl_ascii(Lines lines) {
  Polyhedron solid;
  int corners = 0;
  while (const auto line = lines.next()) {
    const std::string_view word = line->words.front();
    if (word == "vertex") {
      solid.vertices.push_back(point(*line, 1));
      if (++corners == 3) close_triangle(solid);
    } else if (word == "endloop") {
      if (corners != 3) throw InputError(line->where, fmt::format("found a facet of {} corners", corners), "three");
      corners = 0;
    } else if (word != "solid" && word != "facet" && word != "outer" && word != "endfacet" && word != "endsolid") {
      throw InputError(line->where, fmt::format("found \"{}\"", word), "a line of an STL file");
    }
  }
  return solid;
}

constexpr std::size_t stl_header = 80, stl_count = 4, stl_triangle = 50, stl_normal = 12;

std::uint32_t stl_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + stl_header, stl_count);
  return count;
}

bool is_stl_binary(std::string_view bytes) {
  return bytes.size() >= stl_header + stl_count &&
         bytes.size() == stl_header + stl_count + stl_triangle * stl_triangles(bytes);
}

Polyhedron read_stl_binary(const std::filesystem::path& path, std::string_view bytes) {
  Polyhedron solid;
  const std::uint32_t count = stl_triangles(bytes);
  for (std::uint32_t i = 0; i < count; ++i) {
    const char* corner = bytes.data() + stl_header + stl_count + stl_triangle * i + stl_normal;
    for (int k = 0; k < 3; ++k) {
      float x[3];
      std::memcpy(x, corner + sizeof x * static_cast<std::size_t>(k), sizeof x);
      const Vec3 vertex(x[0], x[1], x[2]);
      if (!vertex.allFinite()) {
        throw InputError(fmt::format("{}: triangle {}", path.string(), i + 1), "found a coordinate that is not finite",
                         "finite coordinates");
      }
      solid.vertices.push_back(vertex);
    }
    close_triangle(solid);
  }
  return solid;
}

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

Polyhedron read_polyhedron(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending != ".off" && ending != ".stl" && ending != ".obj") {
    throw InputError(path.string(), fmt::format("found the ending \"{}\"", ending),
                     "a polyhedron file: .off, .stl or .obj");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream || !std::filesystem::is_regular_file(path)) {
    throw InputError(path.string(), "found no such file", "a polyhedron file (.off, .stl or .obj)");
  }
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  Polyhedron solid = ending == ".off"      ? read_off({path, text})
                     : ending == ".obj"    ? read_obj({path, text})
                     : is_stl_binary(text) ? read_stl_binary(path, text)
                                           : read_stl_ascii({path, text});
  if (solid.vertices.size() < 4) {
    throw InputError(path.string(), fmt::format("found {} vertices", solid.vertices.size()), "a solid: at least four");
  }
  return solid;
}

}  // namespace osculate::io
