#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "app/program.hpp"
#include "io/results_file.hpp"
#include "io/scene.hpp"

namespace osculate::app {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::fresh_folder;
using test::run;

/// Rounded cubes, ellipsoids and a shaken floor: every kind of memory there is. `body` is put in front of [time].
std::string small_scene(const std::string& duration, const std::string& body = "") {
  return R"(length_unit = "mm"
gravity = [0, 0, -9.81]
[[materials]]
name = "plastic"
youngs_modulus = "5 MPa"
poissons_ratio = 0.3
density = "1.2 g/cm3"
[[interactions]]
normal = "hertz"
dissipation = {law = "tsuji", restitution = 0.4}
tangential = {law = "mindlin", friction = 0.4}
[[particles]]
name = "cube"
shape = {kind = "superquadric", half_axes = [2.5, 2.5, 2.5], n = [4, 4]}
[[particles]]
name = "pill"
shape = {kind = "ellipsoid", half_axes = [3, 2, 2]}
[[walls]]
kind = "box"
lower = [0, 0, 0]
upper = [20, 20, 90]
sides = ["-x", "+x", "-y", "+y"]
[[walls]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
motion = {kind = "oscillation", amplitude = [0, 0, 0.2], frequency = "40 Hz"}
[[insert]]
how = "random"
particles = [{name = "cube", share = 1}, {name = "pill", share = 1}]
count = 40
region = {kind = "box", lower = [0, 0, 2], upper = [20, 20, 50]}
velocity = [0, 0, -0.5]
)" + body +
         "[time]\nduration = \"" + duration + R"("
[output]
interval = "5 ms"
contacts = true
checkpoint_every = "20 ms"
)";
}

/// The same, but that nothing is there at the start and particles pour in.
std::string pouring_scene(const std::string& duration) {
  std::string text = small_scene(duration);
  const std::size_t from = text.find("how = \"random\""), to = text.find("region", from);
  return text.replace(from, to - from, R"(how = "pour"
particles = [{name = "cube", share = 1}, {name = "pill", share = 1}]
rate = 1500
begin = "2 ms"
)");
}

