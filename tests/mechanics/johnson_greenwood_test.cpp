#include "osculate/mechanics/johnson_greenwood.hpp"

#include <gsl/gsl_integration.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "mechanics/reference.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace jg = osculate::johnson_greenwood;
using osculate::contact_ellipse;

namespace {

constexpr double pi = M_PI;

double integrate(const std::function<double(double)>& f, double from, double to) {
  gsl_function integrand;
  integrand.params = const_cast<std::function<double(double)>*>(&f);
  integrand.function = [](double x, void* g) { return (*static_cast<std::function<double(double)>*>(g))(x); };
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(500);
  double value = 0.0, error = 0.0;
  gsl_integration_qag(&integrand, from, to, 0.0, 1e-11, 500, GSL_INTEG_GAUSS31, workspace, &value, &error);
  gsl_integration_workspace_free(workspace);
  return value;
}

/// A micrometre-sized contact of the given elongation, R = 3 µm.
jg::Pair pair_of(double ratio, double work = 0.05) {
  constexpr double R = 3e-6;
  return {.R_i = R * std::sqrt(ratio), .R_j = R / std::sqrt(ratio), .modulus = 2e9, .work_of_adhesion = work};
}

double mean_radius(const jg::Pair& pair) {
  return std::sqrt(pair.R_i * pair.R_j);
}

struct Columns {
  std::vector<double> R_i, R_j, modulus, work, overlap, force, a_c, b_c, stiffness;
  std::vector<jg::Status> status;
  std::vector<jg::Memory> memory;

  void add(const jg::Pair& pair, double delta, jg::Memory last = {}) {
    R_i.push_back(pair.R_i), R_j.push_back(pair.R_j), modulus.push_back(pair.modulus);
    work.push_back(pair.work_of_adhesion), overlap.push_back(delta), memory.push_back(last);
  }
  void run() {
    for (auto* column : {&force, &a_c, &b_c, &stiffness}) column->resize(R_i.size());
    status.resize(R_i.size());
    jg::contacts({R_i, R_j, modulus, work, overlap}, memory, {force, a_c, b_c, stiffness, status});
  }
};

}  // namespace

TEST_CASE("Johnson-Greenwood states agree with the reference values") {
  for (const auto& row : reference_rows("johnson_greenwood")) {
    const double ratio = row.at("ratio");
    for (const auto& state : row.at("states")) {
      const double g = state.at("g");
      CAPTURE(ratio, g);
      // The states lie on the difference g²D − (R_j/R_i)B, which loses (g − g_Hertz)/g of its digits: 1e-3 at the
      // nearest rows, so 1e-16 of the inputs becomes 1e-13 of the answers.
      const double tolerance = 2e-12;
      REQUIRE(jg::shape_constant_major(ratio, g) == Approx(state.at("Pi1").get<double>()).epsilon(1e-14));
      REQUIRE(jg::shape_constant_minor(ratio, g) == Approx(state.at("Pi2").get<double>()).epsilon(1e-14));
      REQUIRE(jg::force_of(ratio, g) == Approx(state.at("F_bar").get<double>()).epsilon(tolerance));
      REQUIRE(jg::overlap_of(ratio, g) == Approx(state.at("delta_bar").get<double>()).epsilon(tolerance));
      REQUIRE(jg::area_of(ratio, g) == Approx(state.at("A_bar").get<double>()).epsilon(tolerance));
      if (state.at("gamma_JG").is_null()) continue;
      REQUIRE(jg::gamma(ratio, g) == Approx(state.at("gamma_JG").get<double>()).epsilon(tolerance));
      REQUIRE(jg::beta(ratio, g) == Approx(state.at("beta_JG").get<double>()).epsilon(tolerance));
    }
  }
}

