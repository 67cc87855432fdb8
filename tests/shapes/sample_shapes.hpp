#pragma once
// Bodies and directions that the tests of this room share.

#include <random>
#include <vector>

#include "osculate/shapes/shape.hpp"

namespace osculate::samples {

inline Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

inline std::vector<Superquadric> superquadrics() {
  return {
      {Vec3(0.01, 0.01, 0.01), {2.0, 2.0}}, {Vec3(0.01, 0.02, 0.03), {2.0, 2.0}}, {Vec3(1.0, 1.2, 0.7), {4.0, 4.0}},
      {Vec3(1.0, 1.0, 2.0), {8.0, 2.0}},    {Vec3(3.0, 1.0, 2.0), {2.0, 5.0}},    {Vec3(1e-5, 1e-5, 5e-5), {3.0, 3.0}},
      {Vec3(1.0, 2.0, 3.0), {12.0, 12.0}},  {Vec3(1.0, 1.0, 1.0), {1.3, 1.3}},    {Vec3(1.0, 0.5, 1.0), {1.5, 6.0}},
      {Vec3(1.0, 0.5, 1.0), {6.0, 1.2}},    {Vec3(1.0, 1.0, 0.1), {2.5, 3.7}},    {Vec3(1.0, 1.0, 1.0), {50.0, 50.0}}};
}

inline PotentialParticle potential_cube(double distance, double k, double r, double R) {
  PotentialParticle cube{{}, k, r, R};
  for (int axis = 0; axis < 3; ++axis) {
    cube.planes.push_back({Vec3::Unit(axis), distance});
    cube.planes.push_back({-Vec3::Unit(axis), distance});
  }
  return cube;
}

inline PotentialParticle potential_tetrahedron(double distance, double k, double r, double R) {
  PotentialParticle tetrahedron{{}, k, r, R};
  for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
    tetrahedron.planes.push_back({corner.normalized(), distance});
  }
  return tetrahedron;
}

/// No symmetry, and its centroid off the origin.
inline PotentialParticle potential_stone() {
  PotentialParticle stone{{}, 0.05, 0.003, 0.02};
  const std::vector<std::pair<Vec3, double>> planes = {
      {Vec3(1, 0.1, 0.2), 0.010}, {Vec3(-1, 0.3, 0.0), 0.012}, {Vec3(0.2, 1, -0.1), 0.008}, {Vec3(0.0, -1, 0.3), 0.011},
      {Vec3(0.1, 0.0, 1), 0.009}, {Vec3(0.3, 0.2, -1), 0.013}, {Vec3(1, 1, 1), 0.012}};
  for (const auto& [normal, distance] : planes) stone.planes.push_back({normal.normalized(), distance});
  return stone;
}

inline std::vector<PotentialParticle> potential_particles() {
  return {potential_cube(0.01, 0.01, 0.002, 0.02),        potential_cube(0.01, 0.3, 0.005, 0.02),
          potential_tetrahedron(0.01, 0.05, 0.003, 0.03), potential_stone(),
          potential_cube(1e-5, 1e-4, 1e-7, 2e-5),         potential_cube(0.01, 1.0, 0.001, 0.02)};
}

inline std::vector<Shape> particles() {
  std::vector<Shape> shapes = {Sphere{0.01}, Ellipsoid{Vec3(0.03, 0.01, 0.02)}};
  for (const auto& shape : superquadrics()) shapes.emplace_back(shape);
  for (const auto& shape : potential_particles()) shapes.emplace_back(shape);
  return shapes;
}

}  // namespace osculate::samples
