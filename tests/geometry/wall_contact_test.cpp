#include <catch2/catch.hpp>
#include <limits>

#include "contact_checks.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;
using checks::Body;

namespace {

constexpr double round_off = 1e-14;  // a few dozen operations, relative to coordinates of order 1

Cylinder rod(double radius) {
  return {radius, Cylinder::Solid::inside};
}
Cylinder drum(double radius) {
  return {radius, Cylinder::Solid::outside};
}

/// The body's point furthest from the wall's axis (drum) or centre (container), from many random directions.
double furthest_by_brute_force(const Body& body, const Pose& wall, bool from_axis, std::mt19937& random) {
  const Vec3 axis = wall.orientation * Vec3::UnitZ();
  const auto outward = [&](const Vec3& v) -> Vec3 { return from_axis ? Vec3(v - v.dot(axis) * axis) : v; };
  double furthest = 0.0;
  for (int i = 0; i < 150; ++i) {
    Vec3 u = outward(samples::random_direction(random)).normalized();
    for (int k = 0; k < 150; ++k) {
      const Vec3 x = outward(checks::support_w(body, u) - wall.position);
      furthest = std::max(furthest, x.norm());
      u = x.normalized();
    }
  }
  return furthest;
}

std::vector<Shape> walls_around(double radius) {
  return {HalfSpace{}, rod(0.7 * radius), drum(6.0 * radius), SphereContainer{6.0 * radius}};
}

/// Where a body of this bounding radius touches the wall.
Pose beside(const Shape& wall, const Pose& wall_pose, double radius, std::mt19937& random) {
  double out = 0.6 * radius;
  if (const auto* cylinder = std::get_if<Cylinder>(&wall))
    out = cylinder->solid == Cylinder::Solid::inside ? 1.2 * radius : 5.4 * radius;
  if (std::holds_alternative<SphereContainer>(wall)) out = 5.4 * radius;
  const Vec3 place =
      std::holds_alternative<HalfSpace>(wall) ? Vec3(0.3 * radius, radius, out) : Vec3(0.6 * out, -0.8 * out, 0.0);
  return {wall_pose.to_world(place), checks::random_orientation(random)};
}

}  // namespace

TEST_CASE("A sphere touches every wall as a sphere does") {
  const Body sphere{Sphere{0.5}, {Vec3(0.0, 0.0, 0.4), Quat::Identity()}};
  SECTION("half-space") {
    const ContactGeometry c = checks::contact_of(sphere, {HalfSpace{}, {}});
    CHECK(c.status == ContactStatus::touching);
    CHECK(c.overlap == Approx(0.1).epsilon(round_off));
    CHECK((c.normal + Vec3::UnitZ()).norm() < round_off);
    CHECK((c.point() - Vec3(0.0, 0.0, -0.05)).norm() < round_off);
    CHECK(c.relative.R_i == Approx(0.5).epsilon(round_off));
    CHECK(c.relative.R_j == Approx(0.5).epsilon(round_off));
    CHECK(c.curvature_2.max == 0.0);
  }
  SECTION("rod") {
    const ContactGeometry c =
        checks::contact_of({sphere.shape, {Vec3(1.4, 0.0, 7.0), Quat::Identity()}}, {rod(1.0), {}});
    CHECK(c.status == ContactStatus::touching);
    CHECK(c.overlap == Approx(0.1).epsilon(10.0 * round_off));
    CHECK((c.on_2 - Vec3(1.0, 0.0, 7.0)).norm() < 10.0 * round_off);
    CHECK(c.curvature_2.max == Approx(1.0));
    CHECK(c.relative.R_i == Approx(0.5));        // along the rod: 1/R = 2
    CHECK(c.relative.R_j == Approx(1.0 / 3.0));  // around it: 1/R = 2 + 1
    CHECK(std::fabs(c.relative.major_axis.z()) == Approx(1.0));
  }
  SECTION("drum") {
    const ContactGeometry c =
        checks::contact_of({sphere.shape, {Vec3(0.0, 1.6, -3.0), Quat::Identity()}}, {drum(2.0), {}});
    CHECK(c.status == ContactStatus::touching);
    CHECK(c.overlap == Approx(0.1).epsilon(10.0 * round_off));
    CHECK((c.normal - Vec3::UnitY()).norm() < round_off);
    CHECK(c.curvature_2.min == Approx(-0.5));
    CHECK(c.curvature_2.max == Approx(0.0).margin(round_off));
    CHECK(c.relative.R_i == Approx(1.0 / 1.5));
    CHECK(c.relative.R_j == Approx(0.5));
  }
  SECTION("sphere container") {
    const ContactGeometry c =
        checks::contact_of({sphere.shape, {Vec3(-1.4, 0.0, 0.0), Quat::Identity()}}, {SphereContainer{2.0}, {}});
    CHECK(c.status == ContactStatus::separated);
    CHECK(c.overlap == Approx(-0.1).epsilon(10.0 * round_off));
    CHECK(c.relative.R_i == Approx(1.0 / 1.5));
    CHECK(c.relative.R_j == Approx(1.0 / 1.5));
  }
}

