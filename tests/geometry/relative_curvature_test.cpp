#include "osculate/geometry/relative_curvature.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace osculate;

namespace {

const Vec3 up = Vec3::UnitZ();

PrincipalCurvatures curvatures(double max, double min, double angle) {
  return {.max = max, .min = min, .max_direction = Vec3(std::cos(angle), std::sin(angle), 0.0)};
}

}  // namespace

TEST_CASE("Two equal spheres have relative radii R/2") {
  const PrincipalCurvatures sphere = curvatures(4.0, 4.0, 0.3);
  const RelativeCurvature relative = relative_curvature(up, sphere, sphere);
  CHECK(relative.R_i == Approx(0.125).epsilon(1e-15));
  CHECK(relative.R_j == Approx(0.125).epsilon(1e-15));
  CHECK_FALSE(relative.capped);
}

TEST_CASE("Crossed cylinders touch like a sphere on a plane, parallel ones along a line") {
  const double R = 0.5;
  const RelativeCurvature crossed =
      relative_curvature(up, curvatures(1 / R, 0, 0), curvatures(1 / R, 0, std::numbers::pi / 2));
  CHECK(crossed.R_i == Approx(R).epsilon(1e-14));
  CHECK(crossed.R_j == Approx(R).epsilon(1e-14));
  const RelativeCurvature parallel = relative_curvature(up, curvatures(1 / R, 0, 0.0), curvatures(1 / R, 0, 0.0));
  CHECK(std::isinf(parallel.R_i));
  CHECK(parallel.R_j == Approx(R / 2).epsilon(1e-15));
  CHECK(std::fabs(parallel.major_axis.y()) == Approx(1.0));  // along the cylinders
}

TEST_CASE("Relative radii follow eqs. (3) and (4) for any angle between the principal directions") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const double k1 = 1 + uniform(random), k2 = uniform(random), k3 = 1 + 3 * uniform(random), k4 = uniform(random);
    const double omega = 2 * std::numbers::pi * uniform(random);
    const double sum = k1 + k2 + k3 + k4;
    const double root =
        std::sqrt((k1 - k2) * (k1 - k2) + (k3 - k4) * (k3 - k4) + 2 * (k1 - k2) * (k3 - k4) * std::cos(2 * omega));
    const PrincipalCurvatures one = curvatures(k1, k2, 0.4), two = curvatures(k3, k4, 0.4 + omega);
    const RelativeCurvature relative = relative_curvature(up, one, two);
    CHECK(1 / relative.R_i == Approx(0.5 * (sum - root)).epsilon(1e-12));
    CHECK(1 / relative.R_j == Approx(0.5 * (sum + root)).epsilon(1e-12));
    CHECK(relative.R_i >= relative.R_j);
    // Euler's formula: the sum of normal curvatures along the major axis is 1/R_i.
    const auto along = [&](const PrincipalCurvatures& k) {
      const double c = k.max_direction.dot(relative.major_axis);
      return k.max * c * c + k.min * (1 - c * c);
    };
    CHECK(along(one) + along(two) == Approx(1 / relative.R_i).epsilon(1e-12));
    const RelativeCurvature swapped = relative_curvature(-up, two, one);
    CHECK(swapped.R_i == Approx(relative.R_i).epsilon(1e-14));
    CHECK((swapped.major_axis - relative.major_axis).norm() < 1e-12);
  }
}

TEST_CASE("A large curvature leaves the small one its digits") {
  const RelativeCurvature relative = relative_curvature(up, curvatures(1e12, 1.0, 0.0), curvatures(1e-3, 0.5, 0.0));
  CHECK(relative.R_i == Approx(1.0 / 1.5).epsilon(1e-14));
  const RelativeCurvature rim = relative_curvature(up, curvatures(1e100, 2.0, 0.7), curvatures(1e100, 1.0, 0.7));
  CHECK(rim.R_i == Approx(1.0 / 3.0).epsilon(1e-12));
  CHECK(rim.R_j > 0.0);
}

TEST_CASE("Flat on flat has no radius: infinite, or the cap, and the result says so") {
  const PrincipalCurvatures flat = curvatures(0.0, 0.0, 0.0);
  const RelativeCurvature bare = relative_curvature(up, flat, flat);
  CHECK(std::isinf(bare.R_i));
  CHECK(std::isinf(bare.R_j));
  CHECK_FALSE(bare.capped);
  const RelativeCurvature capped = relative_curvature(up, flat, curvatures(2.0, 0.0, 0.0), 10.0);
  CHECK(capped.R_i == 10.0);
  CHECK(capped.R_j == Approx(0.5));
  CHECK(capped.capped);
  CHECK_FALSE(relative_curvature(up, flat, curvatures(2.0, 1.0, 0.0), 10.0).capped);
}

TEST_CASE("A sphere in a drum is relieved around it and not along it; one too large has no radius") {
  const double R = 1.0, r = 0.5;
  const PrincipalCurvatures ball = curvatures(1 / r, 1 / r, 0.2),
                            drum = curvatures(0.0, -1 / R, 0.0);  // z of the drum: x here
  const RelativeCurvature relative = relative_curvature(up, ball, drum);
  CHECK(relative.R_i == Approx(1 / (1 / r - 1 / R)).epsilon(1e-14));
  CHECK(relative.R_j == Approx(r).epsilon(1e-14));
  CHECK(std::fabs(relative.major_axis.y()) == Approx(1.0));
  const RelativeCurvature too_large =
      relative_curvature(up, curvatures(0.5, 0.5, 0.0), curvatures(-1.0, -1.0, 0.0), 7.0);
  CHECK(too_large.R_i == 7.0);
  CHECK(too_large.R_j == 7.0);
  CHECK(too_large.capped);
}

TEST_CASE("Where every direction is principal the major axis depends on the normal only") {
  const PrincipalCurvatures round = curvatures(1.0, 1.0, 0.123);
  const Vec3 axis = relative_curvature(up, round, round).major_axis;
  CHECK(axis.norm() == Approx(1.0));
  CHECK(axis.dot(up) == 0.0);
  CHECK(relative_curvature(-up, round, round).major_axis == axis);
}
