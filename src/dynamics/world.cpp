#include "dynamics/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "dynamics/pouring.hpp"
#include "osculate/core/error.hpp"

namespace osculate {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

void require(bool sound, const std::string& where, const std::string& found, const std::string& expected) {
  if (!sound) throw InputError(where, found, expected);
}

void require_index(std::int32_t index, std::size_t count, const std::string& where, const std::string& what) {
  require(index >= 0 && static_cast<std::size_t>(index) < count, where, what + " " + std::to_string(index),
          count == 0 ? "one that exists; there is none" : "0 to " + std::to_string(count - 1));
}

/// Calls check() and puts a place before what it complains about.
template <class Check>
void at_place(const std::string& where, const Check& check) {
  try {
    check();
  } catch (const InputError& error) {
    throw InputError(where, error);
  }
}

void check_numbers(const Setup& setup) {
  require(setup.time_step > 0.0 && std::isfinite(setup.time_step), "time step", number(setup.time_step) + " s",
          "a finite value > 0");
  require(setup.gravity.allFinite(), "gravity", "a number that is not finite", "three finite numbers");
  require(setup.skin > 0.0 && std::isfinite(setup.skin), "skin", number(setup.skin), "a finite value > 0");
  require(setup.radius_cap > 0.0 && std::isfinite(setup.radius_cap), "radius cap", number(setup.radius_cap),
          "a finite value > 0: a flat contact has no Hertz force");
  require(setup.threads >= 1, "threads", std::to_string(setup.threads), "1 or more");
  validate(setup.box);
}

void check_materials(const Setup& setup) {
  for (std::size_t i = 0; i < setup.materials.size(); ++i) {
    const Material& material = setup.materials[i];
    const std::string where = "material " + std::to_string(i) + " (" + material.name + ")";
    at_place(where, [&] { validate(material.elastic); });
    require(material.density > 0.0 && std::isfinite(material.density), where,
            "density " + number(material.density) + " kg/m³", "a finite value > 0");
  }
  std::vector<std::pair<std::int32_t, std::int32_t>> seen;
  for (std::size_t i = 0; i < setup.interactions.size(); ++i) {
    const Interaction& interaction = setup.interactions[i];
    const std::string where = "interaction " + std::to_string(i);
    require_index(interaction.material_1, setup.materials.size(), where, "material");
    require_index(interaction.material_2, setup.materials.size(), where, "material");
    const auto pair = std::minmax(interaction.material_1, interaction.material_2);
    require(std::find(seen.begin(), seen.end(), std::pair<std::int32_t, std::int32_t>(pair)) == seen.end(), where,
            "a second one between materials " + std::to_string(pair.first) + " and " + std::to_string(pair.second),
            "one");
    seen.emplace_back(pair);
  }
}

void check_body(const Setup& setup, std::size_t i) {
  constexpr double unit_tolerance = 1e-6;
  const BodyStart& body = setup.bodies[i];
  const std::string where = "body " + std::to_string(i);
  require_index(body.shape, setup.shapes.size(), where, "shape");
  require_index(body.material, setup.materials.size(), where, "material");
  const bool is_free = body.motion == Bodies::free;
  if (!is_free) require_index(body.motion, setup.motions.size(), where, "motion");
  const Shape& shape = setup.shapes[static_cast<std::size_t>(body.shape)];
  require(!is_free || is_particle(shape), where, "a free " + std::string(kind(shape)),
          "a wall to have a prescribed motion");
  require(body.pose.position.allFinite() && body.velocity.allFinite() && body.angular_velocity.allFinite(), where,
          "a position or velocity that is not finite", "finite numbers");
  const double norm = body.pose.orientation.norm();
  require(std::fabs(norm - 1.0) <= unit_tolerance, where, "an orientation of norm " + number(norm),
          "a unit quaternion");
  require(is_free || (body.velocity.isZero(0.0) && body.angular_velocity.isZero(0.0)), where,
          "a velocity of a driven body", "none: its motion says how it moves");
}

std::vector<std::int32_t> laws_of(const Setup& setup) {
  const std::size_t count = setup.materials.size();
  std::vector<std::int32_t> law_of(count * count, -1);
  for (std::size_t i = 0; i < setup.interactions.size(); ++i) {
    const auto one = static_cast<std::size_t>(setup.interactions[i].material_1);
    const auto two = static_cast<std::size_t>(setup.interactions[i].material_2);
    law_of[one * count + two] = law_of[two * count + one] = static_cast<std::int32_t>(i);
  }
  return law_of;
}

/// Two materials whose bodies may meet: at least one of the bodies is free.
void require_laws(const World& world) {
  const Setup& setup = world.setup;
  std::vector<std::int64_t> free(setup.materials.size(), 0), all(setup.materials.size(), 0);
  for (const BodyStart& body : world.starts) {
    const auto material = static_cast<std::size_t>(body.material);
    ++all[material];
    if (body.motion == Bodies::free) ++free[material];
  }
  for (const Pour& pour : setup.pours)
    for (const Kind& kind : pour.kinds) {
      constexpr std::int64_t several = 2;
      all[static_cast<std::size_t>(kind.material)] += several;
      free[static_cast<std::size_t>(kind.material)] += several;
    }
  for (std::size_t one = 0; one < all.size(); ++one)
    for (std::size_t two = 0; two < all.size(); ++two) {
      const bool may_meet = free[one] > 0 && all[two] > (one == two ? 1 : 0);
      require(!may_meet || world.law_between(static_cast<std::int32_t>(one), static_cast<std::int32_t>(two)) >= 0,
              "interactions",
              "none between materials " + setup.materials[one].name + " and " + setup.materials[two].name,
              "one for every two materials whose bodies may meet");
    }
}

void add_meshes(World& world) {
  const Setup& setup = world.setup;
  world.starts = setup.bodies;
  for (std::size_t m = 0; m < setup.meshes.size(); ++m) {
    const MeshStart& mesh = setup.meshes[m];
    const std::string where = "mesh " + std::to_string(m);
    require_index(mesh.material, setup.materials.size(), where, "material");
    require_index(mesh.motion, setup.motions.size(), where, "motion");
    constexpr double unit_tolerance = 1e-6;
    require(mesh.pose.position.allFinite() && std::fabs(mesh.pose.orientation.norm() - 1.0) <= unit_tolerance, where,
            "a pose that is none", "a finite position and a unit quaternion");
    require(!setup.box.repeats(), where, "a surface of triangles in a periodic box", "space that does not repeat");
    world.first_face.push_back(static_cast<std::int32_t>(world.starts.size()));
    at_place(where, [&] {
      for (const BodyShape& face : face_shapes(mesh.triangles)) {
        world.starts.push_back({.shape = static_cast<std::int32_t>(world.shapes.size()),
                                .material = mesh.material,
                                .motion = mesh.motion,
                                .pose = mesh.pose});
        world.shapes.push_back(face);
      }
    });
  }
}

}  // namespace

