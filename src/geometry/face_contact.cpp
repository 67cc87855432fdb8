// Contacts of particles with the faces of a surface: which face makes which.

#include <algorithm>
#include <cmath>
#include <optional>

#include "osculate/geometry/common_normal.hpp"
#include "osculate/geometry/mesh_surface.hpp"
#include "osculate/geometry/relative_curvature.hpp"

namespace osculate {
namespace {

/// Two contacts along normals nearer than a degree are one.
constexpr double same_normal = 0.99984769515639124;

/// What lies on the border between two features belongs to both, within this share of the particle's size: of two that
/// claim one contact the deeper makes it.
constexpr double border = 1e-6;

/// The radius of rods and balls that stand for edges and vertices, in bounding radii of the particle.
constexpr double stand_in = 0.1;

/// A contact over a face, an edge or a vertex, in the surface's frame.
struct Touch {
  double overlap;
  Vec3 normal;  ///< from the surface to the particle
  /// Of an edge or vertex: from the particle to the stand-in.
  std::optional<ContactGeometry> with_stand_in = std::nullopt;
};

/// A particle over a surface, in the surface's frame.
class Probe {
 public:
  Probe(const Shape& shape, const Pose& pose, const MeshSurface& surface, double reach)
      : shape_(shape), pose_(pose), surface_(surface), size_(bounding_radius(shape)), reach_(reach) {}

  /// The particle's deepest point under a face's plane, on the side where it stands.
  struct Deepest {
    Vec3 normal;     ///< of the face, towards the particle
    Vec3 point;      ///< [m]
    double overlap;  ///< with the plane [m]
  };
  Deepest deepest(int face) const {
    const SurfaceFace& plane = surface_.faces[static_cast<std::size_t>(face)];
    const bool above = plane.normal.dot(pose_.position - plane.corners[0]) >= 0.0;
    const Vec3 normal = above ? plane.normal : Vec3(-plane.normal);
    const Vec3 point = pose_.to_world(support_point(shape_, pose_.rotate_to_body(-normal)));
    return {normal, point, normal.dot(plane.corners[0] - point)};
  }

  /// The deepest of the contacts that are this face's to make.
  std::optional<Touch> touch(int face) const {
    std::optional<Touch> best;
    const auto consider = [&](const std::optional<Touch>& one) {
      if (one && (!best || one->overlap > best->overlap)) best = one;
    };
    consider(over_face(face));
    const SurfaceFace& own = surface_.faces[static_cast<std::size_t>(face)];
    for (const int edge : own.edges)
      if (surface_.edges[static_cast<std::size_t>(edge)].faces.front() == face) consider(over_edge(edge));
    for (const int vertex : own.vertices)
      if (surface_.vertices[static_cast<std::size_t>(vertex)].faces.front() == face) consider(over_vertex(vertex));
    return best;
  }

  /// Another face's contact that is the same one and is to be preferred.
  bool is_anothers(int face, const Touch& own) const {
    const std::vector<int>& neighbours = surface_.faces[static_cast<std::size_t>(face)].neighbours;
    return std::any_of(neighbours.begin(), neighbours.end(), [&](int other) {
      // No contact of a face is deeper than its plane, but for rounding.
      if (deepest(other).overlap < own.overlap - border * size_) return false;
      const std::optional<Touch> rival = touch(other);
      if (!rival || rival->normal.dot(own.normal) < same_normal) return false;
      return rival->overlap > own.overlap || (rival->overlap == own.overlap && other < face);
    });
  }

 private:
  std::optional<Touch> over_face(int face) const {
    if (!is_over(face, border)) return std::nullopt;
    const Deepest under = deepest(face);
    return Touch{under.overlap, under.normal};
  }

  /// Whether the deepest point under a face lies over it, or at most `margin` of the particle's size beyond its sides.
  bool is_over(int face, double margin) const {
    const SurfaceFace& plane = surface_.faces[static_cast<std::size_t>(face)];
    const Vec3 point = deepest(face).point;
    for (std::size_t k = 0; k < 3; ++k)
      if (plane.outward[k].dot(point - plane.corners[k]) > margin * size_) return false;
    return true;
  }

  /// Whether the deepest point under a face lies beyond its side at a place, or nearly so.
  bool is_beyond(int face, const Vec3& place, const Vec3& into) const {
    return into.dot(deepest(face).point - place) < border * size_;
  }

