#include "osculate/mechanics/polygon_energy.hpp"

#include <gsl/gsl_integration.h>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "osculate/core/error.hpp"

namespace pe = osculate::polygon_energy;
using pe::Polygon;
using pe::Vec2;

namespace {

Polygon moved(const Polygon& polygon, const Vec2& shift, double angle, const Vec2& pivot = Vec2::Zero()) {
  const Eigen::Rotation2D<double> turn(angle);
  Polygon result;
  for (const Vec2& vertex : polygon) result.push_back(turn * (vertex - pivot) + pivot + shift);
  return result;
}

Polygon regular(int corners, double radius, double phase = 0.3) {
  Polygon result;
  for (int i = 0; i < corners; ++i)
    result.emplace_back(radius * std::cos(phase + 2 * M_PI * i / corners),
                        radius * std::sin(phase + 2 * M_PI * i / corners));
  return result;
}

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

/// Sutherland and Hodgman: `subject` cut by every edge of a convex `clip`. Nothing in common with the edge-pair sums.
double clipped_area(Polygon subject, const Polygon& clip) {
  for (std::size_t i = 0; i < clip.size(); ++i) {
    const Vec2 a = clip[i], b = clip[(i + 1) % clip.size()];
    const auto side = [&](const Vec2& p) {
      return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    };
    Polygon kept;
    for (std::size_t k = 0; k < subject.size(); ++k) {
      const Vec2 p = subject[k], q = subject[(k + 1) % subject.size()];
      const double at_p = side(p), at_q = side(q);
      if (at_p >= 0.0) kept.push_back(p);
      if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    subject = kept;
  }
  return area_of(subject);
}

/// A comb of three teeth on a bar, and the convex pieces that make it up.
const Polygon comb = {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
const std::vector<Polygon> comb_pieces = {{{0, 0}, {5, 0}, {5, 1}, {0, 1}},
                                          {{0, 1}, {1, 1}, {1, 3}, {0, 3}},
                                          {{2, 1}, {3, 1}, {3, 3}, {2, 3}},
                                          {{4, 1}, {5, 1}, {5, 3}, {4, 3}}};

double gauss(const std::function<double(double)>& f, double from, double to) {
  static const auto rule =
      std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)>(
          gsl_integration_glfixed_table_alloc(8), gsl_integration_glfixed_table_free);
  gsl_function integrand{[](double t, void* g) { return (*static_cast<const std::function<double(double)>*>(g))(t); },
                         const_cast<std::function<double(double)>*>(&f)};
  return gsl_integration_glfixed(&integrand, from, to, rule.get());
}

/// Gauss on panels that are halved until halving changes nothing.
double integrate(const std::function<double(double)>& f, double from, double to, int halvings) {
  const double middle = 0.5 * (from + to), left = gauss(f, from, middle), right = gauss(f, middle, to);
  if (halvings == 0 || std::fabs(gauss(f, from, to) - left - right) < 1e-16) return left + right;
  return integrate(f, from, middle, halvings - 1) + integrate(f, middle, to, halvings - 1);
}

pe::Overlap overlap_of(const Polygon& a, const Polygon& b, const Vec2& pivot = Vec2::Zero()) {
  return pe::overlap(a, b, pivot);
}

}  // namespace

TEST_CASE("Two squares overlap in a square") {
  const Polygon unit = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto common = overlap_of(unit, moved(unit, {0.75, 0.5}, 0.0));
  REQUIRE(common.area == Approx(0.125).epsilon(1e-15));
  REQUIRE(common.centroid.x() == Approx(0.875).epsilon(1e-15));
  REQUIRE(common.centroid.y() == Approx(0.75).epsilon(1e-15));
  // Moving body 2 by dx to the right loses a strip as high as the overlap.
  REQUIRE(common.gradient.x() == Approx(-0.5).epsilon(1e-15));
  REQUIRE(common.gradient.y() == Approx(-0.25).epsilon(1e-15));
}

TEST_CASE("The overlap of convex polygons is what clipping leaves") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int overlapping = 0;
  for (int i = 0; i < 2000; ++i) {
    const Polygon a = regular(3 + i % 7, 1.0, uniform(random));
    const Polygon b = moved(regular(3 + i % 5, 0.3 + 0.2 * uniform(random)),
                            Vec2(1.2 * uniform(random), 1.2 * uniform(random)), 3.0 * uniform(random));
    const double expected = clipped_area(b, a);
    CAPTURE(i);
    REQUIRE(overlap_of(a, b).area == Approx(expected).margin(1e-14));
    REQUIRE(overlap_of(b, a).area == Approx(expected).margin(1e-14));
    if (expected > 0.0) ++overlapping;
  }
  REQUIRE(overlapping > 500);
}

