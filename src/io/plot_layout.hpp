#pragma once
// What a panel's numbers ask of its axes and its legend.

#include <optional>
#include <vector>

#include "io/plot.hpp"

namespace osculate::io {

/// Throws InputError for a plot that cannot be drawn, naming panel and curve.
void validate(const Plot& plot);

struct PanelRanges {
  PlotRange x;
  PlotRange y;
};

/// The ranges that were asked for, or those that the curves fill, with a little air above and below.
PanelRanges ranges(const Panel& panel);

enum class Legend { none, top_left, top_right, bottom_left, bottom_right, below };

/// Size of a legend over that of its panel.
struct LegendSize {
  double width;
  double height;
};

/// The corner whose legend would cover no curve and no note; below the panel if there is none.
Legend place_legend(const Panel& panel, const PanelRanges& ranges, const LegendSize& size);

}  // namespace osculate::io
