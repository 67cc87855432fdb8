#include "osculate/shapes/potential_particle.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "osculate/core/error.hpp"
#include "osculate/shapes/mesh.hpp"
#include "shapes/radial_quadrature.hpp"
#include "shapes/sample_shapes.hpp"

using namespace osculate;

TEST_CASE("The potential of eq. (16) is minus one at the centre and has the derivatives it states") {
  std::mt19937 random(1);
  for (const PotentialParticle& shape : samples::potential_particles()) {
    CHECK(implicit_value(shape, Vec3::Zero()).value == -1.0);
    const double size = shape.sphere_radius;
    for (int i = 0; i < 50; ++i) {
      const Vec3 x = 0.7 * size * samples::random_direction(random);
      const ImplicitValue f = implicit_value(shape, x);
      double printed = -1.0 + shape.sphericity * x.squaredNorm() / (size * size);
      for (const FacePlane& plane : shape.planes) {
        const double beyond = std::max(plane.normal.dot(x) - plane.distance, 0.0) / shape.edge_radius;
        printed += (1.0 - shape.sphericity) * beyond * beyond;
      }
      CHECK(f.value == Approx(printed).epsilon(1e-12).margin(1e-14));
      const double h = 1e-6 * size;
      for (int axis = 0; axis < 3; ++axis) {
        const ImplicitValue plus = implicit_value(shape, x + h * Vec3::Unit(axis));
        const ImplicitValue minus = implicit_value(shape, x - h * Vec3::Unit(axis));
        // f is quadratic: central differences are exact but for rounding (1e-16/1e-6) and steps across a kink.
        const double scale = std::max(f.gradient.norm(), f.hessian.norm() * size);
        CHECK(std::fabs((plus.value - minus.value) / (2.0 * h) - f.gradient[axis]) < 1e-6 * scale);
        CHECK(((plus.gradient - minus.gradient) / (2.0 * h) - f.hessian.col(axis)).norm() <=
              1e-6 * scale / size +
                  ((plus.hessian - minus.hessian).norm() > 0.0 ? f.hessian.norm() + plus.hessian.norm() : 0.0));
      }
    }
  }
}

TEST_CASE("The gauge of a potential particle is one on f = 0, with its own derivatives") {
  std::mt19937 random(2);
  for (const PotentialParticle& shape : samples::potential_particles()) {
    const double sharpness = shape.planes.front().distance / shape.edge_radius;  // a·x − d loses as many digits
    for (int i = 0; i < 100; ++i) {
      const Vec3 u = samples::random_direction(random);
      const Vec3 x = u / gauge(shape, u).value;
      const ImplicitValue f = implicit_value(shape, x);
      // Rounding of x moves f by |x||∇f| units in the last place.
      CHECK(std::fabs(f.value) < 8.0 * 2.2e-16 * x.norm() * f.gradient.norm());
      const Gauge g = gauge(shape, x);
      CHECK(g.value == Approx(1.0).epsilon(1e-14));
      CHECK(g.gradient.dot(x) == Approx(1.0).epsilon(1e-12));  // Euler: homogeneous of degree 1
      CHECK((g.hessian * x).norm() < 1e-10 * g.hessian.norm() * x.norm());
      CHECK((g.gradient.normalized() - f.gradient.normalized()).norm() < 1e-12);
      const double h = 1e-6 * x.norm();
      const Gauge plus = gauge(shape, x + h * Vec3::UnitX()), minus = gauge(shape, x - h * Vec3::UnitX());
      if ((plus.hessian - minus.hessian).norm() > 1e-3 * g.hessian.norm()) continue;  // across a kink
      CHECK((plus.value - minus.value) / (2.0 * h) == Approx(g.gradient.x()).margin(1e-6 * g.gradient.norm()));
      CHECK(((plus.gradient - minus.gradient) / (2.0 * h) - g.hessian.col(0)).norm() <
            1e-5 * (1.0 + sharpness) * g.hessian.norm());
    }
  }
}

TEST_CASE("The support point of a potential particle is exact to round-off, blunt or sharp") {
  std::mt19937 random(3);
  for (const PotentialParticle& shape : samples::potential_particles()) {
    const double sharpness = shape.planes.front().distance / shape.edge_radius;
    for (int i = 0; i < 500; ++i) {
      const Vec3 u = samples::random_direction(random);
      const Vec3 x = support_point(shape, u);
      const ImplicitValue f = implicit_value(shape, x);
      // a·x − d loses d/r digits.
      CHECK((f.gradient.normalized() - u).norm() < 1e-14 * (1.0 + sharpness));
      CHECK(std::fabs(f.value) < 1e-14 * (1.0 + sharpness));
      const Vec3 other = samples::random_direction(random);
      CHECK(u.dot(other) / gauge(shape, other).value <= u.dot(x) * (1.0 + 1e-14));
    }
    CHECK(support_point(shape, Vec3::Zero()).isZero(0.0));
  }
}

TEST_CASE("Support points along symmetry axes of a potential cube, where planes tie") {
  const PotentialParticle cube = samples::potential_cube(0.01, 0.01, 0.002, 0.02);
  CHECK(support_point(cube, Vec3::UnitX()).tail<2>().isZero(0.0));
  const Vec3 corner = support_point(cube, Vec3(1, 1, 1));
  CHECK(corner.y() == Approx(corner.x()).epsilon(1e-14));
  CHECK(corner.z() == Approx(corner.x()).epsilon(1e-14));
}

