#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace {

using Catch::Contains;
using nlohmann::json;
using osculate::test::content_of;
using osculate::test::fresh_folder;
using osculate::test::run;

const std::string examples = OSCULATE_EXAMPLES_DIR "/contacts/";

std::string block_on_floor(const std::string& first_line, const std::string& height) {
  return first_line +
         "\n[body_1]\nshape = {kind = \"superquadric\", unit = \"mm\", half_axes = [3, 2, 1], n = [4, 4]}\n"
         "position = [0, 0, \"" +
         height +
         " mm\"]\nmaterial = \"steel\"\n"
         "[body_2]\nshape = {kind = \"half_space\"}\nmaterial = \"steel\"\n";
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

}  // namespace

TEST_CASE("Two spheres meet with the force of Hertz in closed form") {
  const auto result = run(fresh_folder("contact"), "contact " + examples + "two-glass-beads.toml --json");
  REQUIRE(result.exit_code == 0);
  const json report = json::parse(result.out);
  const double radius = 1.59e-3, overlap = 2 * radius - 3.177e-3;
  const double modulus = 71e9 / (2 * (1 - 0.22 * 0.22));
  CHECK(report["status"] == "touching");
  // The overlap is the difference of lengths 1000 times larger: three digits of sixteen are lost.
  CHECK(report["overlap"].get<double>() == Approx(overlap).epsilon(1e-12));
  CHECK(report["hertz"]["force"].get<double>() ==
        Approx(4.0 / 3.0 * modulus * std::sqrt(radius / 2) * std::pow(overlap, 1.5)).epsilon(1e-12));
  CHECK(report["hertz"]["a_c"].get<double>() == Approx(std::sqrt(radius / 2 * overlap)).epsilon(1e-12));
  CHECK(report["hertz"]["gamma"].get<double>() == Approx(std::sqrt(2.0)).epsilon(1e-14));
  for (const json& model : report["models"]) CHECK(std::fabs(model["error"].get<double>()) < 1e-12);
  CHECK(report["models"].size() == 4);
}

TEST_CASE("Every example is a valid contact and prints its blocks") {
  for (const auto& entry : std::filesystem::directory_iterator(examples)) {
    INFO(entry.path());
    const auto result = run(fresh_folder("examples"), "contact " + entry.path().string());
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    for (const std::string part : {"touching", "overlap δ", "Principal curvatures", "R_i, along the major axis",
                                   "force F", "a_c/R_min", "volume-equivalent sphere"})
      CHECK_THAT(result.out, Contains(part));
    CHECK_THAT(result.out, Contains("validity") && Contains("   a_c/R_min") && !Contains("large contact"));
  }
}

TEST_CASE("A flat contact has no force without a cap, and says that it was capped with one") {
  const auto folder = fresh_folder("flat");
  write(folder / "flat.toml", block_on_floor("", "0.999"));
  const auto flat = run(folder, "contact flat.toml");
  CHECK(flat.exit_code == 0);
  CHECK_THAT(flat.out, Contains("R_i = ∞") && Contains("radius_cap"));
  const json report = json::parse(run(folder, "contact flat.toml --json").out);
  CHECK(report["relative"]["R_i"] == "inf");
  CHECK(report["hertz"].is_null());

  write(folder / "capped.toml", block_on_floor("radius_cap = 10", "0.999"));
  CHECK_THAT(run(folder, "contact capped.toml").out, Contains("capped at 10 R_vol") && Contains("force F"));
}

TEST_CASE("Bodies apart have a gap and no force") {
  const auto folder = fresh_folder("apart");
  write(folder / "apart.toml", block_on_floor("", "1.5"));
  const auto result = run(folder, "contact apart.toml");
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.out, Contains("separated") && Contains("500.000 µm") && Contains("No force: the bodies are apart"));
}

TEST_CASE("A picture of a contact is a PNG file") {
  const auto folder = fresh_folder("picture");
  REQUIRE(run(folder, "contact " + examples + "rice-on-floor.toml --picture rice.png").exit_code == 0);
  const std::string picture = content_of(folder / "rice.png");
  CHECK(picture.starts_with("\x89PNG"));
  CHECK(picture.size() > 10000);
}

