#pragma once
// The numbers behind plots, for those who want to draw them anew.

#include <span>
#include <string>

#include "io/plot.hpp"

namespace osculate::io {

/// Comma-separated: panel, curve, what is along x, what is along y, x, y; one point a line, 17 digits.
std::string csv_of(const Plot& plot);

struct NamedPlot {
  std::string name;
  std::string caption;
  Plot plot;
};

/// The bytes of an HDF5 file: /NAME/panel_1/curve_1/{x, y}, numbered in the order of drawing. Attributes of a plot:
/// title, caption; of a panel: title, x, y (labels with units); of a curve: name.
std::string hdf5_of(std::span<const NamedPlot> plots);

}  // namespace osculate::io
