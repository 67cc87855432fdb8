#pragma once
// The visible part of walls without end: the polygons they cut out of a box.

#include <cstddef>
#include <vector>

#include "osculate/core/types.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate::io {

/// A shape where it is.
struct PlacedShape {
  Shape shape;
  Pose pose;
};

struct Box {
  Vec3 lower, upper;  ///< [m]
};

/// A flat piece of a wall, seen from the side where particles are.
struct WallFace {
  std::vector<Vec3> corners;  ///< convex, counter-clockwise seen from that side [m]
  std::vector<Vec3> normals;  ///< of the wall at the corners
  std::size_t wall;
};

/// Where two different walls meet, or a wall leaves the box.
struct WallEdge {
  Vec3 from, to;  ///< [m]
};

struct WallSurface {
  std::vector<WallFace> faces;
  std::vector<WallEdge> edges;
};

/// The walls that bound the space of particles (half-spaces, cylinders and spheres with particles inside), cut off at
/// the box and by each other. A cylinder and a sphere appear as `around` flat pieces around. Rods and particles among
/// the walls bound nothing and are left out. Without a piece of a wall inside the box there are no faces.
WallSurface wall_surface(const std::vector<PlacedShape>& walls, const Box& box, int around);

}  // namespace osculate::io
