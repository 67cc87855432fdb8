#include "validation/flow/heap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/scene.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/simulation.hpp"
#include "validation/flow/scenes.hpp"

namespace osculate::validation {
namespace {

std::string scene_of(const HeapCase& heap) {
  return varied(repose_scene(),
                {{"friction = 0.6", fmt::format("friction = {}", heap.friction)},
                 {"count = 300", fmt::format("count = {}", heap.grains)},
                 {"n = [3, 3]", fmt::format("n = [{0}, {0}]", heap.exponent)},
                 {"velocity = [0, 0, -0.3]", fmt::format("velocity = [0, 0, -0.3]\nseed = {}", heap.seed)}});
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
  const io::Scene scene = io::parse_scene(scene_of(heap), "angle-of-repose.toml");
  Simulation simulation(scene.setup);
  constexpr double between_looks = 1e-3;  // s
  while (simulation.steps() < scene.steps()) {
    simulation.advance(std::min(scene.steps_in(between_looks), scene.steps() - simulation.steps()));
    if (done) done(simulation.time() / scene.duration);
  }
  std::vector<Vec3> centroids;
  for (std::size_t i = 0; i < simulation.bodies().size(); ++i)
    if (simulation.bodies().is_free(i)) centroids.push_back(simulation.bodies().position[i]);
  return cone_angle(centroids);
}

}  // namespace osculate::validation