TEST_CASE("The integrals are those of their definitions") {
  for (const double g : {0.02, 0.4, 0.9, 0.999999}) {
    const double m = (1.0 - g) * (1.0 + g);
    const auto over = [&](double s2, double c2, double power) {
      return integrate(
          [=](double t) {
            const double s = std::sin(t), c = std::cos(t);
            return std::pow(s * s, s2) * std::pow(c * c, c2) * std::pow(1.0 - m * s * s, -0.5 * power);
          },
          0.0, 0.5 * pi);
    };
    REQUIRE(jg::integral_D(g) == Approx(over(1, 0, 1)).epsilon(1e-10));  // quadrature's own error
    REQUIRE(jg::integral_B(g) == Approx(over(0, 1, 1)).epsilon(1e-10));
    REQUIRE(jg::integral_C(g) == Approx(over(1, 1, 3)).epsilon(1e-10));
  }
  REQUIRE(jg::integral_C(1.0) == Approx(pi / 16.0).epsilon(1e-15));
}

TEST_CASE("At Hertz's axis ratio the traction is Hertz's, and gamma and beta become Hertz's") {
  for (const double ratio : {1.2, 5.0, 44.0, 1000.0}) {
    const auto ellipse = contact_ellipse(ratio, 1.0);
    const double g = ellipse.axis_ratio;
    REQUIRE(jg::shape_constant_minor(ratio, g) * g * g ==
            Approx(jg::shape_constant_major(ratio, g)).epsilon(2e-14));  // rounding of g
    const double near = g * (1.0 + 1e-9);
    const double R_c_over_R = std::sqrt(ratio) / (1.0 + ratio);
    // Off by the first order in g − g_Hertz.
    REQUIRE(jg::gamma(ratio, near) == Approx(std::sqrt(R_c_over_R) * ellipse.gamma()).epsilon(1e-7));
    REQUIRE(jg::beta(ratio, near) == Approx(R_c_over_R * ellipse.beta()).epsilon(1e-7));
  }
}

TEST_CASE("The printed area factor, without the factor 2 on K, misses Hertz's: erratum to (28)") {
  // The denominator of (27), (28) is 2K(p_1 − T) − B p_1 − D p_2 in the unit of p_1; the review's (28) has K once.
  const double ratio = 5.0;
  const auto ellipse = contact_ellipse(ratio, 1.0);
  const double g = ellipse.axis_ratio, R_over_R_c = (1.0 + ratio) / std::sqrt(ratio);
  const double p = jg::shape_constant_major(ratio, g) / (2.0 * g);
  const double B = jg::integral_B(g), D = jg::integral_D(g), K = B + D;
  REQUIRE(R_over_R_c / (2.0 * K * p - B * p - D * p) == Approx(ellipse.beta()).epsilon(1e-13));
  // With K once the denominator vanishes in the Hertz limit: no finite area at all.
  REQUIRE(std::abs(K * p - B * p - D * p) < 1e-14 * K * p);
}

