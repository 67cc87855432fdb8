#include "osculate/mechanics/hertzian_tangential.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <type_traits>

#include "osculate/core/error.hpp"

using namespace osculate;
namespace ht = osculate::hertzian_tangential;

namespace {

constexpr ElasticMaterial glass{71e9, 0.22};
constexpr double sphere_radius = 1.59e-3, overlap = 2e-6;

ht::Model model() {
  return {.radius = 0.5 * sphere_radius,
          .modulus = effective_modulus(glass, glass),
          .shear_modulus = effective_shear_modulus(glass, glass),
          .friction = 0.3};
}

double hertz_force() {
  return 4.0 / 3.0 * model().modulus * std::sqrt(model().radius * overlap) * overlap;
}

ht::Step step_to(double displacement, double velocity = 0.0) {
  return {.overlap = overlap,
          .normal_force = hertz_force(),
          .displacement = {displacement, 0.0},
          .velocity = {velocity, 0.0}};
}

}  // namespace

TEST_CASE("The tangential modulus of like spheres is G/(2 (2 − ν)), with 2 − ν and not 1 − ν²") {
  REQUIRE(effective_shear_modulus(glass, glass) == Approx(glass.shear_modulus() / (2 * (2 - 0.22))).epsilon(1e-14));
}

TEST_CASE("Tsuji's stiffness for equal spheres is that of the paper, with the spheres' own radius") {
  ht::Memory memory;
  const double tiny = 1e-12, G = glass.shear_modulus();
  const double printed = 2.0 * std::sqrt(2.0 * sphere_radius) * G / (2.0 - 0.22) * std::sqrt(overlap);
  REQUIRE(-ht::tsuji(model(), 0.0, step_to(tiny), memory).x / tiny == Approx(printed).epsilon(1e-13));
}

TEST_CASE(
    "Langston's and Zheng's springs start with Mindlin's no-slip stiffness 8 G a and Di Renzo's with two thirds of "
    "it") {
  const double tiny = 1e-15, no_slip = 8.0 * model().shear_modulus * std::sqrt(model().radius * overlap);
  ht::Memory a, b, c;
  // The curve bends by 3/4·s... of s = tiny/δ_max ~ 1e-9.
  REQUIRE(-ht::langston(model(), 0.0, 0.0, step_to(tiny), a).x / tiny == Approx(no_slip).epsilon(1e-8));
  REQUIRE(-ht::zheng(model(), 0.0, 1e9, step_to(tiny), b).x / tiny == Approx(no_slip).epsilon(1e-8));
  REQUIRE(-ht::di_renzo(model(), step_to(tiny), c).x / tiny == Approx(2.0 / 3.0 * no_slip).epsilon(1e-13));
}

TEST_CASE("Slip is complete at the slip displacement of like materials, and the force stays there") {
  const double reach = ht::slip_displacement(model(), overlap);
  REQUIRE(reach == Approx(0.3 * overlap * (2 - 0.22) / (2 * (1 - 0.22))).epsilon(1e-14));
  const double limit = 0.3 * hertz_force();
  ht::Memory memory;
  REQUIRE(ht::langston(model(), 0.0, 0.0, step_to(0.5 * reach), memory).x ==
          Approx(-limit * (1 - std::pow(0.5, 1.5))).epsilon(1e-13));
  REQUIRE(ht::langston(model(), 0.0, 0.0, step_to(7.0 * reach), memory).x == Approx(-limit).epsilon(1e-14));
  // What slipped is forgotten: turning back lowers the force at once.
  REQUIRE(ht::langston(model(), 0.0, 0.0, step_to(-0.5 * reach), memory).x ==
          Approx(-limit * (1 - std::pow(0.5, 1.5))).epsilon(1e-13));
}

TEST_CASE("Dashpots oppose the motion and never break the friction limit") {
  const double limit = 0.3 * hertz_force();
  for (const double velocity : {1e-6, 1e-2, 1.0, 1e4}) {
    ht::Memory memory;
    const auto all = {ht::tsuji(model(), 5.0, step_to(0.0, velocity), memory),
                      ht::langston(model(), 1e-5, 0.1, step_to(0.0, velocity), memory),
                      ht::zheng(model(), 10.0, glass.shear_modulus(), step_to(0.0, velocity), memory)};
    for (const TangentVector& force : all) {
      REQUIRE(force.x <= 0.0);
      REQUIRE(norm(force) <= limit * (1 + 1e-15));
    }
  }
  ht::Memory memory;
  const double q = 10.0 / (2 * glass.shear_modulus() * ht::slip_displacement(model(), overlap)), v = 1e-3;
  REQUIRE(ht::zheng(model(), 10.0, glass.shear_modulus(), step_to(0.0, v), memory).x ==
          Approx(-q * (1 - 0.4 * q * v) * 1.5 * limit * v).epsilon(1e-12));
  REQUIRE(ht::langston(model(), 1e-5, 0.1, step_to(0.0, v), memory).x ==
          Approx(-0.1 * std::sqrt(6 * 1e-5 * limit / ht::slip_displacement(model(), overlap)) * v).epsilon(1e-12));
}

TEST_CASE("Without overlap there is no force and no memory") {
  ht::Memory memory{{1e-6, 0.0}};
  ht::Step step = step_to(1e-6);
  step.overlap = 0.0;
  REQUIRE(norm(ht::di_renzo(model(), step, memory)) == 0.0);
  REQUIRE(norm(memory.displacement) == 0.0);
  STATIC_REQUIRE(std::is_trivially_copyable_v<ht::Memory>);
}

TEST_CASE("Hertzian tangential models that make no sense are refused") {
  const double nan = std::nan("");
  for (const ht::Model& bad :
       {ht::Model{0.0, 1.0, 1.0, 0.3}, ht::Model{1.0, 0.0, 1.0, 0.3}, ht::Model{1.0, 1.0, -1.0, 0.3},
        ht::Model{1.0, 1.0, 1.0, -0.3}, ht::Model{1.0, 1.0, 1.0, nan}})
    REQUIRE_THROWS_AS(ht::validate(bad), InputError);
}
