#include "io/polyhedron.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "osculate/core/error.hpp"
#include "temporary.hpp"
#include "tools/convex_hull.hpp"

using namespace osculate;
using Catch::Matchers::Contains;
using osculate::test::temporary;

namespace {

/// A file that lives as long as the test.
struct TemporaryFile {
  TemporaryFile(const std::string& name, const std::string& content) : path(temporary(name)) {
    std::ofstream(path, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::filesystem::path path;
};

const std::string tetrahedron_off =
    "OFF # a corner of the unit cube\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string tetrahedron_obj =
    "# a corner\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nf 1//1 3//1 2//1\nf 1 2 4\nf -4 -1 -2\nf 2 3 4\n";

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal 0 0 0\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c +
         "\n  endloop\n endfacet\n";
}
const std::string tetrahedron_stl = "solid corner\n" + facet("0 0 0", "0 1 0", "1 0 0") +
                                    facet("0 0 0", "1 0 0", "0 0 1") + facet("0 0 0", "0 0 1", "0 1 0") +
                                    facet("1 0 0", "0 1 0", "0 0 1") + "endsolid corner\n";

std::string binary_stl(const io::Polyhedron& solid) {
  std::string bytes = "solid is how even some binary files begin";
  bytes.resize(80, ' ');
  const auto append = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  append(static_cast<std::uint32_t>(solid.polygons.size()));
  for (const auto& polygon : solid.polygons) {
    for (int i = 0; i < 3; ++i) append(0.0F);
    for (const int vertex : polygon) {
      for (const double x : solid.vertices[static_cast<std::size_t>(vertex)]) append(static_cast<float>(x));
    }
    append(std::uint16_t{0});
  }
  return bytes;
}

double volume(const io::Polyhedron& solid) {
  double sixfold = 0.0;
  for (const auto& p : solid.polygons) {
    const auto at = [&](std::size_t i) { return solid.vertices[static_cast<std::size_t>(p[i])]; };
    sixfold += at(0).dot(at(1).cross(at(2)));
  }
  return sixfold / 6.0;
}

}  // namespace

TEST_CASE("One tetrahedron reads alike from OFF, OBJ and both kinds of STL") {
  const TemporaryFile off("a.off", tetrahedron_off), obj("a.obj", tetrahedron_obj), stl("a.stl", tetrahedron_stl);
  const TemporaryFile binary("b.stl", binary_stl(io::read_polyhedron(off.path)));
  for (const auto& path : {off.path, obj.path, stl.path, binary.path}) {
    INFO(path);
    const auto solid = io::read_polyhedron(path);
    CHECK(solid.polygons.size() == 4);
    CHECK(volume(solid) == Approx(1.0 / 6.0).epsilon(1e-14));  // corners are exact in any format
  }
}

TEST_CASE("A broken polyhedron file is reported with file and line") {
  const auto refused = [](const std::string& name, const std::string& content, const std::string& message) {
    const TemporaryFile file(name, content);
    CHECK_THROWS_WITH(io::read_polyhedron(file.path), Contains(message));
  };
  refused("c.off", "OFF\n4 0 0\n0 0 0\n1 0 zero\n", "c.off:4: found \"zero\"; expected a coordinate");
  refused("c.off", "OFF\n4 0 0\n0 0 0\n1 0 nan\n", "c.off:4: found the coordinate nan");
  refused("c.off", "OFF\n4 0 0\n0 0 0\n", "found the end of the file; expected vertex 2 of 4");
  refused("c.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 7\n", "c.off:7: found a polygon with vertex 7");
  refused("c.off", "PLY\n", "c.off:1: found \"PLY\"; expected the word OFF");
  refused("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "c.obj:4: found a polygon");
  refused("c.stl", "solid x\n facets\n", "c.stl:2: found \"facets\"");
  refused("c.obj", "v 0 0 0\n", "at least four");
  refused("c.ply", "", "found the ending \".ply\"");
  CHECK_THROWS_WITH(io::read_polyhedron("none.off"), Contains("none.off: found no such file"));
}

TEST_CASE("A box given by cloud and facet centres has six planes about its centroid") {
  if (!tools::can_find_convex_hulls()) return;
  std::vector<Vec3> points;
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      for (int k = -2; k <= 2; ++k) points.emplace_back(3.0 * i + 10.0, 2.0 * j, 1.0 * k - 5.0);
    }
  }
  const auto hull = tools::convex_hull(points);
  CHECK(hull.planes.size() == 6);
  CHECK((hull.centroid - Vec3(10, 0, -5)).norm() < 1e-13);
  CHECK(hull.volume == Approx(12.0 * 8.0 * 4.0).epsilon(1e-13));
  for (const auto& plane : hull.planes) {
    CHECK(plane.distance == Approx(plane.normal.cwiseAbs().dot(Vec3(6, 4, 2))).epsilon(1e-13));
  }
}

TEST_CASE("A tetrahedron's planes are seen from its centroid") {
  if (!tools::can_find_convex_hulls()) return;
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto hull = tools::convex_hull(corners);
  CHECK(hull.planes.size() == 4);
  CHECK((hull.centroid - Vec3::Constant(0.25)).norm() < 1e-15);
}

TEST_CASE("Points that span no volume have no hull") {
  const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}};
  CHECK_THROWS_AS(tools::convex_hull(flat), InputError);
}
