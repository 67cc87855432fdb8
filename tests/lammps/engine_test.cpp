// The same scenes through LAMMPS and through the library's own engine.

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "io/scene.hpp"
#include "osculate/dynamics/simulation.hpp"
#include "temporary.hpp"

namespace osculate::lammps {
namespace {

namespace fs = std::filesystem;

constexpr int columns = 16;
/// Position, velocity, angular velocity, orientation w x y z, force with gravity.
using test::fresh_folder;
using test::temporary;
using Row = std::array<double, columns>;
/// By step, then by tag.
using Frames = std::map<std::uint64_t, std::map<int, Row>>;

Frames read_dump(const fs::path& path) {
  std::ifstream file(path);
  Frames frames;
  std::string line;
  while (std::getline(file, line)) {
    REQUIRE(line == "ITEM: TIMESTEP");
    std::getline(file, line);
    auto& frame = frames[std::stoull(line)];
    while (line.rfind("ITEM: ATOMS", 0) != 0) REQUIRE(std::getline(file, line));
    while (file.peek() != 'I' && std::getline(file, line)) {
      std::istringstream numbers(line);
      int tag = 0, type = 0;
      numbers >> tag >> type;
      for (double& value : frame[tag]) numbers >> value;
      REQUIRE(numbers);
    }
  }
  return frames;
}

fs::path written(const std::string& name, const std::string& text) {
  const fs::path path = temporary(name);
  std::ofstream(path) << text;
  return path;
}

struct Run {
  int exit_code;
  std::string said;
};

/// A program with its arguments under mpirun.
Run mpirun(int ranks, const std::string& program) {
  const fs::path said = temporary("said.txt");
  const std::string command = std::string(OSCULATE_MPIEXEC) +
                              " --allow-run-as-root --oversubscribe --bind-to none -n " + std::to_string(ranks) + " " +
                              program + " >" + said.string() + " 2>&1";
  const int status = std::system(command.c_str());
  std::ifstream file(said);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  fs::remove(said);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, command + '\n' + text};
}

/// What osculate-lammps said; fails if the program does.
std::string run_program(int ranks, const std::string& arguments) {
  const Run run = mpirun(ranks, std::string(OSCULATE_LAMMPS_PROGRAM) + " " + arguments);
  INFO(run.said);
  REQUIRE(run.exit_code == 0);
  return run.said;
}

Frames run_ranks(int ranks, const fs::path& scene, std::uint64_t steps, std::uint64_t every) {
  const fs::path folder = fresh_folder("ranks");
  run_program(ranks, scene.string() + " --steps " + std::to_string(steps) + " --every " + std::to_string(every) +
                         " --out " + folder.string());
  return read_dump(folder / "frames.lammpstrj");
}

Row row_of(const Simulation& simulation, std::size_t i) {
  const Bodies& bodies = simulation.bodies();
  const Vec3 x = wrapped(simulation.setup().box, bodies.position[i]), v = bodies.velocity[i],
             omega = bodies.angular_velocity(i), force = bodies.force[i] + bodies.mass[i] * simulation.setup().gravity;
  const Quat q = bodies.orientation[i];
  return {x.x(),     x.y(), x.z(), v.x(), v.y(), v.z(),     omega.x(), omega.y(),
          omega.z(), q.w(), q.x(), q.y(), q.z(), force.x(), force.y(), force.z()};
}

/// What a number of each column is like in a scene: differences are measured against it.
Row scales_of(const Frames& frames) {
  constexpr std::array<int, 6> ends{0, 3, 6, 9, 13, 16};
  Row scales{};
  for (std::size_t group = 0; group + 1 < ends.size(); ++group) {
    double most = 0.0;
    for (const auto& [step, rows] : frames)
      for (const auto& [tag, row] : rows)
        for (int k = ends[group]; k < ends[group + 1]; ++k)
          most = std::max(most, std::fabs(row[static_cast<std::size_t>(k)]));
    for (int k = ends[group]; k < ends[group + 1]; ++k) scales[static_cast<std::size_t>(k)] = most;
  }
  return scales;
}

/// Every number of every frame after the start, where LAMMPS's forces know of no step yet.
double largest_difference(const Frames& one, const Frames& two) {
  const Row scales = scales_of(one);
  double most = 0.0;
  REQUIRE(one.size() == two.size());
  for (const auto& [step, rows] : one) {
    REQUIRE(rows.size() == two.at(step).size());
    for (const auto& [tag, row] : rows)
      for (std::size_t k = 0; k < row.size(); ++k)
        most = std::max(most, std::fabs(row[k] - two.at(step).at(tag)[k]) / scales[k]);
  }
  return most;
}

Frames run_embedded(const fs::path& path, std::uint64_t steps, std::uint64_t every) {
  const io::Scene scene = io::read_scene(path);
  Simulation simulation(scene.setup);
  Frames frames;
  for (;;) {
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i)
      if (simulation.bodies().is_free(i)) frames[simulation.steps()][static_cast<int>(i) + 1] = row_of(simulation, i);
    if (simulation.steps() == steps) return frames;
    simulation.advance(every);
  }
}

