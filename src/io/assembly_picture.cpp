#include "io/assembly_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/particle_values.hpp"
#include "io/quantity_text.hpp"
#include "osculate/core/error.hpp"
#include "osculate/shapes/mesh.hpp"

namespace osculate::io {
namespace {

constexpr Colour wall_colour{0.95, 0.955, 0.97};
constexpr Colour edge_colour{0.50, 0.53, 0.58};
constexpr int wall_pieces = 96;

/// Colours that stay apart for shapes, then for ids, in turn.
constexpr Colour kinds[] = {{0.27, 0.50, 0.73}, {0.91, 0.61, 0.24}, {0.22, 0.62, 0.50}, {0.79, 0.36, 0.29},
                            {0.60, 0.45, 0.68}, {0.86, 0.76, 0.36}, {0.47, 0.68, 0.82}, {0.64, 0.50, 0.40}};

/// Fine enough for the size in which a body appears: about three pixels a cell along its outline.
int mesh_resolution(double radius_px) {
  return std::clamp(2 * static_cast<int>(std::lround(radius_px / 5.0)), 4, 64);
}

std::vector<Vec3> corners_of(const Box& box) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? box.upper.x() : box.lower.x(), (i & 2) != 0 ? box.upper.y() : box.lower.y(),
                         (i & 4) != 0 ? box.upper.z() : box.lower.z());
  }
  return corners;
}

PictureBody body_of(const WallFace& face) {
  PictureBody body{.mesh = {.vertices = face.corners, .normals = face.normals, .triangles = {}}, .colour = wall_colour};
  for (int i = 2; i < static_cast<int>(face.corners.size()); ++i) body.mesh.triangles.push_back({0, i - 1, i});
  return body;
}

/// The piece of a rod that lies along the box.
PictureBody rod_body(const Cylinder& rod, const Pose& pose, const Box& extent) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& corner : corners_of(extent)) {
    const double along = pose.to_body(corner).z();
    low = std::min(low, along);
    high = std::max(high, along);
  }
  PictureBody body{.mesh = {}, .pose = pose, .colour = wall_colour};
  for (int i = 0; i < wall_pieces; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / wall_pieces;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    for (const double z : {low, high}) {
      body.mesh.vertices.push_back(rod.radius * out + z * Vec3::UnitZ());
      body.mesh.normals.push_back(out);
    }
    const int a = 2 * i, b = 2 * ((i + 1) % wall_pieces);
    body.mesh.triangles.push_back({a, b, a + 1});
    body.mesh.triangles.push_back({b, b + 1, a + 1});
  }
  return body;
}

void add_walls(Picture& picture, const std::vector<PlacedShape>& walls, const Box& extent) {
  const WallSurface surface = wall_surface(walls, extent, wall_pieces);
  for (const WallFace& face : surface.faces) {
    picture.bodies.push_back(body_of(face));
    picture.view.shows.insert(picture.view.shows.end(), face.corners.begin(), face.corners.end());
  }
  for (const WallEdge& edge : surface.edges) {
    picture.lines.push_back({.points = {edge.from, edge.to}, .colour = edge_colour, .width = 1.6});
  }
  for (const PlacedShape& wall : walls) {
    const auto* rod = std::get_if<Cylinder>(&wall.shape);
    if (rod != nullptr && rod->solid == Cylinder::Solid::inside) {
      picture.bodies.push_back(rod_body(*rod, wall.pose, extent));
    }
  }
}

