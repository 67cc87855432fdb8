#pragma once
// A few particles of different shapes at one moment, for the tests of what is made of results.

#include "io/results_file.hpp"

namespace osculate::io {

/// A cylinder with sharp rims, a lentil, a ball and a lopsided stone.
inline ResultsHead sample_head() {
  PotentialParticle stone{.planes = {}, .sphericity = 0.3, .edge_radius = 1e-3, .sphere_radius = 4e-3};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) stone.planes.push_back({side * Vec3::Unit(axis), 2e-3 + 1e-4 * axis});
  return {.title = "samples",
          .scene = "",
          .shapes = {{"cylinder", Superquadric{{2e-3, 2e-3, 4e-3}, {8.0, 2.0}}, {}, "glass", 2500.0},
                     {"lentil", Ellipsoid{{3e-3, 2e-3, 1e-3}}, {}, "glass", 2500.0},
                     {"ball", Sphere{2e-3}, {}, "steel", 7800.0},
                     {"stone", stone, {{1e-4, -2e-4, 3e-4}, Quat(0.5, 0.5, -0.5, 0.5)}, "steel", 7800.0}},
          .walls = {{"floor", 0, HalfSpace{}}},
          .box = {}};
}

inline ParticleFrame sample_frame() {
  ParticleFrame frame{};
  frame.time = 0.25;
  frame.step = 1000;
  for (std::uint32_t i = 0; i < 5; ++i) {
    frame.id.push_back(10 + i);
    frame.shape.push_back(i % 4);
    frame.position.emplace_back(0.02 * i, 0.01, 0.005);
    frame.orientation.push_back(Quat(0.9, 0.1 * i, -0.3, 0.2).normalized());
    frame.velocity.emplace_back(0.1 * i, -0.2, 0.3);
    frame.angular_velocity.emplace_back(1.0, 2.0 * i, 3.0);
  }
  frame.walls = {Pose{}};
  return frame;
}

}  // namespace osculate::io
