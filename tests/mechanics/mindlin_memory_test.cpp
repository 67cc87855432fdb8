#include "osculate/mechanics/mindlin_memory.hpp"

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "osculate/core/error.hpp"

namespace mindlin = osculate::mindlin;
using mindlin::Planar;
using osculate::Quat;
using osculate::Vec3;

namespace {

constexpr double k = 3e9, friction = 0.35, kappa = 1.21, depth = 2e-6;

/// A contact driven along one axis by a path in (F_n, F_t) is driven in (δ, u) here.
struct OneAxis {
  mindlin::Springs springs;
  double place = 0.0;  ///< u/κ

  void go(double overlap, double displacement) {
    mindlin::advance(springs, overlap, {displacement / kappa - place, 0.0}, friction);
    place = displacement / kappa;
  }
  double force() const { return k * mindlin::traction(springs).x; }
};

double normal_force(double overlap) {
  return k * std::pow(overlap, 1.5);
}
double overlap_of(double force) {
  return std::pow(force / k, 2.0 / 3.0);
}
/// The closed forms' view of the same contact: C = κ dδ/dF_n.
mindlin::Contact contact_at(double overlap) {
  return mindlin::contact(kappa / (1.5 * k * std::sqrt(overlap)), friction, normal_force(overlap));
}

/// Forces of the general law against those of a closed form δ(F_t): the law is driven by the closed form's
/// displacement.
constexpr double special_paths = 1e-8;
constexpr int steps = 200;

/// Of a rising function, by bisection and then, where that is nearer, the secant.
double find_root(const std::function<double(double)>& f, double low, double high) {
  double f_low = f(low), f_high = f(high);
  REQUIRE((f_low < 0.0 && f_high > 0.0));
  for (int i = 0; i < 200 && high - low > 1e-15 * (std::fabs(low) + std::fabs(high)); ++i) {
    const double secant = low - f_low * (high - low) / (f_high - f_low);
    const double middle = i % 2 == 0 && secant > low && secant < high ? secant : 0.5 * (low + high);
    const double value = f(middle);
    if (value == 0.0) return middle;
    (value < 0.0 ? low : high) = middle;
    (value < 0.0 ? f_low : f_high) = value;
  }
  return 0.5 * (low + high);
}

double random_sign(std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
}

}  // namespace

TEST_CASE("The general law follows virgin loading, unloading and reloading at constant normal force") {
  const auto held = contact_at(depth);
  const double peak = 0.85 * held.limit;
  OneAxis law;
  law.go(depth, 0.0);
  for (int i = 1; i <= steps; ++i) {
    const double f = peak * i / steps;
    law.go(depth, mindlin::displacement(held, f));
    REQUIRE(law.force() == Approx(f).epsilon(special_paths));
  }
  for (int i = steps; i >= -steps; --i) {
    const double f = peak * i / steps;
    law.go(depth, mindlin::unloading_displacement(held, f, peak));
    REQUIRE(law.force() == Approx(f).epsilon(special_paths).margin(special_paths * peak));
  }
  for (int i = -steps; i <= steps; ++i) {
    const double f = peak * i / steps;
    law.go(depth, mindlin::reloading_displacement(held, f, peak));
    REQUIRE(law.force() == Approx(f).epsilon(special_paths).margin(special_paths * peak));
  }
  law.go(depth, 1.5 * mindlin::sliding_displacement(held));
  REQUIRE(law.force() == Approx(held.limit).epsilon(1e-14));
}

TEST_CASE("The general law follows oblique loading, unloading and reloading") {
  const auto held = contact_at(depth);
  for (const double theta : {0.0, 0.2, 0.7, 1.0, 1.8}) {
    CAPTURE(theta);
    const auto slanted = mindlin::oblique(held, theta);
    const double peak = 0.5 * held.limit;
    OneAxis law;
    law.go(depth, 0.0);
    const auto follow = [&](double f, double displacement) {
      law.go(overlap_of(slanted.at(f).limit / friction), displacement);
      REQUIRE(law.force() == Approx(f).epsilon(special_paths).margin(special_paths * peak));
    };
    for (int i = 1; i <= steps; ++i) follow(peak * i / steps, mindlin::oblique_displacement(slanted, peak * i / steps));
    if (theta * 0.5 + 0.5 >= 1.0) continue;  // the other side of the cycle would slide or open
    for (int i = steps; i >= -steps; --i)
      follow(peak * i / steps, mindlin::oblique_unloading_displacement(slanted, peak * i / steps, peak));
    for (int i = -steps; i <= steps; ++i)
      follow(peak * i / steps, mindlin::oblique_reloading_displacement(slanted, peak * i / steps, peak));
  }
}

