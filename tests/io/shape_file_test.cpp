#include "io/shape_file.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <string>

#include "tools/convex_hull.hpp"

using namespace osculate;
using Catch::Matchers::Contains;

namespace {

io::ShapeFile shape_of(const std::string& text) {
  return io::parse_shape(io::parse_toml(text, "grain.toml"));
}

/// The message must name the file, the line and the key, and contain `rest`.
void check_refused(const std::string& text, int line, const std::string& key, const std::string& rest) {
  INFO(text);
  CHECK_THROWS_WITH(shape_of(text), Contains("grain.toml:" + std::to_string(line) + ":") && Contains(": key " + key) &&
                                        Contains("expected") && Contains(rest));
}

const std::string superquadric = "kind = 'superquadric'\nunit = 'mm'\n";
const std::string ellipsoid = "kind = 'ellipsoid'\nunit = 'mm'\n";
const std::string cube_planes =
    "planes = [[1,0,0,4],[-1,0,0,4],[0,1,0,4],[0,-1,0,4],[0,0,1,4],[0,0,-1,4]]\nk = 0.1\nr = 1\nR = 6\n";

}  // namespace

TEST_CASE("Lengths come out in metres whatever their unit") {
  const auto grain = shape_of(superquadric + "half_axes = [3, '250 um', 0.2]\nn = [4, 2.5]\n");
  const auto& shape = std::get<Superquadric>(grain.shape);
  CHECK((shape.half_axes - Vec3(3e-3, 250e-6, 0.2e-3)).norm() < 1e-18);  // one rounding each
  CHECK(shape.exponents.n1 == 4.0);
  CHECK(shape.exponents.n2 == 2.5);
  CHECK(std::get<Sphere>(shape_of("kind='sphere'\nunit='um'\nradius=7").shape).radius == 7.0 * 1e-6);
}

TEST_CASE("eta and n = 2/eta give the same superquadric") {
  const auto by_eta = std::get<Superquadric>(shape_of(superquadric + "half_axes=[1,1,1]\neta=[0.5,0.8]").shape);
  CHECK(by_eta.exponents.n1 == 4.0);
  CHECK(by_eta.exponents.n2 == 2.5);
}

TEST_CASE("Every kind of shape is read") {
  CHECK(std::holds_alternative<Ellipsoid>(shape_of(ellipsoid + "half_axes=[1,2,3]").shape));
  CHECK(std::holds_alternative<HalfSpace>(shape_of("kind='half_space'").shape));
  CHECK(std::get<SphereContainer>(shape_of("kind='sphere_container'\nunit='m'\nradius=2").shape).radius == 2.0);
  const auto drum = std::get<Cylinder>(shape_of("kind='cylinder'\nunit='m'\nradius=2\nside='drum'").shape);
  CHECK(drum.solid == Cylinder::Solid::outside);
  const auto cube = shape_of("kind='potential_particle'\nunit='mm'\n" + cube_planes);
  CHECK(std::get<PotentialParticle>(cube.shape).planes.size() == 6);
  CHECK(std::get<PotentialParticle>(cube.shape).planes.front().distance == 4.0 * 1e-3);
}

TEST_CASE("Wrong shapes are refused with file, line and key") {
  check_refused(ellipsoid + "half_axes = [1, -2, 3]\n", 3, "half_axes[1]", "positive");
  check_refused(ellipsoid + "half_axes = [1, nan, 3]\n", 3, "half_axes[1]", "finite");
  check_refused(ellipsoid + "half_axes = [1, 2]\n", 3, "half_axes", "three lengths");
  check_refused(ellipsoid + "half_axis = [1, 2, 3]\n", 3, "half_axes", "similar \"half_axis\"");
  check_refused(ellipsoid + "half_axes = [1, 2, 3]\ncolour = 'red'\n", 4, "colour", "unknown key");
  check_refused(superquadric + "half_axes = [1, 2, 3]\nn = [1.0, 2.0]\n", 4, "n[0]", "above 1 and at most 64");
  check_refused(superquadric + "half_axes = [1, 2, 3]\nn = [2.0, 65]\n", 4, "n[1]", "at most 64");
  check_refused(superquadric + "half_axes = [1, 2, 3]\neta = [2.0, 1.0]\n", 4, "eta[0]", "eta = 2/n");
  check_refused(superquadric + "half_axes = [1, 2, 3]\nn = [4,4]\neta = [1,1]\n", 5, "eta", "one of them");
  check_refused("kind = 'elipsoid'\n", 1, "kind", "did you mean ellipsoid?");
  check_refused("kind = 'sphere'\nunit = 'furlong'\nradius = 1\n", 2, "unit", "\"mm\"");
  check_refused("kind = 'sphere'\nradius = 1\n", 1, "unit", "one of");
  check_refused("kind = 'cylinder'\nunit = 'm'\nradius = 2\nside = 'out'\n", 4, "side", "\"drum\"");
  check_refused("kind = 'sphere'\nunit = 'mm'\nradius = '3 kg'\n", 3, "radius", "length");
}