const std::string plastic = R"(length_unit = "mm"
[[materials]]
name = "plastic"
youngs_modulus = "5 MPa"
poissons_ratio = 0.3
density = "1.2 g/cm3"
[[interactions]]
normal = "hertz"
dissipation = {law = "tsuji", restitution = 0.3}
tangential = {law = "mindlin", friction = 0.5}
[output]
interval = "1 ms"
)";

/// A lentil on another one on a belt that carries them through a periodic box: gravity pulls them along it, and the
/// memory of both contacts holds them.
const std::string belt = plastic + R"(
[[particles]]
name = "lentil"
shape = {kind = "superquadric", half_axes = [3, 3, 1.5], n = [2, 2]}
[[walls]]
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
motion = {kind = "translation", velocity = [1, 0, 0]}
[[insert]]
how = "single"
position = [-18, 0, 1.4965]
velocity = [1, 0, 0]
[[insert]]
how = "single"
position = [-17.9, 0.1, 4.4921]
velocity = [1, 0, 0]
[time]
duration = "0.06 s"
)";
const std::string belt_start = R"(gravity = [1, 0, -9.81]
periodic = {x = [-20, 20], y = [-10, 10]}
)";

const std::string falling = R"(gravity = [0, 0, -9.81]
)" + plastic + R"(
fraction_region = {kind = "box", lower = [0, 0, 0], upper = [20, 20, 10]}
[[particles]]
name = "box"
shape = {kind = "superquadric", half_axes = [2.5, 2.5, 2.5], n = [4, 4]}
[[walls]]
kind = "box"
lower = [0, 0, 0]
upper = [20, 20, 60]
sides = ["-x", "+x", "-y", "+y", "-z"]
[[insert]]
how = "lattice"
region = {kind = "box", lower = [0, 0, 0], upper = [20, 20, 50]}
fluctuation = 0.1
[time]
duration = "0.03 s"
)";

}  // namespace

TEST_CASE("An oblique impact through LAMMPS on 1, 2 and 4 ranks is that of the embedded engine to 1e-10") {
  const fs::path scene = OSCULATE_EXAMPLES_DIR "/scenes/two-particle-impact.toml";
  constexpr std::uint64_t steps = 12000, every = 250;
  const Frames embedded = run_embedded(scene, steps, every);
  // They met: they turn otherwise than they did.
  REQUIRE(std::fabs(embedded.at(steps).at(1)[8]) > 1.0);
  for (const int ranks : {1, 2, 4}) {
    CAPTURE(ranks);
    CHECK(largest_difference(embedded, run_ranks(ranks, scene, steps, every)) < 1e-10);
  }
}

TEST_CASE("A sticking pair keeps its tangential forces when it crosses from one rank to the next") {
  const fs::path scene = written("belt.toml", belt_start + belt);
  constexpr std::uint64_t every = 200;
  const std::uint64_t steps = io::read_scene(scene).steps() / every * every;
  const Frames embedded = run_embedded(scene, steps, every);
  // They went through the middle of the box, where the ranks meet, and through its end. With nothing to hold it the
  // lower one would be faster than the belt by 0.06 m/s at the end.
  REQUIRE(embedded.at(0).at(3)[0] < 0.0);
  REQUIRE(embedded.at(steps / 2 / every * every).at(3)[0] > 0.0);
  REQUIRE(embedded.at(steps).at(2)[0] < embedded.at(steps / 2 / every * every).at(2)[0]);
  REQUIRE(std::fabs(embedded.at(steps).at(2)[3] - 1.0) < 0.02);
  for (const int ranks : {1, 2, 4}) {
    CAPTURE(ranks);
    CHECK(largest_difference(embedded, run_ranks(ranks, scene, steps, every)) < 1e-10);
  }
  fs::remove(scene);
}