  std::optional<Touch> over_edge(int index) const {
    const SurfaceEdge& edge = surface_.edges[static_cast<std::size_t>(index)];
    if (edge.is_flat) return std::nullopt;
    const Vec3 from_edge = pose_.position - edge.from;
    const double along = std::clamp(edge.direction.dot(from_edge), 0.0, edge.length);
    if ((from_edge - along * edge.direction).norm() > size_ + reach_) return std::nullopt;
    for (std::size_t k = 0; k < edge.faces.size(); ++k)
      if (!is_beyond(edge.faces[k], edge.from, edge.into[k])) return std::nullopt;
    const double radius = stand_in * size_;
    const std::optional<Touch> touch =
        against(Cylinder{.radius = radius, .solid = Cylinder::Solid::inside}, edge.pose, radius);
    if (!touch || !is_within(touch->normal, edge.into)) return std::nullopt;
    const double place = edge.direction.dot(touch->with_stand_in->on_2 - edge.from);
    if (place < -border * size_ || place > edge.length + border * size_) return std::nullopt;
    return touch;
  }

  std::optional<Touch> over_vertex(int index) const {
    const SurfaceVertex& vertex = surface_.vertices[static_cast<std::size_t>(index)];
    if (vertex.is_flat || (pose_.position - vertex.at).norm() > size_ + reach_) return std::nullopt;
    if (std::any_of(vertex.faces.begin(), vertex.faces.end(), [&](int face) { return is_over(face, -border); }))
      return std::nullopt;
    const double radius = stand_in * size_;
    const std::optional<Touch> touch = against(Sphere{radius}, {.position = vertex.at}, radius);
    if (!touch || !is_within(touch->normal, vertex.along)) return std::nullopt;
    return touch;
  }

  std::optional<Touch> against(const Shape& stand_in_shape, const Pose& pose, double radius) const {
    const ContactGeometry contact = common_normal(shape_, pose_, stand_in_shape, pose);
    const double overlap = contact.overlap - radius;
    if (!is_resolved(contact.status) || overlap < -reach_) return std::nullopt;
    return Touch{overlap, -contact.normal, contact};
  }

  /// Whether a normal leads away from all that lies in these directions: no face is nearer.
  static bool is_within(const Vec3& normal, const std::vector<Vec3>& directions) {
    return std::all_of(directions.begin(), directions.end(),
                       [&](const Vec3& direction) { return normal.dot(direction) <= border; });
  }

  const Shape& shape_;
  Pose pose_;
  const MeshSurface& surface_;
  double size_, reach_;
};

/// With a face: as with its whole plane.
ContactGeometry with_plane(const Shape& shape, const Pose& pose, const SurfaceFace& face, const Vec3& normal,
                           const Pose& surface_pose) {
  const Pose plane{.position = surface_pose.to_world(face.corners[0]),
                   .orientation = surface_pose.orientation * Quat::FromTwoVectors(Vec3::UnitZ(), normal)};
  return common_normal(shape, pose, HalfSpace{}, plane);
}

/// With an edge or vertex: as with the plane along the contact's normal through it.
ContactGeometry with_tangent_plane(const Touch& touch, const Pose& surface_pose) {
  const ContactGeometry& found = *touch.with_stand_in;
  ContactGeometry contact = found;
  contact.overlap = touch.overlap;
  contact.status = touch.overlap >= 0.0 ? ContactStatus::touching : ContactStatus::separated;
  contact.normal = surface_pose.rotate_to_world(found.normal);
  contact.on_1 = surface_pose.to_world(found.on_1);
  contact.on_2 = surface_pose.to_world(found.on_1 - touch.overlap * found.normal);
  contact.curvature_1.max_direction = surface_pose.rotate_to_world(found.curvature_1.max_direction);
  contact.curvature_2 = {.max = 0.0, .min = 0.0, .max_direction = contact.curvature_1.max_direction};
  contact.relative = relative_curvature(contact.normal, contact.curvature_1, contact.curvature_2);
  return contact;
}

}  // namespace

FaceContact face_contact(const Shape& shape, const Pose& pose, const MeshSurface& surface, const Pose& surface_pose,
                         int face, double reach) {
  const SurfaceFace& own = surface.faces[static_cast<std::size_t>(face)];
  const Pose seen{.position = surface_pose.to_body(pose.position),
                  .orientation = surface_pose.orientation.conjugate() * pose.orientation};
  const Probe probe(shape, seen, surface, reach);
  FaceContact result;
  result.contact.status = ContactStatus::separated;
  if (!seen.position.allFinite() || !seen.orientation.coeffs().allFinite()) {
    result.contact.status = ContactStatus::degenerate;
    return result;
  }
  const double gap = std::max(-probe.deepest(face).overlap, distance_to(own, seen.position) - bounding_radius(shape));
  result.contact.overlap = -std::max(gap, 0.0);
  if (gap > reach) return result;
  const std::optional<Touch> touch = probe.touch(face);
  if (!touch || probe.is_anothers(face, *touch)) return result;
  result.is_active = true;
  result.contact = touch->with_stand_in ? with_tangent_plane(*touch, surface_pose)
                                        : with_plane(shape, pose, own, touch->normal, surface_pose);
  return result;
}

}  // namespace osculate