TEST_CASE("With k = 1 a potential particle is the sphere of radius R") {
  const double R = 0.02;
  const PotentialParticle ball = samples::potential_cube(0.01, 1.0, 0.001, R);
  const MassProperties mass = mass_properties(ball);
  const double volume = 4.0 / 3.0 * std::numbers::pi * R * R * R;
  CHECK(std::fabs(mass.volume / volume - 1.0) < mass.relative_error);
  CHECK(std::fabs(mass.inertia(1, 1) / (0.4 * volume * R * R) - 1.0) < 3.0 * mass.relative_error);
  CHECK(bounding_radius(ball) == Approx(R).epsilon(1e-14));
  CHECK(bounding_radius(ball) >= R);
}

TEST_CASE("The bounding sphere and box of a potential particle hold it tightly") {
  for (const PotentialParticle& shape : samples::potential_particles()) {
    const double radius = bounding_radius(shape);
    const OrientedBox box = oriented_box(shape);
    double furthest = 0.0;
    Vec3 reach = Vec3::Zero();
    for (const Vec3& x : surface_mesh(shape, 24).vertices) {
      const Vec3 offset = (x - box.centre).cwiseAbs();
      CHECK((offset - box.half_extents * (1.0 + 1e-12)).maxCoeff() <= 0.0);
      reach = reach.cwiseMax(offset);
      CHECK(x.norm() <= radius);
      Vec3 further = x;
      for (int i = 0; i < 3; ++i) further = support_point(shape, further.normalized());
      CHECK(further.norm() <= radius);
      furthest = std::max(furthest, further.norm());
    }
    CHECK(furthest > radius * (1.0 - 1e-7));
    CHECK((reach - 0.99 * box.half_extents).minCoeff() > 0.0);
  }
}

TEST_CASE("Mass properties of potential particles agree with the divergence theorem on their meshes") {
  for (const PotentialParticle& shape :
       {samples::potential_cube(0.01, 0.05, 0.003, 0.02), samples::potential_stone()}) {
    struct Sums {
      double volume = 0.0;
      Vec3 first = Vec3::Zero();
      double second_xx = 0.0;
    };
    const auto sums_at = [&](int resolution) {
      const TriangleMesh mesh = surface_mesh(shape, resolution);
      Sums sums;
      for (const auto& t : mesh.triangles) {
        const auto vertex = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(t[i])]; };
        const Vec3 a = vertex(0), b = vertex(1), c = vertex(2);
        const double tetrahedron = a.dot(b.cross(c)) / 6.0;
        sums.volume += tetrahedron;
        sums.first += tetrahedron * (a + b + c) / 4.0;
        const Vec3 x(a.x(), b.x(), c.x());
        sums.second_xx += tetrahedron * (x.squaredNorm() + x.sum() * x.sum()) / 20.0;
      }
      return sums;
    };
    const Sums coarse = sums_at(48), fine = sums_at(96);
    // Chords cut off an error of second order in the cell: extrapolate it away; what is left is of order h³ at kinks.
    const auto limit = [](const auto& c, const auto& f) { return f + (f - c) / 3.0; };
    const double volume = limit(coarse.volume, fine.volume);
    const MassProperties mass = mass_properties(shape);
    CHECK(mass.relative_error < 1e-6);
    CHECK(mass.volume == Approx(volume).epsilon(1e-5));
    const Vec3 centroid = Vec3(limit(coarse.first, fine.first)) / volume;
    CHECK((mass.centroid - centroid).norm() < 1e-5 * shape.sphere_radius);
    const double xx = limit(coarse.second_xx, fine.second_xx) - volume * centroid.x() * centroid.x();
    const double from_inertia = 0.5 * mass.inertia.trace() - mass.inertia(0, 0);
    CHECK(from_inertia == Approx(xx).epsilon(3e-5));
  }
}

TEST_CASE("The stated error of mass properties is no smaller than the true one, sharp edges included") {
  for (const PotentialParticle& shape : {samples::potential_cube(1e-5, 1e-4, 1e-7, 2e-5), samples::potential_stone()}) {
    const MassProperties mass = mass_properties(shape);
    const MassProperties finer =
        mass_properties_by_quadrature([&](const Vec3& x) { return 1.0 / gauge(shape, x).value; },
                                      {.relative_error = 1e-12, .evaluations = 4'000'000});
    CHECK(mass.relative_error < 2e-6);
    CHECK(std::fabs(mass.volume / finer.volume - 1.0) < mass.relative_error);
    CHECK((mass.inertia - finer.inertia).norm() < mass.relative_error * finer.inertia.norm());
  }
}

TEST_CASE("Potential particles that are none are refused, naming the plane") {
  const PotentialParticle good = samples::potential_cube(0.01, 0.05, 0.002, 0.02);
  CHECK_NOTHROW(validate(good));

  PotentialParticle shape = good;
  shape.planes[2].normal *= 1.001;
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("plane 3") && Catch::Contains("unit normal"));
  shape = good;
  shape.planes[4].distance = -0.01;
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("plane 5") && Catch::Contains("origin lies inside"));
  shape = good;
  shape.planes.pop_back();
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("5 planes") && Catch::Contains("bound a volume"));
  shape.planes.resize(2);
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("bound a volume"));
  shape.planes.clear();
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("bound a volume"));
  shape = good;
  shape.sphericity = 0.0;
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("(0, 1]"));
  shape = good;
  shape.edge_radius = std::nan("");
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("edge radius"));
  shape = good;
  shape.sphere_radius = 0.001;
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("cuts the sphere"));
  shape = good;
  shape.edge_radius = 2.0;  // millimetres given as metres
  CHECK_THROWS_WITH(validate(shape), Catch::Contains("metres"));
}