/// A surface that lets the particles be seen on either side, and its edges where it turns.
void add_mesh(Picture& picture, const ResultsMesh& mesh, const Pose& pose) {
  constexpr double opacity = 0.35, turns = 0.9;  // the cosine between faces whose edge is drawn
  PictureBody body{.mesh = {}, .colour = wall_colour, .opacity = opacity};
  const MeshSurface surface = mesh_surface(mesh.triangles);
  for (const SurfaceFace& face : surface.faces) {
    const Vec3 normal = pose.rotate_to_world(face.normal);
    const bool shown = normal.dot(picture.view.towards_viewer) >= 0.0;
    const int first = static_cast<int>(body.mesh.vertices.size());
    for (const Vec3& corner : face.corners) {
      body.mesh.vertices.push_back(pose.to_world(corner));
      body.mesh.normals.push_back(shown ? normal : Vec3(-normal));
    }
    body.mesh.triangles.push_back({first, shown ? first + 1 : first + 2, shown ? first + 2 : first + 1});
  }
  picture.bodies.push_back(std::move(body));
  for (const SurfaceEdge& edge : surface.edges) {
    const auto normal = [&](std::size_t k) { return surface.faces[static_cast<std::size_t>(edge.faces[k])].normal; };
    if (edge.faces.size() == 2 && std::fabs(normal(0).dot(normal(1))) > turns) continue;
    picture.lines.push_back(
        {.points = {pose.to_world(edge.from), pose.to_world(edge.from + edge.length * edge.direction)},
         .colour = edge_colour,
         .width = 1.6});
  }
}

/// Meshes are seen as far as the particles are large.
Box with_meshes(const Box& particles, const ParticleFrame& frame, const ResultsHead& head) {
  const Vec3 margin = Vec3::Constant((particles.upper - particles.lower).norm());
  Box extent = particles;
  for (std::size_t m = 0; m < head.meshes.size(); ++m)
    for (const Vec3& vertex : head.meshes[m].triangles.vertices) {
      const Vec3 at = frame.meshes.at(m).to_world(vertex);
      const Vec3 near = at.cwiseMax(particles.lower - margin).cwiseMin(particles.upper + margin);
      extent = united(extent, {near, near});
    }
  return extent;
}

std::vector<PlacedShape> placed_walls(const ParticleFrame& frame, const ResultsHead& head) {
  std::vector<PlacedShape> walls;
  for (std::size_t w = 0; w < head.walls.size(); ++w) walls.push_back({head.walls[w].shape, frame.walls.at(w)});
  return walls;
}

/// A drum that is not far larger than what it holds is seen all around.
Box with_drums(const Box& particles, const std::vector<PlacedShape>& walls) {
  Box extent = particles;
  const double size = (particles.upper - particles.lower).norm();
  for (const PlacedShape& wall : walls) {
    const auto* drum = std::get_if<Cylinder>(&wall.shape);
    if (drum == nullptr || drum->solid == Cylinder::Solid::inside || drum->radius > size) continue;
    const Vec3 axis = wall.pose.rotate_to_world(Vec3::UnitZ());
    const Vec3 middle = 0.5 * (particles.lower + particles.upper);
    const Vec3 centre = wall.pose.position + axis * axis.dot(middle - wall.pose.position);
    const Vec3 reach = drum->radius * (1.0 - axis.array().square()).max(0.0).sqrt().matrix();
    extent = united(extent, {centre - reach, centre + reach});
  }
  return extent;
}

/// The edges of the box; along an axis that does not repeat it reaches as far as the particles.
void add_periodic_box(Picture& picture, const PeriodicBox& box, Box edges) {
  if (!box.repeats()) return;
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(box.length[axis])) continue;
    edges.lower[axis] = box.origin[axis];
    edges.upper[axis] = box.origin[axis] + box.length[axis];
  }
  const std::vector<Vec3> corners = corners_of(edges);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const std::size_t axis : {1U, 2U, 4U}) {
      if ((i & axis) != 0) continue;
      picture.lines.push_back({.points = {corners[i], corners[i | axis]}, .colour = edge_colour, .width = 1.6});
    }
  }
}

Vec3 towards_viewer(const AssemblyLook& look) {
  if (!(std::fabs(look.elevation) < 90.0)) {
    throw InputError("view", fmt::format("an elevation of {}°", look.elevation), "one between -90° and 90°");
  }
  const double azimuth = look.azimuth * std::numbers::pi / 180.0, elevation = look.elevation * std::numbers::pi / 180.0;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

}  // namespace