void put(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// Starts the program and kills it after a while; false if it had ended by then.
bool run_and_kill(const fs::path& folder, const std::string& arguments, std::chrono::microseconds after) {
  const std::string command =
      "cd '" + folder.string() + "' && exec " OSCULATE_PROGRAM " " + arguments + " >/dev/null 2>&1";
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  std::this_thread::sleep_for(after);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

void require_same_results(const fs::path& one, const fs::path& two) {
  const io::ResultsFile first(one / "results.h5"), second(two / "results.h5");
  REQUIRE(first.frame_count() == second.frame_count());
  for (std::size_t i = 0; i < first.frame_count(); ++i) {
    const io::ParticleFrame a = first.frame(i), b = second.frame(i);
    REQUIRE(a.step == b.step);
    REQUIRE(a.position == b.position);
    REQUIRE(a.velocity == b.velocity);
    REQUIRE(a.angular_velocity == b.angular_velocity);
    for (std::size_t k = 0; k < a.size(); ++k) REQUIRE(a.orientation[k].coeffs() == b.orientation[k].coeffs());
    REQUIRE(first.contacts(i).force == second.contacts(i).force);
  }
  REQUIRE(first.series().columns == second.series().columns);
  REQUIRE(content_of(one / "series.csv") == content_of(two / "series.csv"));
}

/// Kills a run at random moments, `kills` times, and resumes it; the end must be that of an undisturbed run.
void kill_and_resume(const std::string& name, const std::string& scene, int kills) {
  const fs::path folder = fresh_folder(name);
  put(folder / "scene.toml", scene);
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(run(folder, "run scene.toml --threads 1 --out whole").exit_code == 0);
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> part(0.0, 2.0 / kills);
  int killed = 0;
  for (int i = 0; i < kills; ++i) {
    const bool has_checkpoint = fs::exists(folder / "killed" / "checkpoint.bin");
    const auto after = std::chrono::microseconds(static_cast<std::int64_t>(1e6 * part(random) * whole.count()));
    killed += run_and_kill(folder,
                           std::string("run scene.toml --threads 2 --out killed ") +
                               (has_checkpoint ? "--resume" : "--overwrite"),
                           after)
                  ? 1
                  : 0;
  }
  CHECK(killed > kills / 2);
  const bool has_checkpoint = fs::exists(folder / "killed" / "checkpoint.bin");
  const test::Run last = run(
      folder, std::string("run scene.toml --threads 2 --out killed ") + (has_checkpoint ? "--resume" : "--overwrite"));
  INFO(last.err);
  REQUIRE(last.exit_code == 0);
  require_same_results(folder / "whole", folder / "killed");
}

}  // namespace

TEST_CASE("A run killed at random moments and resumed ends bit by bit like one that was not") {
  kill_and_resume("kill", small_scene("60 ms"), 5);
}

TEST_CASE("A run that pours, killed at random moments and resumed, ends bit by bit like one that was not") {
  kill_and_resume("kill_pouring", pouring_scene("60 ms"), 5);
}

TEST_CASE("Results of a pour hold more and more particles, from none, and can be looked at") {
  const fs::path folder = fresh_folder("pour");
  put(folder / "scene.toml", pouring_scene("40 ms"));
  const test::Run check = run(folder, "check scene.toml");
  CHECK_THAT(check.out, Catch::Contains("0, and about 57 poured in"));
  const test::Run done = run(folder, "run scene.toml --out out");
  REQUIRE(done.exit_code == 0);
  const io::ResultsFile file(folder / "out" / "results.h5");
  REQUIRE(file.frame_count() >= 9);
  CHECK(file.frame(0).size() == 0);
  std::size_t before = 0;
  for (std::size_t i = 1; i < file.frame_count(); ++i) {
    const io::ParticleFrame frame = file.frame(i);
    CHECK(frame.size() >= before);
    CHECK(std::is_sorted(frame.id.begin(), frame.id.end()));
    before = frame.size();
  }
  CHECK(before >= 55);  // from none at the start
  const io::NumberTable series = file.series();
  REQUIRE(series.find("particles") != nullptr);
  CHECK(series.find("particles")->back() == static_cast<double>(before));
  CHECK(run(folder, "info out/results.h5").exit_code == 0);
  const test::Run render = run(folder, "render out/results.h5 -o frames --size 200x200");
  INFO(render.err);
  CHECK(render.exit_code == 0);
  CHECK(fs::exists(folder / "frames" / "frame_000000.png"));
  CHECK(run(folder, "export out/results.h5 --paraview run.pvd --ovito run.dump").exit_code == 0);
  CHECK(run(folder, "render out/results.h5 -o none.png --frame 0").exit_code == 2);
}

TEST_CASE("A run killed fifty times ends bit by bit like one that was not", "[.long]") {
  kill_and_resume("kill_often", small_scene("500 ms"), 50);
}

TEST_CASE("A run stopped by a signal says how to go on, and goes on") {
  const fs::path folder = fresh_folder("stop");
  put(folder / "scene.toml", small_scene("10 s"));
  const test::Run stopped =
      run(folder, "law hertz > law.txt; " OSCULATE_PROGRAM
                  " run scene.toml --out out >/dev/null 2> said.txt & pid=$!; sleep 1; kill -INT $pid; wait $pid");
  CHECK(stopped.exit_code == 128 + SIGINT);
  CHECK_THAT(content_of(folder / "said.txt"), Catch::Contains("--resume"));
  CHECK(fs::exists(folder / "out" / "checkpoint.bin"));
}

TEST_CASE("A damaged checkpoint is told and the one before it serves") {
  const fs::path folder = fresh_folder("damaged");
  put(folder / "scene.toml", small_scene("20 ms"));
  REQUIRE(run(folder, "run scene.toml --out whole").exit_code == 0);
  REQUIRE(run(folder, "run scene.toml --out out").exit_code == 0);
  const fs::path newest = folder / "out" / "checkpoint.bin";
  std::string bytes = content_of(newest);
  bytes[bytes.size() / 2] ^= 1;
  put(newest, bytes);
  const test::Run resumed = run(folder, "run scene.toml --out out --resume");
  CHECK(resumed.exit_code == 0);
  CHECK_THAT(resumed.err, Catch::Contains("checkpoint.bin") && Catch::Contains("damaged"));
  require_same_results(folder / "whole", folder / "out");
  // With both damaged there is nothing to go on from; the results stay.
  for (const char* name : {"checkpoint.bin", "checkpoint.earlier.bin"})
    fs::resize_file(folder / "out" / name, fs::file_size(folder / "out" / name) / 2);
  const test::Run refused = run(folder, "run scene.toml --out out --resume");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("no sound checkpoint"));
  require_same_results(folder / "whole", folder / "out");
}

