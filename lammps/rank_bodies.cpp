#include "lammps/rank_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "dynamics/chunk_forces.hpp"
#include "dynamics/driven_travel.hpp"
#include "io/nearest_name.hpp"
#include "osculate/core/error.hpp"

namespace osculate::lammps {

void require_supported(const Setup& setup) {
  const auto refuse = [](bool has, const std::string& found, const std::string& expected) {
    if (has) throw InputError("a scene on LAMMPS", found, expected + ", or the embedded engine");
  };
  refuse(!setup.pours.empty(), "a pour", "particles that are there from the start");
  refuse(!setup.meshes.empty(), "a mesh", "walls of other kinds");
  refuse(setup.box.shear.has_value(), "a sheared box", "a periodic box without shear");
}

std::vector<AtomKind> kinds_of(const Setup& setup) {
  std::set<std::pair<std::int32_t, std::int32_t>> found;
  for (const BodyStart& body : setup.bodies)
    if (body.motion == Bodies::free) found.emplace(body.shape, body.material);
  std::vector<AtomKind> kinds;
  for (const auto& [shape, material] : found) kinds.push_back({shape, material});
  return kinds;
}

std::vector<AtomKind> kinds_by_name(const io::Scene& scene, const std::vector<std::string>& names) {
  std::vector<AtomKind> kinds;
  for (const std::string& name : names) {
    const auto found = std::find(scene.shape_names.begin(), scene.shape_names.end(), name);
    const auto shape = found - scene.shape_names.begin();
    if (found == scene.shape_names.end() || !is_particle(scene.setup.shapes[static_cast<std::size_t>(shape)]))
      throw InputError(scene.file.string(), "found no particles named \"" + name + "\"",
                       fmt::format("one of {}", fmt::join(scene.shape_names, ", ")));
    kinds.push_back({static_cast<std::int32_t>(shape), scene.shape_materials[static_cast<std::size_t>(shape)]});
  }
  return kinds;
}

RankBodies make_rank_bodies(Setup setup, const std::vector<AtomKind>& kinds) {
  require_supported(setup);
  setup.box = {};  // images are LAMMPS's ghosts
  std::erase_if(setup.bodies, [](const BodyStart& body) { return body.motion == Bodies::free; });
  RankBodies rank;
  rank.driven = setup.bodies.size();
  // Two of each, so that the law between bodies of one kind is asked for.
  for (const AtomKind& kind : kinds)
    for (int k = 0; k < 2; ++k) setup.bodies.push_back({.shape = kind.shape, .material = kind.material, .pose = {}});
  rank.world = make_world(setup);
  rank.kinds = kinds;
  set_atoms(rank, 0, 0, nullptr);
  return rank;
}

void set_atoms(RankBodies& rank, std::size_t owned, std::size_t ghosts, const int* types) {
  rank.owned = owned;
  rank.ghosts = ghosts;
  const std::size_t size = rank.driven + owned + ghosts;
  Bodies& bodies = rank.bodies;
  bodies.shape.resize(size);
  bodies.material.resize(size);
  bodies.motion.assign(size, Bodies::free);
  bodies.position.resize(size, Vec3::Zero());
  bodies.orientation.resize(size, Quat::Identity());
  bodies.velocity.resize(size, Vec3::Zero());
  bodies.angular_momentum.resize(size, Vec3::Zero());
  bodies.force.resize(size, Vec3::Zero());
  bodies.torque.resize(size, Vec3::Zero());
  bodies.mass.resize(size);
  bodies.inertia.resize(size);
  rank.kinematics.records.resize(size);
  rank.kinematics.travel.assign(size, 0.0);
  rank.radius.resize(size);
  rank.way.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    AtomKind kind{};
    if (i < rank.driven) {
      const BodyStart& start = rank.world.setup.bodies[i];
      kind = {start.shape, start.material};
      bodies.motion[i] = start.motion;
    } else {
      kind = rank.kinds[static_cast<std::size_t>(types[i - rank.driven] - 1)];
    }
    const BodyShape& shape = rank.world.shapes[static_cast<std::size_t>(kind.shape)];
    const double density = rank.density(kind);
    bodies.shape[i] = kind.shape;
    bodies.material[i] = kind.material;
    bodies.mass[i] = density * shape.volume;
    bodies.inertia[i] = density * shape.inertia;
    rank.radius[i] = shape.bounding_radius;
    const auto numbers = superquadric_numbers(shape.shape);
    std::copy(numbers.begin(), numbers.end(), rank.kinematics.records[i].placed.begin());
  }
}

void place_driven(RankBodies& rank, double t, double dt, const Vec3& centre, double far) {
  const Setup& setup = rank.world.setup;
  for (std::size_t i = 0; i < rank.driven; ++i) {
    const BodyStart& start = setup.bodies[i];
    const Moving moving = at_time(setup.motions[static_cast<std::size_t>(start.motion)], start.pose, t);
    const Vec3 displacement = moving.pose.position - rank.bodies.position[i];
    BodyRecord& record = rank.kinematics.records[i];
    record.velocity = dt > 0.0 ? Vec3(displacement / dt) : moving.velocity;
    record.last_velocity = moving.velocity;
    record.mean_angular_velocity = record.last_angular_velocity = moving.angular_velocity;
    rank.bodies.position[i] = moving.pose.position;
    rank.bodies.orientation[i] = moving.pose.orientation;
    record.place(moving.pose.position, moving.pose.orientation);
    if (dt > 0.0)
      rank.kinematics.travel[i] +=
          driven_travel(rank.shape(i), moving.pose, {displacement, dt * moving.angular_velocity}, {centre, far});
  }
}

}  // namespace osculate::lammps
