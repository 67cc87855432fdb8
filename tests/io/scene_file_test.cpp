#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "io/scene.hpp"
#include "osculate/core/error.hpp"
#include "temporary.hpp"

namespace osculate::io {
namespace {

constexpr const char* good = R"(length_unit = "mm"
gravity = [0, 0, -9.81]
[[materials]]
name = "glass"
preset = "glass"
density = "2.5 g/cm3"
[[materials]]
name = "wood"
youngs_modulus = "10 GPa"
poissons_ratio = 0.3
density = 700
[[interactions]]
normal = "hertz"
dissipation = {law = "tsuji", restitution = 0.5}
[[interactions]]
between = ["wood", "glass"]
normal = "hertz"
tangential = {law = "mindlin", friction = 0.3}
[[particles]]
name = "bead"
shape = {kind = "sphere", radius = 2}
material = "glass"
[[particles]]
name = "grain"
shape = {kind = "ellipsoid", half_axes = [1, 2, 3]}
material = "wood"
scale = 0.5
sizes = {distribution = "uniform", least = 1, most = 2, classes = 2}
[[walls]]
kind = "box"
name = "tray"
lower = [0, 0, 0]
upper = [50, 60, 70]
sides = ["-z", "+x"]
material = "wood"
motion = {kind = "oscillation", amplitude = [0, 0, 1], frequency = "50 Hz", phase = 90}
[[walls]]
kind = "cylinder"
side = "drum"
point = [0, 0, 0]
axis = [0, 2, 0]
radius = 100
material = "glass"
motion = {kind = "rotation", point = [0, 0, 0], axis = [0, 1, 0], rate = "30 rpm"}
[[obstacles]]
name = "post"
shape = {kind = "superquadric", half_axes = [2, 2, 20], n = [8, 2]}
position = [10, 0, 20]
material = "wood"
ring = {count = 4, point = [0, 0, 0], axis = [0, 0, 1]}
[[insert]]
how = "single"
particles = "bead"
position = [20, 20, "4 cm"]
velocity = [0, 0, "-10 cm/s"]
angular_velocity = [1, 2, 3]
[[insert]]
how = "lattice"
particles = [{name = "bead", share = 1}, {name = "grain", share = 3}]
count = 12
region = {kind = "box", lower = [-30, -30, 50], upper = [-5, -5, 90]}
[time]
duration = "1 ms"
[output]
interval = "0.1 ms"
)";

std::filesystem::path put(const std::string& text) {
  const auto folder = test::temporary("scene");  // what stands beside the scene stays
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scene.toml") << text;
  return folder / "scene.toml";
}

Scene read(const std::string& text) {
  return read_scene(put(text));
}

/// The good scene with one piece replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = good;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

void require_error(const std::string& text, const std::vector<std::string>& parts) {
  try {
    read(text);
  } catch (const InputError& error) {
    for (const std::string& part : parts) CHECK_THAT(error.what(), Catch::Contains(part));
    return;
  }
  FAIL("no error that says " << parts.front());
}

}  // namespace

