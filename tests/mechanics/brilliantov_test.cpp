#include "osculate/mechanics/brilliantov.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace brilliantov = osculate::brilliantov;
namespace hertz = osculate::hertz;
namespace jg = osculate::johnson_greenwood;
using brilliantov::Attraction;
using osculate::contact_ellipse;

namespace {

constexpr double modulus = 2e9, mass = 1e-5;

/// Overlap and its rate.
struct Motion {
  double overlap, rate;
};

/// One step of the classical Runge–Kutta method for m δ̈ = −F(δ, δ̇).
Motion stepped(const Motion& m, double dt, const std::function<double(const Motion&)>& force) {
  const auto slope = [&](const Motion& at) { return Motion{at.rate, -force(at) / mass}; };
  const auto moved = [](const Motion& from, double h, const Motion& by) {
    return Motion{from.overlap + h * by.overlap, from.rate + h * by.rate};
  };
  const Motion k1 = slope(m), k2 = slope(moved(m, 0.5 * dt, k1)), k3 = slope(moved(m, 0.5 * dt, k2)),
               k4 = slope(moved(m, dt, k3));
  return {m.overlap + dt / 6.0 * (k1.overlap + 2.0 * k2.overlap + 2.0 * k3.overlap + k4.overlap),
          m.rate + dt / 6.0 * (k1.rate + 2.0 * k2.rate + 2.0 * k3.rate + k4.rate)};
}

/// Restitution of a collision by integration: the bodies part where the cut-off force vanishes while they recede.
double integrated_restitution(double time, double speed) {
  const auto ellipse = contact_ellipse(3e-3, 1e-3);
  const auto force = [&](const Motion& m) {
    const auto contact = hertz::contact(ellipse, modulus, std::max(m.overlap, 0.0), 1e-3);
    return contact.force + brilliantov::dissipative_force(time, contact.stiffness, m.rate);
  };
  const double k = hertz::force(ellipse, modulus, 1.0);
  const double duration = 2.94 * std::pow(25.0 / 16.0 * mass * mass / (k * k * speed), 0.2);
  const double dt = duration / 20000.0;
  Motion m{0.0, speed};
  do m = stepped(m, dt, force);
  while (m.rate > 0.0 || (m.overlap > 0.0 && force(m) > 0.0));
  return -m.rate / speed;
}

jg::Pair sticky(double ratio) {
  return {.R_i = 1e-5 * std::sqrt(ratio), .R_j = 1e-5 / std::sqrt(ratio), .modulus = 1e8, .work_of_adhesion = 0.05};
}

}  // namespace

TEST_CASE("The Hertzian dissipative force is the review's (37)") {
  const auto ellipse = contact_ellipse(3e-3, 1e-3);
  const double A = 1e-6, overlap = 2e-6, rate = 0.3;
  const auto contact = hertz::contact(ellipse, modulus, overlap, 1e-3);
  REQUIRE(brilliantov::dissipative_force(A, contact.stiffness, rate) ==
          Approx(2.0 * A * modulus * std::sqrt(ellipse.R_c * overlap) * ellipse.gamma() * rate).epsilon(1e-14));
}

TEST_CASE("Restitution falls with speed as an integrated collision says") {
  const double k = hertz::force(contact_ellipse(3e-3, 1e-3), modulus, 1.0);
  double last = 1.0;
  for (const double speed : {0.01, 0.1, 1.0, 10.0}) {
    const double A = 4e-7;
    const double x = 1.5 * A * std::pow(k / mass, 0.4) * std::pow(speed, 0.2);
    REQUIRE(x < 0.3);
    CAPTURE(speed, x);
    const double series = brilliantov::restitution(A, k, mass, speed);
    const double integrated = integrated_restitution(A, speed);
    REQUIRE(series < last);
    // The first term left out: 0.267 x^{5/2}, and a half more for those beyond. The integration is good to 1e-5.
    REQUIRE(std::abs(series - integrated) < 0.4 * std::pow(x, 2.5) + 1e-5);
    last = series;
  }
  REQUIRE(brilliantov::restitution(0.0, k, mass, 1.0) == 1.0);
}

