#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "c/c_bodies.hpp"

using namespace osculate;

extern "C" int abi_version_seen_by_c(void);

namespace {

std::vector<Shape> centimetre_shapes() {
  return {Sphere{0.01},
          Ellipsoid{Vec3(0.03, 0.01, 0.02)},
          Superquadric{Vec3(0.01, 0.012, 0.007), {4.0, 4.0}},
          Superquadric{Vec3(0.02, 0.01, 0.015), {2.5, 6.0}},
          samples::potential_cube(0.01, 0.3, 0.005, 0.02),
          samples::potential_stone()};
}

std::array<double, 25> numbers_of(const ContactGeometry& c) {
  std::array<double, 25> numbers{};
  std::size_t k = 0;
  const auto put = [&](const auto&... values) { ((numbers[k++] = values), ...); };
  const auto put_vector = [&](const Vec3& v) { put(v.x(), v.y(), v.z()); };
  put_vector(c.normal);
  put(c.overlap);
  put_vector(c.on_1);
  put_vector(c.on_2);
  put(c.curvature_1.max, c.curvature_1.min);
  put_vector(c.curvature_1.max_direction);
  put(c.curvature_2.max, c.curvature_2.min);
  put_vector(c.curvature_2.max_direction);
  put(c.relative.R_i, c.relative.R_j);
  put_vector(c.relative.major_axis);
  return numbers;
}

std::array<double, 25> numbers_of(const osculate_contact& c) {
  std::array<double, 25> numbers{};
  std::size_t k = 0;
  const auto put = [&](const auto& values) {
    for (const double value : values) numbers[k++] = value;
  };
  put(c.normal);
  numbers[k++] = c.overlap;
  put(c.on_1);
  put(c.on_2);
  put(c.curvature_1);
  put(c.direction_1);
  put(c.curvature_2);
  put(c.direction_2);
  numbers[k++] = c.R_i;
  numbers[k++] = c.R_j;
  put(c.major_axis);
  return numbers;
}

/// Every column of contacts of a number of pairs.
struct Columns25 {
  explicit Columns25(std::size_t pairs) : status(pairs, -1), values(25, std::vector<double>(pairs, -1.0)) {}

  osculate_contact_columns view() {
    std::size_t k = 0;
    const auto next = [&] { return values[k++].data(); };
    osculate_contact_columns to{};
    const auto fill = [&](auto& components) {
      for (double*& component : components) component = next();
    };
    to.status = status.data();
    fill(to.normal);
    to.overlap = next();
    fill(to.on_1);
    fill(to.on_2);
    fill(to.curvature_1);
    fill(to.direction_1);
    fill(to.curvature_2);
    fill(to.direction_2);
    to.R_i = next();
    to.R_j = next();
    fill(to.major_axis);
    return to;
  }
  std::vector<std::int32_t> status;
  std::vector<std::vector<double>> values;
};

struct PairIndices {
  std::vector<std::int32_t> first, second;
};

/// All pairs of a crowd, so many of which touch, in an order that mixes the kinds.
PairIndices all_pairs(std::size_t bodies) {
  PairIndices pairs;
  for (std::size_t i = 0; i < bodies; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      pairs.first.push_back(static_cast<std::int32_t>((i + j) % 2 == 0 ? i : j));
      pairs.second.push_back(static_cast<std::int32_t>((i + j) % 2 == 0 ? j : i));
    }
  return pairs;
}

}  // namespace

TEST_CASE("The header is C99 and its ABI version that of the library") {
  CHECK(abi_version_seen_by_c() == OSCULATE_ABI_VERSION);
  CHECK(std::string(osculate_version()).size() >= 5);
}

