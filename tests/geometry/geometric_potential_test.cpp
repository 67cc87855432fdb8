#include "osculate/geometry/geometric_potential.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "osculate/core/error.hpp"

using namespace osculate;

namespace {

/// Γ of [KDY23 (15)], written out: the library's gauge is not asked.
double gamma_of(const Superquadric& shape, const Pose& pose, const Vec3& x_w) {
  const Vec3 x = pose.to_body(x_w).cwiseQuotient(shape.half_axes).cwiseAbs();
  const auto [n1, n2] = shape.exponents;
  return std::pow(std::pow(x.x(), n2) + std::pow(x.y(), n2), n1 / n2) + std::pow(x.z(), n1) - 1.0;
}

struct Pair {
  Superquadric shape_1;
  Pose pose_1;
  Superquadric shape_2;
  Pose pose_2;
};

std::vector<Pair> sample_pairs() {
  const Quat tilted = Quat(0.9, 0.2, -0.3, 0.1).normalized(), turned = Quat(0.4, -0.5, 0.6, 0.3).normalized();
  const Superquadric ellipsoid{{1, 2, 3}, {2, 2}}, box{{1, 1.5, 2}, {6, 6}}, blocky{{2, 1, 1}, {4, 3.3}},
      sharp{{1, 1.2, 0.8}, {1.5, 1.3}}, cylinder{{1, 1, 1.5}, {8, 2}};
  const Vec3 somewhere(-7, 5, 3);
  return {{ellipsoid, {somewhere, tilted}, ellipsoid, {somewhere + Vec3(1.8, 1.1, 1.2), turned}},
          {box, {somewhere, tilted}, blocky, {somewhere + Vec3(1.4, -0.9, 1.3), turned}},
          {cylinder, {somewhere, turned}, ellipsoid, {somewhere + Vec3(-1.5, 0.5, 1.8), tilted}},
          {sharp, {somewhere, tilted}, blocky, {somewhere + Vec3(0.4, 0.5, -1.1), turned}}};
}

GeometricPotentialContact contact_of(const Pair& pair) {
  return geometric_potential(pair.shape_1, pair.pose_1, pair.shape_2, pair.pose_2);
}

}  // namespace

TEST_CASE("The midway point of two spheres divides the centre line by their radii") {
  const Vec3 centre_1(0.1, -0.2, 0.3), apart(0.9, 1.2, -0.8);
  const auto contact =
      geometric_potential(Sphere{1.0}, {.position = centre_1}, Sphere{0.8}, {.position = centre_1 + apart});
  const double distance = apart.norm();
  CHECK(contact.status == ContactStatus::touching);
  CHECK(contact.overlap == Approx(1.8 - distance).epsilon(1e-13));
  CHECK((contact.normal - apart / distance).norm() < 1e-12);
  CHECK((contact.point - (centre_1 + apart / 1.8)).norm() < 1e-12);
  CHECK(contact.potential == Approx(std::pow(distance / 1.8, 2) - 1.0).epsilon(1e-12));
  // Level surfaces through the point, not the spheres themselves.
  CHECK(contact.curvature_1.max == Approx(1.8 / distance).epsilon(1e-12));
  CHECK(contact.curvature_2.min == Approx(1.8 / (0.8 * distance)).epsilon(1e-12));
  CHECK(contact.relative.R_i == Approx(distance / 1.8 / (1.0 + 1.0 / 0.8)).epsilon(1e-12));
}

TEST_CASE("At the midway point both potentials are equal and nowhere is the larger of them smaller") {
  for (const Pair& pair : sample_pairs()) {
    const auto contact = contact_of(pair);
    REQUIRE(contact.status == ContactStatus::touching);
    const double here_1 = gamma_of(pair.shape_1, pair.pose_1, contact.point);
    const double here_2 = gamma_of(pair.shape_2, pair.pose_2, contact.point);
    CHECK(here_1 == Approx(contact.potential).margin(1e-11));
    CHECK(here_2 == Approx(contact.potential).margin(1e-11));
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 300; ++i) {
      const double reach = std::pow(10.0, -1.0 - i % 4);
      const Vec3 x = contact.point + reach * Vec3(normal(random), normal(random), normal(random));
      const double larger = std::max(gamma_of(pair.shape_1, pair.pose_1, x), gamma_of(pair.shape_2, pair.pose_2, x));
      CHECK(larger > contact.potential - 1e-12);
    }
  }
}