TEST_CASE("A scene file becomes a setup in SI") {
  const Scene scene = read(good);
  const Setup& setup = scene.setup;
  REQUIRE(setup.materials.size() == 2);
  CHECK(setup.materials[0].density == Approx(2500.0));
  CHECK(setup.materials[1].elastic.youngs_modulus == Approx(1e10));
  REQUIRE(setup.interactions.size() == 3);  // one by name, two by the one for all others
  REQUIRE(setup.shapes.size() == 7);        // bead, two grains, post, two planes, drum
  CHECK(std::get<Sphere>(setup.shapes[0]).radius == Approx(2e-3));
  // Halves, times the medians of the two halves of 1 … 2.
  CHECK(std::get<Ellipsoid>(setup.shapes[1]).half_axes.isApprox(0.5 * 1.25 * 1e-3 * Vec3(1, 2, 3)));
  CHECK(std::get<Ellipsoid>(setup.shapes[2]).half_axes.isApprox(0.5 * 1.75 * 1e-3 * Vec3(1, 2, 3)));
  REQUIRE(setup.bodies.size() == 4 + 3 + 1 + 12);
  CHECK(setup.bodies[1].pose.position.isApprox(Vec3(0, 10e-3, 20e-3)));
  CHECK(scene.walls.size() == 3);
  CHECK(scene.walls[0].name == "tray -z");
  const BodyStart& side = setup.bodies[5];  // +x: its normal points inwards
  CHECK((side.pose.orientation * Vec3::UnitZ()).isApprox(-Vec3::UnitX(), 1e-12));
  CHECK(side.pose.position.x() == Approx(50e-3));
  const auto& shaking = std::get<Oscillation>(setup.motions[static_cast<std::size_t>(side.motion)]);
  CHECK(shaking.phase == Approx(std::acos(-1.0) / 2.0));
  CHECK(shaking.amplitude.z() == Approx(1e-3));
  const auto& turning = std::get<Rotation>(setup.motions[static_cast<std::size_t>(setup.bodies[6].motion)]);
  CHECK(turning.rate == Approx(std::acos(-1.0)));
  const BodyStart& single = setup.bodies[7];
  CHECK(single.pose.position.isApprox(Vec3(20e-3, 20e-3, 40e-3)));
  CHECK(single.velocity.isApprox(Vec3(0, 0, -0.1)));
  CHECK(single.angular_velocity == Vec3(1, 2, 3));
  CHECK(setup.time_step == scene.limits.recommended);
  // Its own speed, the drum's wall (the fastest) and a fall from the highest particle to the drum's bottom.
  CHECK(scene.speed > 0.1 + std::acos(-1.0) * 0.1);
  CHECK(scene.steps() == static_cast<std::uint64_t>(std::round(1e-3 / setup.time_step)));
}

TEST_CASE("A slip in a scene file is told with its place and a suggestion") {
  require_error(with("youngs_modulus", "young_modulus"), {"scene.toml:9", "young_modulus"});
  require_error(with("frequency", "frequenzy"), {"scene.toml:36", "frequenzy"});
  require_error(with("restitution = 0.5", "restitution = 1.5"), {"scene.toml:14", "restitution", "1.5"});
  require_error(with("\"tsuji\"", "\"tsui\""), {"scene.toml:14", "did you mean", "tsuji"});
  require_error(with("friction = 0.3", "fricton = 0.3"), {"scene.toml:18", "fricton"});
  require_error(with("particles = \"bead\"", "particles = \"baed\""), {"scene.toml:53", "did you mean", "bead"});
  require_error(with("interval =", "intervall ="), {"scene.toml:65", "interval"});
  require_error(with("\"1 ms\"", "\"1 mm\""), {"scene.toml:63", "1 mm", "duration"});
  require_error(with("[time]", "unknown = 3\n[time]"), {"scene.toml:62", "unknown"});
  require_error(with("between = [\"wood\", \"glass\"]\n", ""), {"second interaction without \"between\""});
  require_error(with("density = 700", "density = 0"), {"scene.toml:11", "density"});
  require_error(with("\"-z\", \"+x\"", "\"-z\", \"x\""), {"scene.toml:34", "\"x\""});
}

TEST_CASE("A scene that cannot run is refused") {
  SECTION("without particles") {
    std::string text = good;
    text.erase(text.find("[[insert]]"), text.find("[time]") - text.find("[[insert]]"));
    require_error(text, {"insert"});
  }
  SECTION("with a step that crosses contacts") {
    require_error(with("duration = \"1 ms\"", "duration = \"1 ms\"\nstep = \"1 ms\""),
                  {"scene.toml:64", "0.001 s", "at most"});
  }
  SECTION("with two materials that have no law") {
    require_error(
        with("[[interactions]]\nnormal = \"hertz\"\ndissipation = {law = \"tsuji\", restitution = 0.5}\n", ""),
        {"none between materials"});
  }
  SECTION("with more particles than there is room for") {
    require_error(with("count = 12", "count = 1000000"), {"count", "do not fit"});
  }
}

