#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace {

using Catch::Contains;
using osculate::test::content_of;
using osculate::test::fresh_folder;
using osculate::test::run;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("The review writes every figure as SVG, PNG and CSV, and the tables") {
  const auto folder = fresh_folder("review_out");
  const auto result = run(folder, "review --out here/below");
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  const auto below = folder / "here" / "below";
  for (const std::string name : {"fig2", "fig4", "fig6", "fig7", "fig8", "fig12", "fig13", "fig14"}) {
    INFO(name);
    CHECK_THAT(content_of(below / (name + ".svg")), Contains("</svg>"));
    CHECK(content_of(below / (name + ".png")).substr(1, 3) == "PNG");
    CHECK(count(content_of(below / (name + ".csv")), "\n") > 100);
  }
  for (const std::string name : {"table1", "table2", "table3", "table4", "table5", "table6"})
    CHECK_FALSE(content_of(below / (name + ".txt")).empty());
  CHECK(content_of(below / "figures.h5").substr(1, 3) == "HDF");
}

TEST_CASE("The review's page stands alone: tables, figures, errata and numbers without another file") {
  const auto folder = fresh_folder("review_page");
  REQUIRE(run(folder, "review --html .").exit_code == 0);
  const std::string page = content_of(folder / "index.html");
  CHECK(count(page, "<svg") == 8);
  CHECK(count(page, "href=\"data:text/csv;base64,") == 8);
  CHECK(count(page, "href=\"data:application/x-hdf5;base64,iUhERg0K") == 1);  // "\x89HDF\r\n"
  CHECK_THAT(page, Contains("Errata of the sources") && Contains("1.5911") && Contains("hertz::force"));
  CHECK(count(page, "src=") == 0);
  CHECK(count(page, "href=\"http") == 0);
  for (const auto* element : {"table", "tr", "figure", "svg", "section", "div"}) {
    INFO(element);
    CHECK(count(page, std::string("<") + element + ">") + count(page, std::string("<") + element + " ") ==
          count(page, std::string("</") + element + ">"));
  }
}

TEST_CASE("The review as JSON has every table and figure") {
  const auto result = run(fresh_folder("review_json"), "review --json");
  REQUIRE(result.exit_code == 0);
  const auto report = nlohmann::json::parse(result.out);
  CHECK(report.size() == 14);
  CHECK(report.at("table4").at("rows").at(0).at(1) == "hertz");
  CHECK_THAT(report.at("fig6").at("caption").get<std::string>(), Contains("JKR"));
}

TEST_CASE("A folder that cannot be made is refused with the reason") {
  const auto folder = fresh_folder("review_refused");
  std::ofstream(folder / "file") << "in the way";
  const auto result = run(folder, "review --out file/below");
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Contains("file/below") && Contains("Not a directory"));
}
