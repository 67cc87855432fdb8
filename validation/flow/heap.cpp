#include "validation/flow/heap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "osculate/core/error.hpp"
#include "osculate/dynamics/insertion.hpp"
#include "osculate/dynamics/simulation.hpp"
#include "osculate/dynamics/size_distribution.hpp"
#include "validation/flow/grains.hpp"

namespace osculate::validation {
namespace {

constexpr double gravity = 9.81;                    // m/s²
constexpr double tube_radius = 22e-3;               // m
constexpr double lifting = 0.15, lift_speed = 0.2;  // s, m/s
constexpr double lifted = 0.7;                      // s: the tube is above the heap, and the heap at rest
enum Motions : std::int32_t { fixed, lift };

/// A tube of twelve staves on the floor.
void add_tube(Setup& setup) {
  constexpr int staves = 12;
  const Vec3 half_axes(3e-3, 7e-3, 45e-3);
  const auto shape = static_cast<std::int32_t>(setup.shapes.size());
  setup.shapes.emplace_back(Superquadric{.half_axes = half_axes, .exponents = {8.0, 8.0}});
  for (int i = 0; i < staves; ++i) {
    const Quat turn(Eigen::AngleAxisd(2.0 * std::numbers::pi * i / staves, Vec3::UnitZ()));
    constexpr double clear = 1.005;
    setup.bodies.push_back({.shape = shape,
                            .material = 0,
                            .motion = lift,
                            .pose = {turn * Vec3(tube_radius + half_axes.x(), 0.0, clear * half_axes.z()), turn}});
  }
}

Setup setup_of(const HeapCase& heap) {
  Setup setup;
  setup.gravity = Vec3(0.0, 0.0, -gravity);
  setup.materials = {{.name = "grain", .elastic = soft, .density = grain_density}};
  setup.interactions = {{0, 0, grain_law(heap.friction)}};
  setup.motions = {Fixed{}, Translation{.velocity = Vec3(0.0, 0.0, lift_speed),
                                        .begin = lifting,
                                        .end = std::numeric_limits<double>::infinity()}};
  const Superquadric grain{.half_axes = {2e-3, 2e-3, 3e-3}, .exponents = {heap.exponent, heap.exponent}};
  constexpr int classes = 3;
  std::vector<Kind> kinds;
  for (const double size : size_classes(UniformSizes{.least = 0.9, .most = 1.1}, classes)) {
    kinds.push_back({.shape = static_cast<std::int32_t>(setup.shapes.size()), .material = 0});
    setup.shapes.push_back(scaled(grain, size));
  }
  setup.bodies = {fixed_plane(Vec3::Zero(), Vec3::UnitZ(), static_cast<std::int32_t>(setup.shapes.size()), 0)};
  setup.shapes.emplace_back(HalfSpace{});
  add_tube(setup);
  constexpr double margin = 3e-3, throw_speed = 0.3, height = 90e-3;
  insert_randomly(
      setup,
      {.region = CylinderRegion{.base = Vec3(0.0, 0.0, margin), .radius = tube_radius - margin, .height = height},
       .kinds = kinds,
       .count = heap.grains,
       .seed = heap.seed,
       .velocity = Vec3(0.0, 0.0, -throw_speed)});
  setup.time_step = flow_time_step(setup);
  return setup;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double cone_angle(const std::vector<Vec3>& centroids) {
  if (centroids.empty()) throw InputError("a heap", "no grains", "one at least");
  std::vector<double> heights, distances;
  for (const Vec3& x : centroids) {
    heights.push_back(x.z());
    distances.push_back(std::hypot(x.x(), x.y()));
  }
  const double height = median(heights) / (1.0 - std::cbrt(0.5)), radius = 2.0 * median(distances);
  return std::atan2(height, radius);
}

double heap_angle(const HeapCase& heap, const std::function<void(double)>& done) {
  Simulation simulation(setup_of(heap));
  constexpr std::uint64_t between_looks = 100;  // steps
  while (simulation.time() < lifted) {
    simulation.advance(between_looks);
    if (done) done(std::min(1.0, simulation.time() / lifted));
  }
  std::vector<Vec3> centroids;
  for (std::size_t i = 0; i < simulation.bodies().size(); ++i)
    if (simulation.bodies().is_free(i)) centroids.push_back(simulation.bodies().position[i]);
  return cone_angle(centroids);
}

}  // namespace osculate::validation