TEST_CASE("The adhesive dissipative force is A da/dt dF/da of JKR with D = 3/(4E): erratum to (39) and (40)") {
  const auto pair = sticky(1.0);
  const double R = 1e-5, A = 1e-6;
  const auto state = *jg::at_overlap(pair, 0.5 * jg::units(pair).overlap);
  const double a = state.a_c, step = 1e-5 * a;
  const auto up = jg::at_major_axis(pair, a + step), down = jg::at_major_axis(pair, a - step);
  const double force_slope = (up.force - down.force) / (2.0 * step);
  const double overlap_slope = (up.overlap - down.overlap) / (2.0 * step);
  const double rate = 0.02, radius_rate = rate / overlap_slope;
  const double expected = A * radius_rate * force_slope;
  // Central differences: (step/a)² = 1e-10.
  REQUIRE(brilliantov::dissipative_force(A, state, rate) == Approx(expected).epsilon(1e-8));
  const double closed =
      brilliantov::dissipative_force_circular(A, R, pair.modulus, pair.work_of_adhesion, a, radius_rate);
  REQUIRE(closed == Approx(expected).epsilon(1e-8));
  // A D without Ê, as printed, would be wrong by the modulus itself.
  const double printed_D = 0.75;
  const double printed =
      A * radius_rate *
      (3.0 * a * a / (printed_D * R) - 1.5 * std::sqrt(6.0 * M_PI * pair.work_of_adhesion / printed_D * a));
  REQUIRE(std::abs(printed / expected) < 1e-3);
  // Without adhesion it is Hertz's.
  auto dry = pair;
  dry.work_of_adhesion = 0.0;
  const auto contact = hertz::contact(contact_ellipse(R, R), pair.modulus, 1e-8, R);
  REQUIRE(brilliantov::dissipative_force(A, *jg::at_overlap(dry, 1e-8), rate) ==
          Approx(brilliantov::dissipative_force(A, contact.stiffness, rate)).epsilon(1e-12));
}

TEST_CASE("Between pull-off and snap-off the printed adhesive dissipation would create energy, ours is zero") {
  for (const double ratio : {1.0, 6.0}) {
    const auto pair = sticky(ratio);
    const auto between = jg::at_overlap(pair, 0.5 * (jg::snap_off(pair).overlap + jg::pull_off(pair).overlap));
    REQUIRE(between);
    REQUIRE(between->stiffness < 0.0);
    const double rate = -1e-3;
    REQUIRE(between->stiffness * rate * rate < 0.0);  // printed power, per A
    REQUIRE(brilliantov::dissipative_force(1e-6, *between, rate) == 0.0);
  }
}

TEST_CASE("An adhesive collision loses the hysteresis and the viscous work, and sticks below a speed") {
  const auto pair = sticky(3.0);
  const double torn = jg::snap_off(pair).overlap, loss = jg::hysteresis_loss(pair);
  const double sticking_speed = std::sqrt(2.0 * loss / mass);
  const auto collide = [&](double A, double speed) {
    double viscous = 0.0;
    const auto force = [&](const Motion& m) {
      const auto state = jg::at_overlap(pair, m.overlap);
      return state ? state->force + brilliantov::dissipative_force(A, *state, m.rate) : 0.0;
    };
    const double dt = 1e-3 * jg::units(pair).overlap / speed;
    Motion m{0.0, speed};
    while (true) {
      const Motion next = stepped(m, dt, force);
      const auto state = jg::at_overlap(pair, 0.5 * (m.overlap + next.overlap));
      const double rate = 0.5 * (m.rate + next.rate);
      if (state) {
        const double power = brilliantov::dissipative_force(A, *state, rate) * rate;
        REQUIRE(power >= 0.0);
        viscous += power * dt;
      }
      if (next.overlap < torn) return std::pair{next.rate, viscous};
      if (m.rate < 0.0 && next.rate >= 0.0) return std::pair{0.0, viscous};  // turned back before it tore: stuck
      m = next;
    }
  };
  const auto energy = [](double speed) { return 0.5 * mass * speed * speed; };
  // The step over the tear-off loses a thousandth of an overlap unit times the force there.
  REQUIRE(collide(0.0, 0.99 * sticking_speed).first == 0.0);
  const auto [rebound, none] = collide(0.0, 1.5 * sticking_speed);
  REQUIRE(none == 0.0);
  REQUIRE(energy(1.5 * sticking_speed) - energy(rebound) == Approx(loss).epsilon(1e-2));
  const double A = 0.02 * jg::units(pair).overlap / sticking_speed;
  const auto [slower, viscous] = collide(A, 1.5 * sticking_speed);
  REQUIRE(viscous > 0.0);
  REQUIRE(energy(1.5 * sticking_speed) - energy(slower) == Approx(loss + viscous).epsilon(1e-2));
}

