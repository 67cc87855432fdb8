#include "osculate/mechanics/jamari_schipper.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace js = osculate::jamari_schipper;
namespace hertz = osculate::hertz;
using osculate::contact_ellipse;

namespace {

constexpr double R_i = 0.013, R_j = 0.002, modulus = 60e9;
constexpr js::Plasticity aluminium_like{
    .hardness = 1.2e9, .yield_factor = 0.577, .plastic_factor = 0.7, .area_ratio = 160.0};

js::Contact loaded(double overlap, double major = R_i, double minor = R_j) {
  js::Memory fresh;
  return js::contact(major, minor, modulus, aluminium_like, overlap, fresh);
}

struct Batch {
  std::vector<double> R_i, R_j, modulus, yield, plastic, area_ratio, overlap, largest, force, area, stiffness, energy,
      residual;
  std::vector<js::Regime> regime;

  void add(double i, double j, double e, const js::Plasticity& p, double delta, double before) {
    R_i.push_back(i), R_j.push_back(j), modulus.push_back(e), yield.push_back(p.yield_pressure());
    plastic.push_back(p.plastic_pressure()), area_ratio.push_back(p.area_ratio);
    overlap.push_back(delta), largest.push_back(before);
  }
  void run() {
    for (auto* column : {&force, &area, &stiffness, &energy, &residual}) column->resize(R_i.size());
    regime.resize(R_i.size());
    js::contacts({R_i, R_j, modulus, yield, plastic, area_ratio, overlap},
                 {largest, force, area, stiffness, energy, residual, regime});
  }
};

}  // namespace

TEST_CASE("First yield is where Hertz's peak pressure reaches the yield pressure") {
  const auto limits = js::limits(R_i, R_j, modulus, aluminium_like);
  const auto at_yield = hertz::contact(contact_ellipse(R_i, R_j), modulus, limits.first_yield, R_j);
  REQUIRE(at_yield.peak_pressure == Approx(aluminium_like.yield_pressure()).epsilon(1e-14));  // rounding
  // (41) by the review's gamma and beta.
  const auto ellipse = contact_ellipse(R_i, R_j);
  const double root = M_PI * ellipse.beta() * aluminium_like.yield_pressure() / (2.0 * ellipse.gamma() * modulus);
  REQUIRE(limits.first_yield == Approx(ellipse.R_c * root * root).epsilon(1e-14));
}

TEST_CASE("Circular contacts are fully plastic from half c_A times first yield, and yield as spheres do") {
  const double R = 0.005;  // relative radius of spheres
  const auto limits = js::limits(R, R, modulus, aluminium_like);
  REQUIRE(limits.full_plasticity == Approx(0.5 * aluminium_like.area_ratio * limits.first_yield).epsilon(1e-14));
  const double root = M_PI * aluminium_like.yield_pressure() / (2.0 * modulus);
  REQUIRE(limits.first_yield == Approx(R * root * root).epsilon(1e-14));
  // The truncated sphere: a cap of height δ has base radius √(2Rδ).
  REQUIRE(loaded(2.0 * limits.full_plasticity, R, R).area ==
          Approx(2.0 * M_PI * R * 2.0 * limits.full_plasticity).epsilon(1e-14));
}

TEST_CASE("Below first yield the contact is Hertz's") {
  const double overlap = 0.7 * js::limits(R_i, R_j, modulus, aluminium_like).first_yield;
  const auto contact = loaded(overlap);
  const auto elastic = hertz::contact(contact_ellipse(R_i, R_j), modulus, overlap, R_j);
  REQUIRE(contact.regime == js::Regime::elastic);
  REQUIRE(contact.force == Approx(elastic.force).epsilon(1e-14));
  REQUIRE(contact.area == Approx(M_PI * elastic.a_c * elastic.b_c).epsilon(1e-14));
  REQUIRE(contact.stiffness == Approx(elastic.stiffness).epsilon(1e-14));
  REQUIRE(contact.strain_energy == Approx(elastic.strain_energy).epsilon(1e-14));
  REQUIRE(contact.residual_overlap == 0.0);
}

