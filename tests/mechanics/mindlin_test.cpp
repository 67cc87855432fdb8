#include "osculate/mechanics/mindlin.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mechanics/gsl_quadrature.hpp"
#include "mechanics/reference.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace mindlin = osculate::mindlin;
using osculate::ElasticMaterial;

namespace {

const ElasticMaterial steel{.youngs_modulus = 210e9, .poissons_ratio = 0.29};
const ElasticMaterial rubber{.youngs_modulus = 4e6, .poissons_ratio = 0.49};

/// Displacement of the half-space's surface inside the ellipse (uniform) under q = (1 − x²/a² − y²/b²)^{−1/2} along x
/// or y, by Cerruti's kernel in polar coordinates about the point: every chord integrates to π/√A.
double punch_displacement(double a, double b, bool along_x, const ElasticMaterial& material) {
  const double nu = material.poissons_ratio;
  const auto chord = [&](double phi) {
    const double c = std::cos(phi), s = std::sin(phi);
    const double A = c * c / (a * a) + s * s / (b * b);
    return M_PI / std::sqrt(A) * (1.0 - nu + nu * (along_x ? c * c : s * s));
  };
  return quadrature(chord, 0.0, M_PI) / (2.0 * M_PI * material.shear_modulus());
}

/// Two bodies; C and μF_n that are not 1.
const mindlin::Contact held = mindlin::contact(3e-8, 0.4, 250.0);

}  // namespace

TEST_CASE("Compliances and shape factors are the reference's, along both axes") {
  for (const auto& row : reference_rows("tangential")) {
    const double nu = row.at("nu"), e2 = row.at("e2");
    const auto ellipse = ellipse_of(e2);
    const ElasticMaterial material{.youngs_modulus = 2.0 * (1.0 + nu), .poissons_ratio = nu};  // G = 1
    const auto body = mindlin::body_compliance(ellipse, 0.5, material);
    const double unit = 2.0 * M_PI * 0.5;
    // e² is given to 17 digits; the rest is rounding.
    CHECK(unit * body.major == Approx(row.at("compliance_major_times_2piGa_one_body").get<double>()).epsilon(1e-14));
    CHECK(unit * body.minor == Approx(row.at("compliance_minor_times_2piGa_one_body").get<double>()).epsilon(1e-14));
    const auto factor = mindlin::shape_factor(ellipse, nu);
    CHECK(factor.major == Approx(row.at("Phi_major").get<double>()).epsilon(1e-14));
    CHECK(factor.minor == Approx(row.at("Phi_minor").get<double>()).epsilon(1e-14));
  }
}

TEST_CASE("The major axis is the more compliant one, by Cerruti's kernel") {
  const double a = 2e-3;
  for (const double e2 : {0.0, 0.4, 0.95}) {
    const auto ellipse = ellipse_of(e2);
    const double b = a * ellipse.axis_ratio;
    const double force = 2.0 * M_PI * a * b;  // of the unit punch traction
    const auto body = mindlin::body_compliance(ellipse, a, steel);
    CHECK(body.major == Approx(punch_displacement(a, b, true, steel) / force).epsilon(1e-11));
    CHECK(body.minor == Approx(punch_displacement(a, b, false, steel) / force).epsilon(1e-11));
    CHECK(body.major >= body.minor);
  }
}

TEST_CASE("A circular contact has Mindlin's compliance and ratio") {
  const auto ellipse = osculate::contact_ellipse(0.01, 0.01);
  const double a = 1e-3, nu = steel.poissons_ratio;
  const auto both = mindlin::compliance(ellipse, a, steel, steel);
  CHECK(both.major == Approx((2.0 - nu) / (4.0 * steel.shear_modulus() * a)).epsilon(4e-15));
  CHECK(both.minor == Approx(both.major).epsilon(4e-15));
  const auto ratio = mindlin::compliance_ratio(ellipse, steel, steel);
  CHECK(ratio.major == Approx((2.0 - nu) / (2.0 * (1.0 - nu))).epsilon(4e-15));
}

TEST_CASE("The compliance ratio is the tangential over the normal compliance of the same contact") {
  for (const double R_i : {0.002, 0.004, 0.2}) {
    const auto ellipse = osculate::contact_ellipse(R_i, 0.002);
    const double modulus = osculate::effective_modulus(steel, rubber);
    const auto pressed = osculate::hertz::contact(ellipse, modulus, 1e-6, 0.002);
    const auto both = mindlin::compliance(ellipse, pressed.a_c, steel, rubber);
    const auto ratio = mindlin::compliance_ratio(ellipse, steel, rubber);
    CHECK(ratio.major == Approx(both.major * pressed.stiffness).epsilon(1e-14));
    CHECK(ratio.minor == Approx(both.minor * pressed.stiffness).epsilon(1e-14));
  }
}