World make_world(const Setup& setup) {
  check_numbers(setup);
  check_materials(setup);
  World world;
  world.setup = setup;
  world.box = setup.box;
  world.law_of = laws_of(setup);
  for (std::size_t i = 0; i < setup.shapes.size(); ++i)
    at_place("shape " + std::to_string(i), [&] { world.shapes.push_back(body_shape(setup.shapes[i])); });
  for (std::size_t i = 0; i < setup.motions.size(); ++i)
    at_place("motion " + std::to_string(i), [&] { validate(setup.motions[i]); });

  for (std::size_t i = 0; i < setup.bodies.size(); ++i) check_body(setup, i);
  for (std::size_t i = 0; i < setup.pours.size(); ++i) check_pour(setup, setup.pours[i], "pour " + std::to_string(i));
  add_meshes(world);
  bool any_free = false;
  double least_radius = std::numeric_limits<double>::infinity(), most_volume_radius = 0.0;
  world.least_half_width = least_radius;
  for (const BodyKind& kind : body_kinds(world)) {
    any_free = any_free || kind.is_free;
    const BodyShape& shape = world.shapes[static_cast<std::size_t>(kind.shape)];
    if (!is_particle(shape.shape)) continue;
    least_radius = std::min(least_radius, shape.bounding_radius);
    world.largest_radius = std::max(world.largest_radius, shape.bounding_radius);
    most_volume_radius = std::max(most_volume_radius, shape.volume_radius);
    world.least_half_width = std::min(world.least_half_width, shape.half_width);
  }
  require(any_free, "bodies", std::to_string(setup.bodies.size()) + " bodies, none of them free", "a free body");
  require_laws(world);
  if (setup.box.shear) {
    const bool any_driven = std::any_of(setup.bodies.begin(), setup.bodies.end(),
                                        [](const BodyStart& body) { return body.motion != Bodies::free; });
    require(!any_driven, "sheared box", "a wall or another driven body",
            "free bodies only: images of others would move");
    require(setup.pours.empty(), "sheared box", "a pour", "particles that are there from the start");
  }
  world.least_skin = 0.5 * setup.skin * least_radius;
  const double flattest = setup.radius_cap * most_volume_radius;
  for (const Interaction& interaction : setup.interactions) {
    world.reach.push_back(interaction.law.interaction_range(flattest, flattest));
    world.largest_reach = std::max(world.largest_reach, world.reach.back());
  }
  const double least_length = setup.box.length.minCoeff(),
               needed = 4.0 * world.largest_radius + 2.0 * world.largest_reach, room = 0.25 * (least_length - needed);
  require(room > world.least_skin, "periodic box", "a length of " + number(least_length) + " m",
          "more than " + number(needed + 4.0 * world.least_skin) +
              " m, or the largest particles would meet each other twice");
  world.most_skin = std::max(world.least_skin, std::min(world.largest_radius, room));
  return world;
}

