#include "app/validate_flow.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "io/plot.hpp"
#include "io/progress.hpp"
#include "io/table.hpp"
#include "validation/flow/flow_study.hpp"

namespace osculate::app {
namespace {

using validation::DischargeSeries;
using validation::FlowSettings;
using validation::FlowStudy;
using validation::HeapSeries;
namespace expected = validation::expected;

constexpr const char* help =
    R"(Hopper: ellipsoids 3 : 3 : 2 mm, friction 0.3; a bin 78 mm wide and 20 mm deep above a wedge of 60 degrees; its upright
walls have no friction, so that the slot is as if it went on behind them. W is taken from when a tenth has left, until
the filling is no higher above the slot than the bin is wide: later it feels that the hopper runs empty. Errors are those
of the mean of four parts of that time, or of the mean of several hoppers where these differ by more.
Heaps: superquadrics of half axes 2 : 2 : 3 mm and of the exponent n, sizes spread by a tenth, on a floor of the same
friction. The angle is that of the cone with the same medians of height and of distance from the axis.
Grains are softer than real ones, 1 MPa: that allows a longer time step.
Examples:
  osculate validate flow --picture flow.png
  osculate validate flow --particles 2400 --hoppers 4 --heaps 8 --json > flow.json)";

constexpr const char* about_discharge =
    R"(Discharge of {} ellipsoids from a wedge hopper through a slot of width D: W = C ρ_b √g L (D − k d)^(3/2) [BLV61],
d = {:.2f} mm the diameter of the sphere of equal volume; mean of {}. Grains at rest overlap by {:.1f} % of d on average.

{}
{}
The exponent depends on the k that one takes: with another one of 1 to 2 the law itself has {:g} to {:g} here.
Values of k that are commonly quoted are mostly those of flat bottoms.

)";

constexpr const char* about_heaps =
    R"(Angle of the heap of 300 superquadrics that a lifted tube leaves, mean of {}. It rises with friction [ZXYZ01], and
with blockiness.

)";

struct Options {
  FlowSettings settings;
  bool csv = false;
  bool json = false;
  std::string picture;
};

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

std::string with_error(double value, double error, int digits) {
  return fmt::format("{:.{}f} ± {:.{}f}", value, digits, error, digits);
}

void print_discharge(const DischargeSeries& series, const FlowSettings& settings) {
  io::Table rates{{"slot D [mm]", "D / d", "W [kg/s]", "Beverloo [kg/s]"}, {}, 0};
  for (std::size_t i = 0; i < series.widths.size(); ++i)
    rates.rows.push_back(
        {fmt::format("{:g}", 1e3 * series.widths[i]), fmt::format("{:.2f}", series.widths[i] / series.diameter),
         with_error(series.discharges[i].rate, series.discharges[i].error, 4),
         fmt::format("{:.4f}", validation::beverloo_rate(series.fit, series.diameter, series.widths[i]))});
  const validation::Discharge ratio = series.gravity_ratio();
  const auto verdict = [](bool agrees) { return agrees ? "agrees" : "DIFFERS"; };
  const io::Table trends{
      {"trend", "expected", "found", "verdict"},
      {{"exponent of D − 1.4 d", fmt::format("1.5: {:g} – {:g}", expected::least_exponent, expected::most_exponent),
        with_error(series.fit.exponent, series.fit.exponent_error, 2), verdict(series.exponent_agrees())},
       {"k of the line of W^(2/3) over D", fmt::format("{:g} – {:g}", expected::least_k, expected::most_k),
        with_error(series.fit.k, series.fit.k_error, 2), verdict(series.k_agrees())},
       {"correlation along that line", fmt::format("above {:g}", expected::least_correlation),
        fmt::format("{:.4f}", series.fit.correlation), verdict(series.is_straight())},
       {"W at a quarter of the gravity, over W",
        fmt::format("{:g} ± {:g}", expected::gravity_ratio, expected::gravity_tolerance),
        with_error(ratio.rate, ratio.error, 3), verdict(series.gravity_agrees())}},
      1};
  fmt::print(fmt::runtime(about_discharge), settings.particles, 1e3 * series.diameter, settings.hoppers,
             100.0 * series.overlap / series.diameter, io::to_text(rates), io::to_text(trends),
             expected::least_exponent, expected::most_exponent);
}