TEST_CASE("The traction presses the half-space into the bodies' shape and carries the force") {
  // Boussinesq's integral of (P_0 − P_1 x²/a² − P_2 y²/b²)/√(…) in polar coordinates about a point: along a chord the
  // root integrates to π/√A, x and y to their means and mean squares over the arcsine law. One quadrature remains.
  const auto pair = pair_of(7.0);
  const auto state = jg::at_major_axis(pair, 1.3 * jg::units(pair).length);
  const double a = state.a_c, b = state.b_c, g = state.axis_ratio, E = pair.modulus, R = mean_radius(pair);
  const double ratio = pair.R_i / pair.R_j;
  const double P_1 = jg::shape_constant_major(ratio, g) * E * a / (2.0 * g * R);
  const double P_2 = jg::shape_constant_minor(ratio, g) * g * E * a / (2.0 * R);
  // Griffith: (P_1 − P_0)√(πa) = (P_2 − P_0)√(πb) = √(2ÊW).
  const double tension = std::sqrt(2.0 * E * pair.work_of_adhesion);
  const double P_0 = P_1 - tension / std::sqrt(pi * a);
  REQUIRE(P_2 - P_0 == Approx(tension / std::sqrt(pi * b)).epsilon(1e-11));
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.5 * a, 0.0}, {0.0, 0.7 * b}, {-0.4 * a, 0.6 * b}}) {
    const auto along_chord = [&, x = x, y = y](double phi) {
      const double c = std::cos(phi), s = std::sin(phi);
      const double A = c * c / (a * a) + s * s / (b * b), B = x * c / (a * a) + y * s / (b * b);
      const double C = 1.0 - x * x / (a * a) - y * y / (b * b), spread = (B * B / A + C) / (2.0 * A);
      const double mean_x2 = std::pow(x - c * B / A, 2) + c * c * spread;
      const double mean_y2 = std::pow(y - s * B / A, 2) + s * s * spread;
      return pi / std::sqrt(A) * (P_0 - P_1 * mean_x2 / (a * a) - P_2 * mean_y2 / (b * b));
    };
    const double sinking = integrate(along_chord, 0.0, pi) / (pi * E);
    const double expected = state.overlap - x * x / (2.0 * pair.R_i) - y * y / (2.0 * pair.R_j);
    REQUIRE(sinking == Approx(expected).epsilon(1e-9).margin(1e-10 * jg::units(pair).overlap));
  }
  const double carried = 2.0 * pi * a * b * (P_0 - (P_1 + P_2) / 3.0);
  REQUIRE(state.force == Approx(carried).epsilon(1e-11));
}

TEST_CASE("JKR pulls off at 1.5 pi W R when the contact is circular, and at less when it is long") {
  const auto circle = pair_of(1.0);
  REQUIRE(jg::pull_off(circle).force ==
          Approx(-1.5 * pi * mean_radius(circle) * circle.work_of_adhesion).epsilon(1e-13));
  const auto pull_off_of = [](double ratio) {
    const auto pair = pair_of(ratio);
    return jg::pull_off(pair).force / jg::units(pair).force;
  };
  REQUIRE(pull_off_of(1.0001) == Approx(-0.5).epsilon(1e-8));
  REQUIRE(pull_off_of(2.0) == Approx(-0.4926).epsilon(1e-4));  // printed to four digits
  REQUIRE(pull_off_of(5.0) == Approx(-0.463).epsilon(1e-3));
  for (const auto& row : reference_rows("johnson_greenwood")) {
    const double scanned = row.at("pull_off_F_bar_on_300_point_scan"), ratio = row.at("ratio");
    REQUIRE(pull_off_of(ratio) <= scanned);  // a scan cannot go below the minimum
    // and misses it by the square of its spacing, ~(1/300)² times the curvature there.
    REQUIRE(pull_off_of(ratio) == Approx(scanned).epsilon(2e-4));
  }
}

TEST_CASE("A circular contact snaps off where JKR does") {
  // δ = a²/R − √(2πWa/Ê) is least at a^{3/2} = R/4 √(2πW/Ê), where the force is 5/9 of the pull-off force.
  const auto pair = pair_of(1.0);
  const double R = mean_radius(pair), W = pair.work_of_adhesion, E = pair.modulus;
  const double a = std::pow(R / 4.0 * std::sqrt(2.0 * pi * W / E), 2.0 / 3.0);
  const auto state = jg::snap_off(pair);
  REQUIRE(state.overlap == Approx(a * a / R - std::sqrt(2.0 * pi * W * a / E)).epsilon(1e-13));
  REQUIRE(state.a_c == Approx(a).epsilon(1e-10));  // the place of a zero slope, not of a root of the overlap
  REQUIRE(state.force == Approx(-5.0 / 9.0 * 1.5 * pi * R * W).epsilon(1e-10));
}

