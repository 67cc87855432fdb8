#pragma once
// VTK's XML format for surfaces, as ParaView and VTK read it: arrays as compressed binary after the text.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace osculate::io {

/// A PolyData file of triangles under construction. Columns of numbers are taken as they are, 32 bits each.
class VtkSurface {
 public:
  VtkSurface(const std::vector<float>& points, const std::vector<std::int32_t>& triangles);

  /// One row a point.
  void add_point_data(std::string_view name, const std::vector<float>& values, int columns);
  void add_point_data(std::string_view name, const std::vector<std::int32_t>& values);
  /// The moment that the file shows [s].
  void set_time(double seconds) { time_ = seconds; }

  /// The file.
  std::string bytes() const;

 private:
  /// The description of an array that is appended to the data.
  std::string array(std::string_view type, std::string_view name, int columns, std::string_view raw);

  std::size_t points_, triangles_;
  double time_ = 0.0;
  std::string data_;
  std::string point_array_, connectivity_, offsets_, point_data_;
};

}  // namespace osculate::io
