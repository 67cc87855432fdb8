#include "osculate/geometry/curvature.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "osculate/core/error.hpp"

using namespace osculate;

namespace {

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

Vec3 on_surface(const Shape& shape, const Vec3& ray) {
  return ray / gauge(shape, ray).value;
}

PotentialParticle potential_cube(double k) {
  PotentialParticle cube{{}, k, 0.003, 0.02};
  for (int axis = 0; axis < 3; ++axis) {
    cube.planes.push_back({Vec3::Unit(axis), 0.01});
    cube.planes.push_back({-Vec3::Unit(axis), 0.01});
  }
  return cube;
}

/// How fast the normal turns per length along a unit tangent: t · dn/ds, by central differences on the surface.
double normal_curvature(const Shape& shape, const Vec3& point, const Vec3& tangent, double step) {
  const Vec3 ahead = on_surface(shape, point + step * tangent), behind = on_surface(shape, point - step * tangent);
  const Vec3 turned = gauge(shape, ahead).gradient.normalized() - gauge(shape, behind).gradient.normalized();
  return tangent.dot(turned) / tangent.dot(ahead - behind);
}

/// Gaussian curvature of (x/a)^n + (y/b)^n + (z/c)^n = 1 for even n from the bordered Hessian, in long double:
/// K = Σ F_x² F_yy F_zz / |∇F|⁴ since the Hessian is diagonal.
double gaussian_of_even(const Vec3& a, int n, const Vec3& point) {
  long double g[3], h[3], square = 0.0L;
  for (int i = 0; i < 3; ++i) {
    const long double t = static_cast<long double>(point[i]) / a[i];
    g[i] = n * std::pow(t, n - 1) / a[i];
    h[i] = n * (n - 1) * std::pow(t, n - 2) / (static_cast<long double>(a[i]) * a[i]);
    square += g[i] * g[i];
  }
  const long double sum = g[0] * g[0] * h[1] * h[2] + g[1] * g[1] * h[2] * h[0] + g[2] * g[2] * h[0] * h[1];
  return static_cast<double>(sum / (square * square));
}

}  // namespace

TEST_CASE("A sphere has curvature 1/R everywhere, poles included") {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const PrincipalCurvatures k = principal_curvatures(Sphere{0.25}, 0.25 * random_direction(random));
    CHECK(k.max == Approx(4.0).epsilon(1e-13));
    CHECK(k.min == Approx(4.0).epsilon(1e-13));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const PrincipalCurvatures k = principal_curvatures(Sphere{0.25}, 0.25 * Vec3::Unit(axis));
    CHECK(k.max == Approx(4.0).epsilon(1e-14));
    CHECK(k.min == Approx(4.0).epsilon(1e-14));
    CHECK(std::fabs(k.max_direction.dot(Vec3::Unit(axis))) < 1e-15);
    CHECK(k.max_direction.norm() == Approx(1.0).epsilon(1e-15));
  }
}

TEST_CASE("An ellipsoid's vertex has curvatures c/a² and c/b²") {
  const double a = 3.0, b = 2.0, c = 1.0;
  const PrincipalCurvatures k = principal_curvatures(Ellipsoid{Vec3(a, b, c)}, Vec3(0, 0, c));
  CHECK(k.max == Approx(c / (b * b)).epsilon(1e-14));
  CHECK(k.min == Approx(c / (a * a)).epsilon(1e-14));
  CHECK(std::fabs(k.max_direction.y()) == Approx(1.0));
}

TEST_CASE("Principal curvatures are the extremes of the turning of the normal") {
  std::mt19937 random(2);
  const std::vector<Shape> shapes = {Superquadric{Vec3(1.0, 2.0, 3.0), {2.5, 2.5}},
                                     Superquadric{Vec3(1.0, 1.0, 0.5), {4.0, 6.0}},
                                     Superquadric{Vec3(1.0, 1.5, 1.0), {1.5, 1.8}},
                                     Superquadric{Vec3(0.01, 0.01, 0.02), {8.0, 2.0}},
                                     potential_cube(0.05),
                                     potential_cube(0.5)};
  for (const Shape& shape : shapes) {
    const double size = bounding_radius(shape);
    for (int i = 0; i < 100; ++i) {
      Vec3 ray = random_direction(random);
      ray += 0.3 * ray.cwiseSign();  // off the symmetry planes, where finite differences see the powers' kinks
      const Vec3 point = on_surface(shape, ray);
      const PrincipalCurvatures k = principal_curvatures(shape, point);
      const Vec3 normal = gauge(shape, point).gradient.normalized(), across = normal.cross(k.max_direction);
      CHECK(k.max >= k.min);
      CHECK(k.min >= 0.0);
      CHECK(std::fabs(k.max_direction.dot(normal)) < 1e-13);
      CHECK(k.max_direction.norm() == Approx(1.0).epsilon(1e-13));
      const double step = 1e-5 * size;
      const double along_max = normal_curvature(shape, point, k.max_direction, step);
      const double along_min = normal_curvature(shape, point, across, step);
      const bool across_a_kink =
          std::fabs(normal_curvature(shape, point, k.max_direction, 0.5 * step) - along_max) > 1e-5 * k.max ||
          std::fabs(normal_curvature(shape, point, across, 0.5 * step) - along_min) > 1e-5 * k.max;
      if (across_a_kink) continue;
      // Truncation (step/size)² times high derivatives, rounding 1e-16/step.
      CHECK(along_max == Approx(k.max).margin(1e-6 * k.max));
      CHECK(along_min == Approx(k.min).margin(1e-6 * k.max));
    }
  }
}