TEST_CASE("A particle of absurd size is taken for a slip of unit") {
  check_refused("kind = 'sphere'\nunit = 'm'\nradius = 60\n", 3, "radius", "is unit = \"m\" right?");
  check_refused("kind = 'sphere'\nunit = 'nm'\nradius = 0.4\n", 3, "radius", "is unit = \"nm\" right?");
  check_refused("kind = 'ellipsoid'\nunit = 'm'\nhalf_axes = [1, 2, 250]\n", 3, "half_axes", "100 m across");
}

TEST_CASE("Planes that bound nothing are refused with their place in the file") {
  const std::string head = "kind='potential_particle'\nunit='mm'\nk=0.1\nr=1\nR=6\n";
  check_refused(head + "planes=[[1,0,0,4],[-1,0,0,4],[0,1,0,4],[0,-1,0,4],[0,0,1,4]]\n", 1, "kind", "bound a volume");
  check_refused(head + "planes=[[1,0,0,4],[0,0,0,4]]\n", 6, "planes[1]", "a direction");
  check_refused(head + "planes=[[1,0,0,4],[-1,0,0,-4]]\n", 6, "planes[1]", "origin lies inside");
  check_refused(head + "planes=[[1,0,0]]\n", 6, "planes[0]", "4 numbers");
  check_refused(head + "polyhedron='no-such.off'\n", 6, "polyhedron", "no such file");
}

TEST_CASE("A shape in another file is an inline table, a catalogue name or a path from that file") {
  const std::string other = std::string(OSCULATE_SHAPES_DIR) + "/../contact.toml";
  const auto table = io::parse_toml(
      "a = {kind='sphere', radius=2}\nb = 'rice'\nc = 'shapes/rice.toml'\nd = 'rise'\ne = 3\nf = {kind='sphere', "
      "radus=2}\n",
      other);
  CHECK(std::get<Sphere>(io::parse_shape_of(table, "a", "mm").shape).radius == 2.0 * 1e-3);
  CHECK(io::parse_shape_of(table, "b").name == "rice");
  CHECK(io::parse_shape_of(table, "c").title == io::find_shape("rice").title);
  CHECK_THROWS_WITH(io::parse_shape_of(table, "d"),
                    Contains("contact.toml:4:5: key d") && Contains("did you mean rice"));
  CHECK_THROWS_WITH(io::parse_shape_of(table, "e"), Contains("contact.toml:5:5: key e"));
  CHECK_THROWS_WITH(io::parse_shape_of(table, "f", "mm"), Contains("contact.toml:6:") && Contains("key f.radius"));
}

TEST_CASE("Every shape of the catalogue is named as its file, has title and source, and is valid") {
  const auto entries = io::catalogue();
  CHECK(entries.size() >= 12);
  for (const auto& entry : entries) {
    INFO(entry.name);
    if (entry.name == "railway-ballast" && !tools::can_find_convex_hulls()) continue;
    const auto shape = io::find_shape(entry.name);
    CHECK(shape.name == entry.name);
    CHECK(!shape.title.empty());
    CHECK(!shape.source.empty());
    CHECK(is_particle(shape.shape));
  }
}

TEST_CASE("The ballast stone is the hull of the points that its file states") {
  std::ifstream file(std::string(OSCULATE_SHAPES_DIR) + "/railway-ballast.off");
  std::string line;
  while (std::getline(file, line) && line != "24 0 0") {
  }
  for (int i = 0; i < 24; ++i) {
    Vec3 point;
    file >> point.x() >> point.y() >> point.z();
    REQUIRE(file.good());
    const double z = 1.0 - (2.0 * i + 1.0) / 24.0, radius = std::sqrt(1.0 - z * z), longitude = 2.399963 * i;
    const double out = 1.0 + 0.12 * std::sin(5.0 * i * i);
    const Vec3 stated(26.0 * radius * std::cos(longitude), 20.0 * radius * std::sin(longitude), 15.0 * z);
    CHECK((point - out * stated).cwiseAbs().maxCoeff() < 0.5001e-4);  // four decimals are printed
  }
}