TEST_CASE("Force and area are continuous at first yield and at full plasticity") {
  for (const double ratio : {1.0, 1.5, 6.5, 100.0, 1e4}) {
    CAPTURE(ratio);
    const double major = R_j * ratio;
    const auto limits = js::limits(major, R_j, modulus, aluminium_like);
    for (const double at : {limits.first_yield, limits.full_plasticity}) {
      const double step = 1e-9;
      const auto below = loaded(at * (1.0 - step), major), above = loaded(at * (1.0 + step), major);
      REQUIRE(below.regime != above.regime);
      // dlnF/dlnδ is about 1.5: a step of 2e-9 changes force and area by no more than 1e-8.
      REQUIRE(above.force == Approx(below.force).epsilon(1e-8));
      REQUIRE(above.area == Approx(below.area).epsilon(1e-8));
    }
    const auto plastic = loaded(2.0 * limits.full_plasticity, major);
    REQUIRE(plastic.regime == js::Regime::fully_plastic);
    REQUIRE(plastic.force == Approx(aluminium_like.plastic_pressure() * plastic.area).epsilon(1e-14));
  }
}

TEST_CASE("Stiffness is the slope of the loading and of the unloading curve") {
  const auto limits = js::limits(R_i, R_j, modulus, aluminium_like);
  for (const double factor : {0.5, 3.0, 20.0, 500.0}) {
    CAPTURE(factor);
    const double overlap = factor * limits.first_yield, step = 1e-5 * overlap;
    const double slope = (loaded(overlap + step).force - loaded(overlap - step).force) / (2.0 * step);
    // Central difference: step² F'''/(6 F') ~ 1e-10; rounding 1e-16/1e-5.
    REQUIRE(loaded(overlap).stiffness == Approx(slope).epsilon(1e-8));
    js::Memory memory{2.0 * overlap};
    const double below = 1.9 * overlap;
    const auto force = [&](double at) { return js::contact(R_i, R_j, modulus, aluminium_like, at, memory).force; };
    REQUIRE(js::contact(R_i, R_j, modulus, aluminium_like, below, memory).stiffness ==
            Approx((force(below + step) - force(below - step)) / (2.0 * step)).epsilon(1e-6));
  }
}

TEST_CASE("Unloading is Hertz on the enlarged radii and starts where loading ended") {
  const auto limits = js::limits(R_i, R_j, modulus, aluminium_like);
  for (const double factor : {1.5, 10.0, 300.0}) {
    CAPTURE(factor);
    const double largest = factor * limits.first_yield;
    js::Memory memory;
    const auto top = js::contact(R_i, R_j, modulus, aluminium_like, largest, memory);
    REQUIRE(top.residual_overlap > 0.0);
    REQUIRE(top.radius_growth > 1.0);
    const auto enlarged = contact_ellipse(top.radius_growth * R_i, top.radius_growth * R_j);
    for (const double part : {1.0 - 1e-12, 0.8, 0.3}) {
      const double depth = part * (largest - top.residual_overlap);
      const auto contact = js::contact(R_i, R_j, modulus, aluminium_like, top.residual_overlap + depth, memory);
      const auto elastic = hertz::contact(enlarged, modulus, depth, R_j);
      // The depth is the difference of overlaps up to 30 times as large.
      REQUIRE(contact.force == Approx(elastic.force).epsilon(1e-12));
      REQUIRE(contact.area == Approx(M_PI * elastic.a_c * elastic.b_c).epsilon(1e-12));
      REQUIRE(contact.strain_energy == Approx(elastic.strain_energy).epsilon(1e-12));
      REQUIRE(contact.regime == js::Regime::unloaded);
    }
    REQUIRE(js::contact(R_i, R_j, modulus, aluminium_like, 0.999 * top.residual_overlap, memory).force == 0.0);
    // Reloading meets the old curve.
    REQUIRE(js::contact(R_i, R_j, modulus, aluminium_like, largest, memory).force == Approx(top.force).epsilon(1e-14));
  }
}