TEST_CASE("Between the axes the displacement is the vector sum of those along them") {
  const mindlin::Axes both{.major = 5.0, .minor = 3.0};
  const double angle = 0.7, c = std::cos(angle), s = std::sin(angle);
  const auto off = mindlin::off_axis(both, angle);
  CHECK(off.along * c - off.across * s == Approx(both.major * c).epsilon(1e-15));
  CHECK(off.along * s + off.across * c == Approx(both.minor * s).epsilon(1e-15));
}

TEST_CASE("Force and displacement of virgin loading are inverse, and stiffness the slope") {
  for (const double share : {1e-9, 0.1, 0.7, 0.999}) {
    const double force = share * held.limit;
    const double moved = mindlin::displacement(held, force);
    CHECK(mindlin::force(held, moved) == Approx(force).epsilon(1e-13));
    CHECK(mindlin::displacement(held, -force) == -moved);
    const double slope = quadrature([](double f) { return 1.0 / mindlin::stiffness(held, f); }, 0.0, force);
    CHECK(moved == Approx(slope).epsilon(1e-11));
  }
  CHECK(mindlin::stiffness(held, 0.0) == 1.0 / held.compliance);
  CHECK(mindlin::displacement(held, held.limit) == mindlin::sliding_displacement(held));
  CHECK(mindlin::force(held, 2.0 * mindlin::sliding_displacement(held)) == held.limit);
  CHECK(mindlin::stick_ratio(held, held.limit) == 0.0);
}

TEST_CASE("The ellipse of stick leaves the tangential force to the two Hertz pressures' difference") {
  // Cattaneo: q = μp(ρ) − r μp(ρ/r) inside the stick, with p = 3F_n/(2πab) (1 − ρ²)^{1/2} in scaled coordinates.
  for (const double share : {0.1, 0.5, 0.9}) {
    const double r = mindlin::stick_ratio(held, share * held.limit);
    const auto pressure = [](double rho) { return 1.5 * std::sqrt(std::max(0.0, 1.0 - rho * rho)); };  // × F_n/(πab)
    const auto ring = [&](double rho) { return 2.0 * rho * pressure(rho); };
    const auto stick = [&](double rho) { return 2.0 * rho * r * pressure(rho / r); };
    CHECK(quadrature(ring, 0.0, 1.0) - quadrature(stick, 0.0, r) == Approx(share).epsilon(1e-8));  // quadrature's own
  }
}

TEST_CASE("Unloading starts stiff at the peak and joins the mirrored virgin curve at its foot") {
  const double peak = 0.8 * held.limit;
  const auto unload = [&](double f) { return mindlin::unloading_displacement(held, f, peak); };
  CHECK(unload(peak) == Approx(mindlin::displacement(held, peak)).epsilon(1e-15));
  CHECK(unload(-peak) == Approx(-mindlin::displacement(held, peak)).epsilon(1e-14));
  CHECK(mindlin::reloading_displacement(held, peak, peak) == Approx(unload(peak)).epsilon(1e-14));
  CHECK(mindlin::unloading_stiffness(held, peak, peak) == 1.0 / held.compliance);
  const double slope =
      quadrature([&](double f) { return 1.0 / mindlin::unloading_stiffness(held, f, peak); }, 0.1 * peak, peak);
  CHECK(unload(peak) - unload(0.1 * peak) == Approx(slope).epsilon(1e-11));
}

TEST_CASE("The reference's cycles of two equal bodies are reproduced") {
  // In units of (2−ν)μF_nΦ/(G a_c) the total compliance times μF_n is 1/4.
  const mindlin::Contact unit{.compliance = 0.25, .limit = 1.0};
  for (const auto& row : reference_rows("mindlin_cycle")) {
    const double peak = row.at("Ft_star_over_muFn");
    CHECK(mindlin::displacement(unit, peak) == Approx(row.at("delta_peak").get<double>()).epsilon(1e-14));
    CHECK(mindlin::unloading_displacement(unit, 0.0, peak) ==
          Approx(row.at("delta_residual_at_Ft_zero").get<double>()).epsilon(1e-12));  // a difference: 3 digits lost
    CHECK(mindlin::cycle_energy(unit, peak) == Approx(row.at("energy_lost_per_cycle").get<double>()).epsilon(1e-13));
  }
}

TEST_CASE("Errata (66),(67),(69): with total displacement the loop's area is the energy") {
  for (const double share : {0.05, 0.5, 1.0}) {
    const double peak = share * held.limit;
    const double area = quadrature(
        [&](double f) {
          return mindlin::unloading_displacement(held, f, peak) - mindlin::reloading_displacement(held, f, peak);
        },
        -peak, peak);
    CHECK(mindlin::cycle_energy(held, peak) == Approx(area).epsilon(1e-9));
  }
}

TEST_CASE("Erratum (76): a small cycle loses energy as the cube of its amplitude") {
  const double peak = 1e-5 * held.limit;
  // The next term is 5/9 of the amplitude ratio.
  CHECK(mindlin::small_cycle_energy(held, peak) == Approx(mindlin::cycle_energy(held, peak)).epsilon(2e-5));
}