TEST_CASE("One pair through C is the C++ answer bit for bit, cold and warm") {
  const Gap gap = GENERATE(Gap::resolve, Gap::skip);
  Crowd crowd(centimetre_shapes(), 12, 3);
  std::vector<ContactCache> caches(crowd.size() * crowd.size());
  std::vector<OddBytes> bytes(caches.size(), OddBytes(osculate_cache_size()));
  int touching = 0, warm = 0;
  for (int step = 0; step < 3; ++step) {
    for (std::size_t i = 0; i < crowd.size(); ++i)
      for (std::size_t j = 0; j < crowd.size(); ++j) {
        if (i == j) continue;
        const std::size_t pair = i * crowd.size() + j;
        warm += caches[pair].state != ContactCache::State::empty;
        const ContactGeometry expected =
            common_normal(crowd.shape(i), crowd.pose(i), crowd.shape(j), crowd.pose(j), caches[pair], gap);
        osculate_contact contact;
        const osculate_pose pose_1 = c_pose(crowd.pose(i)), pose_2 = c_pose(crowd.pose(j));
        REQUIRE(osculate_find_contact(crowd.handle(i), &pose_1, crowd.handle(j), &pose_2,
                                      gap == Gap::resolve ? OSCULATE_GAP_RESOLVE : OSCULATE_GAP_SKIP,
                                      bytes[pair].data(), &contact) == OSCULATE_OK);
        bytes[pair].move();
        REQUIRE(contact.status == static_cast<int>(expected.status));
        REQUIRE(numbers_of(contact) == numbers_of(expected));
        touching += contact.status == OSCULATE_TOUCHING;
      }
    crowd.move();
  }
  CHECK(touching > 100);
  CHECK(warm > 200);
}

TEST_CASE("Many pairs of all kinds through C are the C++ batch bit for bit, and the caches move") {
  std::vector<Shape> kinds = GENERATE(
      centimetre_shapes(),
      std::vector<Shape>{Ellipsoid{Vec3(0.012, 0.01, 0.008)}, Superquadric{Vec3(0.01, 0.01, 0.01), {4.0, 4.0}}});
  const Gap gap = GENERATE(Gap::resolve, Gap::skip);
  Crowd crowd(kinds, 36, 5);
  const PairIndices pairs = all_pairs(crowd.size());
  const std::size_t size = pairs.first.size();
  REQUIRE(size > 512);  // more than are worked on at a time
  OddBytes bytes(size * osculate_cache_size());
  ContactCaches caches;
  ContactColumns expected;
  ShapePairs placed;
  placed.resize(size);
  for (int step = 0; step < 3; ++step) {
    for (std::size_t k = 0; k < size; ++k) {
      const auto i = static_cast<std::size_t>(pairs.first[k]), j = static_cast<std::size_t>(pairs.second[k]);
      placed.set(k, crowd.shape(i), crowd.pose(i), crowd.shape(j), crowd.pose(j));
    }
    common_normals(placed, caches, expected, gap);
    Columns25 found(size);
    const osculate_contact_columns view = found.view();
    const osculate_bodies bodies = crowd.bodies();
    REQUIRE(osculate_find_contacts(&bodies, size, pairs.first.data(), pairs.second.data(),
                                   gap == Gap::resolve ? OSCULATE_GAP_RESOLVE : OSCULATE_GAP_SKIP, bytes.data(),
                                   &view) == OSCULATE_OK);
    bytes.move();
    for (std::size_t k = 0; k < size; ++k) {
      REQUIRE(found.status[k] == static_cast<int>(expected.statuses[k]));
      for (std::size_t c = 0; c < 25; ++c) REQUIRE(found.values[c][k] == expected.columns[c][k]);
    }
    crowd.move();
  }
}

TEST_CASE("Grains find all walls through C") {
  const Shape grain = Ellipsoid{Vec3(0.01, 0.012, 0.008)};
  const Shape wall = GENERATE(Shape(HalfSpace{}), Shape(Cylinder{0.05, Cylinder::Solid::inside}),
                              Shape(Cylinder{0.05, Cylinder::Solid::outside}), Shape(SphereContainer{0.05}));
  const ShapeHandle c_grain(grain), c_wall(wall);
  const Pose at{.position = Vec3(0.03, 0.02, 0.005), .orientation = Quat(0.8, 0.6, 0.0, 0.0)};
  const osculate_pose c_at = c_pose(at), c_origin = c_pose({});
  osculate_contact contact;
  REQUIRE(osculate_find_contact(c_wall.handle, &c_origin, c_grain.handle, &c_at, OSCULATE_GAP_RESOLVE, nullptr,
                                &contact) == OSCULATE_OK);
  CHECK(numbers_of(contact) == numbers_of(common_normal(wall, {}, grain, at)));
}

