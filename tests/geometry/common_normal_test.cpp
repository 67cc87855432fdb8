// What holds for every pair of shapes.
#include <ccd/ccd.h>

#include <catch2/catch.hpp>
#include <limits>

#include "contact_checks.hpp"
#include "osculate/geometry/shape_contacts.hpp"

using namespace osculate;
using checks::Body;

namespace {

struct Pair {
  Body a, b;
};

std::vector<Shape> particles_of_one_size(double scale) {
  PotentialParticle cube = samples::potential_cube(0.01 * scale, 0.02, 0.002 * scale, 0.02 * scale);
  PotentialParticle stone = samples::potential_stone();
  for (FacePlane& plane : stone.planes) plane.distance *= scale;
  stone.edge_radius *= scale;
  stone.sphere_radius *= scale;
  return {Sphere{0.01 * scale},
          Ellipsoid{scale * Vec3(0.02, 0.01, 0.015)},
          Superquadric{scale * Vec3(0.01, 0.012, 0.02), {6.0, 4.0}},
          Superquadric{scale * Vec3(0.01, 0.012, 0.02), {1.5, 1.7}},
          cube,
          stone};
}

std::vector<Shape> walls(double scale) {
  return {HalfSpace{}, Cylinder{0.01 * scale, Cylinder::Solid::inside}, Cylinder{0.1 * scale, Cylinder::Solid::outside},
          SphereContainer{0.1 * scale}};
}

/// Every kind of particle against every kind of shape, touching, in random poses.
std::vector<Pair> touching_pairs(unsigned seed, double scale = 1.0) {
  std::mt19937 random(seed);
  std::vector<Pair> pairs;
  const auto particles = particles_of_one_size(scale);
  for (const Shape& shape : particles) {
    for (const Shape& other : particles) {
      const Body a{shape, {scale * Vec3(0.1, 0.2, 0.3), checks::random_orientation(random)}};
      Body b{other,
             {a.pose.position + 0.05 * scale * samples::random_direction(random), checks::random_orientation(random)}};
      checks::bring_together(a, b, 2e-4 * scale);
      pairs.push_back({a, b});
    }
    for (const Shape& wall : walls(scale)) {
      const Pose wall_pose{scale * Vec3(0.1, 0.2, 0.3), checks::random_orientation(random)};
      const bool around =
          std::holds_alternative<SphereContainer>(wall) ||
          (std::holds_alternative<Cylinder>(wall) && std::get<Cylinder>(wall).solid == Cylinder::Solid::outside);
      const double out = around ? 0.088 : 0.012;
      const Vec3 place =
          std::holds_alternative<HalfSpace>(wall) ? Vec3(0.0, 0.0, out) : Vec3(0.6 * out, 0.8 * out, 0.0);
      pairs.push_back(
          {{shape, {wall_pose.to_world(scale * place), checks::random_orientation(random)}}, {wall, wall_pose}});
    }
  }
  return pairs;
}

constexpr double size = 0.01;  // of the bodies above

}  // namespace

TEST_CASE("Swapping the bodies swaps the answer exactly") {
  for (const Pair& pair : touching_pairs(1)) {
    ContactCache cache_1, cache_2;
    for (int warm = 0; warm < 2; ++warm) {
      const ContactGeometry one = common_normal(pair.a.shape, pair.a.pose, pair.b.shape, pair.b.pose, cache_1);
      const ContactGeometry two = common_normal(pair.b.shape, pair.b.pose, pair.a.shape, pair.a.pose, cache_2);
      CHECK(one.status == two.status);
      CHECK(one.overlap == two.overlap);
      CHECK(one.normal == -two.normal);
      CHECK(one.on_1 == two.on_2);
      CHECK(one.on_2 == two.on_1);
      CHECK(one.curvature_1.max == two.curvature_2.max);
      CHECK(one.curvature_2.min == two.curvature_1.min);
      CHECK(one.curvature_1.max_direction == two.curvature_2.max_direction);
      CHECK(one.relative.R_i == two.relative.R_i);
      CHECK(one.relative.major_axis == two.relative.major_axis);
      CHECK(cache_1.point_1 == cache_2.point_2);
    }
  }
}