TEST_CASE("An ellipsoid on a plane reaches down to the root of the squared half-axes' components") {
  std::mt19937 random(1);
  const Vec3 axes(0.3, 1.0, 2.0);
  for (int i = 0; i < 20; ++i) {
    const Quat q = checks::random_orientation(random);
    const Vec3 up = q.conjugate() * Vec3::UnitZ();
    const double reach = axes.cwiseProduct(up).norm();
    const ContactGeometry c =
        checks::contact_of({Ellipsoid{axes}, {Vec3(4.0, 5.0, 0.9 * reach), q}}, {HalfSpace{}, {}});
    CHECK(c.overlap == Approx(0.1 * reach).epsilon(1e-13));
    // Gaussian curvature of an ellipsoid in terms of its support: h⁴/(a b c)².
    CHECK(c.curvature_1.gaussian() == Approx(std::pow(reach, 4) / std::pow(axes.prod(), 2)).epsilon(1e-12));
  }
}

TEST_CASE("An ellipsoid across a drum touches with the end of its long axis") {
  const Vec3 axes(1.0, 0.6, 0.4);
  const ContactGeometry c =
      checks::contact_of({Ellipsoid{axes}, {Vec3(1.05, 0.0, 0.3), Quat::Identity()}}, {drum(2.0), {}});
  CHECK(c.status == ContactStatus::touching);
  CHECK(c.overlap == Approx(0.05).epsilon(1e-13));
  CHECK((c.on_1 - Vec3(2.05, 0.0, 0.3)).norm() < 1e-12);
  CHECK(c.curvature_1.max == Approx(1.0 / 0.16));  // a/c²
  CHECK(c.curvature_1.min == Approx(1.0 / 0.36));  // a/b²
  CHECK(1.0 / c.relative.R_i == Approx(1.0 / 0.36 - 0.5));
  CHECK(1.0 / c.relative.R_j == Approx(1.0 / 0.16));
}

TEST_CASE("A particle in the middle of a wall touches on both sides: ambiguous, with the overlap right") {
  const ContactGeometry everywhere = checks::contact_of({Sphere{0.5}, {}}, {SphereContainer{0.45}, {}});
  CHECK(everywhere.status == ContactStatus::ambiguous);
  CHECK(everywhere.overlap == Approx(0.05).epsilon(1e-13));
  const ContactGeometry c = checks::contact_of({Ellipsoid{Vec3(1.0, 0.5, 0.5)}, {}}, {drum(0.9), {}});
  CHECK(c.status == ContactStatus::ambiguous);
  CHECK(c.overlap == Approx(0.1).epsilon(1e-12));
  const ContactGeometry through = checks::contact_of({Ellipsoid{Vec3(1.0, 0.5, 0.5)}, {}}, {rod(0.1), {}});
  CHECK(through.status == ContactStatus::ambiguous);
  CHECK(through.overlap == Approx(0.6).epsilon(1e-12));
}

