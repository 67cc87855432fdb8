#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "validation/kildashti2023/coverage.hpp"
#include "validation/kildashti2023/tables.hpp"

namespace osculate::app {
namespace {

namespace kildashti2023 = validation::kildashti2023;

struct Options {
  std::vector<std::string> names;
  bool json = false;
  bool coverage = false;
};

void print(const Options& options) {
  std::vector<std::string> documents;
  for (const auto& table : kildashti2023::tables()) {
    const bool wanted = options.names.empty() ||
                        std::find(options.names.begin(), options.names.end(), table.name) != options.names.end();
    if (!wanted) continue;
    const validation::ReproducedTable computed = table.compute();
    documents.push_back(options.json ? fmt::format("\"{}\": {}", table.name, to_json(computed)) : to_text(computed));
  }
  if (options.json)
    fmt::print("{{{}}}\n", fmt::join(documents, ",\n"));
  else
    fmt::print("{}", fmt::join(documents, "\n"));
}

}  // namespace

void add_review(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "review",
      "Reproduce the tables of Kildashti, Dong & Yu, Powder Technology 418 (2023) 118323: printed, computed, "
      "verdict");
  std::vector<std::string> names;
  for (const auto& table : kildashti2023::tables()) names.emplace_back(table.name);
  command->add_option("table", options->names, "Which tables; all of them if none is named")
      ->check(CLI::IsMember(names));
  command->add_flag("--json", options->json, "Print JSON, one member a table");
  command->add_flag("--coverage", options->coverage,
                    "Instead: every equation of the review, the function that computes it and the test that holds it");
  command->callback([options] {
    if (options->coverage)
      fmt::print("{}", kildashti2023::coverage_text());
    else
      print(*options);
  });
}

}  // namespace osculate::app