TEST_CASE("Turning the world turns the answer") {
  std::mt19937 random(2);
  for (const Pair& pair : touching_pairs(2)) {
    const ContactGeometry before = checks::contact_of(pair.a, pair.b);
    const Pose world{Vec3(0.3, -0.1, 0.2), checks::random_orientation(random)};
    const auto turned = [&](const Body& body) -> Body {
      return {body.shape, {world.to_world(body.pose.position), world.orientation * body.pose.orientation}};
    };
    const ContactGeometry after = checks::contact_of(turned(pair.a), turned(pair.b));
    CHECK(after.status == before.status);
    CHECK(after.overlap == Approx(before.overlap).margin(1e-13 * size));
    // Poses rounded to 1e-16 of 0.5 m turn normals by 1e-14, and shift points on flat faces by the radius there.
    CHECK((after.normal - world.rotate_to_world(before.normal)).norm() < 1e-9);
    CHECK((after.on_1 - world.to_world(before.on_1)).norm() < 1e-8 * size);
    CHECK(after.relative.R_j == Approx(before.relative.R_j).epsilon(1e-7));
  }
}

TEST_CASE("Metres and micrometres give the same contact") {
  const auto metres = touching_pairs(3), micrometres = touching_pairs(3, 1e-6);
  for (std::size_t i = 0; i < metres.size(); ++i) {
    const Pair& pair = metres[i];
    Pair scaled = micrometres[i];
    scaled.a.pose = {1e-6 * pair.a.pose.position, pair.a.pose.orientation};
    scaled.b.pose = {1e-6 * pair.b.pose.position, pair.b.pose.orientation};
    const ContactGeometry large = checks::contact_of(pair.a, pair.b), small = checks::contact_of(scaled.a, scaled.b);
    CHECK(small.status == large.status);
    CHECK(1e6 * small.overlap == Approx(large.overlap).margin(1e-13 * size));
    CHECK((small.normal - large.normal).norm() < 1e-9);
    CHECK(1e6 * small.relative.R_j == Approx(large.relative.R_j).epsilon(1e-7));
  }
}

TEST_CASE("A warm start finds what a cold start finds") {
  std::mt19937 random(4);
  for (const Pair& pair : touching_pairs(4)) {
    ContactCache cache;
    common_normal(pair.a.shape, pair.a.pose, pair.b.shape, pair.b.pose, cache);
    CHECK(cache.state == ContactCache::State::contact);
    Body moved = pair.a;
    moved.pose.position += 1e-4 * size * samples::random_direction(random);
    moved.pose.orientation = Quat(Eigen::AngleAxisd(1e-4, samples::random_direction(random))) * moved.pose.orientation;
    const ContactGeometry warm = common_normal(moved.shape, moved.pose, pair.b.shape, pair.b.pose, cache);
    const ContactGeometry cold = checks::contact_of(moved, pair.b);
    CHECK(warm.status == cold.status);
    CHECK(warm.overlap == Approx(cold.overlap).margin(1e-13 * size));
    CHECK((warm.normal - cold.normal).norm() < 1e-9);
    CHECK((warm.on_1 - cold.on_1).norm() < 1e-8 * size);
  }
}

TEST_CASE("A cached direction proves separation again") {
  std::mt19937 random(5);
  for (const Pair& pair : touching_pairs(5)) {
    const ContactGeometry contact = checks::contact_of(pair.a, pair.b);
    Body apart = pair.a;
    apart.pose.position -= (contact.overlap + 0.2 * size) * contact.normal;
    const double gap = checks::contact_of(apart, pair.b).overlap;
    REQUIRE(gap < 0.0);
    ContactCache cache;
    for (int i = 0; i < 2; ++i) {
      const ContactGeometry skipped =
          common_normal(apart.shape, apart.pose, pair.b.shape, pair.b.pose, cache, Gap::skip);
      CHECK(skipped.status == ContactStatus::separated);
      CHECK(skipped.overlap < 0.0);
      CHECK(skipped.overlap >= gap - 1e-13 * size);
      CHECK(cache.state == ContactCache::State::separation);
    }
    // Together again, the direction proves nothing.
    const ContactGeometry again = common_normal(pair.a.shape, pair.a.pose, pair.b.shape, pair.b.pose, cache, Gap::skip);
    CHECK(again.overlap == Approx(contact.overlap).margin(1e-13 * size));
  }
}