TEST_CASE("A cycle of snap-in and snap-off loses Thornton and Ning's energy") {
  // 7.09 (Γ⁵R⁴/Ê²)^{1/3}, [TN98], printed to three digits; Γ is the work of adhesion W.
  const auto pair = pair_of(1.0);
  const double scale =
      std::cbrt(std::pow(pair.work_of_adhesion, 5) * std::pow(mean_radius(pair), 4) / (pair.modulus * pair.modulus));
  REQUIRE(jg::hysteresis_loss(pair) / scale == Approx(7.09).epsilon(1e-3));
  REQUIRE(jg::hysteresis_loss(pair_of(10.0)) > 0.0);
  REQUIRE(jg::hysteresis_loss(pair_of(10.0, 0.0)) == 0.0);
}

TEST_CASE("A DEM cycle through contact loses the hysteresis energy") {
  const auto pair = pair_of(4.0);
  const auto scale = jg::units(pair);
  Columns column;
  column.add(pair, 0.0);
  double work = 0.0, last = 0.0;
  const int steps = 20000;
  for (int i = 0; i <= steps; ++i) {  // to 2 overlap units and back
    const double phase = 2.0 * pi * i / steps;
    const double delta = scale.overlap * (0.5 - 1.5 * std::cos(phase));
    column.overlap[0] = delta;
    const double force_before = column.force.empty() ? 0.0 : column.force[0];
    column.run();
    REQUIRE(column.status[0] != jg::Status::not_converged);
    if (i > 0) work += 0.5 * (column.force[0] + force_before) * (delta - last);
    last = delta;
  }
  REQUIRE(column.status[0] == jg::Status::apart);
  // The trapezium rule smears the two jumps over a step of ~2e-4 overlap units each.
  REQUIRE(work == Approx(jg::hysteresis_loss(pair)).epsilon(2e-3));
}

TEST_CASE("Without adhesion the contact is Hertz's, and tends to it") {
  for (const double ratio : {1.0, 3.0, 200.0}) {
    const auto pair = pair_of(ratio, 0.0);
    const auto ellipse = contact_ellipse(pair.R_i, pair.R_j);
    const double overlap = 1e-9;
    const auto hertz = osculate::hertz::contact(ellipse, pair.modulus, overlap, 1.0);
    const auto state = jg::at_overlap(pair, overlap);
    REQUIRE(state);
    REQUIRE(state->force == Approx(hertz.force).epsilon(1e-13));
    REQUIRE(state->a_c == Approx(hertz.a_c).epsilon(1e-13));
    REQUIRE(state->b_c == Approx(hertz.b_c).epsilon(1e-13));
    REQUIRE(state->stiffness == Approx(hertz.stiffness).epsilon(1e-13));
    REQUIRE_FALSE(jg::at_overlap(pair, 0.0));
    REQUIRE_FALSE(jg::at_force(pair, 0.0));
    // The tension enters with the root of W.
    double last = 1.0;
    for (const double work : {1e-6, 1e-8, 1e-10}) {
      const double error = std::abs(jg::at_overlap(pair_of(ratio, work), overlap)->force / hertz.force - 1.0);
      REQUIRE(error < 0.11 * last);
      last = error;
    }
  }
}

TEST_CASE("Force and overlap control find the same states, and the states lie on the curve") {
  for (const double ratio : {1.0, 1.0 + 1e-12, 1.01, 3.0, 50.0, 1e4, 1e8}) {
    const auto pair = pair_of(ratio);
    const auto scale = jg::units(pair);
    const auto least_force = jg::pull_off(pair), least_overlap = jg::snap_off(pair);
    REQUIRE(least_overlap.a_c < least_force.a_c);
    for (const double extra : {1e-6, 1e-3, 0.1, 1.0, 10.0, 1e4}) {
      CAPTURE(ratio, extra);
      const auto state = jg::at_overlap(pair, least_overlap.overlap + extra * scale.overlap);
      REQUIRE(state);
      REQUIRE(state->a_c > least_overlap.a_c);
      const auto on_curve = jg::at_major_axis(pair, state->a_c);
      // The force hangs on a by up to F'a/F ~ 10, and a on δ by ε/extra^{1/2} near the fold.
      REQUIRE(on_curve.overlap == Approx(state->overlap).epsilon(1e-12).margin(1e-13 * scale.overlap));
      REQUIRE(on_curve.force == Approx(state->force).epsilon(1e-11).margin(1e-11 * scale.force));
      if (state->a_c <= least_force.a_c * 1.01) continue;
      const auto same = jg::at_force(pair, state->force);
      REQUIRE(same);
      REQUIRE(same->overlap == Approx(state->overlap).epsilon(1e-10).margin(1e-10 * scale.overlap));
    }
    REQUIRE_FALSE(jg::at_overlap(pair, least_overlap.overlap - 1e-9 * scale.overlap));
    REQUIRE_FALSE(jg::at_force(pair, least_force.force * (1.0 + 1e-9)));
  }
}