void validate(const Setup& setup) {
  make_world(setup);
}

std::set<BodyKind> body_kinds(const World& world) {
  std::set<BodyKind> kinds;
  for (const BodyStart& body : world.setup.bodies)
    kinds.insert({body.shape, body.material, body.motion == Bodies::free});
  for (const std::int32_t face : world.first_face) {  // one stands for all of a mesh
    const BodyStart& start = world.starts[static_cast<std::size_t>(face)];
    kinds.insert({start.shape, start.material, false});
  }
  for (const Pour& pour : world.setup.pours)
    for (const Kind& kind : pour.kinds) kinds.insert({kind.shape, kind.material, true});
  return kinds;
}

void append_body(const World& world, const BodyStart& start, const std::string& where, Bodies& bodies) {
  const BodyShape& shape = world.shapes[static_cast<std::size_t>(start.shape)];
  const double density = world.setup.materials[static_cast<std::size_t>(start.material)].density;
  const double mass = density * shape.volume;
  const Vec3 inertia = density * shape.inertia;
  const Quat orientation = start.pose.orientation.normalized();
  const bool is_free = start.motion == Bodies::free;
  require(!is_free || (mass > 0.0 && inertia.minCoeff() > 0.0 && std::isfinite(mass)), where,
          "mass " + number(mass) + " kg", "a finite mass and inertia > 0");
  bodies.shape.push_back(start.shape);
  bodies.material.push_back(start.material);
  bodies.motion.push_back(start.motion);
  bodies.position.push_back(start.pose.position);
  bodies.orientation.push_back(orientation);
  bodies.velocity.push_back(start.velocity);
  bodies.angular_momentum.push_back(inertia.cwiseProduct(orientation.conjugate() * start.angular_velocity));
  bodies.force.push_back(Vec3::Zero());
  bodies.torque.push_back(Vec3::Zero());
  bodies.mass.push_back(mass);
  bodies.inertia.push_back(inertia);
}

Bodies make_bodies(const World& world) {
  Bodies bodies;
  const auto reserve = [&](auto&... items) { (items.reserve(world.starts.size()), ...); };
  reserve(bodies.shape, bodies.material, bodies.motion, bodies.position, bodies.orientation, bodies.velocity,
          bodies.angular_momentum, bodies.force, bodies.torque, bodies.mass, bodies.inertia);
  for (const BodyStart& start : world.starts)
    append_body(world, start, "body " + std::to_string(bodies.size()), bodies);
  return bodies;
}

}  // namespace osculate
