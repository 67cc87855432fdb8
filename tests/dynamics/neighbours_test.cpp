#include "dynamics/neighbours.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace osculate;

namespace {

std::vector<BodyPair> found(const std::vector<Ball>& balls, const PeriodicBox& box) {
  std::vector<BodyPair> pairs = touching_balls(balls, box);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<BodyPair> exhaustive(const std::vector<Ball>& balls, const PeriodicBox& box) {
  std::vector<BodyPair> pairs;
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      Vec3 apart = balls[j].centre - balls[i].centre;
      for (Eigen::Index k = 0; k < 3; ++k)
        if (std::isfinite(box.length[k])) apart[k] -= box.length[k] * std::round(apart[k] / box.length[k]);
      if (apart.norm() <= balls[i].radius + balls[j].radius)
        pairs.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
    }
  return pairs;
}

std::vector<Ball> random_balls(std::size_t count, double sizes, const Vec3& room, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Ball> balls(count);
  for (Ball& ball : balls) {
    const double x = uniform(random), y = uniform(random), z = uniform(random), size = uniform(random);
    ball = {.centre = room.cwiseProduct(Vec3(x, y, z)), .radius = 0.02 * std::pow(sizes, size - 1.0)};
  }
  return balls;
}

}  // namespace

TEST_CASE("The grid finds the pairs that an exhaustive search finds") {
  std::mt19937_64 random(3);
  const double sizes = GENERATE(1.0, 3.0, 100.0, 1e4);
  const Vec3 room = GENERATE(Vec3(0.4, 0.4, 0.4), Vec3(2.0, 0.3, 0.1), Vec3(0.0, 0.3, 3.0));
  const std::vector<Ball> balls = random_balls(600, sizes, room, random);
  const auto expected = exhaustive(balls, {});
  REQUIRE(expected.size() > 10);
  CHECK(found(balls, {}) == expected);
}

TEST_CASE("The grid finds neighbours across periodic faces, however few cells fit") {
  std::mt19937_64 random(4);
  const double sizes = GENERATE(1.0, 30.0);
  const double length = GENERATE(0.09, 0.13, 0.17, 0.5);
  const Vec3 room = Vec3::Constant(length);
  std::vector<Ball> balls = random_balls(300, sizes, room, random);
  PeriodicBox box{.origin = {0.01, -0.02, 0.0}, .length = room};
  box.length[1] = std::numeric_limits<double>::infinity();
  for (Ball& ball : balls) ball.centre.x() += 5.0 * length;  // not wrapped
  CHECK(found(balls, box) == exhaustive(balls, box));
}

TEST_CASE("Far-flung balls do not exhaust the grid") {
  std::vector<Ball> balls(5, Ball{.centre = Vec3::Zero(), .radius = 1e-3});
  balls[1].centre = {1e9, 0, 0};
  balls[2].centre = {1e9 + 1e-3, 0, 0};
  balls[3].centre = {0, -1e12, 5};
  balls[4].centre = {1e-3, 1e-3, 1e-3};
  CHECK(found(balls, {}) == std::vector<BodyPair>{{0, 4}, {1, 2}});
}
