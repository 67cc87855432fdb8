#include "validation/narrow_phase/random_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "validation/narrow_phase/plain_superquadric.hpp"
#include "validation/narrow_phase/superquadric_reference.hpp"

namespace osculate::validation {

std::uint64_t Random::bits() {
  state_ += 0x9E3779B97F4A7C15U;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

double Random::uniform() {
  return static_cast<double>(bits() >> 11U) * 0x1p-53;
}

double Random::uniform(double low, double high) {
  return low + (high - low) * uniform();
}

double Random::log_uniform(double low, double high) {
  return low * std::exp(std::log(high / low) * uniform());
}

Vec3 Random::direction() {
  const double z = uniform(-1.0, 1.0), turn = uniform(0.0, 2.0 * std::numbers::pi);
  const double r = std::sqrt(1.0 - z * z);
  return Vec3(r * std::cos(turn), r * std::sin(turn), z).normalized();
}

Quat Random::orientation() {
  // Shoemake 1992: two independent points on circles.
  const double share = uniform(), turn_1 = uniform(0.0, 2.0 * std::numbers::pi),
               turn_2 = uniform(0.0, 2.0 * std::numbers::pi);
  const double r1 = std::sqrt(1.0 - share), r2 = std::sqrt(share);
  return Quat(r2 * std::cos(turn_2), r1 * std::sin(turn_1), r1 * std::cos(turn_1), r2 * std::sin(turn_2)).normalized();
}

namespace {

double random_exponent(const PairFamily& family, Random& random) {
  if (family.draw == PairFamily::Draw::real)
    return 1.0 + random.log_uniform(family.least_exponent - 1.0, family.largest_exponent - 1.0);
  const double steps = std::floor((family.largest_exponent - family.least_exponent) / 2.0) + 1.0;
  return family.least_exponent + 2.0 * std::floor(steps * random.uniform());
}

/// R_vol = 1.
Superquadric random_shape(const PairFamily& family, Random& random) {
  const double aspect = random.log_uniform(1.0, family.largest_aspect);
  std::array<double, 3> axes{1.0, aspect, random.log_uniform(1.0, aspect)};
  std::swap(axes[0], axes[static_cast<std::size_t>(3.0 * random.uniform())]);
  if (random.coin()) std::swap(axes[1], axes[2]);
  const double n1 = random_exponent(family, random);
  const double n2 = random_exponent(family, random);
  Superquadric shape{.half_axes = {axes[0], axes[1], axes[2]}, .exponents = {.n1 = n1, .n2 = n2}};
  shape.half_axes /= plain::volume_radius(shape);
  return shape;
}

struct SurfacePoint {
  Vec3 point, normal;  // body frame
};

SurfacePoint random_surface_point(const Superquadric& shape, Random& random) {
  const Vec3 direction = random.direction();
  if (random.coin()) return {plain::support<double>(shape, direction).point, direction};
  const Vec3 x = shape.half_axes.cwiseProduct(direction);
  const plain::Support<double> gauge = plain::gauge<double>(shape, x);
  return {x / gauge.value, gauge.point.normalized()};
}

}  // namespace

std::vector<PairFamily> pair_families() {
  using Draw = PairFamily::Draw;
  return {{.name = "ellipsoid", .draw = Draw::even_integer, .least_exponent = 2.0, .largest_exponent = 2.0},
          {.name = "even", .draw = Draw::even_integer, .least_exponent = 2.0},
          {.name = "n >= 2", .least_exponent = 2.0},
          {.name = "n < 2", .largest_exponent = 2.0},
          {.name = "any"}};
}

RandomPair random_pair(const PairFamily& family, std::uint64_t seed, std::uint64_t index) {
  Random random(Random(seed).bits() + 0xD1342543DE82EF95U * index);
  Superquadric shape_1 = random_shape(family, random), shape_2 = random_shape(family, random);
  const double unit = random.log_uniform(1e-6, 1.0), ratio = random.log_uniform(1.0, family.largest_size_ratio);
  (random.coin() ? shape_1 : shape_2).half_axes *= ratio;
  shape_1.half_axes *= unit;
  shape_2.half_axes *= unit;
  const double overlap = unit * random.log_uniform(family.least_overlap, family.largest_overlap);

  const SurfacePoint here_1 = random_surface_point(shape_1, random), here_2 = random_surface_point(shape_2, random);
  Pose pose_1{.position = random.uniform(0.0, 10.0) * unit * random.direction(), .orientation = random.orientation()};
  const Vec3 normal = pose_1.rotate_to_world(here_1.normal);
  const Quat spin(Eigen::AngleAxisd(random.uniform(0.0, 2.0 * std::numbers::pi), normal));
  Pose pose_2{.orientation = (spin * Quat::FromTwoVectors(here_2.normal, -normal)).normalized()};
  pose_2.position = pose_1.to_world(here_1.point) - pose_2.rotate_to_world(here_2.point) - overlap * normal;
  return {.pair = {shape_1, pose_1, shape_2, pose_2,
                   family.name + ", seed " + std::to_string(seed) + ", index " + std::to_string(index)},
          .overlap = overlap,
          .normal = normal};
}

RandomPair with_exact_depth(RandomPair found) {
  constexpr int steps = 20;
  constexpr double close_enough = 1e-9;
  Pair& pair = found.pair;
  for (int step = 0; step < steps; ++step) {
    const Minimum minimum = reference_depth(pair.shape_1, pair.pose_1, pair.shape_2, pair.pose_2).minimum;
    found.normal = minimum.normal;
    const double missing = found.overlap - minimum.depth;
    if (std::fabs(missing) <= close_enough * found.overlap) break;
    pair.pose_2.position -= missing * minimum.normal;
  }
  return found;
}

}  // namespace osculate::validation