TEST_CASE("Stiffness is the slope of the force") {
  const auto pair = pair_of(6.0);
  const auto scale = jg::units(pair);
  for (const double delta : {-0.3, 0.0, 0.7, 30.0}) {
    const double at = delta * scale.overlap, step = 1e-4 * scale.overlap;
    const double slope =
        (jg::at_overlap(pair, at + step)->force - jg::at_overlap(pair, at - step)->force) / (2.0 * step);
    // Central difference: step² times a third derivative of order one in these units.
    REQUIRE(jg::at_overlap(pair, at)->stiffness == Approx(slope).epsilon(1e-6));
  }
}

TEST_CASE("Parametric, force-controlled and dimensional states are one curve") {
  const auto pair = pair_of(5.0);
  const auto scale = jg::units(pair);
  const auto state = jg::at_major_axis(pair, 0.9 * scale.length);
  const double ratio = pair.R_i / pair.R_j;
  REQUIRE(state.force == Approx(scale.force * jg::force_of(ratio, state.axis_ratio)).epsilon(1e-11));
  REQUIRE(state.overlap == Approx(scale.overlap * jg::overlap_of(ratio, state.axis_ratio)).epsilon(1e-11));
  REQUIRE(state.area() ==
          Approx(pi * scale.length * scale.length * jg::area_of(ratio, state.axis_ratio)).epsilon(1e-11));
}

TEST_CASE("A hard small contact is DMT's and a soft large one JKR's") {
  REQUIRE(jg::regime(0.01) == jg::Regime::hard);
  REQUIRE(jg::regime(1.0) == jg::Regime::intermediate);
  REQUIRE(jg::regime(20.0) == jg::Regime::soft);
  const auto pair = pair_of(1.0);
  REQUIRE(jg::tabor_parameter(pair, 3e-10) ==
          Approx(std::cbrt(3e-6 * std::pow(0.05 / 2e9, 2) / 2.7e-29)).epsilon(1e-14));
  const auto touch = jg::derjaguin_muller_toporov(pair, 0.0);
  REQUIRE(touch);
  REQUIRE(touch->force == Approx(-2.0 * pi * mean_radius(pair) * pair.work_of_adhesion).epsilon(1e-14));
  REQUIRE_FALSE(jg::derjaguin_muller_toporov(pair, -1e-12));
}

TEST_CASE("A batch of adhesive contacts gives what single contacts give") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Columns column;
  std::vector<jg::Pair> pairs;
  for (int i = 0; i < 1001; ++i) {
    const auto pair = pair_of(i % 10 == 0 ? 1.0 : std::pow(10.0, 6.0 * uniform(random)),
                              i % 7 == 0 ? 0.0 : std::pow(10.0, -8.0 + 7.0 * uniform(random)));
    pairs.push_back(pair);
    column.add(pair, 1e-9 * (1e-3 + uniform(random)));
  }
  for (const char* visit : {"cold", "warm"}) {
    column.run();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      CAPTURE(visit, i, pairs[i].R_i / pairs[i].R_j, pairs[i].work_of_adhesion);
      const auto state = jg::at_overlap(pairs[i], column.overlap[i]);
      REQUIRE(column.status[i] == jg::Status::closed);
      const double scale = 1e-12 * jg::units(pairs[i]).force;  // the force may cross zero
      REQUIRE(column.force[i] == Approx(state->force).epsilon(1e-11).margin(scale));
      REQUIRE(column.a_c[i] == Approx(state->a_c).epsilon(1e-11));
      REQUIRE(column.b_c[i] == Approx(state->b_c).epsilon(1e-11));
      REQUIRE(column.stiffness[i] == Approx(state->stiffness).epsilon(1e-6));
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) column.overlap[i] *= 1.0 + 0.1 * uniform(random);
  }
}

