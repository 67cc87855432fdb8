#include <catch2/catch.hpp>

#include "contact_checks.hpp"
#include "osculate/geometry/curvature.hpp"

using namespace osculate;
using checks::Body;

namespace {

std::vector<Shape> of_one_size() {
  return {Sphere{0.01},
          Ellipsoid{Vec3(0.02, 0.01, 0.015)},
          Superquadric{Vec3(0.01, 0.012, 0.02), {6.0, 4.0}},
          Superquadric{Vec3(0.01, 0.012, 0.02), {1.5, 1.7}},
          samples::potential_cube(0.01, 0.01, 0.002, 0.02),
          samples::potential_tetrahedron(0.01, 0.05, 0.003, 0.03),
          samples::potential_stone()};
}

}  // namespace

TEST_CASE("A potential particle of sphericity 1 is a sphere") {
  std::mt19937 random(1);
  const PotentialParticle round = samples::potential_cube(0.01, 1.0, 0.001, 0.02);
  for (const Shape& other : of_one_size()) {
    const Pose pose{Vec3::Zero(), checks::random_orientation(random)};
    Body b{other, {0.04 * samples::random_direction(random), checks::random_orientation(random)}};
    checks::bring_together({round, pose}, b, 1e-4);
    const ContactGeometry c = checks::contact_of({round, pose}, b);
    const ContactGeometry of_sphere = checks::contact_of({Sphere{0.02}, pose}, b);
    CHECK(c.overlap == Approx(of_sphere.overlap).margin(1e-14 * 0.02));
    CHECK((c.normal - of_sphere.normal).norm() < 1e-10);
    CHECK((c.on_2 - of_sphere.on_2).norm() < 1e-10 * 0.02);
    CHECK(c.curvature_1.max == Approx(50.0).epsilon(1e-12));
    CHECK(c.relative.R_i == Approx(of_sphere.relative.R_i).epsilon(1e-8));
    CHECK(c.relative.R_j == Approx(of_sphere.relative.R_j).epsilon(1e-8));
  }
}

TEST_CASE("No direction separates better than the common normal of potential particles") {
  std::mt19937 random(2);
  const auto shapes = of_one_size();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = std::max<std::size_t>(i, 4); j < shapes.size(); ++j) {
      for (const double overlap : {2e-4, 4e-3}) {  // 1 % and a fifth of the body
        const Body a{shapes[i], {Vec3(0.1, 0.2, 0.3), checks::random_orientation(random)}};
        Body b{shapes[j],
               {a.pose.position + 0.05 * samples::random_direction(random), checks::random_orientation(random)}};
        checks::bring_together(a, b, overlap);
        const ContactGeometry c = checks::contact_of(a, b);
        REQUIRE(is_resolved(c.status));
        // Random steps of 1e-9 rad leave an error of their square; supports are exact to some 1e-15.
        CHECK(c.overlap == Approx(checks::brute_force_overlap(a, b, c.normal, random)).margin(1e-12 * 0.02));
        if (c.status == ContactStatus::ambiguous) continue;
        CHECK((c.on_1 - c.on_2 - c.overlap * c.normal).norm() < 1e-9 * 0.02);
        CHECK((checks::support_w(a, c.normal) - c.on_1).dot(c.normal) == Approx(0.0).margin(1e-13 * 0.02));
      }
    }
  }
}

TEST_CASE("Curvatures at a contact are the rates at which the gauge's normal turns") {
  std::mt19937 random(3);
  for (const Shape& shape :
       {Shape(samples::potential_stone()), Shape(samples::potential_cube(0.01, 0.3, 0.005, 0.02))}) {
    for (int i = 0; i < 5; ++i) {
      const Body a{shape, {Vec3(0.1, 0.2, 0.3), checks::random_orientation(random)}};
      Body b{Sphere{0.004}, {a.pose.position + 0.05 * samples::random_direction(random), Quat::Identity()}};
      checks::bring_together(a, b, 1e-5);
      const ContactGeometry c = checks::contact_of(a, b);
      const Vec3 t = c.curvature_1.max_direction, s = c.normal.cross(t);
      CHECK(std::fabs(t.dot(c.normal)) < 1e-12);
      const auto normal_at = [&](const Vec3& x) -> Vec3 {
        return a.pose.rotate_to_world(gauge(shape, a.pose.to_body(x)).gradient.normalized());
      };
      constexpr double step = 1e-8;
      const auto rate = [&](const Vec3& along) -> Vec3 {
        return (normal_at(c.on_1 + step * along) - normal_at(c.on_1 - step * along)) / (2.0 * step);
      };
      // Central differences: round-off 1e-16/1e-8 of a curvature of order 100, and Hessians that jump at planes nearby.
      CHECK(rate(t).dot(t) == Approx(c.curvature_1.max).epsilon(1e-4));
      CHECK(rate(s).dot(s) == Approx(c.curvature_1.min).epsilon(1e-4).margin(1e-3));
      CHECK(rate(t).dot(s) == Approx(0.0).margin(1e-4 * c.curvature_1.max));
    }
  }
}

TEST_CASE("Two potential cubes face to face touch in the middle of their faces") {
  const PotentialParticle cube = samples::potential_cube(0.01, 0.01, 0.002, 0.02);
  const double half = support_point(cube, Vec3::UnitX()).x();
  const ContactGeometry c = checks::contact_of({cube, {}}, {cube, {Vec3(1.99 * half, 0.0, 0.0), Quat::Identity()}});
  CHECK(c.status == ContactStatus::touching);
  CHECK(c.overlap == Approx(0.01 * half).epsilon(1e-12));
  CHECK((c.normal - Vec3::UnitX()).norm() < 1e-12);
  CHECK(c.point().tail<2>().norm() < 1e-10 * half);
}

TEST_CASE("A cube in the middle of another has six ways out") {
  const PotentialParticle cube = samples::potential_cube(0.01, 0.01, 0.002, 0.02);
  const double half = support_point(cube, Vec3::UnitX()).x();
  const ContactGeometry c = checks::contact_of({cube, {}}, {cube, {}});
  CHECK(c.status == ContactStatus::ambiguous);
  CHECK(c.overlap == Approx(2.0 * half).epsilon(1e-12));
}
