#pragma once
// Line plots of computed numbers, as SVG or PNG. Drawn by gnuplot, which must be installed (Debian: gnuplot-nox).
//
// Texts are literal but for _{...} and ^{...}, which lower and raise what stands in the braces: "R_{vol}", "10^{-3}".

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/colour.hpp"

namespace osculate::io {

enum class Scale { linear, logarithmic };

struct PlotRange {
  double low;
  double high;
};

struct Axis {
  std::string label;  ///< quantity and unit: "overlap δ [µm]"
  Scale scale = Scale::linear;
  std::optional<PlotRange> range = std::nullopt;  ///< nothing: what the curves need
};

enum class Mark { line, dashed, dotted, points };

/// y over x. All numbers finite, and positive along a logarithmic axis; a gap is made by two curves.
struct Curve {
  std::string name;  ///< as the legend has it; empty: not in the legend
  std::vector<double> x;
  std::vector<double> y;
  Mark mark = Mark::line;
  std::optional<Colour> colour = std::nullopt;  ///< nothing: the next one of the palette
};

/// A word at a place of the panel, such as the name of a point of a curve.
struct PlotNote {
  double x;
  double y;
  std::string text;
};

struct Panel {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::vector<PlotNote> notes = {};
};

/// One or more panels side by side. The legend of a panel goes to the corner where it covers no curve, or below.
struct Plot {
  std::string title;
  std::vector<Panel> panels;
  int columns = 2;  ///< panels in a row
};

/// Writes the plot; the format follows the name's ending, .svg or .png.
/// Throws InputError for another ending, a plot that cannot be drawn (no panel, no point, lengths that differ, numbers
/// that are not finite or not positive on a logarithmic axis), a missing gnuplot, and a file that cannot be written.
void write_plot(const Plot& plot, const std::filesystem::path& path);

/// The same as the text of an SVG document, without an XML header, to be put into a page.
/// @param name  unique on the page; it becomes part of the identifiers inside
std::string svg_of(const Plot& plot, const std::string& name);

}  // namespace osculate::io
