#include "io/plot.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "io/plot_layout.hpp"
#include "osculate/core/error.hpp"
#include "temporary.hpp"

using namespace osculate;
using Catch::Matchers::Contains;
using osculate::test::temporary;

namespace {

io::Curve line(double from, double to) {
  io::Curve curve{.name = "curve", .x = {}, .y = {}};
  for (int i = 0; i <= 10; ++i) {
    curve.x.push_back(i);
    curve.y.push_back(from + (to - from) * i / 10.0);
  }
  return curve;
}

io::Panel panel_of(std::vector<io::Curve> curves) {
  return {.title = "A panel", .x = {.label = "δ [µm]"}, .y = {.label = "F [N]"}, .curves = std::move(curves)};
}

io::Plot plot_of(io::Panel panel) {
  return {.title = "A plot", .panels = {std::move(panel)}};
}

std::filesystem::path scratch(const char* name) {
  return temporary(name);
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What a reader of the SVG sees: its text without the tags.
std::string seen(const std::string& svg) {
  std::string text;
  bool in_tag = false;
  for (const char c : svg) {
    if (c == '<') in_tag = true;
    if (!in_tag) text += c;
    if (c == '>') in_tag = false;
  }
  return text;
}

constexpr io::LegendSize small{0.3, 0.2};

io::Legend legend_of(const io::Panel& panel, const io::LegendSize& size = small) {
  return place_legend(panel, ranges(panel), size);
}

}  // namespace

TEST_CASE("A plot is written as SVG with its texts, and as PNG") {
  io::Panel panel = panel_of({line(0, 1), line(1, 0)});
  panel.curves[0].name = "F_{n} of a_key & <b>";
  const io::Plot plot = plot_of(panel);
  const auto svg = scratch("plot.svg"), png = scratch("plot.png");
  write_plot(plot, svg);
  write_plot(plot, png);
  const std::string drawn = seen(content(svg));
  CHECK_THAT(drawn, Contains("A plot") && Contains("A panel") && Contains("δ [µm]") && Contains("F [N]"));
  CHECK_THAT(drawn, Contains("Fn of a_key &amp; &lt;b"));  // lowered n, all else literal
  CHECK(content(png).substr(1, 3) == "PNG");
  std::filesystem::remove(svg);
  std::filesystem::remove(png);
}

TEST_CASE("Two plots on one page share no identifier") {
  const io::Plot plot = plot_of(panel_of({line(0, 1)}));
  const std::string one = svg_of(plot, "one"), two = svg_of(plot, "two");
  CHECK(one.rfind("<svg", 0) == 0);
  std::size_t found = 0;
  for (std::size_t at = one.find("id=\""); at != std::string::npos; at = one.find("id=\"", at + 1)) {
    const std::string id = one.substr(at, one.find('"', at + 4) - at + 1);
    CHECK(two.find(id) == std::string::npos);
    ++found;
  }
  CHECK(found > 0);
}

TEST_CASE("The legend takes a corner that the curves leave free, or goes below") {
  CHECK(legend_of(panel_of({line(0, 1)})) == io::Legend::top_left);
  CHECK(legend_of(panel_of({line(1, 0)})) == io::Legend::top_right);
  CHECK(legend_of(panel_of({line(1, 0), line(1, 1)})) == io::Legend::bottom_left);
  CHECK(legend_of(panel_of({line(0, 0), line(1, 1)})) == io::Legend::below);
  CHECK(legend_of(panel_of({line(0, 1)}), {0.95, 0.1}) == io::Legend::below);
  io::Panel nameless = panel_of({line(0, 1)});
  nameless.curves[0].name.clear();
  CHECK(legend_of(nameless) == io::Legend::none);
}

TEST_CASE("A plot that cannot be drawn is refused by panel and curve") {
  io::Panel panel = panel_of({line(0, 1)});
  const auto refusal = [&] {
    try {
      validate(plot_of(panel));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK(refusal() == "accepted");
  panel.y.scale = io::Scale::logarithmic;
  CHECK_THAT(refusal(), Contains("A panel") && Contains("curve 'curve', y") && Contains("logarithmic"));
  panel.y.scale = io::Scale::linear;
  panel.curves[0].y[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(refusal(), Contains("nan") && Contains("finite"));
  panel.curves[0].y.pop_back();
  CHECK_THAT(refusal(), Contains("11 x and 10 y"));
  panel.curves.clear();
  CHECK_THAT(refusal(), Contains("no curve"));
  CHECK_THROWS_WITH(write_plot(plot_of(panel_of({line(0, 1)})), "plot.gif"), Contains(".svg or .png"));
}

TEST_CASE("Without gnuplot the message says what to install") {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  CHECK_THROWS_WITH(svg_of(plot_of(panel_of({line(0, 1)})), "x"), Contains("gnuplot-nox"));
  ::setenv("PATH", path.c_str(), 1);
}