TEST_CASE("Columns that are not wanted are not written") {
  Crowd crowd(centimetre_shapes(), 6, 1);
  const PairIndices pairs = all_pairs(crowd.size());
  const osculate_bodies bodies = crowd.bodies();
  std::vector<std::int32_t> status(pairs.first.size(), -1);
  std::vector<double> overlap(status.size());
  osculate_contact_columns few{};
  few.status = status.data();
  few.overlap = overlap.data();
  REQUIRE(osculate_find_contacts(&bodies, status.size(), pairs.first.data(), pairs.second.data(), OSCULATE_GAP_RESOLVE,
                                 nullptr, &few) == OSCULATE_OK);
  Columns25 all(status.size());
  const osculate_contact_columns view = all.view();
  REQUIRE(osculate_find_contacts(&bodies, status.size(), pairs.first.data(), pairs.second.data(), OSCULATE_GAP_RESOLVE,
                                 nullptr, &view) == OSCULATE_OK);
  CHECK(status == all.status);
  CHECK(overlap == all.values[3]);
}

TEST_CASE("Wrong shapes are refused with a message, and nothing is made") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double axes[3] = {1e-3, 1e-3, 1e-3}, bad_axes[3] = {1e-3, nan, 1e-3};
  osculate_shape* shape = nullptr;
  const auto refused = [&](int error, int expected, const std::string& part) {
    CHECK(error == expected);
    CHECK(shape == nullptr);
    CHECK_THAT(osculate_error_message(), Catch::Contains(part));
  };
  refused(osculate_new_sphere(nan, &shape), OSCULATE_INVALID_INPUT, "osculate_new_sphere");
  refused(osculate_new_sphere(-1.0, &shape), OSCULATE_INVALID_INPUT, "expected");
  refused(osculate_new_sphere(1.0, nullptr), OSCULATE_NULL_POINTER, "shape: NULL");
  refused(osculate_new_ellipsoid(bad_axes, &shape), OSCULATE_INVALID_INPUT, "osculate_new_ellipsoid");
  refused(osculate_new_ellipsoid(nullptr, &shape), OSCULATE_NULL_POINTER, "half_axes");
  refused(osculate_new_superquadric(axes, 0.5, 2.0, &shape), OSCULATE_INVALID_INPUT, "osculate_new_superquadric");
  refused(osculate_new_cylinder(1.0, 7, &shape), OSCULATE_INVALID_INPUT, "OSCULATE_SOLID_OUTSIDE");
  refused(osculate_new_sphere_container(0.0, &shape), OSCULATE_INVALID_INPUT, "expected");
  const double normals[6] = {0, 0, 1, 0, 0, -1}, distances[2] = {1e-3, 1e-3};
  refused(osculate_new_potential_particle(2, normals, distances, 0.1, 1e-4, 2e-3, &shape), OSCULATE_INVALID_INPUT,
          "osculate_new_potential_particle");
  refused(osculate_new_potential_particle(2, nullptr, distances, 0.1, 1e-4, 2e-3, &shape), OSCULATE_NULL_POINTER,
          "normals");
  osculate_free_shape(nullptr);
}

TEST_CASE("Volume, inertia and bounds through C are those of C++; walls have none") {
  const Shape stone = samples::potential_stone();
  const ShapeHandle handle(stone), wall(Shape(HalfSpace{}));
  double volume, centroid[3], inertia[9], radius;
  REQUIRE(osculate_mass_properties(handle.handle, &volume, centroid, inertia) == OSCULATE_OK);
  const MassProperties expected = mass_properties(stone);
  CHECK(volume == expected.volume);
  CHECK(Eigen::Map<Vec3>(centroid) == expected.centroid);
  CHECK(Eigen::Map<Mat3>(inertia) == expected.inertia);
  REQUIRE(osculate_bounding_radius(handle.handle, &radius) == OSCULATE_OK);
  CHECK(radius == bounding_radius(stone));
  CHECK(osculate_mass_properties(wall.handle, &volume, nullptr, nullptr) == OSCULATE_INVALID_INPUT);
  REQUIRE(osculate_bounding_radius(wall.handle, &radius) == OSCULATE_OK);
  CHECK(std::isinf(radius));
}

