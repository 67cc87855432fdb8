#include "osculate/mechanics/walton_braun_friction.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <type_traits>

#include "osculate/core/error.hpp"

using osculate::TangentVector;
namespace wf = osculate::walton_braun_friction;

namespace {

constexpr wf::Model model{.stiffness = 1e4, .friction = 0.4};
constexpr double normal_force = 5.0, limit = 2.0;

}  // namespace

TEST_CASE("Loading at constant load is Mindlin's curve with exponent one third") {
  for (const double s : {1e-6, 1e-5, 1e-4, 2e-4}) {
    wf::Memory fresh;
    // Mindlin: T = μN [1 − (1 − 2/3 K0 s/(μN))^{3/2}]
    const double expected = limit * (1 - std::pow(std::fmax(0.0, 1 - 2.0 / 3.0 * model.stiffness * s / limit), 1.5));
    REQUIRE(wf::force(model, normal_force, {s, 0.0}, fresh).x == Approx(-expected).epsilon(1e-10));
  }
}

TEST_CASE("Any back-and-forth path agrees with the integrated differential law") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  wf::Memory memory;
  double force = 0.0, turning = 0.0, sign = 1.0;
  for (int leg = 0; leg < 200; ++leg) {
    const double way = sign * (leg == 0 ? 0.7e-4 : 1.5e-4 * std::fabs(uniform(random)));
    // GSL integrates dT/ds along this leg, from the turning point T* = T.
    struct Leg {
      double turning, sign;
    } parameters{turning, sign};
    gsl_odeiv2_system system{[](double, const double y[], double f[], void* p) {
                               const auto& leg_ = *static_cast<Leg*>(p);
                               const double u =
                                   1 - leg_.sign * (y[0] - leg_.turning) / (limit - leg_.sign * leg_.turning);
                               f[0] = leg_.sign * model.stiffness * std::cbrt(std::fmax(u, 0.0));
                               return int(GSL_SUCCESS);
                             },
                             nullptr, 1, &parameters};
    gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-8, 1e-12, 1e-12);
    double s = 0.0;
    gsl_odeiv2_driver_apply(driver, &s, std::fabs(way), &force);
    gsl_odeiv2_driver_free(driver);
    double computed = 0.0;
    for (int part = 0; part < 3; ++part) computed = -wf::force(model, normal_force, {way / 3.0, 0.0}, memory).x;
    REQUIRE(computed == Approx(force).margin(1e-6 * limit));
    force = computed;  // no build-up of the witness's error
    turning = force;
    sign = -sign;
  }
}

TEST_CASE("Incrementally slipping friction keeps below its limit in two directions and dissipates") {
  std::mt19937_64 random(10);
  std::normal_distribution<double> normal;
  wf::Memory memory;
  TangentVector before, heading{1e-6, 0.0};
  double work = 0.0, scale = 0.0;
  for (int i = 0; i < 20000; ++i) {
    heading = 0.98 * heading + TangentVector{3e-7 * normal(random), 3e-7 * normal(random)};
    const TangentVector force = wf::force(model, normal_force, heading, memory);
    REQUIRE(norm(force) <= limit * (1 + 1e-14));
    work -= dot(0.5 * (before + force), heading);
    scale += std::fabs(dot(force, heading));
    before = force;
  }
  REQUIRE(work > 0.1 * scale);
  STATIC_REQUIRE(std::is_trivially_copyable_v<wf::Memory>);
}

TEST_CASE("When the normal force falls the friction force follows, and vanishes with it") {
  wf::Memory memory;
  wf::force(model, normal_force, {1e-3, 0.0}, memory);
  REQUIRE(wf::force(model, 0.5 * normal_force, {0.0, 0.0}, memory).x == Approx(-0.5 * limit).epsilon(1e-14));
  REQUIRE(norm(wf::force(model, 0.0, {1e-3, 0.0}, memory)) == 0.0);
  REQUIRE(norm(memory.direction) == 0.0);
}

TEST_CASE("Incrementally slipping friction refuses numbers that make no sense") {
  const double nan = std::nan("");
  for (const wf::Model& bad : {wf::Model{0.0, 0.4}, wf::Model{nan, 0.4}, wf::Model{1.0, -0.4}, wf::Model{1.0, nan},
                               wf::Model{1.0, 0.4, 0.0}, wf::Model{1.0, 0.4, 1.0}, wf::Model{1.0, 0.4, nan}})
    REQUIRE_THROWS_AS(wf::validate(bad), osculate::InputError);
}