TEST_CASE("The energy lost in cycles of the general law is that of the closed forms") {
  const auto held = contact_at(depth);
  constexpr std::size_t nodes = 24;  // δ is smooth in F_t along a leg of the cycle
  gsl_integration_glfixed_table* gauss = gsl_integration_glfixed_table_alloc(nodes);
  for (const double theta : {0.0, 0.4}) {
    CAPTURE(theta);
    const auto slanted = mindlin::oblique(held, theta);
    const double peak = 0.6 * held.limit;
    OneAxis law;
    law.go(depth, 0.0);
    // On to the force f of the load's line. The force rises with the displacement: between two places that hold it.
    const auto follow = [&](double f) {
      const double overlap = overlap_of(slanted.at(f).limit / friction), reach = mindlin::sliding_displacement(held);
      const auto missing = [&](double displacement) {
        OneAxis probe = law;
        probe.go(overlap, displacement);
        return probe.force() - f;
      };
      const double place = find_root(missing, -reach, reach);
      law.go(overlap, place);
      return place;
    };
    // ∫ F dδ from one force to another, by parts.
    const auto work = [&](double from, double start, double to) {
      double sum = 0.0;
      for (std::size_t k = 0; k < nodes; ++k) {
        double force = 0.0, weight = 0.0;
        const std::size_t next = from < to ? k : nodes - 1 - k;
        gsl_integration_glfixed_point(std::min(from, to), std::max(from, to), next, &force, &weight, gauss);
        sum += (from < to ? weight : -weight) * follow(force);
      }
      return to * follow(to) - from * start - sum;
    };
    follow(peak);
    const double foot = follow(-peak);
    const double up = work(-peak, foot, peak);
    const double top = law.place * kappa;
    const double lost = up + work(peak, top, -peak);
    CHECK(law.place * kappa == Approx(foot).epsilon(1e-9));
    CHECK(lost == Approx(mindlin::oblique_cycle_energy(slanted, peak)).epsilon(special_paths));
  }
  gsl_integration_glfixed_table_free(gauss);
}

TEST_CASE("A cycle that comes back to its peak, or a little short of it or beyond, is at the virgin curve") {
  const auto held = contact_at(depth);
  const double peak = 0.6 * held.limit, top = mindlin::displacement(held, peak);
  OneAxis before;
  before.go(depth, 0.0);
  before.go(depth, top);
  before.go(depth, -top);
  before.go(depth, mindlin::reloading_displacement(held, 0.99 * peak, peak));
  // The front of slip comes as near to the virgin one as rounding tells apart, and nearer.
  for (double apart = 1e-7; apart > 1e-17; apart *= 0.97)
    for (const double sign : {-1.0, 1.0}) {
      OneAxis law = before;
      const double place = top * (1.0 + sign * apart);
      law.go(depth, place);
      REQUIRE(law.force() == Approx(mindlin::force(held, place)).epsilon(special_paths));
    }
}

TEST_CASE("Normal unloading under a held tangential displacement slides from the rim, and opening forgets") {
  OneAxis law;
  law.go(depth, 0.0);
  const double moved = 0.5 * mindlin::sliding_displacement(contact_at(depth));
  law.go(depth, moved);
  // Jäger: F_t = μ[F_n(δ) − F_n(δ − u/(κμ))], here with the smaller δ once the slip has passed the old front.
  const double less = 0.6 * depth;
  law.go(less, moved);
  CHECK(law.force() ==
        Approx(friction * (normal_force(less) - normal_force(less - moved / (kappa * friction)))).epsilon(1e-13));
  law.go(0.0, moved);
  CHECK(law.force() == 0.0);
  law.go(depth, moved);
  CHECK(law.force() == 0.0);
}

TEST_CASE("Loading that sticks is reversible") {
  OneAxis law;
  // du/dδ < κμ all the way: the slope of the memory is that of the path, whatever its steps.
  const double slope = 0.6 * kappa * friction;
  for (int i = 1; i <= 50; ++i) law.go(depth * i / 50, slope * depth * i / 50);
  CHECK(law.springs.count == 1);  // one straight line
  CHECK(law.force() == Approx(0.6 * friction * normal_force(depth)).epsilon(1e-13));
  for (int i = 50; i > 10; --i) law.go(depth * i / 50, slope * depth * i / 50);
  CHECK(law.force() == Approx(0.6 * friction * normal_force(0.22 * depth)).epsilon(1e-12));
}