TEST_CASE("The normal is that of both level surfaces, and the line along it meets both bodies") {
  for (const Pair& pair : sample_pairs()) {
    const auto contact = contact_of(pair);
    constexpr double step = 1e-7;  // central differences: rounding 1e-9, and step² of third derivatives to 1e6
    Vec3 slope_1, slope_2;
    for (int k = 0; k < 3; ++k) {
      const Vec3 aside = step * Vec3::Unit(k);
      slope_1[k] = gamma_of(pair.shape_1, pair.pose_1, contact.point + aside) -
                   gamma_of(pair.shape_1, pair.pose_1, contact.point - aside);
      slope_2[k] = gamma_of(pair.shape_2, pair.pose_2, contact.point + aside) -
                   gamma_of(pair.shape_2, pair.pose_2, contact.point - aside);
    }
    CHECK((slope_1.normalized() - contact.normal).norm() < 1e-7);
    CHECK((slope_2.normalized() + contact.normal).norm() < 1e-7);
    CHECK(std::fabs(gamma_of(pair.shape_1, pair.pose_1, contact.on_1)) < 1e-12);
    CHECK(std::fabs(gamma_of(pair.shape_2, pair.pose_2, contact.on_2)) < 1e-12);
    CHECK(contact.overlap == Approx((contact.on_1 - contact.on_2).dot(contact.normal)).epsilon(1e-12));
    CHECK((contact.on_1 - contact.point).cross(contact.normal).norm() < 1e-12);
  }
}

TEST_CASE("Exchanged bodies have the same midway point") {
  for (const Pair& pair : sample_pairs()) {
    const auto contact = contact_of(pair);
    const auto swapped = contact_of({pair.shape_2, pair.pose_2, pair.shape_1, pair.pose_1});
    CHECK((contact.point - swapped.point).norm() < 1e-11);
    CHECK((contact.normal + swapped.normal).norm() < 1e-10);
    CHECK(contact.overlap == Approx(swapped.overlap).epsilon(1e-10));
  }
}

TEST_CASE("The sign of the potential tells touching bodies from separated ones") {
  const Ellipsoid rod{{1, 1, 4}};
  const Quat flat = Quat(std::sqrt(0.5), std::sqrt(0.5), 0, 0);  // its long axis along y
  const auto at = [&](double gap) { return geometric_potential(rod, {}, rod, {{0, 0, 5.0 + gap}, flat}); };
  CHECK(at(-1e-9).status == ContactStatus::touching);
  CHECK(at(-1e-9).overlap == Approx(1e-9).epsilon(1e-5));  // positions carry 1e-15
  CHECK(at(1e-9).status == ContactStatus::separated);
  CHECK(at(1e-9).overlap == Approx(-1e-9).epsilon(1e-5));
  CHECK(at(100.0).status == ContactStatus::separated);
}

TEST_CASE("A potential particle of sphericity one is its sphere") {
  const PotentialParticle round{.planes = {{Vec3::UnitX(), 0.3},
                                           {-Vec3::UnitX(), 0.3},
                                           {Vec3::UnitY(), 0.3},
                                           {-Vec3::UnitY(), 0.3},
                                           {Vec3::UnitZ(), 0.3},
                                           {-Vec3::UnitZ(), 0.3}},
                                .sphericity = 1.0,
                                .edge_radius = 0.1,
                                .sphere_radius = 0.5};
  const Pose pose_2{{0.5, 0.6, 0.4}, Quat(0.5, 0.5, 0.5, 0.5)};
  const auto potential = geometric_potential(round, {}, Ellipsoid{{0.3, 0.4, 0.7}}, pose_2);
  const auto sphere = geometric_potential(Sphere{0.5}, {}, Ellipsoid{{0.3, 0.4, 0.7}}, pose_2);
  CHECK((potential.point - sphere.point).norm() < 1e-10);
  CHECK(potential.overlap == Approx(sphere.overlap).epsilon(1e-9));
}

TEST_CASE("Without a normal the midway contact is degenerate, and walls are refused") {
  CHECK(geometric_potential(Sphere{1.0}, {}, Sphere{0.5}, {}).status == ContactStatus::degenerate);
  CHECK_THROWS_AS(geometric_potential(Sphere{1.0}, {}, HalfSpace{}, {}), InputError);
}