TEST_CASE("Errata (70),(71): oblique compliances are the slopes of the oblique paths") {
  for (const double theta : {0.0, 0.3, 0.9, 1.0, 2.5}) {
    const auto slanted = mindlin::oblique(held, theta);
    const double peak = 0.45 * held.limit;
    const double loading =
        quadrature([&](double f) { return mindlin::oblique_loading_compliance(slanted, f); }, 0.0, peak);
    CHECK(mindlin::oblique_displacement(slanted, peak) == Approx(loading).epsilon(1e-10));
    const double foot = 0.2 * peak * (theta < 1.0 ? -(1.0 - theta) / (1.0 + theta) : 1.0);
    const double unloading =
        quadrature([&](double f) { return mindlin::oblique_unloading_compliance(slanted, f, peak); }, foot, peak);
    CHECK(mindlin::oblique_unloading_displacement(slanted, peak, peak) -
              mindlin::oblique_unloading_displacement(slanted, foot, peak) ==
          Approx(unloading).epsilon(1e-10));
  }
}

TEST_CASE("Erratum (73): unloading is continuous where all earlier slip is forgotten") {
  const auto slanted = mindlin::oblique(held, 0.4);
  const double peak = 0.5 * held.limit, forgotten = -peak * (1.0 - 0.4) / (1.0 + 0.4);
  const auto path = [&](double f) { return mindlin::oblique_unloading_displacement(slanted, f, peak); };
  const double step = 1e-9 * peak;
  CHECK(path(forgotten + step) == Approx(path(forgotten - step)).epsilon(1e-8));
  // Printed, the second branch's bracket has another argument; it would jump by more than a tenth here.
  CHECK(path(-peak) < path(forgotten));
}

TEST_CASE("Oblique paths with a constant normal force are the simple ones") {
  const auto level = mindlin::oblique(held, 0.0);
  const double peak = 0.6 * held.limit, at = -0.2 * held.limit;
  CHECK(mindlin::oblique_displacement(level, peak) == Approx(mindlin::displacement(held, peak)).epsilon(1e-14));
  CHECK(mindlin::oblique_unloading_displacement(level, at, peak) ==
        Approx(mindlin::unloading_displacement(held, at, peak)).epsilon(1e-13));
  CHECK(mindlin::oblique_reloading_displacement(level, at, peak) ==
        Approx(mindlin::reloading_displacement(held, at, peak)).epsilon(1e-13));
  CHECK(mindlin::oblique_cycle_energy(mindlin::oblique(held, 1e-7), peak) ==
        Approx(mindlin::cycle_energy(held, peak)).epsilon(1e-6));
}

TEST_CASE("Erratum (75): the oblique loop's energy is the integral with a changing contact radius") {
  for (const double theta : {0.1, 0.6, 0.95}) {
    const auto slanted = mindlin::oblique(held, theta);
    const double peak = 0.5 * held.limit;
    // Later cycles: unloading starts from the end of reloading, and the slip of the first loading is forgotten.
    const double top = peak / held.limit, scale = 1.5 * held.compliance * held.limit;
    const auto unloading = [&](double f) {
      const double x = f / held.limit, n = 1.0 - 0.5 * (top - x - theta * (top + x));
      return scale * (std::pow(1.0 - theta * top - top, 2.0 / 3.0) - 2.0 * std::pow(1.0 - top, 2.0 / 3.0) +
                      2.0 * std::pow(n, 2.0 / 3.0) - std::pow(1.0 + theta * x, 2.0 / 3.0));
    };
    if (theta * top + top > 1.0) continue;
    const double area =
        quadrature([&](double f) { return unloading(f) - mindlin::oblique_reloading_displacement(slanted, f, peak); },
                   -peak, peak);
    CHECK(mindlin::oblique_cycle_energy(slanted, peak) == Approx(area).epsilon(1e-9));
  }
  CHECK(mindlin::oblique_cycle_energy(mindlin::oblique(held, 1.0), 0.5 * held.limit) == 0.0);
}

TEST_CASE("Parameters that mean nothing are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(mindlin::contact(bad, 0.3, 1.0), osculate::InputError);
    CHECK_THROWS_AS(mindlin::contact(1.0, bad, 1.0), osculate::InputError);
    CHECK_THROWS_AS(mindlin::contact(1.0, 0.3, bad), osculate::InputError);
    CHECK_THROWS_AS(mindlin::body_compliance(ellipse_of(0.5), bad, steel), osculate::InputError);
  }
  CHECK_THROWS_AS(mindlin::oblique(held, -0.1), osculate::InputError);
  CHECK_THROWS_AS(mindlin::oblique(held, nan), osculate::InputError);
  CHECK_THROWS_AS(mindlin::shape_factor(ellipse_of(0.5), 0.6), osculate::InputError);
}
