#include "osculate/dynamics/random.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace osculate;

TEST_CASE("Random numbers are the same everywhere") {
  // std::mt19937_64's ten-thousandth number is fixed by the standard [rand.predef]; its first one with seed 5489 is
  // 14514284786278117030.
  Random random(5489);
  CHECK(random.uniform() == static_cast<double>(14514284786278117030ULL >> 11) * 0x1.0p-53);
}

TEST_CASE("Random numbers have the moments of their distributions") {
  Random random(1);
  constexpr int count = 200000;
  double first = 0.0, second = 0.0, fourth = 0.0;
  Vec3 sum = Vec3::Zero();
  Mat3 squares = Mat3::Zero(), turned = Mat3::Zero();
  std::array<int, 3> picked{};
  for (int i = 0; i < count; ++i) {
    const double x = random.normal();
    first += x, second += x * x, fourth += x * x * x * x;
    const Vec3 u = random.direction();
    sum += u, squares += u * u.transpose();
    const Vec3 v = random.orientation() * Vec3(0.6, 0.0, 0.8);
    turned += v * v.transpose();
    ++picked[random.pick(std::array{1.0, 0.0, 3.0})];
  }
  const double tolerance = 5.0 / std::sqrt(count);
  CHECK(first / count == Approx(0.0).margin(tolerance));
  CHECK(second / count == Approx(1.0).margin(1.5 * tolerance));
  CHECK(fourth / count == Approx(3.0).margin(10.0 * tolerance));
  CHECK((sum / count).norm() < tolerance);
  CHECK((squares / count - Mat3::Identity() / 3.0).norm() < tolerance);
  CHECK((turned / count - Mat3::Identity() / 3.0).norm() < tolerance);
  CHECK(picked[1] == 0);
  CHECK(static_cast<double>(picked[2]) / count == Approx(0.75).margin(tolerance));
}