TEST_CASE("A non-convex body that is met in several regions counts them all") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Polygon bar = moved({{-4, -0.4}, {4, -0.4}, {4, 0.4}, {-4, 0.4}},
                              {2.5 + uniform(random), 2.0 + uniform(random)}, 0.5 * uniform(random));
    double expected = 0.0;
    for (const Polygon& piece : comb_pieces) expected += clipped_area(piece, bar);
    REQUIRE(overlap_of(comb, bar).area == Approx(expected).epsilon(1e-13).margin(1e-14));
  }
  // Upright: the bar crosses three teeth of width 1.
  REQUIRE(overlap_of(comb, {{-1, 2}, {6, 2}, {6, 2.5}, {-1, 2.5}}).area == Approx(1.5).epsilon(1e-15));
}

TEST_CASE("Aligned edges and shared vertices do not upset the area") {
  const Polygon unit = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  REQUIRE(overlap_of(unit, unit).area == Approx(1.0).epsilon(1e-15));
  REQUIRE(overlap_of(comb, comb).area == Approx(area_of(comb)).epsilon(1e-14));
  REQUIRE(overlap_of(unit, moved(unit, {1, 0}, 0.0)).area == 0.0);
  REQUIRE(overlap_of(unit, moved(unit, {0.5, 0}, 0.0)).area == Approx(0.5).epsilon(1e-15));
  REQUIRE(overlap_of(unit, moved(unit, {3, 0}, 0.0)).area == 0.0);
  const Polygon inside = {{0.2, 0.2}, {0.4, 0.2}, {0.3, 0.4}};
  REQUIRE(overlap_of(unit, inside).area == Approx(area_of(inside)).epsilon(1e-14));
  REQUIRE(overlap_of(unit, inside).gradient.norm() < 1e-15);
  // Turned by angles down to rounding, far from the origin: still the area of the comb, to the change of the turn.
  for (const double angle : {1e-16, 1e-14, 1e-12, 1e-9, 1e-6}) {
    const Polygon there = moved(comb, {100, -50}, 0.0), turned = moved(there, {0, 0}, angle, {102, -49});
    REQUIRE(overlap_of(there, turned).area == Approx(area_of(comb)).margin(50 * angle + 1e-12));
  }
}

TEST_CASE("Force and moment are the slopes of the energy") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const Vec2 centre_1(2.5, 1.5);
  const Polygon star = {{1, 0}, {0.3, 0.3}, {0, 1}, {-0.3, 0.3}, {-1, 0}, {-0.3, -0.3}, {0, -1}, {0.3, -0.3}};
  int touching = 0;
  for (const pe::EnergyFunction function :
       {pe::EnergyFunction{2e3}, pe::EnergyFunction{3e3, 1.5}, pe::EnergyFunction{3e3, 2.0}}) {
    for (int i = 0; i < 200; ++i) {
      const Vec2 centre_2(2.5 + 2.5 * uniform(random), 3.0 + uniform(random));
      const double angle = 3.0 * uniform(random);
      const auto energy = [&](const Vec2& shift, double turn) {
        return pe::contact(comb, centre_1, moved(star, centre_2 + shift, angle + turn), centre_2 + shift, function)
            .energy;
      };
      const auto contact = pe::contact(comb, centre_1, moved(star, centre_2, angle), centre_2, function);
      if (contact.area < 1e-3) continue;
      ++touching;
      const double step = 1e-6;
      CAPTURE(i, contact.area);
      // A is piecewise quadratic in the shift; a kink within the step costs step·A'', rounding 1e-16 W/step.
      const double tolerance = 1e-5 * function.slope(contact.area);
      REQUIRE(contact.force_on_2.x() ==
              Approx(-(energy({step, 0}, 0) - energy({-step, 0}, 0)) / (2 * step)).margin(tolerance));
      REQUIRE(contact.force_on_2.y() ==
              Approx(-(energy({0, step}, 0) - energy({0, -step}, 0)) / (2 * step)).margin(tolerance));
      REQUIRE(contact.moment_on_2 ==
              Approx(-(energy({0, 0}, step) - energy({0, 0}, -step)) / (2 * step)).margin(tolerance));
      // The moment on body 1 is that of a turn of body 1.
      const auto turned_1 = [&](double turn) {
        return pe::contact(moved(comb, {0, 0}, turn, centre_1), centre_1, moved(star, centre_2, angle), centre_2,
                           function)
            .energy;
      };
      REQUIRE(contact.moment_on_1 == Approx(-(turned_1(step) - turned_1(-step)) / (2 * step)).margin(4 * tolerance));
    }
  }
  REQUIRE(touching > 200);
}

