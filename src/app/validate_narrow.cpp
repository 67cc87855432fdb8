#include "app/validate_narrow.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/progress.hpp"
#include "io/table.hpp"
#include "osculate/core/error.hpp"
#include "validation/narrow_phase/robustness.hpp"

namespace osculate::app {
namespace {

using validation::RobustnessResult;
using validation::RobustnessRun;
using validation::Trouble;

/// The bar: not converged, of random pairs with exponents of 2 and more.
constexpr double most_not_converged = 1e-5;

struct NarrowValidation {
  std::size_t pairs = 10000;
  std::uint64_t seed = 1;
  std::size_t references = 100;
  std::size_t findings = 3;
  std::string family = "all";
};

std::vector<RobustnessRun> runs_of(const NarrowValidation& settings) {
  std::vector<RobustnessRun> runs;
  std::string known = "all, nasty";
  const auto families = validation::pair_families();
  const bool all = settings.family == "all";
  for (const auto& family : families) {
    known += ", " + family.name;
    if (all || settings.family == family.name)
      runs.push_back(validation::random_run(family, settings.seed, settings.pairs));
  }
  if (all || settings.family == "nasty") runs.push_back(validation::nasty_run());
  if (runs.empty()) throw InputError("--family", "\"" + settings.family + "\"", "one of: " + known);
  if (all)
    for (RobustnessRun& run : runs)
      if (run.family != "nasty poses") run.pairs = std::max<std::size_t>(settings.pairs / families.size(), 1);
  for (RobustnessRun& run : runs) {
    run.references = std::min(settings.references, run.pairs);
    run.most_findings = settings.findings;
  }
  return runs;
}

std::string count_text(std::size_t count) {
  return count == 0 ? "-" : fmt::format("{}", count);
}

std::size_t count_of(const validation::RobustnessRow& row, Trouble trouble) {
  return row.counts[static_cast<std::size_t>(trouble)];
}

std::size_t wrong_answers(const validation::RobustnessRow& row) {
  std::size_t sum = 0;
  for (const std::size_t count : row.counts) sum += count;
  return sum - count_of(row, Trouble::not_converged);
}

io::Table outcome_table(const std::vector<RobustnessResult>& results) {
  io::Table table{{"family", "pairs", "touching", "separated", "flat", "ambiguous", "not converged", "troubles",
                   "passed over", "mean cold", "slowest alone"},
                  {}};
  const auto status = [](const validation::RobustnessRow& row, ContactStatus which) {
    return count_text(row.statuses[static_cast<std::size_t>(which)]);
  };
  for (const auto& [row, findings] : results)
    table.rows.push_back({row.family, fmt::format("{}", row.pairs), status(row, ContactStatus::touching),
                          status(row, ContactStatus::separated), status(row, ContactStatus::flat),
                          status(row, ContactStatus::ambiguous), status(row, ContactStatus::not_converged),
                          count_text(wrong_answers(row)), count_text(row.passed_over),
                          fmt::format("{:.0f} ns", row.mean_ns), fmt::format("{:.0f} µs", row.worst_us)});
  return table;
}

io::Table trouble_table(const std::vector<RobustnessResult>& results) {
  io::Table table{{"trouble"}, {}};
  for (const auto& [row, findings] : results) table.header.push_back(row.family);
  table.header.push_back("worst / tolerance");
  for (std::size_t k = 0; k < validation::troubles; ++k) {
    std::vector<std::string> line{std::string(name(static_cast<Trouble>(k)))};
    std::size_t sum = 0;
    double worst = 0.0;
    for (const auto& [row, findings] : results) {
      line.push_back(count_text(row.counts[k]));
      sum += row.counts[k];
      if (!(row.worst[k] <= worst)) worst = row.worst[k];
    }
    if (sum == 0) continue;
    line.push_back(worst == 0.0 ? "" : fmt::format("{:.1e}", worst));
    table.rows.push_back(std::move(line));
  }
  return table;
}

void print_findings(const std::vector<RobustnessResult>& results) {
  for (std::size_t k = 0; k < validation::troubles; ++k) {
    bool titled = false;
    for (const auto& [row, findings] : results)
      for (const validation::Finding& finding : findings) {
        if (static_cast<std::size_t>(finding.trouble) != k) continue;
        if (!titled) fmt::print("{}: {}\n", name(finding.trouble), meaning(finding.trouble));
        titled = true;
        fmt::print("  {}{}\n", finding.label,
                   finding.size == 0.0 ? "" : fmt::format("  ({:.1e} of the tolerance)", finding.size));
      }
  }
}

void validate_narrow(const NarrowValidation& settings) {
  const std::vector<RobustnessRun> runs = runs_of(settings);
  std::size_t all_pairs = 0, done = 0;
  for (const RobustnessRun& run : runs) all_pairs += run.pairs;

  std::vector<RobustnessResult> results;
  {
    io::Progress progress("Narrow phase under stress");
    for (const RobustnessRun& run : runs) {
      results.push_back(validation::robustness(
          run,
          [](const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts) {
            common_normals(pairs, caches, contacts);
          },
          [&](std::size_t of_run) {
            progress.update(static_cast<double>(done + of_run) / static_cast<double>(all_pairs));
          }));
      done += run.pairs;
    }
  }

  std::size_t wrong = 0, blunt = 0, blunt_lost = 0, references = 0;
  for (const auto& [row, findings] : results) {
    wrong += wrong_answers(row);
    references += row.references;
    if (row.family != "ellipsoid" && row.family != "even" && row.family != "n >= 2") continue;
    blunt += row.pairs;
    blunt_lost += count_of(row, Trouble::not_converged);
  }
  fmt::print(
      "Common normals of {} superquadric pairs (seed {}, {}): exponents 1.05 to 32, aspect ratios to 100, size\n"
      "ratios to 1000, overlaps 1e-8 to 0.3 R_vol, and every nasty pose. Every answer must lie on both surfaces, on "
      "one\n"
      "line along its normal, be the least of 200 sampled directions and of the direction the pair was built on, swap\n"
      "and scale to the last bit, and not change with the world's frame or a warm start. After a move of 1e-4 a warm\n"
      "start follows its contact, also where another one has come to be the least (passed over): by no more than the\n"
      "move itself. {} pairs were also given to a plain multi-start solver.\n\n{}\n",
      all_pairs, settings.seed, batch_instruction_set(), references, io::to_text(outcome_table(results)));
  const io::Table troubles = trouble_table(results);
  if (!troubles.rows.empty()) {
    fmt::print("{}\n", io::to_text(troubles));
    print_findings(results);
    fmt::print("\n");
  }
  const bool converges = static_cast<double>(blunt_lost) <= most_not_converged * static_cast<double>(blunt);
  fmt::print("Not converged with exponents of 2 and more: {} of {} (bar: {:g}). Other troubles: {}. Verdict: {}.\n",
             blunt_lost, blunt, most_not_converged, wrong,
             converges && wrong == 0 ? "the narrow phase holds" : "THE NARROW PHASE FAILS");
  if (!converges || wrong != 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_validate_narrow(CLI::App& validate) {
  auto settings = std::make_shared<NarrowValidation>();
  CLI::App* narrow = validate.add_subcommand(
      "narrow", "Common normals of random and nasty superquadric pairs, checked without and with a reference");
  narrow->add_option("--pairs", settings->pairs, "Random pairs, shared out evenly among the families")
      ->capture_default_str();
  narrow->add_option("--seed", settings->seed, "Another seed, other pairs")->capture_default_str();
  narrow
      ->add_option("--family", settings->family, "One family only: ellipsoid, even, \"n >= 2\", \"n < 2\", any, nasty")
      ->capture_default_str();
  narrow
      ->add_option("--reference", settings->references,
                   "Pairs of each family given to the plain multi-start solver too (10 ms each)")
      ->capture_default_str();
  narrow->add_option("--list", settings->findings, "Pairs listed for each kind of trouble and family")
      ->capture_default_str();
  narrow->callback([settings] { validate_narrow(*settings); });
}

}  // namespace osculate::app