Box extent_of(const ParticleFrame& frame, const ResultsHead& head) {
  if (frame.position.empty()) throw InputError("results", "a frame without particles", "at least one");
  require_shapes(frame, head);
  std::vector<double> radius;
  for (const ResultsShape& shape : head.shapes) {
    radius.push_back(bounding_radius(shape.shape) + shape.frame.position.norm());
  }
  const Vec3 far = Vec3::Constant(std::numeric_limits<double>::infinity());
  Box extent{far, -far};
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec3 reach = Vec3::Constant(radius[frame.shape[i]]);
    extent = united(extent, {frame.position[i] - reach, frame.position[i] + reach});
  }
  extent = with_meshes(with_drums(extent, placed_walls(frame, head)), frame, head);
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(head.box.length[axis])) continue;
    extent.lower[axis] = std::min(extent.lower[axis], head.box.origin[axis]);
    extent.upper[axis] = std::max(extent.upper[axis], head.box.origin[axis] + head.box.length[axis]);
  }
  return extent;
}

Box united(const Box& one, const Box& other) {
  return {one.lower.cwiseMin(other.lower), one.upper.cwiseMax(other.upper)};
}

std::vector<double> values_of(const ParticleFrame& frame, const ResultsHead& head, ParticleColour colour) {
  std::vector<double> values;
  if (colour == ParticleColour::speed) {
    for (const Vec3& velocity : frame.velocity) values.push_back(velocity.norm());
  }
  if (colour == ParticleColour::kinetic_energy) values = kinetic_energies(frame, head);
  return values;
}

Picture assembly_picture(const ParticleFrame& frame, const ResultsHead& head, const AssemblyLook& look) {
  require_shapes(frame, head);
  Picture picture{.title = look.title, .width = look.width, .height = look.height};
  picture.view.towards_viewer = towards_viewer(look);
  picture.view.shows = corners_of(look.extent);
  picture.notes.push_back(fmt::format("t = {}     {} particle{}", quantity_text(frame.time, "s"), frame.size(),
                                      frame.size() == 1 ? "" : "s"));
  const std::vector<double> values = values_of(frame, head, look.colour);
  const bool by_energy = look.colour == ParticleColour::kinetic_energy;
  const PrefixedUnit unit = prefixed_unit(look.most, by_energy ? "J" : "m/s");
  if (!values.empty()) {
    picture.colour_bar = {.title = fmt::format("{} ({})", by_energy ? "kinetic energy" : "speed", unit.symbol),
                          .lower = 0.0,
                          .upper = look.most / unit.size};
  }

  // About how large a metre will appear, for the meshes only.
  const double px_per_metre = std::min(look.width, look.height) / (look.extent.upper - look.extent.lower).norm();
  std::vector<PictureSwarm> swarms(head.shapes.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const ResultsShape& shape = head.shapes[frame.shape[i]];
    PictureSwarm& swarm = swarms[frame.shape[i]];
    if (swarm.poses.empty()) {
      const double radius = bounding_radius(shape.shape);
      swarm.mesh = surface_mesh(shape.shape, mesh_resolution(radius * px_per_metre));
      largest = std::max(largest, radius);
    }
    swarm.poses.push_back(shape_pose_of(frame, head, i));
    if (!values.empty()) {
      swarm.scalars.push_back(values[i] / unit.size);
    } else {
      const std::uint32_t kind = look.colour == ParticleColour::shape ? frame.shape[i] : frame.id[i];
      swarm.colours.push_back(kinds[kind % std::size(kinds)]);
    }
  }
  for (PictureSwarm& swarm : swarms) {
    if (!swarm.poses.empty()) picture.swarms.push_back(std::move(swarm));
  }
  picture.shade_radius = 0.9 * largest;
  const Vec3 margin = Vec3::Constant(0.5 * largest);
  add_walls(picture, placed_walls(frame, head), {look.extent.lower - margin, look.extent.upper + margin});
  for (std::size_t m = 0; m < head.meshes.size(); ++m) add_mesh(picture, head.meshes[m], frame.meshes.at(m));
  add_periodic_box(picture, head.box, look.extent);
  return picture;
}

}  // namespace osculate::io