void print_heaps(const HeapSeries& series) {
  io::Table table{{series.name, "angle [°]"}, {}, 0};
  for (std::size_t i = 0; i < series.values.size(); ++i)
    table.rows.push_back({fmt::format("{:g}", series.values[i]),
                          with_error(degrees(series.angles[i].mean), degrees(series.angles[i].error), 1)});
  fmt::print("{}rises: {}\n\n", io::to_text(table), series.rises() ? "yes" : "NO");
}

void print_text(const FlowStudy& study, const FlowSettings& settings) {
  print_discharge(study.discharge, settings);
  fmt::print(fmt::runtime(about_heaps), settings.heaps);
  for (const HeapSeries& series : study.heaps) print_heaps(series);
}

void print_csv(const FlowStudy& study) {
  fmt::print("series,x,value,standard_error\n");
  const DischargeSeries& discharge = study.discharge;
  for (std::size_t i = 0; i < discharge.widths.size(); ++i)
    fmt::print("discharge [kg/s] over slot [m],{:.17g},{:.17g},{:.17g}\n", discharge.widths[i],
               discharge.discharges[i].rate, discharge.discharges[i].error);
  for (const HeapSeries& series : study.heaps)
    for (std::size_t i = 0; i < series.values.size(); ++i)
      fmt::print("angle of repose [rad] over {},{:.17g},{:.17g},{:.17g}\n", series.name, series.values[i],
                 series.angles[i].mean, series.angles[i].error);
}

void print_json(const FlowStudy& study) {
  using Json = nlohmann::ordered_json;
  const DischargeSeries& discharge = study.discharge;
  const auto json_of = [](double value, double error) { return Json{{"value", value}, {"standard_error", error}}; };
  const validation::Discharge ratio = discharge.gravity_ratio();
  Json report{{"discharge",
               {{"diameter_m", discharge.diameter},
                {"width_m", discharge.widths},
                {"rate_kg_s", Json::array()},
                {"exponent", json_of(discharge.fit.exponent, discharge.fit.exponent_error)},
                {"k", json_of(discharge.fit.k, discharge.fit.k_error)},
                {"correlation", discharge.fit.correlation},
                {"gravity_ratio", json_of(ratio.rate, ratio.error)},
                {"overlap_m", discharge.overlap},
                {"agrees", discharge.agrees()}}},
              {"heaps", Json::array()}};
  for (const validation::Discharge& one : discharge.discharges)
    report["discharge"]["rate_kg_s"].push_back(json_of(one.rate, one.error));
  for (const HeapSeries& series : study.heaps) {
    Json angles = Json::array();
    for (const validation::HeapAngle& angle : series.angles) angles.push_back(json_of(angle.mean, angle.error));
    report["heaps"].push_back(
        {{"over", series.name}, {"values", series.values}, {"angle_rad", angles}, {"rises", series.rises()}});
  }
  fmt::print("{}\n", report.dump(2));
}

/// A bar from one standard error below a value to one above.
io::Curve error_bar(double x, double value, double error, io::Colour colour) {
  return {.name = "", .x = {x, x}, .y = {value - error, value + error}, .colour = colour};
}