TEST_CASE("An infinitesimal displacement meets the no-slip compliance, on both axes") {
  const mindlin::Axes ratio{.major = 1.3, .minor = 1.1};
  mindlin::Memory memory{};
  const auto law = mindlin::law(k, ratio, friction);
  const Vec3 normal = Vec3::UnitZ(), major = Vec3(1, 1, 0).normalized(), minor = normal.cross(major);
  mindlin::advance(memory, law, {normal, major, depth, Vec3::Zero(), 0.0});
  const double tiny = 1e-9 * depth, stiffness = 1.5 * k * std::sqrt(depth);
  const Vec3 force = mindlin::advance(memory, law, {normal, major, depth, tiny * (major + 2.0 * minor), 0.0});
  // Slip eats a relative 1e-9/(μ·…) of the stiffness.
  CHECK(force.dot(major) == Approx(tiny * stiffness / ratio.major).epsilon(1e-7).margin(0));
  CHECK(force.dot(minor) == Approx(2.0 * tiny * stiffness / ratio.minor).epsilon(1e-7).margin(0));
}

TEST_CASE("On any path friction bounds the force and no energy comes out of nothing") {
  std::mt19937_64 random(11);
  const mindlin::Axes ratio{.major = 1.35, .minor = 1.12};
  const int paths = 100000, length = 40;
  double worst = 0.0, work_scale = friction * normal_force(depth) * friction * depth;
  std::size_t over_limit = 0, not_finite = 0;
  for (int path = 0; path < paths; ++path) {
    mindlin::Springs springs;
    double overlap = depth * std::fabs(random_sign(random)), lost = 0.0, energy = 0.0;
    const double step = std::pow(10.0, -1.5 + 1.5 * random_sign(random)), persistence = path % 3 == 0 ? 0.95 : 0.0;
    double drift_x = 0.0, drift_y = 0.0;
    mindlin::advance(springs, overlap, {0.0, 0.0}, friction);
    for (int i = 0; i < length; ++i) {
      overlap = std::fmax(overlap + step * depth * random_sign(random), path % 5 == 0 ? -1.0 : 1e-3 * depth);
      drift_x = persistence * drift_x + step * friction * depth * random_sign(random);
      drift_y = persistence * drift_y + step * friction * depth * random_sign(random);
      mindlin::advance(springs, overlap, {drift_x, drift_y}, friction);
      const Planar force = mindlin::traction(springs);
      const double size = k * std::hypot(force.x, force.y);
      not_finite += std::isfinite(size) ? 0 : 1;
      over_limit += size > friction * normal_force(std::fmax(overlap, 0.0)) * (1.0 + 1e-14) ? 1 : 0;
      const double now = mindlin::stored_energy(springs, k, ratio);
      lost += k * (force.x * ratio.major * drift_x + force.y * ratio.minor * drift_y) - (now - energy);
      energy = now;
      worst = std::fmin(worst, lost / work_scale);
    }
  }
  CHECK(not_finite == 0);
  CHECK(over_limit == 0);
  CHECK(worst > -1e-12);
}

TEST_CASE("Turning the whole contact turns the force, whatever the path") {
  std::mt19937_64 random(5);
  const auto law = mindlin::law(k, {.major = 1.3, .minor = 1.1}, friction);
  for (int path = 0; path < 200; ++path) {
    mindlin::Memory fixed{}, turned{};
    Quat orientation = Quat::Identity();
    double overlap = depth;
    for (int i = 0; i < 30; ++i) {
      const Vec3 normal = Vec3(0.1 * i, 0.3, 1.0).normalized();
      const Vec3 major = normal.cross(Vec3::UnitX()).normalized();
      overlap *= 1.0 + 0.2 * random_sign(random);
      const Vec3 moved = friction * depth * Vec3(random_sign(random), random_sign(random), random_sign(random));
      // The same motion seen in a frame that turns by a large angle each step.
      const Quat turn(Eigen::AngleAxisd(0.9 * random_sign(random),
                                        Vec3(random_sign(random), random_sign(random), 0.2).normalized()));
      const Vec3 old_normal = i == 0 ? normal : Vec3(0.1 * (i - 1), 0.3, 1.0).normalized();
      const Vec3 old_turned = orientation * old_normal;
      const double own_spin = 0.1;
      // What turns the plane of the second: its own spin, in the turned frame, and the frame's turn.
      const Quat roll = Quat::FromTwoVectors(old_normal, normal);
      const Quat own = Quat(Eigen::AngleAxisd(own_spin, normal)) * roll;
      orientation = turn * orientation;
      const Quat seen = orientation * own * (turn.conjugate() * orientation).conjugate();
      const Vec3 force = mindlin::advance(fixed, law, {normal, major, overlap, moved, own_spin});
      const Vec3 same = mindlin::advance(turned, law,
                                         {orientation * normal, orientation * major, overlap, orientation * moved,
                                          mindlin::spin_of(seen, old_turned)});
      REQUIRE((same - orientation * force).norm() <= 1e-9 * friction * normal_force(2 * depth));
    }
  }
}