TEST_CASE("A step between the recommended and the longest is warned about") {
  const double recommended = read(good).limits.recommended;
  const Scene scene =
      read(with("duration = \"1 ms\"", "duration = \"1 ms\"\nstep = " + std::to_string(2e9 * recommended) + "e-9"));
  REQUIRE(scene.warnings.size() == 1);
  CHECK_THAT(scene.warnings[0], Catch::Contains("scene.toml:64") && Catch::Contains("recommended"));
}

TEST_CASE("What is allowed and seldom meant is warned about") {
  CHECK(read(good).warnings.empty());
  std::string bare = good;
  bare.erase(bare.find("[[walls]]"), bare.find("[[insert]]") - bare.find("[[walls]]"));
  REQUIRE(read(bare).warnings.size() == 1);
  CHECK_THAT(read(bare).warnings[0], Catch::Contains("falls for ever"));
  const Scene rare = read(with("interval = \"0.1 ms\"", "interval = \"1 s\""));
  REQUIRE(rare.warnings.size() == 1);
  CHECK_THAT(rare.warnings[0], Catch::Contains("scene.toml:65") && Catch::Contains("longer than the run"));
  const Scene often = read(with("interval = \"0.1 ms\"", "interval = \"1 ns\""));
  REQUIRE(often.warnings.size() == 1);
  CHECK_THAT(often.warnings[0], Catch::Contains("every step"));
}

TEST_CASE("Particles from a table keep their numbers") {
  std::ofstream(put(good).parent_path() / "beads.csv")
      << "x,y,z,qw,qx,qy,qz,wz\n0.01,0.02,0.2,1,0,0,0,5\n-0.01,0.02,0.2,0.6,0,0.8,0,0\n";
  std::string text = good;
  text.insert(text.find("[time]"), "[[insert]]\nhow = \"file\"\nparticles = \"bead\"\nfile = \"beads.csv\"\n");
  const Scene scene = read(text);
  REQUIRE(scene.setup.bodies.size() == 22);
  const BodyStart& first = scene.setup.bodies[20];
  CHECK(first.pose.position == Vec3(0.01, 0.02, 0.2));
  CHECK(first.angular_velocity == Vec3(0, 0, 5));
  CHECK(scene.setup.bodies[21].pose.orientation.y() == Approx(0.8));
}

TEST_CASE("A pour comes by number or by mass, in SI") {
  const auto pouring = [](const std::string& keys) {
    std::string text = good;
    const std::string pour =
        "[[insert]]\nhow = \"pour\"\nparticles = \"grain\"\n"
        "region = {kind = \"box\", lower = [0, 0, 60], upper = [10, 10, 70]}\n";
    return text.insert(text.find("[time]"), pour + keys + "\n");
  };
  const Scene scene =
      read(pouring("mass_rate = \"6 kg/min\"\nbegin = \"1 ms\"\nend = \"2 s\"\ncount = 9\nseed = 4\n"
                   "velocity = [0, 0, -20]\nfluctuation = 0.1\ngap = 0.5\ntries = 7"));
  REQUIRE(scene.setup.pours.size() == 1);
  const Pour& pour = scene.setup.pours[0];
  CHECK(pour.measure == Pour::Measure::mass);
  CHECK(pour.rate == Approx(0.1));
  CHECK(pour.begin == Approx(1e-3));
  CHECK(pour.end == 2.0);
  CHECK(pour.most == 9);
  CHECK(pour.seed == 4);
  CHECK(pour.gap == Approx(5e-4));
  CHECK(pour.tries == 7);
  CHECK(pour.kinds.size() == 2);
  CHECK(std::get<BoxRegion>(pour.region).upper.z() == Approx(70e-3));
  CHECK(scene.speed > 20.0);
  CHECK(scene.warnings.size() == 1);  // the run is over when it begins
  CHECK(read(pouring("rate = 50")).setup.pours[0].measure == Pour::Measure::particles);
  require_error(pouring("rate = 50\nmass_rate = 1"), {"both rate and mass_rate"});
  require_error(pouring("seed = 3"), {"no rate", "mass_rate"});
  require_error(pouring("rate = -5"), {"rate", "-5"});
  require_error(pouring("rate = 5\nbegin = 2\nend = 1"), {"end", "after the beginning"});
  require_error(pouring("rate = 5\nspacing = 1"), {"spacing"});
  // Nothing else need be there.
  std::string text = pouring("rate = 50");
  const std::size_t first = text.find("[[insert]]");
  text.erase(first, text.find("[[insert]]\nhow = \"pour\"") - first);
  CHECK(read(text).setup.bodies.size() == 7);
}

