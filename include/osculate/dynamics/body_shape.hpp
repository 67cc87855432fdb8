#pragma once
// What the dynamics need to know of a shape, computed once.

#include <memory>

#include "osculate/geometry/mesh_surface.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate {

/// A shape as a rigid body of unit density. The body's frame has its origin in the centroid and the principal axes of
/// inertia as its axes.
struct BodyShape {
  Shape shape;
  Pose frame;              ///< of the shape in the body's frame: identity but for lopsided potential particles
  double volume;           ///< [m³]; 0 for walls
  Vec3 inertia;            ///< principal moments at unit density [m⁵]; 0 for walls
  double volume_radius;    ///< radius of the sphere of equal volume [m]; ∞ for walls
  double bounding_radius;  ///< of a sphere about the centroid that holds the body [m]; ∞ for walls
  double half_width;       ///< the least half extent of the oriented box [m]; ∞ for walls
  /// Of a face of a surface, which counts as a wall of finite size: `shape` is a half-space, and says nothing of where.
  std::shared_ptr<const MeshSurface> surface = nullptr;
  int face = 0;
  Vec3 centre = Vec3::Zero();  ///< of the bounding sphere, in the body's frame [m]: not zero for faces only

  bool is_face() const { return surface != nullptr; }
};

/// Throws InputError if the shape is not valid.
BodyShape body_shape(const Shape& shape);

/// The faces of a surface, each as a body of its own in the surface's frame. Throws InputError as mesh_surface does.
std::vector<BodyShape> face_shapes(const SurfaceTriangles& triangles);

/// Where the shape is when its body is at `body`.
Pose shape_pose(const BodyShape& shape, const Pose& body);

}  // namespace osculate
