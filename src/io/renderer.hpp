#pragma once
// Triangles to pixels by software OpenGL (OSMesa): no display, no graphics card.

#include <cstdint>
#include <vector>

#include "io/colour.hpp"
#include "io/picture_triangles.hpp"
#include "osculate/shapes/mesh.hpp"

namespace osculate::io {

/// Rows from the top; red, green, blue, a byte each.
struct Image {
  int width;
  int height;
  std::vector<std::uint8_t> pixels;
};

/// One of many equal bodies.
struct RenderInstance {
  Mat3 rotation;  ///< body → picture
  Vec3 position;  ///< of the body's origin [px]
  Colour colour;
};

/// A mesh drawn once for each instance.
struct RenderSwarm {
  TriangleMesh mesh;  ///< [m]
  double scale;       ///< [px/m]
  std::vector<RenderInstance> instances;
};

/// Drawn in this order on white.
struct RenderScene {
  PictureTriangles opaque;
  std::vector<RenderSwarm> swarms = {};
  PictureTriangles translucent;  ///< sorted by depth; fronts only
  PictureTriangles on_top;       ///< over everything before
  int width;
  int height;
  double shade_radius = 0.0;  ///< of the shade in gaps between opaque things [px]; 0: none
};

/// Shades every pixel of three by three in each of the picture and averages them.
Image render(const RenderScene& scene);

}  // namespace osculate::io
