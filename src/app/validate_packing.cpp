#include "app/validate_packing.hpp"

#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/plot.hpp"
#include "io/progress.hpp"
#include "io/table.hpp"
#include "validation/packing/published_packings.hpp"

namespace osculate::app {
namespace {

using validation::Mean;
using validation::PackingRow;
using validation::PublishedRange;

constexpr const char* help =
    R"(Frictionless particles start at random in a periodic cube that shrinks until their contacts carry 1e-5 of Young's
modulus at rest: no floor, no walls, no free surface, so that the whole cube counts. Particles with fewer than four
contacts are rattlers; Z counts the contacts of the others. Means over the seeds, with the standard error of the mean.
A superball's published range is wide, for how densely it packs depends on how much order the way there allows: [DC10]
grow theirs slowly, and find order.
Examples:
  osculate validate packing --picture packing.png
  osculate validate packing --particles 400 --seeds 5 --csv > packing.csv)";

constexpr const char* introduction =
    R"(Random packings of {0} frictionless particles in a periodic cube that shrinks until they jam, {1} seeds a shape; mean
and standard error. φ: solid fraction; Z: contacts of a particle that is no rattler. Sources: docs/references.md.

)";

struct Options {
  std::uint64_t particles = 200;
  int seeds = 3;
  int threads = validation::processors();
  bool csv = false;
  bool json = false;
  std::string picture;
};

std::string text_of(const Mean& mean, int digits) {
  return fmt::format("{:.{}f} ± {:.{}f}", mean.value, digits, mean.error, digits);
}

std::string text_of(const PublishedRange& range) {
  return fmt::format("{:g} – {:g}", range.least, range.most);
}

void print_table(const std::vector<PackingRow>& rows, const Options& options) {
  io::Table table{{"shape", "source", "φ", "published", "Z", "published", "rattlers", "verdict"}, {}, 2};
  for (const PackingRow& row : rows)
    table.rows.push_back({row.published.name, row.published.source, text_of(row.fraction, 4),
                          text_of(row.published.fraction), text_of(row.coordination, 2),
                          text_of(row.published.coordination), fmt::format("{:.1f} %", 100.0 * row.rattlers.value),
                          row.agrees() ? "agrees" : "DIFFERS"});
  fmt::print(fmt::runtime(introduction), options.particles, options.seeds);
  fmt::print("{}", io::to_text(table));
}

void print_csv(const std::vector<PackingRow>& rows) {
  fmt::print("shape,seed,fraction,fraction_by_points,coordination,rattlers,pressure_over_modulus\n");
  for (const PackingRow& row : rows)
    for (std::size_t i = 0; i < row.packings.size(); ++i) {
      const validation::JammedPacking& packing = row.packings[i];
      fmt::print("\"{}\",{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", row.published.name, i + 1, packing.fraction,
                 packing.fraction_by_points, packing.coordination, packing.rattlers, packing.pressure);
    }
}

void print_json(const std::vector<PackingRow>& rows, const Options& options) {
  using Json = nlohmann::ordered_json;
  const auto mean = [](const Mean& one) { return Json{{"mean", one.value}, {"standard_error", one.error}}; };
  Json report{{"particles", options.particles}, {"seeds", options.seeds}, {"shapes", Json::array()}};
  for (const PackingRow& row : rows)
    report["shapes"].push_back(
        {{"shape", row.published.name},
         {"fraction", mean(row.fraction)},
         {"published_fraction", {row.published.fraction.least, row.published.fraction.most}},
         {"coordination", mean(row.coordination)},
         {"published_coordination", {row.published.coordination.least, row.published.coordination.most}},
         {"rattlers", mean(row.rattlers)},
         {"source", row.published.source},
         {"agrees", row.agrees()}});
  fmt::print("{}\n", report.dump(2));
}

/// Fraction over contacts: every packing a point, the published ranges as boxes.
void draw(const std::vector<PackingRow>& rows, const std::string& path) {
  io::Panel panel{
      .title = "", .x = {.label = "contacts of a held particle Z"}, .y = {.label = "solid fraction φ"}, .curves = {}};
  constexpr io::Colour colours[] = {io::palette::blue, io::palette::orange, io::palette::green, io::palette::red,
                                    io::palette::purple};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const PackingRow& row = rows[i];
    const io::Colour colour = colours[i % std::size(colours)];
    const PublishedRange &x = row.published.coordination, &y = row.published.fraction;
    panel.curves.push_back({.name = "",
                            .x = {x.least, x.most, x.most, x.least, x.least},
                            .y = {y.least, y.least, y.most, y.most, y.least},
                            .mark = io::Mark::dashed,
                            .colour = colour});
    io::Curve packings{.name = row.published.name, .x = {}, .y = {}, .mark = io::Mark::points, .colour = colour};
    for (const validation::JammedPacking& packing : row.packings) {
      packings.x.push_back(packing.coordination);
      packings.y.push_back(packing.fraction);
    }
    panel.curves.push_back(packings);
  }
  io::write_plot({.title = "Random packings (points) and published ranges (dashed)", .panels = {panel}, .columns = 1},
                 path);
}

void run(const Options& options) {
  std::vector<PackingRow> rows;
  {
    io::Progress progress("validate packing");
    rows = validation::packing_rows(validation::published_packings(), options.particles, options.seeds, options.threads,
                                    [&](double part) { progress.update(part); });
  }
  if (options.json)
    print_json(rows, options);
  else if (options.csv)
    print_csv(rows);
  else
    print_table(rows, options);
  if (!options.picture.empty()) draw(rows, options.picture);
  std::size_t missed = 0;
  for (const PackingRow& row : rows) missed += row.agrees() ? 0 : 1;
  if (!options.json && !options.csv)
    fmt::print("\nVerdict: {}.\n", missed == 0 ? "the packings agree" : "THE PACKINGS DIFFER");
  if (missed != 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_validate_packing(CLI::App& validate) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = validate.add_subcommand(
      "packing", "Random packings of spheres, ellipsoids and superballs through the engine, beside published ones");
  command->footer(help);
  command->add_option("--particles", options->particles, "How many in the cube")
      ->capture_default_str()
      ->check(CLI::Range(100, 100000));
  command->add_option("--seeds", options->seeds, "Packings of each shape")
      ->capture_default_str()
      ->check(CLI::Range(2, 1000));
  command->add_option("--threads", options->threads, "Packings at a time")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  CLI::Option* csv = command->add_flag("--csv", options->csv, "Print every packing as CSV");
  command->add_flag("--json", options->json, "Print the means as JSON")->excludes(csv);
  command->add_option("--picture", options->picture, "Plot of fraction over contacts, .svg or .png");
  command->callback([options] { run(*options); });
}

}  // namespace osculate::app
