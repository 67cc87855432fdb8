#include "app/review_page.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/markdown.hpp"
#include "io/plot_numbers.hpp"
#include "io/progress.hpp"
#include "osculate/core/error.hpp"
#include "validation/kildashti2023/coverage.hpp"
#include "validation/kildashti2023/errata.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/models.hpp"
#include "validation/kildashti2023/tables.hpp"

namespace osculate::app {
namespace {

namespace kildashti2023 = validation::kildashti2023;

constexpr std::string_view style = R"(
body { font: 15px/1.5 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #1d2023; background: #fff;
       max-width: 1180px; margin: 0 auto; padding: 24px 28px 80px; }
h1 { font-size: 1.7em; margin: 0.6em 0 0.2em; } h2 { font-size: 1.3em; margin: 2.2em 0 0.4em; }
h3 { font-size: 1.05em; margin: 1.6em 0 0.4em; }
nav a { margin-right: 1.1em; } a { color: #28659b; text-decoration: none; } a:hover { text-decoration: underline; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.86em; margin: 0.6em 0; }
th { text-align: left; border-bottom: 1.5px solid #404448; padding: 4px 12px 4px 0; vertical-align: bottom; }
td { border-bottom: 1px solid #e2e5e8; padding: 4px 12px 4px 0; vertical-align: top; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
figure { margin: 1.2em 0 2.4em; } figure svg { width: 100%; height: auto; }
figcaption { font-size: 0.9em; color: #3a3f44; max-width: 100ch; } code { font-size: 0.95em; }
sub, sup { line-height: 0; font-size: 0.78em; }
.notes { font-size: 0.86em; white-space: pre-wrap; }
)";

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      three = (three << 8U) | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[(three >> (18U - 6U * k)) & 63U] : '=';
  }
  return text;
}

std::string download(std::string_view text, std::string_view file, std::string_view type, std::string_view content) {
  return fmt::format("<a download=\"{}\" href=\"data:{};base64,{}\">{}</a>", file, type, base64(content), text);
}

std::vector<io::NamedPlot> all_figures() {
  std::vector<io::NamedPlot> plots;
  for (const auto& entry : kildashti2023::figures()) {
    kildashti2023::Figure figure = entry.compute();
    plots.push_back({std::string(entry.name), std::move(figure.caption), std::move(figure.plot)});
  }
  return plots;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);
  if (trouble) throw InputError(folder.string(), trouble.message(), "a folder that can be made");
}

std::string notes_html(const std::vector<std::string>& lines) {
  return fmt::format("<div class=\"notes\">{}</div>\n", io::html_of_formula(fmt::format("{}", fmt::join(lines, "\n"))));
}

std::string tables_html() {
  std::string html = "<h2 id=\"tables\">Tables</h2>\n";
  for (const auto& entry : kildashti2023::tables()) {
    const validation::ReproducedTable table = entry.compute();
    html += fmt::format("<h3 id=\"{}\">{}</h3>\n{}<div class=\"wide\">{}</div>\n{}", entry.name,
                        io::escape_html(table.title), notes_html(table.preamble), io::to_html(columns_of(table)),
                        notes_html(table.notes));
  }
  for (const auto& models : kildashti2023::model_tables())
    html += fmt::format(
        "<h3 id=\"{}\">{}</h3>\n<p>As implemented here; which model stands in which table was inferred."
        "</p>\n<div class=\"wide\">{}</div>\n{}",
        models.name, io::escape_html(models.title), io::to_html(models.table), notes_html({models.note}));
  return html;
}

std::string figures_html(const std::vector<io::NamedPlot>& plots, io::Progress& progress) {
  std::string html = fmt::format(
      "<h2 id=\"figures\">Figures</h2>\n<p>Computed anew from the library's functions. The project does not have the "
      "review's pictures: what each shows was inferred from the sections around it, and the captions say so. All "
      "numbers: "
      "{}.</p>\n",
      download("figures.h5", "figures.h5", "application/x-hdf5", io::hdf5_of(plots)));
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const io::NamedPlot& plot = plots[i];
    html += fmt::format("<figure id=\"{}\">\n{}\n<figcaption>{} {}</figcaption>\n</figure>\n", plot.name,
                        io::svg_of(plot.plot, plot.name), io::html_of_formula(plot.caption),
                        download("Its numbers.", plot.name + ".csv", "text/csv", io::csv_of(plot.plot)));
    progress.update(static_cast<double>(i + 1) / static_cast<double>(plots.size()));
  }
  return html;
}

}  // namespace

void write_review_files(const std::filesystem::path& folder) {
  make_folder(folder);
  for (const auto& entry : kildashti2023::tables())
    io::write_atomically((folder / entry.name).string() + ".txt", to_text(entry.compute()));
  for (const auto& models : kildashti2023::model_tables())
    io::write_atomically((folder / models.name).string() + ".txt", to_text(models));
  const std::vector<io::NamedPlot> plots = all_figures();
  io::write_atomically((folder / "figures.h5").string(), io::hdf5_of(plots));
  io::Progress progress("review");
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const std::string path = (folder / plots[i].name).string();
    io::write_plot(plots[i].plot, path + ".svg");
    io::write_plot(plots[i].plot, path + ".png");
    io::write_atomically(path + ".csv", io::csv_of(plots[i].plot));
    progress.update(static_cast<double>(i + 1) / static_cast<double>(plots.size()));
  }
}

void write_review_page(const std::filesystem::path& folder) {
  make_folder(folder);
  io::Progress progress("review");
  const std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>The review, computed anew</title>\n<style>{}</style>\n</head>\n<body>\n"
      "<h1>Contact force models for non-spherical particles, computed anew</h1>\n"
      "<p>Tables and figures of K. Kildashti, K. Dong, A. Yu, “Contact force models for non-spherical particles with "
      "different surface properties: A review”, Powder Technology 418 (2023) 118323 [KDY23], reproduced by "
      "Osculate.</p>\n"
      "<nav><a href=\"#tables\">Tables</a><a href=\"#figures\">Figures</a><a href=\"#errata\">Errata</a>"
      "<a href=\"#coverage\">Equations, functions, tests</a></nav>\n{}{}<section id=\"errata\" "
      "class=\"wide\">\n{}</section>\n"
      "<h2 id=\"coverage\">Equations, functions, tests</h2>\n<div class=\"wide\">{}</div>\n</body>\n</html>\n",
      style, tables_html(), figures_html(all_figures(), progress),
      io::html_of_markdown(kildashti2023::errata_page(), 2), io::to_html(kildashti2023::coverage_table()));
  io::write_atomically((folder / "index.html").string(), page);
}

}  // namespace osculate::app
