#pragma once
// Surfaces of triangles as boundaries. They have two sides: a particle stays on the one where its centroid is, so that
// it does not matter how the triangles turn, and open sheets serve as well as closed bodies.

#include <array>
#include <vector>

#include "osculate/geometry/contact_geometry.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate {

/// Triangles of a surface and their corners, in the surface's frame.
struct SurfaceTriangles {
  std::vector<Vec3> vertices;                 ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< three vertex indices each
};

struct SurfaceFace {
  std::array<Vec3, 3> corners;  ///< [m]
  Vec3 normal;                  ///< unit
  std::array<Vec3, 3> outward;  ///< unit, in the plane: across the edge from corner k to the next
  std::array<int, 3> edges, vertices;
  std::vector<int> neighbours;  ///< faces that share a vertex, in increasing order
  Vec3 centre;                  ///< of a sphere that holds the face [m]
  double radius;                ///< of it [m]
};

struct SurfaceEdge {
  Vec3 from, direction;  ///< [m]; unit
  double length;         ///< [m]
  std::vector<int> faces;
  std::vector<Vec3> into;  ///< unit, from the edge into each of them
  Pose pose;               ///< of a cylinder along the edge
  bool is_flat;            ///< two faces in one plane: nothing to touch
};

struct SurfaceVertex {
  Vec3 at;  ///< [m]
  std::vector<int> faces;
  std::vector<Vec3> along;  ///< unit, along the edges that end here
  bool is_flat;             ///< all its edges are
};

/// Triangles that know their neighbours.
struct MeshSurface {
  std::vector<SurfaceFace> faces;
  std::vector<SurfaceEdge> edges;
  std::vector<SurfaceVertex> vertices;
};

/// Vertices that stand together within 1e-6 of the surface's size are one; triangles without an area are left out.
/// Throws InputError if no triangle is left, or for indices and coordinates that are none.
MeshSurface mesh_surface(const SurfaceTriangles& triangles);

/// The distance from a point to a face [m], in the surface's frame.
double distance_to(const SurfaceFace& face, const Vec3& point);

struct FaceContact {
  bool is_active = false;   ///< the contact is this face's to make
  ContactGeometry contact;  ///< body 1 is the particle; not active: overlap is minus a lower bound of the gap, or zero
};

/// What a particle has to do with one face of a surface. Of the contacts of a particle with faces next to each other
/// those along different normals are all there; one and the same is exactly one face's:
/// - over a face where the particle's deepest point lies over it, along its normal;
/// - over an edge or vertex where the surface is convex, along the normal of least overlap, which goes over from that
/// of
///   one face to that of the next without a jump; made by the first of the faces there;
/// - of two along one normal within a degree, as at the seams of a plane, the deeper one; of two as deep, the first
///   face's.
/// Edges and vertices count as flat: the radii of relative curvature are the particle's own, and go over, too.
/// @param reach  ≥ 0: gaps wider than this are not resolved [m]
FaceContact face_contact(const Shape& shape, const Pose& pose, const MeshSurface& surface, const Pose& surface_pose,
                         int face, double reach);

}  // namespace osculate
