#include "dynamics/pouring.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "dynamics/crowd.hpp"
#include "osculate/core/error.hpp"

namespace osculate {
namespace {

/// What a pour counts has rounding in it: a particle is due at the very moment it should come.
constexpr double rounding = 1e-9;

/// A particle on its way in.
struct Arrival {
  Kind kind;
  Vec3 velocity;
  std::uint64_t seed;
};

Arrival arrival(const Pour& pour, std::uint64_t number) {
  const std::uint64_t seed = numbered_seed(pour.seed, number);
  Random random(seed);
  const Kind& kind = pour.kinds[random.pick(weights_of(pour.kinds))];
  return {kind, random_velocity(pour.velocity, pour.fluctuation, random), seed};
}

double mass_of(const World& world, const Kind& kind) {
  return world.shapes[static_cast<std::size_t>(kind.shape)].volume *
         world.setup.materials[static_cast<std::size_t>(kind.material)].density;
}

bool is_due(const Pour& pour, const Poured& poured, double mass, double amount) {
  if (poured.particles >= pour.most) return false;
  const double next = arrived(pour, poured) + (pour.measure == Pour::Measure::mass ? mass : 1.0);
  return next <= amount * (1.0 + rounding);
}

/// The bodies that reach into the region, and all walls.
Crowd crowd_around(const World& world, const Bodies& bodies, const Pour& pour) {
  const PeriodicBox& box = world.box;
  double gap = pour.gap, largest = 0.0;
  for (const double reach : world.reach) gap = std::max(gap, pour.gap + reach);
  for (const Kind& kind : pour.kinds)
    largest = std::max(largest, world.shapes[static_cast<std::size_t>(kind.shape)].bounding_radius);
  const BoxRegion region = bounds(pour.region);
  Crowd crowd(world.shapes, box, gap);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double reach = gap + largest + world.shapes[static_cast<std::size_t>(bodies.shape[i])].bounding_radius;
    const BodyShape& shape = world.shapes[static_cast<std::size_t>(bodies.shape[i])];
    const Vec3 centre = bodies.pose(i).to_world(shape.centre);
    const Vec3 outside = (region.lower - centre).cwiseMax(centre - region.upper);
    bool is_near = true;
    for (Eigen::Index k = 0; k < 3; ++k) is_near = is_near && (std::isfinite(box.length[k]) || outside[k] <= reach);
    if (is_near) crowd.add(bodies.shape[i], bodies.pose(i));
  }
  return crowd;
}

}  // namespace

double due(const Pour& pour, double t) {
  const double amount = pour.rate * (std::clamp(t, pour.begin, pour.end) - pour.begin);
  return pour.measure == Pour::Measure::mass
             ? amount
             : std::min(std::floor(amount * (1.0 + rounding)), static_cast<double>(pour.most));
}

double arrived(const Pour& pour, const Poured& poured) {
  return pour.measure == Pour::Measure::mass ? poured.mass : static_cast<double>(poured.particles);
}

std::vector<BodyStart> poured_now(const World& world, const Bodies& bodies, const Pour& pour, std::uint64_t step,
                                  Poured& poured) {
  const double amount = due(pour, static_cast<double>(step) * world.setup.time_step);
  std::vector<BodyStart> placed;
  Arrival next = arrival(pour, poured.particles);
  if (!is_due(pour, poured, mass_of(world, next.kind), amount)) return placed;
  Crowd crowd = crowd_around(world, bodies, pour);
  do {
    Random random(numbered_seed(next.seed, step));
    const std::optional<Pose> place = random_place(crowd, pour.region, next.kind.shape, pour.tries, random);
    if (!place) break;
    crowd.add(next.kind.shape, *place);
    placed.push_back(
        {.shape = next.kind.shape, .material = next.kind.material, .pose = *place, .velocity = next.velocity});
    ++poured.particles;
    poured.mass += mass_of(world, next.kind);
    next = arrival(pour, poured.particles);
  } while (is_due(pour, poured, mass_of(world, next.kind), amount));
  return placed;
}

void check_pour(const Setup& setup, const Pour& pour, const std::string& where) {
  const auto require = [&](bool sound, const std::string& found, const std::string& expected) {
    if (!sound) throw InputError(where, found, expected);
  };
  try {
    validate(pour.region);
  } catch (const InputError& error) {
    throw InputError(where, error);
  }
  check_kinds(setup, pour.kinds, where);
  check_numbers(pour.gap, pour.tries, pour.velocity, pour.fluctuation, where);
  require(pour.rate > 0.0 && std::isfinite(pour.rate), "a rate of " + std::to_string(pour.rate) + " a second",
          "a finite value > 0");
  require(pour.begin >= 0.0 && std::isfinite(pour.begin) && pour.end > pour.begin,
          "a time from " + std::to_string(pour.begin) + " s to " + std::to_string(pour.end) + " s",
          "an end after a beginning >= 0");
}

}  // namespace osculate
