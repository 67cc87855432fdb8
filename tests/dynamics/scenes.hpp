#pragma once
// Small scenes for the tests of the engine.

#include <random>

#include "osculate/dynamics/simulation.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate {

inline Material soft_glass() {
  return {.name = "glass", .elastic = {.youngs_modulus = 1e8, .poissons_ratio = 0.25}, .density = 2500.0};
}

inline LawChoice elastic_law() {
  return {{"hertz", {}}};
}
inline LawChoice damped_frictional_law() {
  return {{"hertz", {}}, {"tsuji", {{"restitution", 0.5}}}, {"mindlin", {{"friction", 0.4}}}};
}

/// One material, one law, no bodies.
inline Setup one_material(const LawChoice& law, double time_step) {
  Setup setup;
  setup.materials = {soft_glass()};
  const ElasticMaterial& elastic = setup.materials[0].elastic;
  setup.interactions.push_back({0, 0, make_contact_law(law, elastic, elastic)});
  setup.motions = {Fixed{}};
  setup.time_step = time_step;
  return setup;
}

inline BodyStart at(std::int32_t shape, const Vec3& position, const Quat& orientation = Quat::Identity()) {
  return {.shape = shape, .material = 0, .pose = {.position = position, .orientation = orientation}};
}

inline Quat random_orientation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Quat(w, x, y, z).normalized();
}

inline BodyStart wall(std::int32_t shape, const Vec3& position, const Vec3& normal) {
  BodyStart start = at(shape, position, Quat::FromTwoVectors(Vec3::UnitZ(), normal));
  start.motion = 0;
  return start;
}

/// Particles that fall into an open box of planes: shape 0 is the half-space, the particles have the shapes given.
inline Setup settling(const LawChoice& law, const std::vector<Shape>& shapes, int per_edge, double spacing,
                      double time_step) {
  Setup setup = one_material(law, time_step);
  setup.gravity = {0.0, 0.0, -9.81};
  setup.shapes = {HalfSpace{}};
  setup.shapes.insert(setup.shapes.end(), shapes.begin(), shapes.end());
  const double width = per_edge * spacing;
  setup.bodies = {wall(0, Vec3::Zero(), Vec3::UnitZ()), wall(0, Vec3::Zero(), Vec3::UnitX()),
                  wall(0, Vec3::Zero(), Vec3::UnitY()), wall(0, {width, 0, 0}, -Vec3::UnitX()),
                  wall(0, {0, width, 0}, -Vec3::UnitY())};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> speed(-0.1, 0.1);
  std::int32_t next = 0;
  for (int k = 0; k < per_edge; ++k)
    for (int j = 0; j < per_edge; ++j)
      for (int i = 0; i < per_edge; ++i) {
        const std::int32_t shape = 1 + next++ % static_cast<std::int32_t>(shapes.size());
        BodyStart body = at(shape, spacing * Vec3(i + 0.5, j + 0.5, k + 0.5), random_orientation(random));
        const double x = speed(random), y = speed(random), z = speed(random);
        body.velocity = {x, y, z};
        body.angular_velocity = 100.0 * Vec3(y, z, x);
        setup.bodies.push_back(body);
      }
  return setup;
}

inline Superquadric blocky() {
  return {.half_axes = {2.5e-3, 2.5e-3, 2.5e-3}, .exponents = {4.0, 4.0}};
}
inline Superquadric box() {
  return {.half_axes = {2e-3, 2e-3, 4e-3}, .exponents = {6.0, 6.0}};
}
inline Ellipsoid candy() {
  return {.half_axes = {3e-3, 3e-3, 1.8e-3}};
}

}  // namespace osculate
