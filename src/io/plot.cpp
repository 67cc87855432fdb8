#include "io/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "io/atomic_file.hpp"
#include "io/gnuplot.hpp"
#include "io/plot_layout.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

// A panel and what surrounds it, in units of an SVG pixel.
constexpr double panel_width = 560, panel_height = 400, title_height = 40;
constexpr double left = 84, right = 22, bottom = 68, top_with_title = 38, top_without = 16;
constexpr double axis_height = 58;  // its numbers and label
constexpr double font_size = 13, character_width = 7.6, line_height = 19, sample_width = 44;
constexpr double png_scale = 2;

using std::back_inserter;

/// What a reader sees of a text: code points, without the marks of _{...} and ^{...}.
std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
    if (!continues && std::string_view("_^{}").find(c) == std::string_view::npos) ++count;
  }
  return count;
}

/// Literal text for gnuplot's enhanced mode, in single quotes, _{...} and ^{...} kept.
std::string literal(std::string_view text) {
  std::string out = "'";
  bool in_braces = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool opens = (c == '_' || c == '^') && i + 1 < text.size() && text[i + 1] == '{' && !in_braces &&
                       text.find('}', i) != std::string_view::npos;
    if (opens) {
      out += c;
      out += '{';
      ++i;
      in_braces = true;
    } else if (c == '}' && in_braces) {
      out += c;
      in_braces = false;
    } else if (c == '\'') {
      out += "''";
    } else if (c == '\n') {
      out += ' ';
    } else {
      if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) out += '\\';
      out += c;
    }
  }
  return out + "'";
}

std::string hex(const Colour& colour) {
  const auto byte = [](double value) { return static_cast<int>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green), byte(colour.blue));
}

constexpr std::array<Colour, 7> cycle{palette::blue,   palette::orange, palette::green, palette::red,
                                      palette::purple, palette::black,  palette::grey};

std::string style(const Curve& curve, std::size_t index) {
  const std::string colour = hex(curve.colour.value_or(cycle[index % cycle.size()]));
  switch (curve.mark) {
    case Mark::line:
      return fmt::format("lines lw 2 dt {} lc rgb '{}'", index < cycle.size() || curve.colour ? 1 : 4, colour);
    case Mark::dashed:
      return fmt::format("lines lw 2 dt (9,5) lc rgb '{}'", colour);
    case Mark::dotted:
      return fmt::format("lines lw 2 dt (2,4) lc rgb '{}'", colour);
    case Mark::points:
      break;
  }
  return fmt::format("points pt 7 ps 0.6 lc rgb '{}'", colour);
}

void describe_axis(std::string& script, char name, const Axis& axis, const PlotRange& range) {
  fmt::format_to(back_inserter(script), "set {}label {}\nset {}range [{:.17g}:{:.17g}]\n", name, literal(axis.label),
                 name, range.low, range.high);
  if (axis.scale == Scale::linear) {
    fmt::format_to(back_inserter(script), "unset logscale {0}\nset format {0} '%h'\nset {0}tics autofreq\n", name);
    return;
  }
  fmt::format_to(back_inserter(script), "set logscale {0}\n", name);
  if (range.high / range.low >= 100.0) {
    fmt::format_to(back_inserter(script), "set format {0} '10^{{%T}}'\nset {0}tics autofreq\n", name);
    return;
  }
  // Over less than two decades powers of ten would leave a tic or two: 1, 2, 5 and their tenfolds.
  std::string tics;
  for (double decade = std::pow(10.0, std::floor(std::log10(range.low))); decade <= range.high; decade *= 10.0) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double at = digit * decade;
      if (at >= range.low && at <= range.high) tics += fmt::format("{}{:.10g}", tics.empty() ? "" : ", ", at);
    }
  }
  fmt::format_to(back_inserter(script), "set format {0} '%g'\nset {0}tics ({1})\n", name, tics);
}

struct LegendText {
  std::size_t lines = 0, longest = 0;
};

LegendText legend_text(const Panel& panel) {
  LegendText text;
  for (const auto& curve : panel.curves) {
    if (curve.name.empty()) continue;
    ++text.lines;
    text.longest = std::max(text.longest, characters(curve.name));
  }
  return text;
}

double legend_width(const LegendText& text) {
  return character_width * static_cast<double>(text.longest) + sample_width + 16;
}

/// Whole picture [px].
struct Size {
  double width, height;
};

/// Where a panel stands in the whole [px], from the upper left corner.
struct Frame {
  double left, top, width, height;
};

/// gnuplot's key. Below, it stands under the x axis' label, in as many columns as there is room for.
std::string key(Legend legend, const Frame& frame, double plot_height, double columns, const Size& whole) {
  switch (legend) {
    case Legend::none:
      break;
    case Legend::top_left:
      return "set key inside top left vertical reverse Left maxcols 1";
    case Legend::top_right:
      return "set key inside top right vertical noreverse Right maxcols 1";
    case Legend::bottom_left:
      return "set key inside bottom left vertical reverse Left maxcols 1";
    case Legend::bottom_right:
      return "set key inside bottom right vertical noreverse Right maxcols 1";
    case Legend::below:
      return fmt::format("set key at screen {:.6f},{:.6f} center top horizontal reverse Left maxcols {:.0f}",
                         (frame.left + 0.5 * frame.width) / whole.width,
                         1.0 - (frame.top + plot_height + axis_height) / whole.height, columns);
  }
  return "unset key";
}