TEST_CASE("A face on a plane is flat and touches in its middle") {
  const Superquadric box{Vec3(1.0, 1.2, 0.7), {4.0, 4.0}};
  const ContactGeometry c = checks::contact_of({box, {Vec3(3.0, 1.0, 0.69), Quat::Identity()}}, {HalfSpace{}, {}});
  CHECK(c.status == ContactStatus::flat);
  CHECK((c.on_1 - Vec3(3.0, 1.0, -0.01)).norm() < 1e-14);
  CHECK(c.overlap == Approx(0.01).epsilon(1e-13));
}

TEST_CASE("A potential cube touches a plane with the middle of a face and with a vertex") {
  const double d = 0.01, k = 0.05, r = 0.002, R = 0.02;
  const PotentialParticle cube = samples::potential_cube(d, k, r, R);
  SECTION("face: one plane in play, a quadratic equation on the axis") {
    // (1−k) (z−d)²/r² + k z²/R² = 1
    const double a = (1 - k) / (r * r), b = k / (R * R);
    const double z = (a * d + std::sqrt(a * a * d * d - (a + b) * (a * d * d - 1.0))) / (a + b);
    const ContactGeometry c =
        checks::contact_of({cube, {Vec3(0.0, 0.0, 0.9 * z), Quat::Identity()}}, {HalfSpace{}, {}});
    CHECK(c.overlap == Approx(0.1 * z).epsilon(1e-12));
    CHECK(c.on_1.head<2>().norm() < 1e-12 * d);
    // K = ∇∇f/|∇f|: only the sphere's term is left across the face.
    const double curvature = 2 * b / (2 * a * (z - d) + 2 * b * z);
    CHECK(c.curvature_1.max == Approx(curvature).epsilon(1e-9));
    CHECK(c.curvature_1.min == Approx(curvature).epsilon(1e-9));
  }
  SECTION("vertex: three planes in play, all alike") {
    const double a = 3 * (1 - k) / (r * r), b = 3 * k / (R * R);  // each coordinate t
    const double t = (a * d + std::sqrt(a * a * d * d - (a + b) * (a * d * d - 1.0))) / (a + b);
    const Quat on_vertex = Quat::FromTwoVectors(Vec3(1, 1, 1), -Vec3::UnitZ());
    const double reach = std::sqrt(3.0) * t;
    const ContactGeometry c = checks::contact_of({cube, {Vec3(0.0, 0.0, 0.95 * reach), on_vertex}}, {HalfSpace{}, {}});
    CHECK(c.overlap == Approx(0.05 * reach).epsilon(1e-12));
    CHECK(c.on_1.head<2>().norm() < 1e-12 * d);
  }
}

TEST_CASE("No point of a particle lies deeper in a drum or container than the contact says") {
  std::mt19937 random(5);
  for (const Shape& shape : samples::particles()) {
    const double radius = bounding_radius(shape);
    const Pose wall_pose{radius * Vec3(1.0, 2.0, 3.0), checks::random_orientation(random)};
    for (const bool from_axis : {true, false}) {
      const double wall_radius = 3.0 * radius;
      const Shape wall = from_axis ? Shape(drum(wall_radius)) : Shape(SphereContainer{wall_radius});
      const Body body{shape,
                      {wall_pose.to_world(Vec3(1.5 * radius, 1.6 * radius, 0.0)), checks::random_orientation(random)}};
      const ContactGeometry c = checks::contact_of(body, {wall, wall_pose});
      REQUIRE(is_resolved(c.status));
      const double expected = furthest_by_brute_force(body, wall_pose, from_axis, random) - wall_radius;
      CHECK(c.overlap == Approx(expected).margin(1e-10 * radius));  // what 150 steps of the search leave
    }
  }
}