TEST_CASE("What a pair caches holds the curvatures of its contact, to the digits of floats") {
  std::vector<Pair> pairs;
  for (unsigned seed = 6; seed < 17; ++seed)
    for (const Pair& pair : touching_pairs(seed)) {
      const auto is_blunt = [](const Shape& shape) {
        const auto* body = std::get_if<Superquadric>(&shape);
        return body != nullptr && body->exponents.n2 >= 2.0;
      };
      if (is_blunt(pair.a.shape) && is_blunt(pair.b.shape)) pairs.push_back(pair);
    }
  SuperquadricPairs table;
  table.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
    table.set(i, std::get<Superquadric>(pairs[i].a.shape), pairs[i].a.pose, std::get<Superquadric>(pairs[i].b.shape),
              pairs[i].b.pose);
  for (const auto& solve : {common_normals, common_normals_scalar}) {
    ContactCaches caches;
    ContactColumns contacts;
    solve(table, caches, contacts, Gap::resolve, Curvatures::all);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const ContactCache cache = caches.get(i);
      const ContactGeometry contact = contacts.get(i);
      REQUIRE(cache.state == ContactCache::State::contact);
      const auto check = [](const Vec3& shape, const PrincipalCurvatures& k) {
        CHECK(shape.x() + shape.z() == Approx(k.max + k.min).epsilon(1e-6));
        CHECK(shape.x() * shape.z() - shape.y() * shape.y() == Approx(k.max * k.min).margin(1e-6 * k.max * k.max));
      };
      check(cache.shape_1, contact.curvature_1);
      check(cache.shape_2, contact.curvature_2);
    }
  }
}

TEST_CASE("In batches every pair has the answer it has alone") {
  std::vector<Pair> pairs = touching_pairs(6);
  for (const Pair& pair : touching_pairs(7)) pairs.push_back(pair);
  ShapePairs table;
  table.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
    table.set(i, pairs[i].a.shape, pairs[i].a.pose, pairs[i].b.shape, pairs[i].b.pose);
  ContactCaches caches;
  ContactColumns contacts;
  for (int warm = 0; warm < 2; ++warm) {
    common_normals(table, caches, contacts);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const ContactGeometry alone = checks::contact_of(pairs[i].a, pairs[i].b), together = contacts.get(i);
      CHECK(together.status == alone.status);
      CHECK(together.overlap == Approx(alone.overlap).margin(1e-13 * size));
      CHECK((together.normal - alone.normal).norm() < 1e-9);
      CHECK((together.on_2 - alone.on_2).norm() < 1e-8 * size);
      CHECK(together.curvature_1.max == Approx(alone.curvature_1.max).epsilon(1e-7));
      CHECK(together.relative.R_j == Approx(alone.relative.R_j).epsilon(1e-7));
    }
  }
}

TEST_CASE("The curvatures for a law are those of the contact, without the bodies' own") {
  std::mt19937 random(11);
  constexpr std::size_t count = 40;
  SuperquadricPairs here, moved;
  here.resize(count);
  moved.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double n = 2.0 + static_cast<double>(i % 5);
    const Superquadric one{Vec3(0.010, 0.012, 0.020), {n, n}}, two{Vec3(0.015, 0.011, 0.013), {n + 0.5, 4.0}};
    const Body a{one, {Vec3::Zero(), checks::random_orientation(random)}};
    Body b{two, {0.05 * samples::random_direction(random), checks::random_orientation(random)}};
    checks::bring_together(a, b, 1e-4);
    here.set(i, one, a.pose, two, b.pose);
    // As bodies move in a time step.
    b.pose.position += 1e-7 * samples::random_direction(random);
    b.pose.orientation = Quat(Eigen::AngleAxisd(1e-5, samples::random_direction(random))) * b.pose.orientation;
    moved.set(i, one, a.pose, two, b.pose);
  }
  ContactCaches caches;
  ContactColumns contacts, whole, for_law;
  common_normals(here, caches, contacts);
  ContactCaches others = caches;
  common_normals(moved, caches, whole);
  common_normals(moved, others, for_law, Gap::resolve, Curvatures::relative);
  for (std::size_t i = 0; i < count; ++i) {
    const ContactGeometry a = whole.get(i), b = for_law.get(i);
    CHECK(b.status == a.status);
    // The contact itself to round-off, the curvatures to some 1e-8 of a body's size away.
    CHECK(b.overlap == Approx(a.overlap).margin(1e-14 * size));
    CHECK((b.normal - a.normal).norm() < 1e-13);
    CHECK((b.on_1 - a.on_1).norm() < 1e-12 * size);
    CHECK(b.relative.R_i == Approx(a.relative.R_i).epsilon(1e-5));
    CHECK(b.relative.R_j == Approx(a.relative.R_j).epsilon(1e-5));
    CHECK(a.curvature_1.max > 0.0);
    CHECK(b.curvature_1.max == 0.0);
    CHECK(b.curvature_2.max_direction == Vec3::Zero());
  }
}

