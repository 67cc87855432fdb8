#pragma once
// Triangles to pixels by software OpenGL (OSMesa): no display, no graphics card.

#include <cstdint>
#include <vector>

#include "io/picture_triangles.hpp"

namespace osculate::io {

/// Rows from the top; red, green, blue, a byte each.
struct Image {
  int width;
  int height;
  std::vector<std::uint8_t> pixels;
};

/// Drawn in this order on white.
struct RenderScene {
  PictureTriangles opaque;
  PictureTriangles translucent;  ///< sorted by depth; fronts only
  PictureTriangles on_top;       ///< over everything before
  int width;
  int height;
};

/// Shades every pixel of three by three in each of the picture and averages them.
Image render(const RenderScene& scene);

}  // namespace osculate::io