void describe_panel(std::string& script, const Panel& panel, std::size_t number, const Frame& frame,
                    const Size& whole) {
  const PanelRanges range = ranges(panel);
  const LegendText text = legend_text(panel);
  double plot_height = frame.height;
  const LegendSize size{legend_width(text) / frame.width,
                        (line_height * static_cast<double>(text.lines) + 14) / frame.height};
  const Legend legend = place_legend(panel, range, size);
  const double columns = std::max(1.0, std::floor(frame.width / legend_width(text)));
  if (legend == Legend::below) plot_height -= line_height * std::ceil(static_cast<double>(text.lines) / columns) + 8;

  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    fmt::format_to(back_inserter(script), "$data_{}_{} << END\n", number, i);
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      fmt::format_to(back_inserter(script), "{:.17g} {:.17g}\n", curve.x[k], curve.y[k]);
    script += "END\n";
  }
  fmt::format_to(back_inserter(script), "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n",
                 frame.left / whole.width, (frame.left + frame.width) / whole.width);
  fmt::format_to(back_inserter(script), "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n",
                 1.0 - frame.top / whole.height, 1.0 - (frame.top + plot_height) / whole.height);
  fmt::format_to(back_inserter(script), "set title {}\n", literal(panel.title));
  describe_axis(script, 'x', panel.x, range.x);
  describe_axis(script, 'y', panel.y, range.y);
  fmt::format_to(back_inserter(script), "{}\nunset label\n", key(legend, frame, plot_height, columns, whole));
  for (const auto& note : panel.notes)
    fmt::format_to(back_inserter(script),
                   "set label {} at {:.17g},{:.17g} point pt 6 ps 1 lc rgb '#303030' offset 0.8,0.7 front\n",
                   literal(note.text), note.x, note.y);
  script += "plot ";
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    const std::string title = curve.name.empty() ? "notitle" : "title " + literal(curve.name);
    fmt::format_to(back_inserter(script), "{}$data_{}_{} using 1:2 with {} {}", i == 0 ? "" : ", ", number, i,
                   style(curve, i), title);
  }
  script += "\n";
}

enum class Format { svg, png };

/// SVG counts letters in its pixels, pngcairo in points of 4/3 px.
double font_points(Format format) {
  return format == Format::svg ? font_size : 0.75 * font_size * png_scale;
}

std::string script_of(const Plot& plot, Format format) {
  const auto count = static_cast<double>(plot.panels.size());
  const double columns = std::min<double>(plot.columns, count), rows = std::ceil(count / columns);
  const double above = plot.title.empty() ? 4 : title_height;
  const double width = columns * panel_width, height = above + rows * panel_height;

  std::string script = "set encoding utf8\n";
  if (format == Format::svg)
    fmt::format_to(back_inserter(script),
                   "set terminal svg enhanced size {},{} font 'DejaVu Sans,{}' background '#ffffff'\n", width, height,
                   font_points(format));
  else
    fmt::format_to(back_inserter(script),
                   "set terminal pngcairo enhanced size {},{} font 'DejaVu Sans,{}' linewidth {} pointscale {} "
                   "background '#ffffff'\n",
                   png_scale * width, png_scale * height, font_points(format), png_scale, png_scale);
  // The SVG terminal stands labels a line further from the axis than cairo does.
  if (format == Format::svg) script += "set xlabel offset 0,0.4\n";
  script +=
      "set border 3 lw 1 lc rgb '#404040'\nset tics nomirror out scale 0.6\nset grid lt 1 lw 0.8 dt 1 lc rgb "
      "'#d0d5da'\n"
      "set key samplen 2.4 spacing 1.15 noautotitle\nset style data lines\n";
  script += plot.title.empty()
                ? "set multiplot\n"
                : fmt::format("set multiplot title {} font ',{}'\n", literal(plot.title), 1.15 * font_points(format));
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const double column = std::fmod(static_cast<double>(i), columns);
    const double row = std::floor(static_cast<double>(i) / columns);
    const double top = plot.panels[i].title.empty() ? top_without : top_with_title;
    describe_panel(script, plot.panels[i], i,
                   {column * panel_width + left, above + row * panel_height + top, panel_width - left - right,
                    panel_height - top - bottom},
                   {width, height});
  }
  return script + "unset multiplot\n";
}

std::string draw(const Plot& plot, Format format) {
  validate(plot);
  return run_gnuplot(script_of(plot, format));
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

void write_plot(const Plot& plot, const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".svg" && ending != ".png")
    throw InputError(path.string(), "no plot by its name", "a name in .svg or .png");
  write_atomically(path.string(), draw(plot, ending == ".svg" ? Format::svg : Format::png));
}

std::string svg_of(const Plot& plot, const std::string& name) {
  std::string svg = draw(plot, Format::svg);
  const std::size_t start = svg.find("<svg");
  svg.erase(0, start == std::string::npos ? svg.size() : start);
  replace_all(svg, "id=\"", "id=\"" + name + "-");
  replace_all(svg, "id='", "id='" + name + "-");
  replace_all(svg, "href='#", "href='#" + name + "-");
  replace_all(svg, "url(#", "url(#" + name + "-");
  return svg;
}

}  // namespace osculate::io