io::Panel discharge_panel(const DischargeSeries& series) {
  io::Panel panel{.title = "Discharge of a hopper",
                  .x = {.label = "slot D [mm]", .range = io::PlotRange{0.0, 1e3 * series.widths.back() + 2.0}},
                  .y = {.label = "W [kg/s]"},
                  .curves = {}};
  io::Curve law{
      .name = fmt::format("Beverloo, k = {:.2f}", series.fit.k), .x = {}, .y = {}, .colour = io::palette::orange};
  const double zero = std::max(series.fit.k, 0.0) * series.diameter;
  constexpr int points = 60;
  for (int i = 0; i <= points; ++i) {
    const double width = zero + (series.widths.back() - zero) * i / points;
    law.x.push_back(1e3 * width);
    law.y.push_back(validation::beverloo_rate(series.fit, series.diameter, width));
  }
  panel.curves.push_back(law);
  io::Curve engine{.name = "engine", .x = {}, .y = {}, .mark = io::Mark::points, .colour = io::palette::blue};
  for (std::size_t i = 0; i < series.widths.size(); ++i) {
    const validation::Discharge& one = series.discharges[i];
    engine.x.push_back(1e3 * series.widths[i]);
    engine.y.push_back(one.rate);
    panel.curves.push_back(error_bar(engine.x.back(), one.rate, one.error, io::palette::blue));
  }
  panel.curves.push_back(engine);
  return panel;
}

io::Panel heap_panel(const HeapSeries& series) {
  io::Panel panel{.title = "Angle of repose", .x = {.label = series.name}, .y = {.label = "angle [°]"}, .curves = {}};
  std::vector<double> angles;
  for (std::size_t i = 0; i < series.values.size(); ++i) {
    const double angle = degrees(series.angles[i].mean);
    angles.push_back(angle);
    panel.curves.push_back(error_bar(series.values[i], angle, degrees(series.angles[i].error), io::palette::blue));
  }
  panel.y.range = io::PlotRange{0.0, 1.4 * *std::max_element(angles.begin(), angles.end())};
  panel.curves.push_back({.name = "", .x = series.values, .y = angles, .colour = io::palette::blue});
  panel.curves.push_back(
      {.name = "", .x = series.values, .y = angles, .mark = io::Mark::points, .colour = io::palette::blue});
  return panel;
}

void draw(const FlowStudy& study, const std::string& path) {
  io::Plot plot{.title = "", .panels = {discharge_panel(study.discharge)}, .columns = 3};
  for (const HeapSeries& series : study.heaps) plot.panels.push_back(heap_panel(series));
  io::write_plot(plot, path);
}

void run(const Options& options) {
  FlowStudy study;
  {
    io::Progress progress("validate flow");
    study = validation::flow_study(options.settings, [&](double part) { progress.update(part); });
  }
  if (options.json)
    print_json(study);
  else if (options.csv)
    print_csv(study);
  else
    print_text(study, options.settings);
  if (!options.picture.empty()) draw(study, options.picture);
  bool agree = study.discharge.agrees();
  for (const HeapSeries& series : study.heaps) agree = agree && series.rises();
  if (!options.json && !options.csv)
    fmt::print("Verdict: {}.\n", agree ? "every trend is as expected" : "NOT EVERY TREND IS AS EXPECTED, see above");
  if (!agree) throw CLI::RuntimeError(1);
}

}  // namespace

void add_validate_flow(CLI::App& validate) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = validate.add_subcommand(
      "flow", "Discharge of a hopper against Beverloo's law, and angles of repose, through the engine");
  command->footer(help);
  command->add_option("--particles", options->settings.particles, "Grains in the hopper")
      ->capture_default_str()
      ->check(CLI::Range(1000, 20000));
  command->add_option("--hoppers", options->settings.hoppers, "Hoppers of each kind, to be averaged")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  command->add_option("--heaps", options->settings.heaps, "Heaps of each kind, to be averaged")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  command->add_option("--threads", options->settings.threads, "Simulations at once")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  CLI::Option* csv = command->add_flag("--csv", options->csv, "Print the numbers as CSV");
  command->add_flag("--json", options->json, "Print the numbers as JSON")->excludes(csv);
  command->add_option("--picture", options->picture, "Plots of rates and angles, .svg or .png");
  command->callback([options] { run(*options); });
}

}  // namespace osculate::app
