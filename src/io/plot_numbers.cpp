#include "io/plot_numbers.hpp"

#include <fmt/format.h>

#include <iterator>

#include "io/hdf5_image.hpp"

namespace osculate::io {
namespace {

/// A text as one field: in quotes, quotes doubled.
std::string field(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

void add_plot(Hdf5Image& file, const NamedPlot& named) {
  const std::string of_plot = "/" + named.name;
  file.add_group(of_plot);
  file.set_text(of_plot, "title", named.plot.title);
  file.set_text(of_plot, "caption", named.caption);
  for (std::size_t i = 0; i < named.plot.panels.size(); ++i) {
    const Panel& panel = named.plot.panels[i];
    const std::string of_panel = fmt::format("{}/panel_{}", of_plot, i + 1);
    file.add_group(of_panel);
    file.set_text(of_panel, "title", panel.title);
    file.set_text(of_panel, "x", panel.x.label);
    file.set_text(of_panel, "y", panel.y.label);
    for (std::size_t k = 0; k < panel.curves.size(); ++k) {
      const std::string of_curve = fmt::format("{}/curve_{}", of_panel, k + 1);
      file.add_numbers(of_curve + "/x", panel.curves[k].x);
      file.add_numbers(of_curve + "/y", panel.curves[k].y);
      file.set_text(of_curve, "name", panel.curves[k].name);
    }
  }
}

}  // namespace

std::string csv_of(const Plot& plot) {
  std::string csv = "panel,curve,along_x,along_y,x,y\n";
  for (const auto& panel : plot.panels) {
    for (const auto& curve : panel.curves) {
      const std::string start =
          fmt::format("{},{},{},{}", field(panel.title), field(curve.name), field(panel.x.label), field(panel.y.label));
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        fmt::format_to(std::back_inserter(csv), "{},{:.17g},{:.17g}\n", start, curve.x[i], curve.y[i]);
    }
  }
  return csv;
}

std::string hdf5_of(std::span<const NamedPlot> plots) {
  Hdf5Image file;
  for (const auto& plot : plots) add_plot(file, plot);
  return file.bytes();
}

}  // namespace osculate::io
