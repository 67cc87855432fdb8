#include "io/plot_layout.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

void require_drawable(const Axis& axis, const std::vector<double>& values, const std::string& where) {
  for (const double value : values) {
    if (!std::isfinite(value)) throw InputError(where, fmt::format("{} among the numbers", value), "finite numbers");
    if (axis.scale == Scale::logarithmic && value <= 0.0)
      throw InputError(where, fmt::format("{:g} on a logarithmic axis", value), "positive numbers");
  }
}

void require_range(const Axis& axis, const std::string& where) {
  if (!axis.range) return;
  const auto [low, high] = *axis.range;
  const bool positive = axis.scale == Scale::linear || low > 0.0;
  if (!(std::isfinite(low) && std::isfinite(high) && low < high && positive))
    throw InputError(where, fmt::format("the range {:g} to {:g}", low, high),
                     "finite bounds in ascending order, positive on a logarithmic axis");
}

/// A value's place along an axis, 0 at the low end and 1 at the high one.
double place(const Axis& axis, const PlotRange& range, double value) {
  if (axis.scale == Scale::logarithmic) return std::log(value / range.low) / std::log(range.high / range.low);
  return (value - range.low) / (range.high - range.low);
}

enum class Air { none, some };

PlotRange range_of(const Axis& axis, const Panel& panel, std::vector<double> Curve::*values, Air air) {
  if (axis.range) return *axis.range;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& curve : panel.curves) {
    for (const double value : curve.*values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (axis.scale == Scale::logarithmic) {
    if (low == high) return {low / 2.0, high * 2.0};
    const double factor = air == Air::some ? std::pow(high / low, 0.05) : 1.0;
    return {low / factor, high * factor};
  }
  if (low == high) {
    const double half = low == 0.0 ? 1.0 : 0.5 * std::fabs(low);
    return {low - half, high + half};
  }
  if (air == Air::none) return {low, high};
  const double margin = 0.06 * (high - low);
  // A curve that starts at zero stands on its axis.
  return {low == 0.0 ? 0.0 : low - margin, high == 0.0 ? 0.0 : high + margin};
}

struct Spot {
  double x, y;
};

/// Spots close together along everything that is drawn.
std::vector<Spot> drawn_spots(const Panel& panel, const PanelRanges& ranges) {
  constexpr int per_width = 100;
  std::vector<Spot> spots;
  for (const auto& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const Spot here{place(panel.x, ranges.x, curve.x[i]), place(panel.y, ranges.y, curve.y[i])};
      const bool joined = i > 0 && curve.mark != Mark::points;
      const Spot from =
          joined ? Spot{place(panel.x, ranges.x, curve.x[i - 1]), place(panel.y, ranges.y, curve.y[i - 1])} : here;
      const double length = std::min(std::hypot(here.x - from.x, here.y - from.y), 10.0);
      const int steps = 1 + static_cast<int>(length * per_width);
      for (int k = 1; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        spots.push_back({from.x + t * (here.x - from.x), from.y + t * (here.y - from.y)});
      }
    }
  }
  for (const auto& note : panel.notes)
    spots.push_back({place(panel.x, ranges.x, note.x), place(panel.y, ranges.y, note.y)});
  return spots;
}

}  // namespace

void validate(const Plot& plot) {
  const std::string where = "plot '" + plot.title + "'";
  if (plot.panels.empty()) throw InputError(where, "no panel", "at least one");
  if (plot.columns < 1) throw InputError(where, fmt::format("{} columns", plot.columns), "at least one");
  for (const auto& panel : plot.panels) {
    const std::string panel_name = panel.title.empty() ? where : where + ", panel '" + panel.title + "'";
    require_range(panel.x, panel_name + ", x axis");
    require_range(panel.y, panel_name + ", y axis");
    if (panel.curves.empty()) throw InputError(panel_name, "no curve", "at least one");
    for (const auto& curve : panel.curves) {
      const std::string curve_name = panel_name + ", curve '" + curve.name + "'";
      if (curve.x.size() != curve.y.size() || curve.x.empty())
        throw InputError(curve_name, fmt::format("{} x and {} y", curve.x.size(), curve.y.size()),
                         "as many of each, and at least one");
      require_drawable(panel.x, curve.x, curve_name + ", x");
      require_drawable(panel.y, curve.y, curve_name + ", y");
    }
    for (const auto& note : panel.notes) {
      require_drawable(panel.x, {note.x}, panel_name + ", note '" + note.text + "'");
      require_drawable(panel.y, {note.y}, panel_name + ", note '" + note.text + "'");
    }
  }
}

PanelRanges ranges(const Panel& panel) {
  return {range_of(panel.x, panel, &Curve::x, Air::none), range_of(panel.y, panel, &Curve::y, Air::some)};
}

Legend place_legend(const Panel& panel, const PanelRanges& ranges, const LegendSize& size) {
  if (std::none_of(panel.curves.begin(), panel.curves.end(), [](const Curve& c) { return !c.name.empty(); }))
    return Legend::none;
  if (size.width > 0.9 || size.height > 0.9) return Legend::below;
  struct Corner {
    Legend legend;
    double left, bottom;
  };
  const std::array<Corner, 4> corners{{{Legend::top_left, 0.0, 1.0 - size.height},
                                       {Legend::top_right, 1.0 - size.width, 1.0 - size.height},
                                       {Legend::bottom_right, 1.0 - size.width, 0.0},
                                       {Legend::bottom_left, 0.0, 0.0}}};
  const std::vector<Spot> spots = drawn_spots(panel, ranges);
  for (const auto& corner : corners) {
    const bool covers = std::any_of(spots.begin(), spots.end(), [&](const Spot& spot) {
      return spot.x >= corner.left && spot.x <= corner.left + size.width && spot.y >= corner.bottom &&
             spot.y <= corner.bottom + size.height;
    });
    if (!covers) return corner.legend;
  }
  return Legend::below;
}

}  // namespace osculate::io
