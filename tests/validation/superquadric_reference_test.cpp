// The judge is judged first: against contacts polished in 128-bit arithmetic, and against pairs built to a known depth.
#include "validation/narrow_phase/superquadric_reference.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "validation/narrow_phase/plain_superquadric.hpp"
#include "validation/narrow_phase/random_pairs.hpp"
#include "validation/pair_file.hpp"

using namespace osculate;
using namespace osculate::validation;

TEST_CASE("The plain solver finds the depth and normal of the 128-bit reference contacts") {
  const std::vector<test::ReferenceContact> contacts = test::reference_contacts();
  REQUIRE(contacts.size() == 630);
  for (std::size_t i = 0; i < contacts.size(); i += 7) {
    const auto& [pair, normal, depth, gap] = contacts[i];
    const Depth found = reference_depth(pair.shape_1, pair.pose_1, pair.shape_2, pair.pose_2);
    CAPTURE(i, pair.label, depth);
    // The file's overlaps go down to 1e-4 of bodies whose positions are given to 1e-16 of up to five body sizes.
    CHECK(found.minimum.depth == Approx(depth).epsilon(2e-11));
    if (gap > 1e-9 * pair.shape_1.half_axes.x()) CHECK((found.minimum.normal - normal).norm() < 1e-12);
  }
}

TEST_CASE("Two spheres overlap by the sum of their radii less the distance") {
  const Superquadric small{.half_axes = Vec3::Constant(1e-3), .exponents = {}};
  const Superquadric large{.half_axes = Vec3::Constant(0.5), .exponents = {}};
  const Vec3 apart(0.3, -0.4, 0.001);
  const Depth found = reference_depth(small, {}, large, {.position = apart});
  CHECK(found.minimum.depth == Approx(0.501 - apart.norm()).epsilon(1e-13));
  CHECK((found.minimum.normal - apart.normalized()).norm() < 1e-12);
}

TEST_CASE("A random pair has its stated overlap along its stated normal, and is not deeper") {
  for (const PairFamily& family : pair_families())
    for (std::uint64_t index = 0; index < 20; ++index) {
      const RandomPair random = random_pair(family, 1, index);
      const Pair& pair = random.pair;
      CAPTURE(pair.label, random.overlap);
      validate(pair.shape_1);
      validate(pair.shape_2);
      const double size =
          std::max(pair.shape_1.half_axes.maxCoeff(), pair.shape_2.half_axes.maxCoeff()) + pair.pose_1.position.norm();
      const double rounding = 1e-14 * size;  // some dozens of roundings of positions and points
      CHECK(std::fabs(overlap_along(random.normal, pair.shape_1, pair.pose_1, pair.shape_2, pair.pose_2) -
                      random.overlap) < rounding);
      CHECK(reference_depth(pair.shape_1, pair.pose_1, pair.shape_2, pair.pose_2).minimum.depth <
            random.overlap + rounding);
      const RandomPair again = random_pair(family, 1, index);
      CHECK(again.pair.pose_2.position == pair.pose_2.position);
    }
}

TEST_CASE("A pair can be moved until its depth is exactly the prescribed one") {
  const PairFamily family{
      .name = "moderate", .least_exponent = 1.5, .largest_exponent = 8.0, .largest_aspect = 5.0, .least_overlap = 0.1};
  for (std::uint64_t index = 0; index < 10; ++index) {
    const RandomPair random = with_exact_depth(random_pair(family, 2, index));
    const Pair& pair = random.pair;
    CAPTURE(pair.label);
    CHECK(reference_depth(pair.shape_1, pair.pose_1, pair.shape_2, pair.pose_2).minimum.depth ==
          Approx(random.overlap).epsilon(1e-8));  // within 1e-9 by construction, and the round-off of a 1000 times
                                                  // larger partner
  }
}

TEST_CASE("The plain gauge and support function are polar to each other, and the volume is that of known bodies") {
  const Superquadric shape{.half_axes = {0.3, 1.0, 0.02}, .exponents = {.n1 = 5.5, .n2 = 1.4}};
  const Vec3 u = Vec3(0.2, -0.5, 0.7).normalized();
  const plain::Support<double> support = plain::support<double>(shape, u);
  CHECK(support.point.dot(u) == Approx(support.value).epsilon(1e-14));  // Euler: homogeneous of degree 1
  const plain::Support<double> gauge = plain::gauge<double>(shape, support.point);
  CHECK(gauge.value == Approx(1.0).epsilon(1e-14));
  CHECK((gauge.point.normalized() - u).norm() < 1e-12);
  CHECK(plain::volume({.half_axes = {1, 2, 3}, .exponents = {}}) == Approx(8.0 * M_PI).epsilon(1e-13));
  // n2 = 2, n1 → ∞: a cylinder of volume π a b 2c, short of it by its rounded rims.
  CHECK(plain::volume({.half_axes = {1, 1, 1}, .exponents = {.n1 = 64, .n2 = 2}}) == Approx(2.0 * M_PI).epsilon(0.01));
}