TEST_CASE("Cut-off contacts never pull") {
  REQUIRE(brilliantov::total_force(1.0, -2.0, Attraction::cut_off) == 0.0);
  REQUIRE(brilliantov::total_force(1.0, -2.0, Attraction::allowed) == -1.0);
  REQUIRE(brilliantov::total_force(1.0, 2.0, Attraction::cut_off) == 3.0);
}

TEST_CASE("Tangential dissipation is the viscous time times the slope of Mindlin's law: erratum to (85)") {
  // F_t = μF_n [1 − (1 − δ/δ_max)^{3/2}] with initial slope 4Ĝa/Φ = 3/2 μF_n/δ_max.
  const double limit = 2.0, reach = 1e-6, viscosity = 3.0, shear = 1e8, rate = 0.05;
  const double no_slip = 1.5 * limit / reach;
  const auto force = [&](double s) { return limit * (1.0 - std::pow(1.0 - s, 1.5)); };
  for (const double slip : {0.0, 0.3, 0.9}) {
    const double step = 1e-5, from = std::max(slip - step, 0.0);
    const double slope = (force(slip + step) - force(from)) / ((slip + step - from) * reach);
    // One-sided at zero: step/4; central elsewhere.
    REQUIRE(brilliantov::tangential_dissipative_force(viscosity, shear, no_slip, slip, rate) ==
            Approx(viscosity / shear * slope * rate).epsilon(1e-5));
  }
  REQUIRE(brilliantov::tangential_dissipative_force(viscosity, shear, no_slip, 1.5, rate) == 0.0);
  REQUIRE(brilliantov::tangential_dissipative_force(viscosity, shear, no_slip, 0.4, rate) * rate > 0.0);
}

TEST_CASE("The dissipative time has the dimension of one and refuses bad constants") {
  const osculate::ElasticMaterial material{.youngs_modulus = 1e7, .poissons_ratio = 0.3};
  const double A = brilliantov::dissipative_time(material, {.shear = 10.0, .bulk = 20.0});
  REQUIRE(A == Approx(50.0 * 50.0 / 80.0 / 3.0 * 0.91 * 0.4 / (1e7 * 0.09)).epsilon(1e-14));
  REQUIRE(brilliantov::dissipative_time({1e8, 0.3}, {10.0, 20.0}) == Approx(0.1 * A).epsilon(1e-14));
  const double nan = std::nan("");
  REQUIRE_THROWS_AS(brilliantov::dissipative_time(material, {-1.0, 1.0}), osculate::InputError);
  REQUIRE_THROWS_AS(brilliantov::dissipative_time(material, {0.0, 0.0}), osculate::InputError);
  REQUIRE_THROWS_AS(brilliantov::dissipative_time(material, {1.0, nan}), osculate::InputError);
  REQUIRE_THROWS_AS(brilliantov::dissipative_time({1e7, 0.0}, {1.0, 1.0}), osculate::InputError);
  REQUIRE_THROWS_AS(brilliantov::validate_time(-1e-9), osculate::InputError);
  REQUIRE_THROWS_AS(brilliantov::validate_time(nan), osculate::InputError);
  REQUIRE_THROWS_AS(brilliantov::restitution(1e-6, 0.0, 1.0, 1.0), osculate::InputError);
}