TEST_CASE("A sphere is the same as an ellipsoid or superquadric of equal axes") {
  const Pose pose{Vec3(0.1, 0.2, 0.3), Quat::Identity()};
  const Vec3 axes = Vec3::Constant(0.01);
  for (const Shape& other : particles_of_one_size(1.0)) {
    Body b{other, {Vec3(0.115, 0.213, 0.31), Quat(0.5, 0.5, -0.5, 0.5)}};
    checks::bring_together({Sphere{0.01}, pose}, b, 1e-4);
    const ContactGeometry of_sphere = checks::contact_of({Sphere{0.01}, pose}, b);
    for (const Shape& same : {Shape(Ellipsoid{axes}), Shape(Superquadric{axes, {2.0, 2.0}})}) {
      const ContactGeometry c = checks::contact_of({same, pose}, b);
      CHECK(c.overlap == of_sphere.overlap);
      CHECK(c.normal == of_sphere.normal);
      CHECK(c.on_2 == of_sphere.on_2);
      CHECK(c.relative.R_j == of_sphere.relative.R_j);
    }
  }
}

TEST_CASE("Poses that are not finite give no answer and no harm") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const Pair& pair : touching_pairs(8)) {
    for (const double bad : {nan, infinity, -infinity}) {
      for (int where = 0; where < 2; ++where) {
        Body a = pair.a;
        (where == 0 ? a.pose.position.y() : a.pose.orientation.z()) = bad;
        ContactCache cache;
        common_normal(pair.a.shape, pair.a.pose, pair.b.shape, pair.b.pose, cache);
        const ContactGeometry c = common_normal(a.shape, a.pose, pair.b.shape, pair.b.pose, cache);
        CHECK(c.status == ContactStatus::degenerate);
        CHECK(c.normal == Vec3::Zero());
        CHECK(c.overlap == 0.0);
        CHECK(c.relative.R_i == 0.0);
      }
    }
    Body far = pair.a;
    far.pose.position.x() = 1e300;
    const ContactGeometry c = checks::contact_of(far, pair.b);
    CHECK(c.normal.allFinite());
    CHECK(std::isfinite(c.overlap));
  }
}

TEST_CASE("Coincident centres give an answer") {
  for (const Shape& shape : particles_of_one_size(1.0)) {
    for (const Shape& other : particles_of_one_size(1.0)) {
      const ContactGeometry c = common_normal(shape, {}, other, {});
      CHECK(c.overlap > 0.0);
      CHECK(c.normal.allFinite());
    }
    for (const Shape& wall : walls(1.0)) {
      const ContactGeometry c = common_normal(shape, {}, wall, {});
      CHECK(is_resolved(c.status));
      CHECK(c.normal.norm() == Approx(1.0));
    }
  }
}

namespace {

void ccd_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Vec3 u(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3 x = checks::support_w(*static_cast<const Body*>(object), u);
  ccdVec3Set(point, x.x(), x.y(), x.z());
}

}  // namespace

TEST_CASE("GJK and EPA find the same depth") {
  int compared = 0;
  constexpr double metre = 100.0;  // libccd's tolerances are absolute: bodies of its own size
  constexpr double epa_tolerance = 1e-10;
  for (const Pair& pair : touching_pairs(9, metre)) {
    if (!is_particle(pair.b.shape)) continue;
    ccd_t settings;
    CCD_INIT(&settings);
    settings.support1 = ccd_support;
    settings.support2 = ccd_support;
    settings.epa_tolerance = epa_tolerance;
    settings.max_iterations = 1000;
    ccd_real_t depth = 0.0;
    ccd_vec3_t direction, position;
    if (ccdGJKPenetration(&pair.a, &pair.b, &settings, &depth, &direction, &position) != 0) continue;
    ++compared;
    // EPA stops when the square of what a support point gains is less than its tolerance.
    CHECK(checks::contact_of(pair.a, pair.b).overlap == Approx(depth).margin(std::sqrt(epa_tolerance)));
  }
  CHECK(compared > 20);
}