TEST_CASE("Adhesive contacts close at touch, hold on beyond it and let go at snap-off") {
  const auto pair = pair_of(20.0);
  const double least = jg::snap_off(pair).overlap;
  Columns column;
  for (int i = 0; i < 5; ++i) column.add(pair, 0.0);
  column.overlap = {-1e-15, 0.0, 1e-9, 0.0, 0.0};
  column.run();
  REQUIRE(column.status[0] == jg::Status::apart);
  REQUIRE(column.force[0] == 0.0);
  REQUIRE(column.status[1] == jg::Status::closed);
  REQUIRE(column.force[1] < 0.0);
  column.overlap = {0.999 * least, 0.999999 * least, 1.001 * least, 1.0001 * least, 100.0 * least};
  column.run();
  REQUIRE(column.status[0] == jg::Status::apart);
  REQUIRE(column.status[1] == jg::Status::closed);
  for (int i = 2; i < 5; ++i) {
    REQUIRE(column.status[static_cast<std::size_t>(i)] == jg::Status::apart);
    REQUIRE_FALSE(column.memory[static_cast<std::size_t>(i)].closed());
  }
}

TEST_CASE("A memory that has become useless does not open a contact or change its force") {
  const auto pair = pair_of(20.0);
  const double overlap = 0.3 * jg::snap_off(pair).overlap;
  const auto state = *jg::at_overlap(pair, overlap);
  Columns column;
  for (const double wrong : {1e-4, 0.03, 0.5, 2.0, 1e4})
    for (const double g : {1e-3, 0.5, 1.0}) column.add(pair, overlap, {.a_c = wrong * state.a_c, .axis_ratio = g});
  column.run();
  for (std::size_t i = 0; i < column.force.size(); ++i) {
    CAPTURE(i);
    REQUIRE(column.status[i] == jg::Status::closed);
    REQUIRE(column.force[i] == Approx(state.force).epsilon(1e-11));
  }
}

TEST_CASE("Bad adhesive pairs are refused at set-up and said in a batch") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const jg::Pair good{.R_i = 2.0, .R_j = 1.0, .modulus = 1.0, .work_of_adhesion = 0.1};
  REQUIRE_NOTHROW(jg::validate(good));
  std::vector<jg::Pair> bad(8, good);
  bad[0].R_i = 0.5, bad[1].R_j = 0.0, bad[2].R_j = nan, bad[3].R_i = infinity;
  bad[4].modulus = -1.0, bad[5].modulus = nan, bad[6].work_of_adhesion = -0.1, bad[7].work_of_adhesion = nan;
  Columns column;
  for (const auto& pair : bad) {
    REQUIRE_THROWS_AS(jg::validate(pair), osculate::InputError);
    REQUIRE_THROWS_AS(jg::at_overlap(pair, 0.1), osculate::InputError);
    column.add(pair, 0.1);
  }
  column.add(good, nan);
  column.run();
  for (std::size_t i = 0; i < column.R_i.size(); ++i) {
    REQUIRE(column.status[i] == jg::Status::bad_input);
    REQUIRE(column.force[i] == 0.0);
    REQUIRE(column.a_c[i] == 0.0);
  }
  REQUIRE_THROWS_AS(jg::gamma(5.0, 0.8), osculate::InputError);  // δ < 0 there
  REQUIRE_THROWS_AS(jg::force_of(5.0, 0.1), osculate::InputError);
  REQUIRE_THROWS_AS(jg::pull_off(pair_of(2.0, 0.0)), osculate::InputError);
}