TEST_CASE("Another scene does not go on from a checkpoint, and results are not overwritten by accident") {
  const fs::path folder = fresh_folder("another");
  put(folder / "scene.toml", small_scene("2 ms"));
  REQUIRE(run(folder, "run scene.toml").exit_code == 0);
  const test::Run again = run(folder, "run scene.toml");
  CHECK(again.exit_code == 2);
  CHECK_THAT(again.err, Catch::Contains("--overwrite"));
  put(folder / "scene.toml", small_scene("3 ms"));
  const test::Run other = run(folder, "run scene.toml --resume");
  CHECK(other.exit_code == 2);
  CHECK_THAT(other.err, Catch::Contains("another scene"));
  CHECK(run(folder, "run scene.toml --overwrite").exit_code == 0);
}

TEST_CASE("A full disk ends a run with its reason and leaves the frames before it") {
  const fs::path folder = fresh_folder("full");
  put(folder / "scene.toml", small_scene("60 ms"));
  // A limit on the size of files, met by an error and not by a signal: what a full disk does to a program.
  const test::Run full =
      run(folder, "law hertz > law.txt; trap '' XFSZ; ulimit -f 320; " OSCULATE_PROGRAM " run scene.toml --out out");
  CHECK(full.exit_code == 2);
  CHECK_THAT(full.err, Catch::Contains("out/") && Catch::Contains("File too large"));
  {
    const io::ResultsFile file(folder / "out" / "results.h5");
    CHECK(file.frame_count() >= 1);
    for (std::size_t i = 0; i < file.frame_count(); ++i) CHECK(file.frame(i).size() == 40);
  }
  // With room again, it goes on.
  REQUIRE(run(folder, "run scene.toml --out out --resume").exit_code == 0);
  REQUIRE(run(folder, "run scene.toml --out whole").exit_code == 0);
  require_same_results(folder / "whole", folder / "out");
}

TEST_CASE("A folder that cannot be written to is told before the run") {
  const fs::path folder = fresh_folder("nowhere");
  put(folder / "scene.toml", small_scene("1 ms"));
  const test::Run refused = run(folder, "run scene.toml --out /proc/results");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("/proc/results"));
  put(folder / "file", "");
  CHECK(run(folder, "run scene.toml --out file").exit_code == 2);
}

TEST_CASE("Results are read while another program writes them") {
  const fs::path folder = fresh_folder("reader");
  put(folder / "scene.toml", small_scene("60 ms"));
  const test::Run both = run(folder,
                             "run scene.toml --out out >/dev/null & pid=$!; while kill -0 $pid 2>/dev/null; do "
                             "[ -e out/results.h5 ] && " OSCULATE_PROGRAM
                             " info out/results.h5 >/dev/null 2>>info.txt || true; sleep 0.05; done; wait $pid");
  CHECK(both.exit_code == 0);
  // Before the head is written there is nothing to read; afterwards nothing is wrong.
  for (std::size_t at = 0, end = 0; at < content_of(folder / "info.txt").size(); at = end + 1) {
    const std::string all = content_of(folder / "info.txt");
    end = std::min(all.find('\n', at), all.size());
    CHECK_THAT(all.substr(at, end - at), Catch::Contains("no HDF5"));
  }
  const test::Run info = run(folder, "info out/results.h5");
  CHECK(info.exit_code == 0);
  CHECK_THAT(info.out, Catch::Contains("40") && Catch::Contains("cube") && Catch::Contains("floor"));
}