TEST_CASE("The smaller curvature keeps its digits beside a large one") {
  std::mt19937 random(3);
  for (const int n : {4, 8, 20}) {
    const Vec3 axes(1.0, 0.01, 100.0);
    const Superquadric shape{axes, {double(n), double(n)}};
    for (int i = 0; i < 200; ++i) {
      const Vec3 point = on_surface(shape, random_direction(random).cwiseProduct(axes));
      const PrincipalCurvatures k = principal_curvatures(shape, point);
      const double expected = gaussian_of_even(axes, n, point);
      if (expected < 1e-250) continue;
      // The point's own rounding, in 2n powers of small coordinates, and the projection on the tangent plane at aspect
      // ratio 1e4.
      CHECK(k.gaussian() == Approx(expected).epsilon(1e-10));
    }
  }
}

TEST_CASE("Faces are exactly flat for n > 2, rims sharp for n < 2") {
  const Superquadric boxy{Vec3(1, 2, 3), {2.01, 8.0}};
  for (int axis = 0; axis < 3; ++axis) {
    const PrincipalCurvatures k = principal_curvatures(boxy, boxy.half_axes[axis] * Vec3::Unit(axis));
    CHECK(k.max == 0.0);
    CHECK(k.min == 0.0);
    CHECK(k.max_direction.norm() == Approx(1.0));
  }
  const Superquadric cylinder{Vec3(1, 1, 3), {8.0, 2.0}};
  const PrincipalCurvatures side = principal_curvatures(cylinder, Vec3(1, 0, 0));
  CHECK(side.max == Approx(1.0).epsilon(1e-14));
  CHECK(side.min == 0.0);
  CHECK(std::fabs(side.max_direction.y()) == Approx(1.0));

  const Superquadric lens{Vec3(1, 1, 1), {1.5, 2.0}};
  const PrincipalCurvatures rim = principal_curvatures(lens, Vec3(0.6, 0.8, 0.0));
  CHECK(rim.max > 1e90);
  CHECK(std::isfinite(rim.max));
  CHECK(rim.min == Approx(1.0).epsilon(1e-12));  // the circle of the rim
  CHECK(std::fabs(rim.max_direction.z()) == Approx(1.0));
  const PrincipalCurvatures pole = principal_curvatures(lens, Vec3(0, 0, 1));
  CHECK(pole.min > 1e90);
  CHECK(std::isfinite(pole.max));
}

TEST_CASE("A potential cube's face has the curvature of the sphere's term alone") {
  const double k = 0.05, R = 0.02, r = 0.003, d = 0.01;
  const PotentialParticle cube = potential_cube(k);
  const Vec3 point = on_surface(cube, Vec3::UnitX());
  const double slope = 2.0 * (1.0 - k) * (point.x() - d) / (r * r) + 2.0 * k * point.x() / (R * R);
  const PrincipalCurvatures curvature = principal_curvatures(cube, point);
  CHECK(curvature.max == Approx(2.0 * k / (R * R) / slope).epsilon(1e-13));
  CHECK(curvature.min == Approx(curvature.max).epsilon(1e-13));
}

TEST_CASE("Walls are flat, round or hollow") {
  CHECK(principal_curvatures(HalfSpace{}, Vec3(1, 2, 0)).max == 0.0);
  const PrincipalCurvatures rod = principal_curvatures(Cylinder{2.0, Cylinder::Solid::inside}, Vec3(2, 0, 5));
  CHECK(rod.max == 0.5);
  CHECK(rod.min == 0.0);
  CHECK(std::fabs(rod.max_direction.y()) == 1.0);
  const PrincipalCurvatures drum = principal_curvatures(Cylinder{2.0, Cylinder::Solid::outside}, Vec3(2, 0, 5));
  CHECK(drum.max == 0.0);
  CHECK(drum.min == -0.5);
  CHECK(std::fabs(drum.max_direction.z()) == 1.0);
  CHECK(principal_curvatures(SphereContainer{2.0}, Vec3(0, 2, 0)).max == -0.5);
}

TEST_CASE("A particle's centre has no curvature") {
  CHECK_THROWS_AS(principal_curvatures(Sphere{1.0}, Vec3::Zero()), InputError);
  CHECK_THROWS_AS(principal_curvatures(Sphere{1.0}, Vec3::Constant(std::nan(""))), InputError);
}
