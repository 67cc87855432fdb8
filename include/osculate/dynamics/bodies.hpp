#pragma once
// The bodies of a simulation, structure of arrays.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "osculate/core/types.hpp"

namespace osculate {

/// Entry i of every vector belongs to one body. Free bodies obey forces; driven ones follow a prescribed motion. Walls
/// are driven bodies.
struct Bodies {
  static constexpr std::int32_t free = -1;

  std::vector<std::int32_t> shape;     ///< index into the shapes
  std::vector<std::int32_t> material;  ///< index into the materials
  std::vector<std::int32_t> motion;    ///< index into the motions, or `free`
  std::vector<Vec3> position;          ///< of the centroid [m]; in a periodic box not always wrapped
  std::vector<Quat> orientation;       ///< body → world
  std::vector<Vec3> velocity;          ///< [m/s]
  std::vector<Vec3> angular_momentum;  ///< [kg m²/s], body frame; zero for driven bodies
  std::vector<Vec3> force;             ///< by contacts [N]
  std::vector<Vec3> torque;            ///< by contacts, about the centroid [N m], world
  std::vector<double> mass;            ///< [kg]; 0 for walls
  std::vector<Vec3> inertia;           ///< principal moments [kg m²]; 0 for walls

  std::size_t size() const { return position.size(); }
  Pose pose(std::size_t i) const { return {position[i], orientation[i]}; }
  /// World frame [rad/s]. Zero for driven bodies: their motion knows.
  Vec3 angular_velocity(std::size_t i) const {
    if (!is_free(i)) return Vec3::Zero();
    return orientation[i] * angular_momentum[i].cwiseQuotient(inertia[i]);
  }
  bool is_free(std::size_t i) const { return motion[i] == free; }
};

}  // namespace osculate