TEST_CASE("A path mirrored or turned in the plane of a circular contact mirrors and turns the force") {
  std::mt19937_64 random(3);
  const double c = std::cos(1.1), s = std::sin(1.1);
  mindlin::Springs one, other;
  double overlap = depth, worst = 0.0;
  for (int i = 0; i < 300; ++i) {
    overlap *= 1.0 + 0.1 * random_sign(random);
    const Planar shift{0.3 * friction * depth * random_sign(random), 0.3 * friction * depth * random_sign(random)};
    mindlin::advance(one, overlap, shift, friction);
    mindlin::advance(other, overlap, {c * shift.x + s * shift.y, s * shift.x - c * shift.y}, friction);
    const Planar a = mindlin::traction(one), b = mindlin::traction(other);
    worst = std::fmax(
        worst, std::hypot(b.x - c * a.x - s * a.y, b.y - s * a.x + c * a.y) / (friction * std::pow(overlap, 1.5)));
  }
  // Which point is forgotten depends on the axes: a bounded memory's own error.
  CHECK(worst < 0.05);
}

TEST_CASE("The polyline stands for many springs: two-component paths agree with thousands of them") {
  // Independent of the polyline: 4000 springs, each its own radial return.
  const int n = 4000;
  for (const bool loading : {false, true}) {
    std::vector<Planar> deflection(n, {0.0, 0.0});
    mindlin::Springs springs;
    double overlap = depth, last = 0.0;
    mindlin::advance(springs, overlap, {0.0, 0.0}, friction);
    const double radius = 0.5 * friction * depth;
    double worst = 0.0;
    for (int i = 1; i <= 400; ++i) {
      const double angle = 2.0 * M_PI * i / 400;
      const Planar shift{radius * (std::cos(angle) - std::cos(last)), radius * (std::sin(angle) - std::sin(last))};
      last = angle;
      if (loading) overlap = depth * (1.0 + 0.3 * std::sin(2.0 * angle));
      Planar sum{0.0, 0.0};
      const double finest = 1.4 * depth / n;
      for (int j = 0; j < n; ++j) {
        const double eta = (j + 0.5) * finest;
        auto& d = deflection[static_cast<std::size_t>(j)];
        if (eta >= overlap) {
          d = {0.0, 0.0};
          continue;
        }
        d.x += shift.x, d.y += shift.y;
        const double limit = friction * (overlap - eta), size = std::hypot(d.x, d.y);
        if (size > limit) d.x *= limit / size, d.y *= limit / size;
        const double weight = 1.5 * (std::sqrt(eta + 0.5 * finest) - std::sqrt(eta - 0.5 * finest));
        sum.x += weight * d.x, sum.y += weight * d.y;
      }
      mindlin::advance(springs, overlap, shift, friction);
      const Planar force = mindlin::traction(springs);
      worst = std::fmax(worst, std::hypot(force.x - sum.x, force.y - sum.y) / (friction * std::pow(overlap, 1.5)));
    }
    INFO("loading " << loading << ", worst " << worst);
    CHECK(worst < 0.02);  // eight points for a curve: 0.9 % of μF_n
  }
}

TEST_CASE("A general law without sense is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(mindlin::law(-1.0, {1.0, 1.0}, 0.3), osculate::InputError);
  CHECK_THROWS_AS(mindlin::law(1.0, {0.0, 1.0}, 0.3), osculate::InputError);
  CHECK_THROWS_AS(mindlin::law(1.0, {1.0, nan}, 0.3), osculate::InputError);
  CHECK_THROWS_AS(mindlin::law(1.0, {1.0, 1.0}, -0.1), osculate::InputError);
  CHECK_THROWS_AS(mindlin::law(1.0, {1.0, 1.0}, nan), osculate::InputError);
  CHECK(mindlin::law(1.0, {1.0, 1.0}, 0.0).friction == 0.0);
}
