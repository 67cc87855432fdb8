#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "io/body_keys.hpp"
#include "io/number_table.hpp"
#include "io/polyhedron.hpp"
#include "io/scene_parts.hpp"
#include "io/shape_file.hpp"
#include "osculate/dynamics/size_distribution.hpp"

namespace osculate::io {
namespace {

std::vector<double> read_sizes(const TomlTable& table) {
  if (!table.has("sizes")) return {1.0};
  const TomlTable sizes = table.table("sizes");
  constexpr int most_classes = 100;
  const std::string kind = sizes.choice("distribution", {"uniform", "lognormal", "weibull"});
  SizeDistribution distribution;
  if (kind == "uniform")
    distribution = UniformSizes{.least = sizes.number("least", Range::positive()),
                                .most = sizes.number("most", Range::positive())};
  else if (kind == "lognormal")
    distribution = LogNormalSizes{.median = sizes.number_or("median", 1.0, Range::positive()),
                                  .sigma = sizes.number("sigma", Range::not_negative())};
  else
    distribution = WeibullSizes{.scale = sizes.number_or("scale", 1.0, Range::positive()),
                                .modulus = sizes.number("modulus", Range::positive())};
  const int classes = sizes.integer("classes", 1, most_classes);
  sizes.reject_unknown_keys();
  try {
    return size_classes(distribution, classes);
  } catch (const InputError& error) {
    throw InputError(table.where("sizes"), error);
  }
}

Shape read_particle_shape(const TomlTable& table, const std::string& unit) {
  const Shape shape = parse_shape_of(table, "shape", unit).shape;
  if (!is_particle(shape))
    throw table.error("shape", fmt::format("a {}", kind(shape)), "a particle; walls stand under [[walls]]");
  const double scale = table.number_or("scale", 1.0, Range::positive());
  return scaled(shape, scale);
}

std::int32_t add_shape(const Shape& shape, const std::string& name, std::int32_t material, Scene& scene) {
  scene.setup.shapes.push_back(shape);
  scene.shape_names.push_back(name);
  scene.shape_materials.push_back(material);
  return static_cast<std::int32_t>(scene.setup.shapes.size()) - 1;
}

/// `motion` of a table; at rest where it is missing.
std::int32_t add_motion(const TomlTable& table, const std::string& unit, Setup& setup) {
  setup.motions.push_back(table.has("motion") ? read_motion(table.table("motion"), unit) : Motion{Fixed{}});
  try {
    validate(setup.motions.back());
  } catch (const InputError& error) {
    throw InputError(table.where("motion"), error);
  }
  return static_cast<std::int32_t>(setup.motions.size()) - 1;
}

Path read_path(const TomlTable& table, const std::string& unit) {
  Path path;
  if (table.has("file")) {
    const std::vector<std::string> columns{"t", "x", "y", "z"};
    const NumberTable numbers = read_numbers((table.file().parent_path() / table.text("file")).string(), columns);
    for (const std::string& name : columns)
      if (numbers.find(name) == nullptr)
        throw table.error("file", fmt::format("no column {}", name), "the columns t [s] and x, y, z [m]");
    for (std::size_t i = 0; i < numbers.rows(); ++i) {
      path.times.push_back((*numbers.find("t"))[i]);
      path.displacements.emplace_back((*numbers.find("x"))[i], (*numbers.find("y"))[i], (*numbers.find("z"))[i]);
    }
    return path;
  }
  const double length_unit = *length().in_si(unit.empty() ? "m" : unit);
  for (const auto& row : table.rows("points", 4)) {
    path.times.push_back(row[0]);
    path.displacements.push_back(length_unit * Vec3(row[1], row[2], row[3]));
  }
  return path;
}

/// A wall's shape and where it stands.
struct Placed {
  Shape shape;
  Pose pose;
};

Pose along(const Vec3& point, const Vec3& axis) {
  return {.position = point, .orientation = Quat::FromTwoVectors(Vec3::UnitZ(), axis)};
}

Placed read_wall(const TomlTable& table, const std::string& kind, const std::string& unit) {
  const Vec3 point = table.vector("point", length(), Range::any(), unit);
  if (kind == "plane") return {HalfSpace{}, along(point, read_direction(table, "normal"))};
  const double radius = table.quantity("radius", length(), Range::positive(), unit);
  if (kind == "sphere") return {SphereContainer{radius}, {.position = point}};
  const bool rod = table.choice("side", {"rod", "drum"}) == "rod";
  return {Cylinder{radius, rod ? Cylinder::Solid::inside : Cylinder::Solid::outside},
          along(point, read_direction(table, "axis"))};
}

/// Planes around a box, by the sides asked for.
std::vector<std::pair<std::string, Placed>> read_box(const TomlTable& table, const std::string& unit) {
  const Vec3 lower = table.vector("lower", length(), Range::any(), unit);
  const Vec3 upper = table.vector("upper", length(), Range::any(), unit);
  if (!(lower.array() < upper.array()).all())
    throw table.error("upper", "a corner that is not above the lower one", "lower < upper along every axis");
  const std::vector<std::string> all{"-x", "+x", "-y", "+y", "-z", "+z"};
  const std::vector<std::string> wanted = table.has("sides") ? table.texts("sides") : all;
  std::vector<std::pair<std::string, Placed>> sides;
  for (const std::string& side : wanted) {
    const auto found = std::find(all.begin(), all.end(), side);
    if (found == all.end())
      throw table.error("sides", fmt::format("\"{}\"", side), "sides out of -x, +x, -y, +y, -z, +z");
    const auto index = static_cast<Eigen::Index>(found - all.begin());
    const bool is_upper = index % 2 == 1;
    const Vec3 inward = (is_upper ? -1.0 : 1.0) * Vec3::Unit(index / 2);
    sides.emplace_back(side, Placed{HalfSpace{}, along(is_upper ? upper : lower, inward)});
  }
  return sides;
}

void add_wall(const Placed& placed, const std::string& name, std::int32_t material, std::int32_t motion, Scene& scene) {
  const auto body = static_cast<std::int32_t>(scene.setup.bodies.size());
  scene.walls.push_back({name, body});
  scene.setup.bodies.push_back({.shape = add_shape(placed.shape, name, material, scene),
                                .material = material,
                                .motion = motion,
                                .pose = placed.pose});
}

/// A surface from a file, whose polygons become triangles around their first corners.
MeshStart read_mesh(const TomlTable& table, const std::string& unit, std::int32_t material, std::int32_t motion) {
  const double metre = *length().in_si(unit) * table.number_or("scale", 1.0, Range::positive());
  MeshStart mesh{.triangles = {},
                 .material = material,
                 .motion = motion,
                 .pose = {.position = Vec3::Zero(), .orientation = read_orientation(table)}};
  if (table.has("position")) mesh.pose.position = table.vector("position", length(), Range::any(), unit);
  const std::filesystem::path path = table.file().parent_path() / table.text("file");
  try {
    const Polyhedron solid = read_polyhedron(path);
    for (const Vec3& vertex : solid.vertices) mesh.triangles.vertices.push_back(metre * vertex);
    for (const std::vector<int>& polygon : solid.polygons)
      for (std::size_t k = 2; k < polygon.size(); ++k)
        mesh.triangles.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
    mesh_surface(mesh.triangles);
  } catch (const InputError& error) {
    throw InputError(table.where("file"), error);
  }
  return mesh;
}

void read_walls(const TomlTable& table, const std::string& unit, Scene& scene) {
  const std::string kind = table.choice("kind", {"plane", "cylinder", "sphere", "box", "mesh"});
  const std::string name = table.text_or("name", kind);
  const std::int32_t material = material_index(table, scene);
  const std::int32_t motion = add_motion(table, unit, scene.setup);
  if (kind == "mesh") {
    scene.mesh_names.push_back(name);
    scene.setup.meshes.push_back(read_mesh(table, unit, material, motion));
  } else if (kind == "box")
    for (const auto& [side, placed] : read_box(table, unit))
      add_wall(placed, fmt::format("{} {}", name, side), material, motion, scene);
  else
    add_wall(read_wall(table, kind, unit), name, material, motion, scene);
  table.reject_unknown_keys();
}

/// An obstacle and its copies turned about an axis.
void read_obstacle(const TomlTable& table, const std::string& unit, Scene& scene) {
  constexpr int most_copies = 1000;
  const std::int32_t material = material_index(table, scene);
  const Shape shape = read_particle_shape(table, unit);
  const std::int32_t index = add_shape(shape, table.text_or("name", "obstacle"), material, scene);
  const std::int32_t motion = add_motion(table, unit, scene.setup);
  const Pose pose{.position = table.vector("position", length(), Range::any(), unit),
                  .orientation = read_orientation(table)};
  int copies = 1;
  Vec3 point = Vec3::Zero(), axis = Vec3::UnitZ();
  if (table.has("ring")) {
    const TomlTable ring = table.table("ring");
    copies = ring.integer("count", 1, most_copies);
    point = ring.vector("point", length(), Range::any(), unit);
    axis = read_direction(ring, "axis");
    ring.reject_unknown_keys();
  }
  table.reject_unknown_keys();
  for (int k = 0; k < copies; ++k) {
    const Quat turn(Eigen::AngleAxisd(2.0 * std::numbers::pi * k / copies, axis));
    scene.setup.bodies.push_back({.shape = index,
                                  .material = material,
                                  .motion = motion,
                                  .pose = {.position = point + turn * (pose.position - point),
                                           .orientation = (turn * pose.orientation).normalized()}});
  }
}

}  // namespace

std::vector<ParticleKind> read_particles(const TomlTable& file, const std::string& unit, Scene& scene) {
  std::vector<ParticleKind> kinds;
  for (const TomlTable& table : file.tables("particles")) {
    const std::string name = table.text("name");
    if (std::any_of(kinds.begin(), kinds.end(), [&](const ParticleKind& kind) { return kind.name == name; }))
      throw table.error("name", fmt::format("second particles \"{}\"", name), "a name of their own");
    const std::int32_t material = material_index(table, scene);
    const Shape shape = read_particle_shape(table, unit);
    const std::vector<double> sizes = read_sizes(table);
    kinds.push_back({name, static_cast<std::int32_t>(scene.setup.shapes.size()),
                     static_cast<std::int32_t>(sizes.size()), material});
    for (const double size : sizes)
      add_shape(scaled(shape, size), sizes.size() == 1 ? name : fmt::format("{} x {:.4g}", name, size), material,
                scene);
    table.reject_unknown_keys();
  }
  return kinds;
}

Motion read_motion(const TomlTable& table, const std::string& unit) {
  const std::string kind = table.choice("kind", {"translation", "rotation", "oscillation", "path"});
  Motion motion;
  if (kind == "translation") {
    Translation translation{.velocity = table.vector("velocity", velocity(), Range::any()),
                            .end = std::numeric_limits<double>::infinity()};
    if (table.has("begin")) translation.begin = table.quantity("begin", duration(), Range::not_negative());
    if (table.has("end")) translation.end = table.quantity("end", duration(), Range::not_negative());
    motion = translation;
  } else if (kind == "rotation") {
    motion = Rotation{.point = table.vector("point", length(), Range::any(), unit),
                      .axis = read_direction(table, "axis"),
                      .rate = table.quantity("rate", angular_velocity(), Range::any())};
  } else if (kind == "oscillation") {
    Oscillation oscillation{.amplitude = table.vector("amplitude", length(), Range::any(), unit),
                            .frequency = table.quantity("frequency", frequency(), Range::not_negative())};
    if (table.has("phase")) oscillation.phase = table.quantity("phase", angle(), Range::any(), "deg");
    motion = oscillation;
  } else {
    motion = read_path(table, unit);
  }
  table.reject_unknown_keys();
  return motion;
}

void read_boundaries(const TomlTable& file, const std::string& unit, Scene& scene) {
  if (file.has("obstacles"))
    for (const TomlTable& table : file.tables("obstacles")) read_obstacle(table, unit, scene);
  if (file.has("walls"))
    for (const TomlTable& table : file.tables("walls")) read_walls(table, unit, scene);
}

}  // namespace osculate::io
