#include "app/validate_flow.hpp"

#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "app/progress.hpp"
#include "io/plot.hpp"
#include "io/table.hpp"
#include "validation/flow/flow_study.hpp"

namespace osculate::app {
namespace {

using validation::DischargeSeries;
using validation::FlowSettings;
using validation::FlowStudy;
using validation::HeapSeries;

constexpr const char* help =
    R"(The scenes are examples/scenes/hopper.toml, with a gate under the slot, and examples/scenes/angle-of-repose.toml, with
one thing changed at a time. Grains are softer than real ones, 1 MPa in the hopper and 5 MPa in the heap: that allows a
longer time step, and still the weight of those above presses them into each other by less than a hundredth of their
size.
Examples:
  osculate validate flow --picture flow.png
  osculate validate flow --particles 800 --heaps 4 --json > flow.json)";

struct Options {
  FlowSettings settings;
  bool csv = false;
  bool json = false;
  std::string picture;
};

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

void print_discharges(const DischargeSeries& series) {
  io::Table table{{"slot D [mm]", "D / d", "W [kg/s]", "line [kg/s]"}, {}, 0};
  for (std::size_t i = 0; i < series.widths.size(); ++i) {
    const validation::Discharge& one = series.discharges[i];
    table.rows.push_back(
        {fmt::format("{:g}", 1e3 * series.widths[i]), fmt::format("{:.2f}", series.widths[i] / one.diameter),
         fmt::format("{:.4f} ± {:.4f}", one.rate, one.error),
         fmt::format("{:.4f}", validation::beverloo_rate(series.fit, one.diameter, series.widths[i]))});
  }
  const io::Table trends{
      {"trend", "known", "found"},
      {{"exponent of D − 1.4 d", "1.5", fmt::format("{:.2f}", series.fit.exponent)},
       {"k of a line through W^(2/3)", "1 to 3.5", fmt::format("{:.2f}", series.fit.k)},
       {"correlation along that line", "1", fmt::format("{:.4f}", series.fit.correlation)},
       {"W at a quarter of the gravity, over W", "0.5", fmt::format("{:.3f}", series.gravity_ratio())},
       {"verdict", "", series.agrees() ? "agrees" : "DIFFERS"}}};
  fmt::print("{}\n{}\n{}\n", series.name, io::to_text(table), io::to_text(trends));
}

void print_heaps(const HeapSeries& series) {
  io::Table table{{series.name, "angle"}, {}, 0};
  for (std::size_t i = 0; i < series.values.size(); ++i)
    table.rows.push_back({fmt::format("{:g}", series.values[i]), fmt::format("{:.1f}°", degrees(series.angles[i]))});
  fmt::print("{}rises: {}\n\n", io::to_text(table), series.rises() ? "yes" : "NO");
}

void print_text(const FlowStudy& study, const FlowSettings& settings) {
  fmt::print(
      "Discharge of {} grains from a wedge hopper through a slot of width D: W = C ρ_b √g L (D − k d)^(3/2) [BLV61], "
      "d\n"
      "the diameter of the sphere of a grain's volume.\n\n",
      settings.particles);
  for (const DischargeSeries& series : study.discharges) print_discharges(series);
  fmt::print(
      "Angle of the heap of 300 grains that a lifted tube leaves, mean of {} each: of the cone with the same medians of "
      "height\n"
      "and of distance from the axis. It rises with friction [ZXYZ01] and with blockiness.\n\n",
      settings.heaps);
  for (const HeapSeries& series : study.heaps) print_heaps(series);
}

void print_csv(const FlowStudy& study) {
  fmt::print("series,x,value,standard_error\n");
  for (const DischargeSeries& series : study.discharges)
    for (std::size_t i = 0; i < series.widths.size(); ++i)
      fmt::print("\"discharge [kg/s] over slot [m]: {}\",{:.17g},{:.17g},{:.17g}\n", series.name, series.widths[i],
                 series.discharges[i].rate, series.discharges[i].error);
  for (const HeapSeries& series : study.heaps)
    for (std::size_t i = 0; i < series.values.size(); ++i)
      fmt::print("\"angle of repose [rad] over {}\",{:.17g},{:.17g},\n", series.name, series.values[i],
                 series.angles[i]);
}

void print_json(const FlowStudy& study) {
  using Json = nlohmann::ordered_json;
  Json report{{"discharges", Json::array()}, {"heaps", Json::array()}};
  for (const DischargeSeries& series : study.discharges) {
    Json one{{"grain", series.name},
             {"width_m", series.widths},
             {"rate_kg_s", Json::array()},
             {"standard_error_kg_s", Json::array()},
             {"diameter_m", series.discharges[0].diameter},
             {"exponent", series.fit.exponent},
             {"k", series.fit.k},
             {"correlation", series.fit.correlation},
             {"gravity_ratio", series.gravity_ratio()},
             {"agrees", series.agrees()}};
    for (const validation::Discharge& discharge : series.discharges) {
      one["rate_kg_s"].push_back(discharge.rate);
      one["standard_error_kg_s"].push_back(discharge.error);
    }
    report["discharges"].push_back(one);
  }
  for (const HeapSeries& series : study.heaps)
    report["heaps"].push_back(
        {{"over", series.name}, {"values", series.values}, {"angle_rad", series.angles}, {"rises", series.rises()}});
  fmt::print("{}\n", report.dump(2));
}

io::Panel discharge_panel(const std::vector<DischargeSeries>& discharges) {
  io::Panel panel{
      .title = "Discharge of a hopper", .x = {.label = "slot D [mm]"}, .y = {.label = "W [kg/s]"}, .curves = {}};
  constexpr io::Colour colours[] = {io::palette::blue, io::palette::orange};
  for (std::size_t s = 0; s < discharges.size(); ++s) {
    const DischargeSeries& series = discharges[s];
    const io::Colour colour = colours[s % std::size(colours)];
    io::Curve engine{.name = series.name, .x = {}, .y = {}, .mark = io::Mark::points, .colour = colour};
    for (std::size_t i = 0; i < series.widths.size(); ++i) {
      engine.x.push_back(1e3 * series.widths[i]);
      engine.y.push_back(series.discharges[i].rate);
    }
    io::Curve law{.name = fmt::format("Beverloo, k = {:.2f}", series.fit.k), .x = {}, .y = {}, .colour = colour};
    const double diameter = series.discharges[0].diameter, zero = series.fit.k * diameter;
    constexpr int points = 60;
    for (int i = 0; i <= points; ++i) {
      const double width = zero + (series.widths.back() - zero) * i / points;
      law.x.push_back(1e3 * width);
      law.y.push_back(validation::beverloo_rate(series.fit, diameter, width));
    }
    panel.curves.push_back(engine);
    panel.curves.push_back(law);
  }
  return panel;
}

io::Panel heap_panel(const HeapSeries& series) {
  io::Panel panel{.title = "Angle of repose",
                  .x = {.label = series.name},
                  .y = {.label = "angle [°]", .range = io::PlotRange{0.0, 40.0}},
                  .curves = {}};
  std::vector<double> angles;
  for (const double angle : series.angles) angles.push_back(degrees(angle));
  panel.curves.push_back({.name = "", .x = series.values, .y = angles, .colour = io::palette::blue});
  panel.curves.push_back(
      {.name = "", .x = series.values, .y = angles, .mark = io::Mark::points, .colour = io::palette::blue});
  return panel;
}

void draw(const FlowStudy& study, const std::string& path) {
  io::Plot plot{.title = "", .panels = {discharge_panel(study.discharges)}, .columns = 3};
  for (const HeapSeries& series : study.heaps) plot.panels.push_back(heap_panel(series));
  io::write_plot(plot, path);
}

void run(const Options& options) {
  FlowStudy study;
  {
    Progress progress("validate flow");
    study = validation::flow_study(options.settings, [&](double part) { progress.update(part); });
  }
  if (options.json)
    print_json(study);
  else if (options.csv)
    print_csv(study);
  else
    print_text(study, options.settings);
  if (!options.picture.empty()) draw(study, options.picture);
  bool agree = true;
  for (const DischargeSeries& series : study.discharges) agree = agree && series.agrees();
  for (const HeapSeries& series : study.heaps) agree = agree && series.rises();
  if (!options.json && !options.csv)
    fmt::print("Verdict: {}.\n", agree ? "the engine follows the trends" : "THE ENGINE DOES NOT FOLLOW THE TRENDS");
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
      ->check(CLI::Range(200, 20000));
  command->add_option("--heaps", options->settings.heaps, "Heaps of each kind, to be averaged")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  CLI::Option* csv = command->add_flag("--csv", options->csv, "Print the numbers as CSV");
  command->add_flag("--json", options->json, "Print the numbers as JSON")->excludes(csv);
  command->add_option("--picture", options->picture, "Plots of rates and angles, .svg or .png");
  command->callback([options] { run(*options); });
}

}  // namespace osculate::app
