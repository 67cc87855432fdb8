#include "osculate/shapes/superquadric.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "osculate/core/error.hpp"
#include "shapes/radial_quadrature.hpp"
#include "shapes/sample_shapes.hpp"

using namespace osculate;

namespace {

/// Eq. (15) as it is printed.
double inside_outside(const Superquadric& s, const Vec3& x) {
  const auto [n1, n2] = s.exponents;
  const Vec3 t = x.cwiseQuotient(s.half_axes).cwiseAbs();
  return std::pow(std::pow(t.x(), n2) + std::pow(t.y(), n2), n1 / n2) + std::pow(t.z(), n1);
}

}  // namespace

TEST_CASE("A point over its gauge lies on the superquadric of eq. (15)") {
  std::mt19937 random(1);
  for (const Superquadric& shape : samples::superquadrics()) {
    const double largest_exponent = std::max(shape.exponents.n1, shape.exponents.n2);
    for (int i = 0; i < 200; ++i) {
      const Vec3 x = samples::random_direction(random).cwiseProduct(shape.half_axes) * 3.0;
      const Vec3 on_surface = x / gauge(shape, x).value;
      // Powers magnify the rounding of the ratio by the exponent.
      CHECK(std::fabs(inside_outside(shape, on_surface) - 1.0) < 20.0 * largest_exponent * 2.2e-16);
    }
  }
}

TEST_CASE("The gauge's derivatives are those of its value") {
  std::mt19937 random(2);
  for (const Superquadric& shape : samples::superquadrics()) {
    if (shape.exponents.n1 > 20.0) continue;  // finite differences lose too many digits
    for (int i = 0; i < 50; ++i) {
      Vec3 t = samples::random_direction(random);
      t = t + 0.2 * t.cwiseSign();  // off the symmetry planes, where high derivatives grow
      const Vec3 x = t.cwiseProduct(shape.half_axes);
      const Gauge at = gauge(shape, x);
      const double step = 1e-5;
      for (int axis = 0; axis < 3; ++axis) {
        const double h = step * shape.half_axes[axis];
        const Gauge plus = gauge(shape, x + h * Vec3::Unit(axis)), minus = gauge(shape, x - h * Vec3::Unit(axis));
        // Central differences: error of order step² times the third derivative, which grows with the exponent cubed.
        CHECK(std::fabs((plus.value - minus.value) / (2.0 * step) - at.gradient[axis] * shape.half_axes[axis]) < 1e-7);
        const Vec3 column = (plus.gradient - minus.gradient) / (2.0 * step);
        const Vec3 expected = at.hessian.col(axis) * shape.half_axes[axis];
        CHECK((column - expected).cwiseProduct(shape.half_axes).norm() < 1e-6);
      }
    }
  }
}

TEST_CASE("The support point has the wanted normal, and no surface point lies further out") {
  std::mt19937 random(3);
  for (const Superquadric& shape : samples::superquadrics()) {
    const double size = shape.half_axes.maxCoeff();
    std::vector<Vec3> surface;
    for (int i = 0; i < 200; ++i) {
      const Vec3 x = samples::random_direction(random).cwiseProduct(shape.half_axes);
      surface.push_back(x / gauge(shape, x).value);
    }
    for (int i = 0; i < 200; ++i) {
      const Vec3 u = samples::random_direction(random);
      const Support s = support(shape, u);
      CHECK(s.point == support_point(shape, u));
      CHECK(std::fabs(s.value - u.dot(s.point)) < 1e-14 * size);
      const Gauge g = gauge(shape, s.point);
      CHECK(std::fabs(g.value - 1.0) < 1e-14);
      // For n > 2 the normal is a power n − 1 of the point, for n < 2 the point a power 1/(n − 1) of the normal.
      CHECK((g.gradient.normalized() - u).norm() < 1e-13);
      for (const Vec3& x : surface) CHECK(u.dot(x) <= s.value * (1.0 + 1e-14));
    }
  }
}

TEST_CASE("Principal radii of the support function are the inverse of the gauge's curvatures") {
  std::mt19937 random(4);
  for (const Superquadric& shape : samples::superquadrics()) {
    if (shape.exponents.n1 > 20.0 || shape.exponents.n2 > 20.0) continue;  // curvatures beside radii of 1e15
    for (int i = 0; i < 50; ++i) {
      Vec3 u = samples::random_direction(random);
      u = (u + 0.3 * u.cwiseSign()).normalized();
      const Support s = support(shape, u);
      const Gauge g = gauge(shape, s.point);
      const Vec3 e1 = u.unitOrthogonal(), e2 = u.cross(e1);
      Eigen::Matrix<double, 3, 2> tangents;
      tangents << e1, e2;
      const Eigen::Matrix2d product = tangents.transpose() * s.hessian * tangents *
                                      (tangents.transpose() * g.hessian * tangents) / g.gradient.norm();
      CHECK((product - Eigen::Matrix2d::Identity()).norm() < 1e-8);  // condition numbers up to 1e7
    }
  }
}