TEST_CASE("Wrong input is exit code 2 and one line that says what is wrong where") {
  const auto folder = fresh_folder("wrong");
  const auto error = [&](const std::string& text) {
    write(folder / "bad.toml", text);
    const auto result = run(folder, "contact bad.toml");
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    return result.err;
  };
  CHECK_THAT(error(block_on_floor("radius_cup = 10", "1")), Contains("bad.toml:1") && Contains("radius_cap"));
  CHECK_THAT(error(block_on_floor("radius_cap = -1", "1")), Contains("bad.toml:1") && Contains("positive"));
  CHECK_THAT(error("[body_1\n"), Contains("bad.toml:1"));
  CHECK_THAT(error(block_on_floor("", "1 km")), Contains("bad.toml:4"));
  CHECK_THAT(run(folder, "contact none.toml").err, Contains("none.toml"));
  CHECK(run(folder, "contact none.toml").exit_code == 2);
  CHECK(run(folder, "contact " + examples + "two-glass-beads.toml --picture no/folder.png").exit_code == 2);
}

TEST_CASE("The help teaches: commands, examples, keys and columns") {
  const auto folder = fresh_folder("help");
  const auto help = run(folder, "--help");
  CHECK(help.exit_code == 0);
  CHECK_THAT(help.out, Contains("common normal") && Contains("osculate contact") && Contains("osculate bench narrow") &&
                           Contains("osculate shape") && Contains("Exit codes"));
  const auto contact = run(folder, "contact --help");
  CHECK_THAT(contact.out, Contains("radius_cap") && Contains("youngs_modulus") && Contains("a1,b1,c1,n1_1,n2_1") &&
                              Contains("status,nx,ny,nz,depth"));
  CHECK_THAT(run(folder, "bench narrow --help").out, Contains("osculate bench narrow --json"));
  CHECK(run(folder, "contcat").exit_code != 0);
}

TEST_CASE("The narrow-phase benchmark reports every quantity as JSON") {
  const auto result =
      run(fresh_folder("bench"), "bench narrow --class ellipsoid --class general --pairs 64 --repetitions 3 --json");
  REQUIRE(result.exit_code == 0);
  const json report = json::parse(result.out);
  CHECK(report["instruction_set"].is_string());
  CHECK(report["hertz_batched"]["median_ns"] > 0.0);
  REQUIRE(report["classes"].size() == 2);
  for (const json& one : report["classes"])
    for (const char* key :
         {"warm_batched", "warm_scalar", "cold_batched", "cold_scalar", "separated_batched", "separated_scalar", "ccd"})
      CHECK(one[key]["median_ns"] > 0.0);
  CHECK_THAT(run(fresh_folder("bench"), "bench narrow --class elipsoid").err, Contains("ellipsoid"));
}

TEST_CASE("The benchmark of scenes keeps settled states and finds them again") {
  const auto folder = fresh_folder("bench-scenes");
  const std::string few = "bench scenes --scene blocky --particles 8 --repetitions 3 --settled states --json";
  const auto first = run(folder, few);
  REQUIRE(first.exit_code == 0);
  const auto state = folder / "states/blocky-8/checkpoint.bin";
  REQUIRE(std::filesystem::exists(state));
  const std::string kept = content_of(state);
  const auto again = run(folder, few);
  REQUIRE(again.exit_code == 0);
  CHECK(content_of(state) == kept);
  for (const auto& result : {first, again}) {
    const json scene = json::parse(result.out)["scenes"][0];
    CHECK(scene["particles"] == 8);
    CHECK(scene["step"]["median_ns"] > 0.0);
    CHECK(scene["bytes_per_particle"] > 0.0);
    CHECK(scene["missed"] == 0);
  }
  const auto other = run(folder, few + " --tangential mindlin");
  CHECK(other.exit_code == 2);
  CHECK(other.out.empty());
  CHECK_THAT(other.err, Contains("blocky-8") && Contains("another scene") && Contains("mindlin"));
  CHECK(content_of(state) == kept);
  write(state, kept.substr(0, kept.size() / 2));
  const auto damaged = run(folder, few);
  CHECK(damaged.exit_code == 2);
  CHECK_THAT(damaged.err, Contains("blocky-8") && Contains("checksum") && Contains("folder without any"));
  CHECK(content_of(state).size() == kept.size() / 2);
}
