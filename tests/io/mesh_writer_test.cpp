#include "io/mesh_writer.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>

#include "io/polyhedron.hpp"
#include "io/shape_properties.hpp"
#include "osculate/core/error.hpp"
#include "temporary.hpp"

using namespace osculate;
using Catch::Matchers::Contains;
using osculate::test::temporary;

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The numbers of one data array.
std::vector<double> data_array(const std::string& text, const std::string& name) {
  const std::size_t start = text.find('>', text.find("Name=\"" + name + "\"")) + 1;
  std::istringstream stream(text.substr(start, text.find('<', start) - start));
  return {std::istream_iterator<double>(stream), std::istream_iterator<double>()};
}

const Shape ellipsoid = Ellipsoid{Vec3(1e-3, 2e-3, 3e-3)};

}  // namespace

TEST_CASE("An OBJ surface reads back to the last digit") {
  const auto surface = io::curved_surface(ellipsoid, 6);
  const auto path = temporary("mesh_test.obj");
  io::write_obj(surface, io::CurvatureKind::mean, path);
  const auto solid = io::read_polyhedron(path);
  CHECK(solid.vertices == surface.mesh.vertices);
  REQUIRE(solid.polygons.size() == surface.mesh.triangles.size());
  CHECK(solid.polygons.back().front() == surface.mesh.triangles.back().front());
  std::filesystem::remove(path);
}

TEST_CASE("A VTP surface carries points, curvatures and normals of every vertex to the last digit") {
  const auto surface = io::curved_surface(ellipsoid, 6);
  const auto path = temporary("mesh_test.vtp");
  io::write_vtp(surface, io::CurvatureKind::gaussian, path);
  const std::string text = text_of(path);
  const std::size_t points = surface.mesh.vertices.size(), triangles = surface.mesh.triangles.size();
  CHECK_THAT(text, Contains("NumberOfPoints=\"" + std::to_string(points) + "\"") &&
                       Contains("NumberOfPolys=\"" + std::to_string(triangles) + "\"") &&
                       Contains("Scalars=\"gaussian_curvature\""));
  const auto k_max = data_array(text, "k_max"), gaussian = data_array(text, "gaussian_curvature");
  REQUIRE(k_max.size() == points);
  for (std::size_t i = 0; i < points; ++i) {
    CHECK(k_max[i] == surface.curvatures[i].max);
    CHECK(gaussian[i] == surface.curvatures[i].gaussian());
  }
  CHECK(data_array(text, "Normals").size() == 3 * points);
  CHECK(data_array(text, "Points").size() == 3 * points);
  CHECK(data_array(text, "connectivity").size() == 3 * triangles);
  CHECK(data_array(text, "offsets").back() == 3.0 * static_cast<double>(triangles));
  std::filesystem::remove(path);
}

TEST_CASE("A surface that cannot be written says which file") {
  const auto surface = io::curved_surface(ellipsoid, 2);
  CHECK_THROWS_WITH(io::write_vtp(surface, io::CurvatureKind::mean, "no/such/a.vtp"), Contains("no/such/a.vtp"));
  CHECK_THROWS_WITH(io::write_obj(surface, io::CurvatureKind::mean, "no/such/a.obj"), Contains("no/such/a.obj"));
}

TEST_CASE("Area and sphericity of a sphere, a spheroid and a nearly sharp box are the known ones") {
  const auto measured = [](const Shape& shape, int resolution) {
    return io::measure(shape, io::curved_surface(shape, resolution), resolution);
  };
  const auto sphere = measured(Sphere{2.0}, 32);
  CHECK(std::fabs(sphere.area - 16.0 * std::numbers::pi) <= sphere.area_error);
  CHECK(sphere.sphericity == Approx(1.0).epsilon(1e-5));  // the extrapolated mesh: fourth order in 1/32
  CHECK(sphere.smallest_curvature == Approx(0.5));
  CHECK(sphere.largest_curvature == Approx(0.5));

  // Oblate spheroid: A = 2π a² (1 + (1−e²)/e artanh e).
  const double a = 2.0, c = 1.0, e = std::sqrt(1.0 - c * c / (a * a));
  const double exact = 2.0 * std::numbers::pi * a * a * (1.0 + (1.0 - e * e) / e * std::atanh(e));
  const auto spheroid = measured(Ellipsoid{Vec3(a, a, c)}, 32);
  CHECK(std::fabs(spheroid.area - exact) <= spheroid.area_error);

  // A cube has Ψ = (π/6)^(1/3); edges of n = 64 are rounded by about 1/64 of the half-edge.
  const auto box = measured(Superquadric{Vec3::Ones(), {64.0, 64.0}}, 64);
  CHECK(box.sphericity == Approx(std::cbrt(std::numbers::pi / 6.0)).epsilon(0.02));
}

TEST_CASE("An area quantile of a value linear in height is that of the sphere's zones") {
  const auto mesh = surface_mesh(Sphere{1.0}, 48);
  std::vector<double> height;
  for (const Vec3& vertex : mesh.vertices) height.push_back(vertex.z());
  // Archimedes: area grows linearly with height. A row of vertices is 1/24 high at most.
  for (const double fraction : {0.1, 0.5, 0.9}) {
    CHECK(io::area_quantile(mesh, height, fraction) == Approx(2.0 * fraction - 1.0).margin(0.05));
  }
}