TEST_CASE("An ordinary LAMMPS script runs the pair style, on one rank as on two") {
  const fs::path scene = OSCULATE_EXAMPLES_DIR "/scenes/two-particle-impact.toml";
  const auto run_script = [&](int ranks, const std::string& runs) {
    const fs::path dump = temporary("script.lammpstrj");
    const fs::path script = written("in.lmp",
                                    R"(units si
atom_style sphere
atom_modify map yes
newton off
boundary p p p
region box block -0.02 0.02 -0.01 0.01 -0.01 0.01
create_box 1 box
create_atoms 1 single -0.004 0 0
create_atoms 1 single 0.004 0.0008 0.0005
neighbor 0.0003 bin
neigh_modify every 1 delay 0 check yes
pair_style osculate
pair_coeff * * )" + scene.string() + R"( grain
fix move all osculate/rigid
set atom 2 d_qw 0.90630778703664996 d_qz 0.42261826174069944
set atom 2 omega 0 0 20
group one id 1
group two id 2
velocity one set 1 0 0
velocity two set -0.5 0 0
timestep 1.7578e-7
dump frames all custom 250 )" + dump.string() +
                                        R"( id type x y z vx vy vz omegax omegay omegaz d_qw d_qx d_qy d_qz fx fy fz
dump_modify frames sort id format float %.17g
)" + runs);
    run_program(ranks, "-log none -in " + script.string());
    Frames frames = read_dump(dump);
    fs::remove(dump);
    fs::remove(script);
    return frames;
  };
  const Frames one = run_script(1, "run 6000\nrun 6000\n");
  REQUIRE(one.rbegin()->first == 12000);
  CHECK(std::fabs(one.at(12000).at(1)[8]) > 1.0);
  CHECK(largest_difference(one, run_script(2, "run 6000\nrun 6000\n")) < 1e-10);
  // Momentum stays.
  CHECK(one.at(12000).at(1)[3] + one.at(12000).at(2)[3] == Approx(0.5).epsilon(1e-12));
  // A run that goes on with the lists and forces of the last one is the same run: here it does so during the contact.
  const Frames whole = run_script(2, "run 12000\n");
  std::string parts;
  for (int part = 0; part < 12; ++part) parts += "run 1000 pre no\n";
  CHECK(largest_difference(whole, run_script(2, parts)) == 0.0);
}

TEST_CASE("osculate run --engine lammps is osculate-lammps, under mpirun and alone") {
  const fs::path scene = written("belt.toml", belt_start + belt), folder = fresh_folder("engine") / "belt";
  const std::string command =
      std::string(OSCULATE_PROGRAM) + " run " + scene.string() + " --engine lammps --out " + folder.string();
  const Run two = mpirun(2, command);
  INFO(two.said);
  REQUIRE(two.exit_code == 0);
  CHECK(fs::exists(folder / "log.lammps"));
  const Frames frames = read_dump(folder / "frames.lammpstrj");
  CHECK(frames.rbegin()->first == io::read_scene(scene).steps());

  SECTION("Results are kept") {
    const Run again = mpirun(2, command);
    INFO(again.said);
    CHECK(again.exit_code == 2);
    // Said by one of the ranks.
    const std::size_t at = again.said.find("found results of an earlier run; expected --overwrite");
    REQUIRE(at != std::string::npos);
    CHECK(again.said.find("found results of an earlier run", at + 1) == std::string::npos);
  }
  SECTION("One rank needs no mpirun") {
    const fs::path said = temporary("alone.txt");
    REQUIRE(std::system((command + " --overwrite >" + said.string() + " 2>&1").c_str()) == 0);
    CHECK(largest_difference(frames, read_dump(folder / "frames.lammpstrj")) < 1e-10);
  }
  SECTION("A scene that is none is said once") {
    const Run bad =
        mpirun(2, std::string(OSCULATE_PROGRAM) + " run " + (folder / "none.toml").string() + " --engine lammps");
    INFO(bad.said);
    CHECK(bad.exit_code == 2);
    CHECK(bad.said.find("none.toml") != std::string::npos);
  }
  fs::remove(scene);
}

TEST_CASE("Falling boxes meet alike on both engines: single contacts to 1e-10, bulk results within statistical error") {
  const fs::path scene = written("falling.toml", falling);
  const std::string said = run_program(2, scene.string() + " --validate --beginnings 5");
  INFO(said);
  CHECK(said.find("Verdict: they agree") != std::string::npos);
  CHECK(said.find("THEY DISAGREE") == std::string::npos);
  fs::remove(scene);
}

}  // namespace osculate::lammps
