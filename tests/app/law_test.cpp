#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "app/program.hpp"

namespace {

using Catch::Contains;
using nlohmann::json;
using osculate::test::content_of;
using osculate::test::fresh_folder;
using osculate::test::run;

json rows_of(const std::string& arguments) {
  const auto result = run(fresh_folder("law"), "law " + arguments + " --json");
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return json::parse(result.out)["rows"];
}

void refused(const std::string& arguments, const std::string& reason) {
  const auto result = run(fresh_folder("law_refused"), "law " + arguments);
  INFO(arguments);
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Contains(reason));
}

}  // namespace

TEST_CASE("Every law is listed, and each explains itself") {
  const auto folder = fresh_folder("law_list");
  const auto text = run(folder, "law");
  REQUIRE(text.exit_code == 0);
  const json all = json::parse(run(folder, "law --json").out);
  REQUIRE(all.size() > 20);
  for (const json& law : all) {
    const auto name = law["name"].get<std::string>();
    INFO(name);
    CHECK_THAT(text.out, Contains(name));
    const auto one = run(folder, "law " + name);
    CHECK(one.exit_code == 0);
    CHECK_THAT(one.out, Contains(law["formula"].get<std::string>()));
    for (const json& parameter : law["parameters"])
      CHECK_THAT(one.out,
                 Contains(parameter["name"].get<std::string>()) && Contains(parameter["range"].get<std::string>()));
  }
}

TEST_CASE("A law evaluated at a state says what the theory's closed form says") {
  const json hertz = rows_of("hertz --set R_i=1e-3 R_j=1e-3 overlap=2e-6")[0];
  const double modulus = 71e9 / (2.0 * (1.0 - 0.22 * 0.22));
  const double force = 4.0 / 3.0 * modulus * std::sqrt(1e-3) * std::pow(2e-6, 1.5);
  CHECK(hertz["normal_force"].get<double>() == Approx(force).epsilon(1e-12));
  CHECK(hertz["a_c"].get<double>() == Approx(std::sqrt(2e-9)).epsilon(1e-12));

  // Beyond sliding the tangential force is μF_n.
  const json sliding = rows_of("mindlin --set friction=0.3 R_i=1e-3 R_j=1e-3 x=1e-5 overlap=2e-6")[0];
  CHECK(sliding["tangential_x"].get<double>() == Approx(0.3 * force).epsilon(1e-12));
}

TEST_CASE("A swept overlap is a path, a swept parameter a row of contacts") {
  const json path = rows_of("jkr --set work_of_adhesion=0.05 --sweep overlap=1e-7:-1e-8:23");
  REQUIRE(path.size() == 23);
  CHECK(path[20]["normal_force"].get<double>() < 0.0);  // at δ = 0 the contact made before still holds
  const json works = rows_of("jkr --set overlap=1e-7 --sweep work_of_adhesion=0.01:1:3:log");
  CHECK(works[1]["work_of_adhesion"].get<double>() == Approx(0.1).epsilon(1e-12));
  CHECK(works[2]["normal_force"].get<double>() < works[0]["normal_force"].get<double>());
}

TEST_CASE("A load path is followed with memory, and written as it was asked for") {
  const auto folder = fresh_folder("law_path");
  std::ofstream(folder / "load.csv") << "time,overlap,x\n0,1e-6,0\n1e-5,1e-6,2e-7\n2e-5,1e-6,0\n";
  const auto result = run(folder, "law mindlin --set friction=0.3 --path load.csv --csv out.csv --picture loop.svg");
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.empty());
  const std::string csv = content_of(folder / "out.csv");
  CHECK_THAT(csv, Contains("time,overlap,x,normal_force,tangential_x"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 4);
  CHECK_THAT(content_of(folder / "loop.svg"), Contains("tangential force") && Contains("<svg"));
  const auto again = run(folder, "law mindlin --set friction=0.3 --path load.csv --json");
  const json rows = json::parse(again.out)["rows"];
  // Back at no displacement the force has turned round, and something has been lost.
  CHECK(rows[1]["tangential_x"].get<double>() > 0.0);
  CHECK(rows[2]["tangential_x"].get<double>() < 0.0);
  CHECK(rows[2]["friction_loss"].get<double>() > rows[1]["friction_loss"].get<double>());
}

TEST_CASE("A theory that no time step takes is evaluated like a law, and refused as one") {
  const auto folder = fresh_folder("law_study");
  const json swept = rows_of("polygon_energy --set coefficient=1e5 y=0 turn=0 --sweep x=1.9e-3:2.1e-3:3");
  REQUIRE(swept.size() == 3);
  CHECK(swept[0]["force_x"].get<double>() == Approx(10.0).epsilon(1e-10));
  CHECK(swept[2]["force_x"].get<double>() == 0.0);
  std::ofstream(folder / "states.csv") << "x,turn\n1.9e-3,0\n1.5e-3,0.7\n";
  const auto result = run(folder,
                          "law polygon_energy --set polygon_energy.coefficient=1e5 y=0 --path states.csv --csv out.csv "
                          "--picture turned.svg");
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.empty());
  const std::string csv = content_of(folder / "out.csv");
  CHECK_THAT(csv, Contains("x,turn,force_x,force_y,moment_1,moment_2,area,energy"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 3);
  CHECK_THAT(content_of(folder / "turned.svg"), Contains("polygons") && Contains("<svg"));

  refused("polygon_energy --set coefficient=1e5 --with mindlin", "two dimensions");
  refused("hertz --with jeng_wang --set overlap=1e-6", "unloading");
  refused("jeng_wang --sweep h=0:1:3", "density");
  refused("polygon_energy --set coefficient=1e5 --sweep z=0:1:3", "one of coefficient");
}

TEST_CASE("What makes no sense to the law command is refused with what was expected") {
  refused("herz", "hertz");
  refused("hertz --set R_i", "key=value");
  refused("hertz --set R_k=1", "R_i");
  refused("hertz --set R_i=big", "finite number");
  refused("hertz --set R_j=-1e-3", "R_j > 0");
  refused("mindlin --set overlap=1e-6", "friction coefficient");
  refused("mindlin --set friction=-0.1", ">= 0");
  refused("twisting --set friction=0.3 nu=0.5", "Poisson");
  refused(
      "jkr --with jamari_schipper --set work_of_adhesion=0.1 hardness=2e9 yield_factor=0.6 plastic_factor=0.9 "
      "area_ratio=120",
      "peels");
  refused("hertz --sweep R_i=1:2", "key=from:to:n");
  refused("hertz --sweep overlap=0:1e-6:5:log", "logarithmic");
  refused("hertz --sweep overlap=0:1e-6:1", "n from 2");
  refused("--set friction=0.3", "the name of one");
  refused("hertz --path missing.csv", "missing.csv");
}