TEST_CASE("A mesh is read from its file, in the scene's unit") {
  const auto with_mesh = [](const std::string& keys) {
    std::string text = good;
    return text.insert(text.find("[[obstacles]]"),
                       "[[walls]]\nname = \"ramp\"\nkind = \"mesh\"\nmaterial = \"wood\"\n" + keys + "\n");
  };
  const auto ramp = [](const std::filesystem::path& folder) {
    std::ofstream(folder / "ramp.obj") << "v 0 0 0\nv 10 0 0\nv 10 10 5\nv 0 10 5\nf 1 2 3 4\n";
  };
  ramp(put(good).parent_path());
  const Scene scene =
      read(with_mesh("file = \"ramp.obj\"\nscale = 2\nposition = [0, 0, -90]\n"
                     "motion = {kind = \"translation\", velocity = [0, 0, 30]}"));
  REQUIRE(scene.setup.meshes.size() == 1);
  CHECK(scene.mesh_names == std::vector<std::string>{"ramp"});
  const MeshStart& mesh = scene.setup.meshes[0];
  CHECK(mesh.material == 1);
  CHECK(mesh.triangles.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.triangles.vertices[2].isApprox(Vec3(0.02, 0.02, 0.01)));
  CHECK(mesh.pose.position.isApprox(Vec3(0, 0, -0.09)));
  CHECK(scene.speed > 30.0);
  require_error(with_mesh("file = \"none.stl\""), {"file", "none.stl"});
  require_error(with_mesh("file = \"ramp.obj\"\nradius = 3"), {"radius"});
}

TEST_CASE("A sheared box gives particles its flow") {
  std::string text = good;
  text.erase(text.find("[[walls]]"), text.find("[[insert]]") - text.find("[[walls]]"));
  text.replace(text.find("gravity"), std::string("gravity = [0, 0, -9.81]").size(),
               "[periodic]\nx = [-40, 40]\ny = [-40, 40]\nz = [0, 100]\n"
               "shear = {flow = \"x\", gradient = \"z\", rate = \"20 1/s\"}");
  const Scene scene = read(text);
  REQUIRE(scene.setup.box.shear);
  CHECK(scene.setup.box.shear->rate == 20.0);
  CHECK(scene.setup.bodies[0].velocity.isApprox(Vec3(20.0 * (0.04 - 0.05), 0, -0.1)));
  CHECK(scene.speed > 2.0);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    return other.replace(other.find(from), from.size(), to);
  };
  require_error(changed("gradient = \"z\"", "gradient = \"x\""), {"two different axes"});
  require_error(changed("gradient = \"z\"", "gradient = \"up\""), {"gradient", "up"});
  require_error(changed("z = [0, 100]\n", ""), {"axes that repeat"});
}

TEST_CASE("The same seed places the same particles") {
  const std::string lattice = "how = \"lattice\"";
  const Scene one = read(good), two = read(good), other = read(with(lattice, lattice + "\nseed = 77"));
  CHECK(one.setup.bodies.back().pose.orientation.coeffs() == two.setup.bodies.back().pose.orientation.coeffs());
  CHECK(one.setup.bodies.back().pose.orientation.coeffs() != other.setup.bodies.back().pose.orientation.coeffs());
}

}  // namespace osculate::io