TEST_CASE("The forces act along one line through the reference point") {
  const Polygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, wedge = {{0.2, 0.8}, {1.2, 1.6}, {-0.4, 1.5}};
  const Vec2 centre_1(0.5, 0.5), centre_2(0.3, 1.4);
  const auto contact = pe::contact(square, centre_1, wedge, centre_2, {.coefficient = 1e4});
  const auto moment_about = [&](const Vec2& centre) {
    const Vec2 arm = contact.reference_point - centre;
    return arm.x() * contact.force_on_2.y() - arm.y() * contact.force_on_2.x();
  };
  REQUIRE(moment_about(centre_2) == Approx(contact.moment_on_2).epsilon(1e-13));
  REQUIRE(-moment_about(centre_1) == Approx(contact.moment_on_1).epsilon(1e-13));
  // One region, boundaries crossing twice on the line y = 1: the force is k times that chord, upwards, at its middle.
  const double left = 0.2 - 0.6 / 0.7 * 0.2, right = 0.2 + 0.2 / 0.8;
  REQUIRE(contact.force_on_2.x() == Approx(0.0).margin(1e-11));
  REQUIRE(contact.force_on_2.y() == Approx(1e4 * (right - left)).epsilon(1e-13));
  REQUIRE(contact.reference_point.x() == Approx(0.5 * (left + right)).epsilon(1e-13));
}

TEST_CASE("Closed paths do no work") {
  // Body 2 runs round a loop in x, y and angle, in and out of several teeth; the work is integrated panel by panel.
  const Polygon bar = {{-2, -0.3}, {2, -0.3}, {2, 0.3}, {-2, 0.3}};
  const Vec2 centre_1(2.5, 1.5);
  for (const pe::EnergyFunction function : {pe::EnergyFunction{1.0}, pe::EnergyFunction{1.0, 2.0}}) {
    std::function<double(double)> power = [&](double t) {
      const Vec2 centre(2.5 + 1.3 * std::cos(t), 2.6 + 0.9 * std::sin(t));
      const Vec2 velocity(-1.3 * std::sin(t), 0.9 * std::cos(t));
      const double angle = 0.4 * std::sin(2 * t + 0.5), rate = 0.8 * std::cos(2 * t + 0.5);
      const auto contact = pe::contact(comb, centre_1, moved(bar, centre, angle), centre, function);
      return contact.force_on_2.dot(velocity) + contact.moment_on_2 * rate;
    };
    // The power has a kink wherever a vertex crosses an edge: halving closes in on each. A corner that dips in for a
    // moment only is seen because the panels are short to begin with.
    constexpr int panels = 4096;
    double work = 0.0, exchanged = 0.0;
    for (int i = 0; i < panels; ++i) {
      const double part = integrate(power, 2 * M_PI * i / panels, 2 * M_PI * (i + 1) / panels, 40);
      work += part, exchanged += std::fabs(part);
    }
    REQUIRE(exchanged > 1.0);
    REQUIRE(std::fabs(work) < 1e-12);
  }
}

TEST_CASE("Polygons and energies that make no sense are refused at set-up") {
  const double nan = std::nan("");
  REQUIRE_NOTHROW(pe::validate(comb));
  const Polygon bad[] = {{{0, 0}, {1, 0}},
                         {{0, 0}, {0, 1}, {1, 0}},
                         {{0, 0}, {2, 0}, {0, 2}, {2, 1.9}, {1, 5}},
                         {{0, 0}, {1, nan}, {0, 1}}};
  for (const Polygon& polygon : bad) REQUIRE_THROWS_AS(pe::validate(polygon), osculate::InputError);
  for (const pe::EnergyFunction function : {pe::EnergyFunction{0.0}, pe::EnergyFunction{-1.0}, pe::EnergyFunction{nan},
                                            pe::EnergyFunction{1.0, 0.5}, pe::EnergyFunction{1.0, nan}})
    REQUIRE_THROWS_AS(pe::validate(function), osculate::InputError);
}