TEST_CASE("Scenes beyond what can be computed are refused with the body's number") {
  const fs::path folder = fresh_folder("overload");
  const auto single = [](const std::string& position, const std::string& velocity) {
    return "[[insert]]\nhow = \"single\"\nparticles = \"cube\"\nposition = " + position + "\nvelocity = " + velocity +
           "\n";
  };
  SECTION("two bodies overlap by half a radius from the start") {
    put(folder / "scene.toml",
        small_scene("1 ms", single("[10, 10, 70]", "[0, 0, 0]") + single("[10, 10, 73]", "[0, 0, 0]")));
    for (const char* command : {"check scene.toml", "run scene.toml"}) {
      const test::Run refused = run(folder, command);
      CHECK(refused.exit_code == 2);
      CHECK_THAT(refused.err, Catch::Contains("bodies 45 and 46 overlap"));
    }
    CHECK_FALSE(fs::exists(folder / "scene" / "results.h5"));
  }
  SECTION("a body crosses another one in one step") {
    put(folder / "scene.toml",
        small_scene("1 ms\"\nspeed = 1\nstep = \"15 us", single("[10, 10, 80]", "[0, 0, 1000]")));
    const test::Run refused = run(folder, "run scene.toml");
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Catch::Contains("body 45 moved"));
  }
}

TEST_CASE("Every example scene passes its check and runs") {
  const fs::path folder = fresh_folder("examples");
  int count = 0;
  const fs::directory_iterator scenes(OSCULATE_EXAMPLES_DIR "/scenes");
  const std::vector<fs::directory_entry> files(begin(scenes), end(scenes));
  for (const auto& entry : files)  // what scenes read stands beside them
    if (entry.path().extension() != ".toml") fs::copy_file(entry.path(), folder / entry.path().filename());
  for (const auto& entry : files) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    INFO(entry.path());
    const test::Run check = run(folder, "check " + entry.path().string());
    if (!OSCULATE_TEST_WITH_CGAL && entry.path().stem() == "ballast-box") {  // its shapes are convex hulls of files
      CHECK(check.exit_code == 2);
      CHECK_THAT(check.err, Catch::Contains("OSCULATE_WITH_CGAL=ON"));
      continue;
    }
    CHECK(check.exit_code == 0);
    CHECK_THAT(check.out, Catch::Contains("time step"));
    CHECK_THAT(check.out, !Catch::Contains("warning"));
    // The same for a hundred steps. The step depends neither on the duration nor on the output.
    const double step = io::read_scene(entry.path()).setup.time_step;
    std::string text = content_of(entry.path());
    const auto set = [&](const std::string& key, double value) {
      const std::size_t at = text.find("\n" + key + " = ") + 1;
      text.replace(at, text.find('\n', at) - at, key + " = " + std::to_string(1e9 * value) + "e-9");
    };
    set("duration", 100.0 * step);
    set("interval", 50.0 * step);
    put(folder / "short.toml", text);
    const test::Run shortened = run(folder, "run short.toml --overwrite");
    INFO(shortened.err);
    CHECK(shortened.exit_code == 0);
    const io::ResultsFile file(folder / "short" / "results.h5");
    CHECK(file.frame_count() == 3);
    CHECK(file.series().columns[1].back() == 100.0);
  }
  CHECK(count >= 8);
}

TEST_CASE("Without osculate-lammps, --engine lammps says what to install and how to build it") {
  const auto folder = fresh_folder("no_lammps");
  put(folder / "scene.toml", small_scene("1 ms"));
  // A copy with nothing beside it.
  fs::copy_file(OSCULATE_PROGRAM, folder / "osculate");
  const std::string command =
      "cd '" + folder.string() + "' && PATH=/none ./osculate run scene.toml --engine lammps 2>stderr.txt >stdout.txt";
  const int status = std::system(command.c_str());
  CHECK(WEXITSTATUS(status) == 2);
  const std::string said = content_of(folder / "stderr.txt");
  INFO(said);
  CHECK(said.find("found no program osculate-lammps") != std::string::npos);
  CHECK(said.find("-DOSCULATE_WITH_LAMMPS=ON") != std::string::npos);
  CHECK(said.find("liblammps-dev") != std::string::npos);
  CHECK_FALSE(fs::exists(folder / "scene"));
}

TEST_CASE("The engine lammps refuses what only the embedded engine does") {
  const auto folder = fresh_folder("lammps_options");
  put(folder / "scene.toml", small_scene("1 ms"));
  for (const std::string option : {"--resume", "--threads 2"}) {
    const auto refused = run(folder, "run scene.toml --engine lammps " + option);
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find(option.substr(0, option.find(' '))) != std::string::npos);
  }
  CHECK(run(folder, "run scene.toml --engine gromacs").exit_code != 0);
}

}  // namespace osculate::app
