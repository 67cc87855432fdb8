#include "validation/chung_ooi2011/impact_tests.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "validation/chung_ooi2011/collision.hpp"
#include "validation/chung_ooi2011/restitution_curve.hpp"

using namespace osculate;
using namespace osculate::validation;

TEST_CASE("The engine meets the closed forms of all eight impact tests of Chung and Ooi") {
  std::set<int> tests;
  for (const ImpactRow& row : impact_tests()) {
    INFO("test " << row.test << ", " << row.material << ", " << row.condition << ", " << row.quantity << ": "
                 << row.computed << " for " << row.closed_form);
    CHECK(row.agrees());
    tests.insert(row.test);
  }
  CHECK(tests.size() == impact_test_titles().size());
}

TEST_CASE("A row that is off by more than its tolerance, or no number, does not agree") {
  ImpactRow row{.test = 1,
                .material = "",
                .condition = "",
                .quantity = "",
                .closed_form = -2.0,
                .computed = -2.01,
                .tolerance = 1e-3};
  CHECK_FALSE(row.agrees());
  row.computed = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(row.agrees());
  row.computed = -2.001;
  CHECK(row.agrees());
}

TEST_CASE("A simulated impact of equal spheres conserves momentum and turns both alike") {
  const Material glass{.name = "glass", .elastic = {.youngs_modulus = 48e9, .poissons_ratio = 0.2}, .density = 2800.0};
  const Ball ball{.radius = 0.01, .material = glass, .velocity = {1.0, 0.3, 0.0}, .angular_velocity = {0.0, 0.0, 7.0}};
  Ball other = ball;
  other.velocity = {-1.0, -0.3, 0.0};
  Collision collision{};
  collision.ball_1 = ball;
  collision.ball_2 = other;
  collision.law = {{"hertz", {}}, {"tsuji", {{"restitution", 0.7}}}, {"mindlin", {{"friction", 0.2}}}};
  const Outcome after = collide(collision);
  constexpr double rounding = 1e-12;
  CHECK((after.velocity_1 + after.velocity_2).norm() < rounding);
  CHECK((after.angular_velocity_1 - after.angular_velocity_2).norm() < 1e3 * rounding);
}

TEST_CASE("Restitution follows each damped Hertz law over three decades of speed") {
  for (const RestitutionCurve& curve : restitution_curves({0.01, 0.1, 1.0, 10.0})) {
    INFO(curve.law);
    for (std::size_t i = 0; i < curve.speeds.size(); ++i) {
      CHECK(curve.computed[i] ==
            Approx(curve.theory[i]).margin(2e-3));  // touch and parting within a step of a thousand
    }
    CHECK(curve.theory[2] == Approx(0.9).epsilon(1e-8));
  }
}