TEST_CASE("No load cycle gives back more than it took") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int cycles_that_lost = 0;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    const double major = R_j * std::pow(10.0, 2.0 * uniform(random));
    js::Plasticity plasticity{.hardness = 1e9 * (0.1 + uniform(random)),
                              .yield_factor = 0.4 + 0.3 * uniform(random),
                              .plastic_factor = 0.0,
                              .area_ratio = 60.0 + 200.0 * uniform(random)};
    plasticity.plastic_factor = 2.0 / 3.0 * plasticity.yield_factor * (1.0 + 1.4 * uniform(random));
    js::validate(plasticity, 100.0);
    const auto limits = js::limits(major, R_j, modulus, plasticity);
    js::Memory memory;
    double overlap = 0.0, work = 0.0, scale = 0.0, force = 0.0;
    const auto move_to = [&](double target) {
      constexpr int steps = 400;
      const double start = overlap;
      for (int k = 1; k <= steps; ++k) {
        const double next = start + (target - start) * k / steps;
        // Work of the force on the way: Simpson with the midpoint, exact to (1/400)^4 where the curve is smooth.
        const double middle = js::contact(major, R_j, modulus, plasticity, 0.5 * (overlap + next), memory).force;
        const double end = js::contact(major, R_j, modulus, plasticity, next, memory).force;
        work += (next - overlap) * (force + 4.0 * middle + end) / 6.0;
        scale = std::max(scale, std::fabs(work));
        overlap = next, force = end;
      }
    };
    const double reach = limits.first_yield * std::pow(10.0, -0.5 + 3.5 * uniform(random));
    for (int leg = 0; leg < 6; ++leg) move_to(reach * uniform(random));
    const double stored = js::contact(major, R_j, modulus, plasticity, overlap, memory).strain_energy;
    // Work done on the contact must cover what it can still give back. Kinks at δ_max and δ_res cost Simpson 1e-5.
    REQUIRE(work - stored > -1e-5 * scale);
    move_to(0.0);
    REQUIRE(work > -1e-5 * scale);
    if (work > 1e-3 * scale) ++cycles_that_lost;
  }
  REQUIRE(cycles_that_lost > 700);
}

TEST_CASE("A step past the largest overlap does not depend on how it is divided") {
  const double overlap = 30.0 * js::limits(R_i, R_j, modulus, aluminium_like).first_yield;
  js::Memory at_once, in_steps;
  const double direct = js::contact(R_i, R_j, modulus, aluminium_like, overlap, at_once).force;
  for (const double part : {0.2, 0.9, 0.4, 0.95})
    js::contact(R_i, R_j, modulus, aluminium_like, part * overlap, in_steps);
  REQUIRE(js::contact(R_i, R_j, modulus, aluminium_like, overlap, in_steps).force == direct);
  STATIC_REQUIRE(std::is_trivially_copyable_v<js::Memory>);
}

TEST_CASE("A batch of plastic contacts gives what single contacts give") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Batch batch;
  for (int i = 0; i < 1003; ++i) {
    const double major = R_j * std::pow(10.0, 6.0 * uniform(random));
    const double yield = js::limits(major, R_j, modulus, aluminium_like).first_yield;
    batch.add(major, R_j, modulus, aluminium_like, yield * (std::pow(10.0, 4.0 * uniform(random)) / 10.0 - 0.2),
              i % 2 == 0 ? 0.0 : yield * std::pow(10.0, 4.0 * uniform(random)) / 10.0);
  }
  const Batch before = batch;
  batch.run();
  for (std::size_t i = 0; i < batch.R_i.size(); ++i) {
    CAPTURE(i);
    js::Memory memory{before.largest[i]};
    const auto contact = js::contact(batch.R_i[i], R_j, modulus, aluminium_like, batch.overlap[i], memory);
    // Fused and separate roundings; the depth of a nearly emptied contact is a difference.
    const double scale = loaded(memory.largest_overlap, batch.R_i[i]).force;
    REQUIRE(batch.force[i] == Approx(contact.force).epsilon(1e-12).margin(1e-13 * scale));
    REQUIRE(batch.area[i] == Approx(contact.area).epsilon(1e-12).margin(1e-20));
    REQUIRE(batch.stiffness[i] == Approx(contact.stiffness).epsilon(1e-10));
    REQUIRE(batch.energy[i] == Approx(contact.strain_energy).epsilon(1e-10).margin(1e-30));
    REQUIRE(batch.residual[i] == Approx(contact.residual_overlap).epsilon(1e-12).margin(1e-22));
    REQUIRE(batch.largest[i] == memory.largest_overlap);
    REQUIRE(batch.regime[i] == contact.regime);
  }
}