TEST_CASE("Faces, rims and poles are exact on the symmetry planes") {
  const Superquadric boxy{Vec3(1.0, 2.0, 3.0), {2.05, 64.0}};
  CHECK(support_point(boxy, Vec3(0, 0, 1)) == Vec3(0, 0, 3));
  CHECK(support_point(boxy, Vec3(-1, 0, 0)) == Vec3(-1, 0, 0));
  CHECK(gauge(boxy, Vec3(0, 0, 3)).hessian.isZero(0.0));  // flat, although n1 is barely above 2
  CHECK(gauge(boxy, Vec3(0, 2, 0)).gradient == Vec3(0, 0.5, 0));
  CHECK(support(boxy, Vec3(0, 1, 0)).hessian(0, 0) > 1e90);  // stands for an infinite radius

  const Superquadric octahedral{Vec3(1.0, 1.0, 1.0), {1.05, 1.05}};
  CHECK(gauge(octahedral, Vec3(0, 1, 1)).gradient.x() == 0.0);
  CHECK(gauge(octahedral, Vec3(0, 1, 1)).hessian(0, 0) > 1e90);  // stands for an infinite curvature
  CHECK(gauge(octahedral, Vec3(0, 0, 0)).value == 0.0);
  CHECK(support_point(octahedral, Vec3(0, 0, 0)).isZero(0.0));
}

TEST_CASE("The bounding sphere holds every point of a superquadric and touches one") {
  std::mt19937 random(5);
  for (const Superquadric& shape : samples::superquadrics()) {
    const double radius = bounding_radius(shape);
    double furthest = 0.0;
    for (int start = 0; start < 20; ++start) {
      Vec3 x = support_point(shape, samples::random_direction(random));
      // x ← support point of x/|x| never comes nearer; from a rim or face it goes to a furthest point.
      for (int i = 0; i < 4000; ++i) x = support_point(shape, x.normalized());
      furthest = std::max(furthest, x.norm());
    }
    CHECK(furthest <= radius);
    CHECK(furthest > radius * (1.0 - 1e-12));
  }
}

TEST_CASE("Mass properties of a superquadric agree with quadrature over its gauge") {
  for (const Superquadric& shape : samples::superquadrics()) {
    if (shape.exponents.n1 < 2.0 || shape.exponents.n2 < 2.0) continue;  // rims: quadrature converges slowly, see below
    // In scaled coordinates, so that a needle is as easy as a ball.
    const Superquadric scaled{Vec3::Ones(), shape.exponents};
    const MassProperties exact = mass_properties(scaled);
    const MassProperties numeric = mass_properties_by_quadrature(
        [&](const Vec3& x) { return 1.0 / gauge(scaled, x).value; }, {.relative_error = 1e-9, .evaluations = 200'000});
    const double tolerance = std::max(numeric.relative_error, 1e-12);
    CHECK(std::fabs(exact.volume / numeric.volume - 1.0) < tolerance);
    CHECK((exact.inertia - numeric.inertia).norm() < 3.0 * tolerance * exact.inertia.norm());
    const Vec3 a = shape.half_axes;
    CHECK(mass_properties(shape).volume == Approx(exact.volume * a.prod()).epsilon(1e-14));
    const Vec3 second = Vec3::Constant(0.5 * exact.inertia.trace()) - exact.inertia.diagonal();  // ∫ x², y², z²
    const double about_z = a.prod() * (second.x() * a.x() * a.x() + second.y() * a.y() * a.y());
    CHECK(mass_properties(shape).inertia(2, 2) == Approx(about_z).epsilon(1e-13));
  }
}

TEST_CASE("Volumes of ellipsoid, and of the limits box and octahedron") {
  const Vec3 a(0.01, 0.02, 0.03);
  const double box = 8.0 * a.prod();
  const MassProperties ellipsoid = mass_properties(as_superquadric(Ellipsoid{a}));
  CHECK(ellipsoid.volume == Approx(box * std::numbers::pi / 6.0).epsilon(1e-14));
  CHECK(ellipsoid.inertia(0, 0) == Approx(ellipsoid.volume * (a.y() * a.y() + a.z() * a.z()) / 5.0).epsilon(1e-14));
  // Leading terms of Γ(1+1/n)³/Γ(1+3/n) at n = 64: 1 − (π²/2)/n² + O(n⁻³), with ζ(3)-sized coefficients.
  const double n = 64.0, pi = std::numbers::pi;
  CHECK(mass_properties(Superquadric{a, {n, n}}).volume / box ==
        Approx(1.0 - 0.5 * pi * pi / (n * n)).margin(20.0 / (n * n * n)));
  const double nearly_one = 1.0 + 1e-9;  // the octahedron has a sixth of the box
  CHECK(mass_properties(Superquadric{a, {nearly_one, nearly_one}}).volume / box == Approx(1.0 / 6.0).epsilon(1e-8));
}

TEST_CASE("Superquadrics that are none are refused with the reason") {
  CHECK_THROWS_WITH(validate(Superquadric{Vec3(1, -1, 1), {2, 2}}),
                    Catch::Contains("half-axis b") && Catch::Contains("positive"));
  CHECK_THROWS_WITH(validate(Superquadric{Vec3(1, 1, std::nan("")), {2, 2}}), Catch::Contains("half-axis c"));
  CHECK_THROWS_WITH(validate(Superquadric{Vec3(1, 1, 1), {1.0, 2}}),
                    Catch::Contains("n1") && Catch::Contains("(1, 64]"));
  CHECK_THROWS_WITH(validate(Superquadric{Vec3(1, 1, 1), {2, 64.5}}), Catch::Contains("n2"));
  CHECK_THROWS_AS(validate(Ellipsoid{Vec3(0, 1, 1)}), InputError);
  CHECK_THROWS_AS(validate(Sphere{-1.0}), InputError);
  CHECK_NOTHROW(validate(Superquadric{Vec3(1, 1, 1), Exponents::from_eta(1.0 / 32.0, 1.99)}));
}
