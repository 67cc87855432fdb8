#pragma once
// A picture's things as triangles in its own pixels: x to the right, y up from the lower edge, z towards the viewer.

#include <array>
#include <cstdint>
#include <vector>

#include "io/picture.hpp"

namespace osculate::io {

/// Parallel projection of the world to pixels.
struct Projection {
  Mat3 to_view;                ///< rows: right, up, towards the viewer
  Vec3 centre = Vec3::Zero();  ///< [m], world
  double scale = 1.0;          ///< [px/m]
  Vec3 middle = Vec3::Zero();  ///< where the centre appears [px]

  Vec3 point(const Vec3& point_w) const { return scale * (to_view * (point_w - centre)) + middle; }
  Vec3 direction(const Vec3& direction_w) const { return to_view * direction_w; }
};

struct PictureVertex {
  std::array<float, 3> position;  ///< [px]
  std::array<float, 3> normal;
  std::array<float, 4> colour;
};

/// Triangles drawn together.
struct PictureTriangles {
  std::vector<PictureVertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

void add_body(PictureTriangles& triangles, const PictureBody& body, const std::optional<ColourBar>& bar,
              const Projection& projection);
void add_line(PictureTriangles& triangles, const PictureLine& line, const Projection& projection);
void add_arrow(PictureTriangles& triangles, const PictureArrow& arrow, const Projection& projection);
void add_point(PictureTriangles& triangles, const PicturePoint& point, const Projection& projection);

/// Orders triangles so that nearer ones are drawn later, as translucent ones must be.
void sort_by_depth(PictureTriangles& triangles);

}  // namespace osculate::io
