#include "osculate/geometry/plane_contacts.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace osculate;
using Catch::Detail::Approx;

namespace {

const Superquadric grain{.half_axes = {3e-3, 2e-3, 1e-3}, .exponents = {2.0, 2.0}};
const Superquadric blocky{.half_axes = {3e-3, 2e-3, 1e-3}, .exponents = {5.0, 3.3}};
const Pose tilted{.position = {0.2, -0.1, 0.4}, .orientation = Quat(0.9, 0.1, -0.3, 0.2).normalized()};

/// So that the body's frame stands this high above the plane of `tilted`, turned with it.
Pose above(double height) {
  return {.position = tilted.to_world({0.01, 0.02, height}), .orientation = tilted.orientation};
}

ContactColumns contacts_of(const SuperquadricPairs& pairs) {
  ContactColumns contacts;
  plane_contacts(pairs, contacts);
  return contacts;
}

}  // namespace

TEST_CASE("An ellipsoid lies on a plane with the radii of its pole, a²/c and b²/c") {
  for (const double overlap : {1e-5, -1e-4}) {
    SuperquadricPairs pairs;
    pairs.resize(1);
    pairs.set(0, grain, above(1e-3 - overlap), half_space_numbers, tilted);
    const ContactGeometry contact = contacts_of(pairs).get(0);
    CHECK(contact.status == (overlap > 0.0 ? ContactStatus::touching : ContactStatus::separated));
    CHECK(contact.overlap == Approx(overlap).margin(1e-15));
    CHECK((contact.normal + tilted.rotate_to_world(Vec3::UnitZ())).norm() < 1e-15);
    CHECK((contact.on_1 - tilted.to_world({0.01, 0.02, -overlap})).norm() < 1e-15);
    CHECK((contact.on_2 - tilted.to_world({0.01, 0.02, 0.0})).norm() < 1e-15);
    CHECK(contact.relative.R_i == Approx(9e-3).epsilon(1e-13));
    CHECK(contact.relative.R_j == Approx(4e-3).epsilon(1e-13));
    CHECK(std::fabs(contact.relative.major_axis.dot(tilted.rotate_to_world(Vec3::UnitX()))) == Approx(1.0));
    CHECK(contact.curvature_1.max == Approx(1.0 / 4e-3).epsilon(1e-13));
    CHECK(contact.curvature_2.max == 0.0);
  }
}

TEST_CASE("A pair on a plane has the same bits alone, among others, and turned round") {
  SuperquadricPairs pairs;
  constexpr std::size_t count = 11;
  pairs.resize(2 * count);
  const auto pose = [](std::size_t i) {
    const double turn = 0.3 * static_cast<double>(i);
    return Pose{.position = tilted.to_world({0.0, 0.0, 1e-3}),
                .orientation = Quat(Eigen::AngleAxisd(turn, Vec3(1.0, 2.0, -0.5).normalized()))};
  };
  for (std::size_t i = 0; i < count; ++i) {
    pairs.set(i, blocky, pose(i), half_space_numbers, tilted);
    pairs.set(count + i, half_space_numbers, tilted, blocky, pose(i));
  }
  const ContactColumns contacts = contacts_of(pairs);
  for (std::size_t i = 0; i < count; ++i) {
    SuperquadricPairs one;
    one.resize(1);
    one.set(0, blocky, pose(i), half_space_numbers, tilted);
    const ContactGeometry alone = contacts_of(one).get(0), among = contacts.get(i), swapped = contacts.get(count + i);
    CHECK(alone.overlap == among.overlap);
    CHECK(alone.on_1 == among.on_1);
    CHECK(alone.relative.R_i == among.relative.R_i);
    CHECK(swapped.overlap == among.overlap);
    CHECK(swapped.normal == -among.normal);
    CHECK(swapped.on_2 == among.on_1);
    CHECK(swapped.on_1 == among.on_2);
    CHECK(swapped.curvature_2.max == among.curvature_1.max);
    CHECK(swapped.curvature_1.max == 0.0);
    CHECK(swapped.relative.R_j == among.relative.R_j);
  }
}

TEST_CASE("A pose that is not finite makes its own contact with a plane degenerate, and no other") {
  SuperquadricPairs pairs;
  pairs.resize(2);
  Pose nowhere = above(0.0);
  nowhere.position.x() = std::numeric_limits<double>::quiet_NaN();
  pairs.set(0, blocky, nowhere, half_space_numbers, tilted);
  pairs.set(1, blocky, above(0.9e-3), half_space_numbers, tilted);
  const ContactColumns contacts = contacts_of(pairs);
  CHECK(contacts.statuses[0] == ContactStatus::degenerate);
  CHECK(contacts.get(0).overlap == 0.0);
  CHECK(contacts.get(0).on_1 == Vec3::Zero());
  CHECK(contacts.statuses[1] == ContactStatus::flat);
  CHECK(contacts.get(1).overlap == Approx(0.1e-3));
}

TEST_CASE("Two superquadrics, or two half-spaces, are no contact with a plane") {
  SuperquadricPairs pairs;
  pairs.resize(2);
  pairs.set(0, blocky, above(0.5e-3), blocky, tilted);
  pairs.set(1, half_space_numbers, above(0.5e-3), half_space_numbers, tilted);
  const ContactColumns contacts = contacts_of(pairs);
  for (const std::size_t i : {0U, 1U}) {
    CHECK(contacts.statuses[i] == ContactStatus::degenerate);
    CHECK(contacts.get(i).overlap == 0.0);
    CHECK(contacts.get(i).normal == Vec3::Zero());
  }
}
