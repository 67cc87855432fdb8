#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace {

using Catch::Contains;
using osculate::test::content_of;
using osculate::test::fresh_folder;
using osculate::test::run;

const std::string small_sweep = "study curvature --exponent 4 --aspect 2 --overlap 1e-3 1e-2 --orientations 20 ";

}  // namespace

TEST_CASE("The curvature study prints its tables and writes every contact and a picture") {
  const auto folder = fresh_folder("study");
  const auto result = run(folder, small_sweep + "--out here");
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.out, Contains("Force, by the model of curvature") && Contains("Area of contact") &&
                             Contains("Geometric potential against common normal"));
  const std::string csv = content_of(folder / "here" / "curvature.csv");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 2 * 20);
  CHECK(content_of(folder / "here" / "curvature.h5").substr(1, 3) == "HDF");
  CHECK(content_of(folder / "here" / "curvature.png").substr(1, 3) == "PNG");
  CHECK_THAT(content_of(folder / "here" / "curvature.svg"), Contains("exponent n"));
}

TEST_CASE("The curvature study is the same each time, as CSV and as JSON") {
  const auto folder = fresh_folder("study_again");
  const auto first = run(folder, small_sweep + "--csv"), second = run(folder, small_sweep + "--csv");
  REQUIRE(first.exit_code == 0);
  CHECK(first.out == second.out);
  const auto json = nlohmann::json::parse(run(folder, small_sweep + "--json").out);
  CHECK(json.at("gaussian_force_error").size() == 40);
  CHECK(json.at("exact_force_error").at(7).get<double>() == Approx(0.0).margin(1e-14));  // rounding
}

TEST_CASE("The curvature study refuses what makes no sense") {
  const auto result = run(fresh_folder("study_refused"), "study curvature --exponent 0.5");
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Contains("exponent 0.5") && Contains("(1, 64]"));
}
