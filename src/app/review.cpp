#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/review_page.hpp"
#include "validation/kildashti2023/coverage.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/models.hpp"
#include "validation/kildashti2023/tables.hpp"

namespace osculate::app {
namespace {

namespace kildashti2023 = validation::kildashti2023;

constexpr std::size_t line_width = 118;

constexpr const char* review_help = R"(Examples:
  osculate review                    every table, and what the figures show
  osculate review table1 fig6        one table and one figure in words
  osculate review --out review/      tables as text, figures as SVG, PNG and CSV, all numbers as HDF5
  osculate review --html review/     the whole as one page, review/index.html
  osculate review --coverage         equation → function → test)";

struct Options {
  std::vector<std::string> names;
  std::string files;
  std::string page;
  bool json = false;
  bool coverage = false;

  bool wants(std::string_view name) const {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  }
};

std::string json_of(const kildashti2023::ModelTable& models) {
  return nlohmann::ordered_json{{"title", models.title}, {"header", models.table.header}, {"rows", models.table.rows}}
      .dump(2);
}

std::string json_of(const kildashti2023::Figure& figure) {
  return nlohmann::ordered_json{{"title", figure.plot.title}, {"caption", figure.caption}}.dump(2);
}

/// Lines of at most so many characters, broken between words.
std::string wrapped(std::string_view text, std::size_t width) {
  std::string out;
  std::size_t column = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find(' ', i), text.size());
    const std::string_view word = text.substr(i, end - i);
    const auto length = static_cast<std::size_t>(std::count_if(
        word.begin(), word.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
    if (column > 0 && column + 1 + length > width) {
      out += '\n';
      column = 0;
    } else if (column > 0) {
      out += ' ';
      ++column;
    }
    out += word;
    column += length;
    i = end + 1;
  }
  return out;
}

void print(const Options& options) {
  std::vector<std::string> documents;
  const auto add = [&](std::string_view name, const std::string& text, const std::string& json) {
    documents.push_back(options.json ? fmt::format("\"{}\": {}", name, json) : text);
  };
  for (const auto& entry : kildashti2023::tables()) {
    if (!options.wants(entry.name)) continue;
    const validation::ReproducedTable table = entry.compute();
    add(entry.name, to_text(table), to_json(table));
  }
  for (const auto& models : kildashti2023::model_tables())
    if (options.wants(models.name)) add(models.name, to_text(models), json_of(models));
  for (const auto& entry : kildashti2023::figures()) {
    if (!options.wants(entry.name)) continue;
    const kildashti2023::Figure figure = entry.compute();
    add(entry.name, fmt::format("{}\n{}\n", figure.plot.title, wrapped(figure.caption, line_width)), json_of(figure));
  }
  if (options.json)
    fmt::print("{{{}}}\n", fmt::join(documents, ",\n"));
  else
    fmt::print("{}", fmt::join(documents, "\n"));
}

void review(const Options& options) {
  if (options.coverage) fmt::print("{}", io::to_text(kildashti2023::coverage_table()));
  if (!options.files.empty()) {
    write_review_files(options.files);
    fmt::print("Tables, figures and their numbers are in {}\n", options.files);
  }
  if (!options.page.empty()) {
    write_review_page(options.page);
    fmt::print("The page is {}\n", (std::filesystem::path(options.page) / "index.html").string());
  }
  if (!options.coverage && options.files.empty() && options.page.empty()) print(options);
}

}  // namespace

void add_review(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("review",
                                             "Reproduce the tables and figures of Kildashti, Dong & Yu, Powder "
                                             "Technology 418 (2023) 118323: printed, computed, "
                                             "verdict");
  command->footer(review_help);
  std::vector<std::string> names;
  for (const auto& table : kildashti2023::tables()) names.emplace_back(table.name);
  for (const auto& models : kildashti2023::model_tables()) names.emplace_back(models.name);
  for (const auto& figure : kildashti2023::figures()) names.emplace_back(figure.name);
  CLI::Option* which = command->add_option("what", options->names, "Which tables and figures; all if none is named")
                           ->check(CLI::IsMember(names));
  CLI::Option* json = command->add_flag("--json", options->json, "Print JSON, one member a table or figure");
  command->add_option("--out", options->files, "Write all tables, figures and their numbers into a folder")
      ->excludes(which)
      ->excludes(json);
  command->add_option("--html", options->page, "Write the whole as one page, index.html, into a folder")
      ->excludes(which)
      ->excludes(json);
  command
      ->add_flag("--coverage", options->coverage,
                 "Print every equation of the review, the function that computes it and the test that holds it")
      ->excludes(which)
      ->excludes(json);
  command->callback([options] { review(*options); });
}

}  // namespace osculate::app