TEST_CASE("A rod is as far away as the particle's nearest point is from its axis") {
  std::mt19937 random(6);
  for (const Shape& shape : samples::particles()) {
    const double radius = bounding_radius(shape);
    const Body body{shape, {Vec3(1.3 * radius, 0.2 * radius, 9.0 * radius), checks::random_orientation(random)}};
    const ContactGeometry c = checks::contact_of(body, {rod(radius), {}});
    REQUIRE(is_resolved(c.status));
    double expected = std::numeric_limits<double>::infinity();
    const auto along = [&](double angle) {
      const Vec3 n(std::cos(angle), std::sin(angle), 0.0);
      return radius + checks::support_w(body, n).dot(n);
    };
    double best = 0.0;
    for (int i = 0; i < 720; ++i) {
      const double angle = i * (std::acos(-1.0) / 360.0);
      if (along(angle) < expected) {
        expected = along(angle);
        best = angle;
      }
    }
    for (double step = 0.005; step > 1e-10;) {
      const double nearby = along(best - step) < along(best + step) ? best - step : best + step;
      if (along(nearby) < expected) {
        expected = along(nearby);
        best = nearby;
      } else {
        step *= 0.5;
      }
    }
    CHECK(c.overlap == Approx(expected).margin(1e-10 * radius));
  }
}

TEST_CASE("At a wall contact points lie on both surfaces along the common normal") {
  std::mt19937 random(7);
  for (const Shape& shape : samples::particles()) {
    const double radius = bounding_radius(shape);
    for (const Shape& wall : walls_around(radius)) {
      const Pose wall_pose{radius * Vec3(1.0, 2.0, 3.0), checks::random_orientation(random)};
      const Pose pose = beside(wall, wall_pose, radius, random);
      const ContactGeometry c = common_normal(shape, pose, wall, wall_pose);
      REQUIRE(is_resolved(c.status));
      CHECK((c.on_1 - c.on_2 - c.overlap * c.normal).norm() < 1e-10 * radius);
      CHECK(gauge(shape, pose.to_body(c.on_1)).value == Approx(1.0).epsilon(1e-9));
      const Vec3 on_2 = wall_pose.to_body(c.on_2);
      const WallDistance at_wall = std::visit(
          [&](const auto& w) -> WallDistance {
            if constexpr (requires { signed_distance(w, on_2); })
              return signed_distance(w, on_2);
            else
              return {1.0, Vec3::Zero()};
          },
          wall);
      CHECK(std::fabs(at_wall.value) < 1e-12 * radius);
      CHECK((wall_pose.rotate_to_world(at_wall.normal) + c.normal).norm() < 1e-9);
    }
  }
}

TEST_CASE("Far along a wall, contacts keep their digits") {
  const Superquadric shape{Vec3(1.0, 0.8, 0.6), {3.0, 5.0}};
  std::mt19937 random(8);
  const Quat q = checks::random_orientation(random);
  const double near = common_normal(shape, {Vec3(0.0, 1.2, 0.0), q}, rod(0.5), {}).overlap;
  const double far = common_normal(shape, {Vec3(0.0, 1.2, 1048576.0), q}, rod(0.5), {}).overlap;
  CHECK(far == Approx(near).margin(1e-14));
}

TEST_CASE("A warm contact with a drum does not stay on a corner that has lifted off") {
  const PotentialParticle cube = samples::potential_cube(0.01, 0.01, 0.002, 0.02);
  const Shape wall = drum(0.05);
  ContactCache cache;
  Pose pose{Vec3(0.035, 0.0, 0.0), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()))};
  common_normal(cube, pose, wall, {}, cache);
  pose.orientation = Quat(Eigen::AngleAxisd(-0.3, Vec3::UnitZ()));
  const ContactGeometry warm = common_normal(cube, pose, wall, {}, cache);
  const ContactGeometry cold = common_normal(cube, pose, wall, {});
  CHECK(warm.overlap == Approx(cold.overlap).epsilon(1e-12));
}

TEST_CASE("A wall has no contact with a wall") {
  CHECK_THROWS_AS(common_normal(HalfSpace{}, {}, drum(1.0), {}), InputError);
}