TEST_CASE("Bad numbers in a plastic batch are said and leave the memory alone") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const js::Plasticity& good = aluminium_like;
  Batch batch;
  batch.add(nan, R_j, modulus, good, 1e-6, 2e-6);
  batch.add(R_j, R_i, modulus, good, 1e-6, 2e-6);
  batch.add(R_i, R_j, -1.0, good, 1e-6, 2e-6);
  batch.add(R_i, R_j, modulus, {-1e9, 0.5, 0.7, 160}, 1e-6, 2e-6);
  batch.add(R_i, R_j, modulus, {1e9, 0.5, 0.0, 160}, 1e-6, 2e-6);
  batch.add(R_i, R_j, modulus, {1e9, 0.5, 0.7, 1.0}, 1e-6, 2e-6);
  batch.add(R_i, R_j, modulus, good, nan, 2e-6);
  batch.add(R_i, R_j, modulus, good, 1e-6, -2e-6);
  const std::size_t bad = batch.R_i.size();
  batch.add(infinity, R_j, modulus, good, 1e-6, 0.0);
  const Batch before = batch;
  batch.run();
  for (std::size_t i = 0; i < bad; ++i) {
    CAPTURE(i);
    REQUIRE(batch.regime[i] == js::Regime::bad_input);
    REQUIRE(batch.force[i] == 0.0);
    REQUIRE(batch.stiffness[i] == 0.0);
    REQUIRE(batch.largest[i] == before.largest[i]);
  }
  REQUIRE(batch.regime[bad] != js::Regime::bad_input);
  REQUIRE(std::isfinite(batch.force[bad]));
}

TEST_CASE("Plasticity that makes no sense or would create energy is refused at set-up") {
  const double nan = std::nan("");
  REQUIRE_NOTHROW(js::validate(aluminium_like, 1e12));
  for (const js::Plasticity& bad :
       {js::Plasticity{0.0, 0.5, 0.7, 160}, js::Plasticity{-1e9, 0.5, 0.7, 160}, js::Plasticity{1e9, 0.0, 0.7, 160},
        js::Plasticity{1e9, 0.5, 0.0, 160}, js::Plasticity{1e9, 0.5, 0.3, 160}, js::Plasticity{1e9, 0.5, 0.7, 2.0},
        js::Plasticity{nan, 0.5, 0.7, 160}, js::Plasticity{1e9, nan, 0.7, 160}, js::Plasticity{1e9, 0.5, nan, 160},
        js::Plasticity{1e9, 0.5, 0.7, nan}, js::Plasticity{1e9, 0.3, 1.0, 10.0}})
    REQUIRE_THROWS_AS(js::validate(bad, 10.0), osculate::InputError);
  REQUIRE_THROWS_AS(js::validate(aluminium_like, nan), osculate::InputError);
  js::Memory memory{nan};
  REQUIRE_THROWS_AS(js::contact(R_i, R_j, modulus, aluminium_like, 1e-6, memory), osculate::InputError);
  memory = {};
  REQUIRE_THROWS_AS(js::contact(R_i, R_j, modulus, aluminium_like, nan, memory), osculate::InputError);
  REQUIRE_THROWS_AS(js::contact(R_i, R_j, 0.0, aluminium_like, 1e-6, memory), osculate::InputError);
}