TEST_CASE("A wrong pair is refused, and the message names it") {
  Crowd crowd(centimetre_shapes(), 6, 1);
  osculate_bodies bodies = crowd.bodies();
  std::int32_t first[] = {0, 1, 2}, second[] = {1, 2, 3};
  std::int32_t status[3];
  osculate_contact_columns contacts{};
  contacts.status = status;
  std::vector<unsigned char> caches(3 * osculate_cache_size());
  const auto find = [&] {
    return osculate_find_contacts(&bodies, 3, first, second, OSCULATE_GAP_RESOLVE, caches.data(), &contacts);
  };
  REQUIRE(find() == OSCULATE_OK);
  const auto refused = [&](int expected, const std::string& part) {
    CHECK(find() == expected);
    CHECK_THAT(osculate_error_message(), Catch::Contains(part));
  };
  SECTION("an index out of range") {
    second[1] = GENERATE(6, -1);
    refused(OSCULATE_INVALID_INPUT, "pair 1");
  }
  SECTION("a position that is not finite") {
    std::vector<double> x(6, std::numeric_limits<double>::infinity());
    bodies.position[0] = x.data();
    refused(OSCULATE_INVALID_INPUT, "pair 0, body 0");
  }
  SECTION("an orientation that is no rotation") {
    std::vector<double> w(6, GENERATE(2.0, std::numeric_limits<double>::quiet_NaN()));
    bodies.orientation[0] = w.data();
    refused(OSCULATE_INVALID_INPUT, "unit quaternion");
  }
  SECTION("a shape that is missing") {
    std::vector<const osculate_shape*> shapes(6, nullptr);
    bodies.shape = shapes.data();
    refused(OSCULATE_NULL_POINTER, "body 0");
  }
  SECTION("two walls") {
    const ShapeHandle wall{Shape(HalfSpace{})};
    std::vector<const osculate_shape*> shapes(6, wall.handle);
    bodies.shape = shapes.data();
    refused(OSCULATE_INVALID_INPUT, "two walls");
  }
  SECTION("columns that are missing") {
    bodies.orientation[3] = nullptr;
    refused(OSCULATE_NULL_POINTER, "bodies.orientation");
  }
  SECTION("half a vector") {
    double x[3];
    contacts.normal[0] = x;
    refused(OSCULATE_NULL_POINTER, "contacts.normal");
  }
  SECTION("no status") {
    contacts.status = nullptr;
    refused(OSCULATE_NULL_POINTER, "contacts.status");
  }
  SECTION("a cache that is none") {
    caches[osculate_cache_size()] = 99;
    refused(OSCULATE_INVALID_INPUT, "pair 1: a cache");
  }
}

TEST_CASE("One pair with wrong arguments is refused") {
  const ShapeHandle sphere{Shape(Sphere{0.01})};
  const osculate_pose origin = c_pose({});
  osculate_pose bad = origin;
  bad.position[1] = std::numeric_limits<double>::quiet_NaN();
  osculate_contact contact;
  const auto find = [&](const osculate_shape* shape, const osculate_pose* pose, int gap, osculate_contact* to) {
    return osculate_find_contact(sphere.handle, &origin, shape, pose, gap, nullptr, to);
  };
  CHECK(find(nullptr, &origin, OSCULATE_GAP_SKIP, &contact) == OSCULATE_NULL_POINTER);
  CHECK(find(sphere.handle, nullptr, OSCULATE_GAP_SKIP, &contact) == OSCULATE_NULL_POINTER);
  CHECK(find(sphere.handle, &origin, OSCULATE_GAP_SKIP, nullptr) == OSCULATE_NULL_POINTER);
  CHECK(find(sphere.handle, &bad, OSCULATE_GAP_SKIP, &contact) == OSCULATE_INVALID_INPUT);
  CHECK(find(sphere.handle, &origin, 2, &contact) == OSCULATE_INVALID_INPUT);
}

TEST_CASE("Each thread has its own message") {
  osculate_shape* shape = nullptr;
  CHECK(osculate_new_sphere(-1.0, &shape) == OSCULATE_INVALID_INPUT);
  const std::string here = osculate_error_message();
  std::string fresh = "?", there;
  std::thread([&] {
    fresh = osculate_error_message();
    osculate_shape* other = nullptr;
    osculate_new_cylinder(1.0, 7, &other);
    there = osculate_error_message();
  }).join();
  CHECK(fresh.empty());
  CHECK_THAT(there, Catch::Contains("osculate_new_cylinder"));
  CHECK(here == osculate_error_message());
}
