#include "io/contact_file.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "osculate/core/error.hpp"
#include "temporary.hpp"

namespace {

using Catch::Contains;
using osculate::io::read_contact_file;
using osculate::test::temporary;

/// Lines 1–4 and 5–9 of every test file: what a test leaves alone.
const std::string body_1 =
    "length_unit = \"mm\"\n"
    "[body_1]\n"
    "shape = {kind = \"sphere\", radius = 2}\n"
    "material = \"glass\"\n";
const std::string body_2 =
    "[body_2]\n"
    "shape = {kind = \"superquadric\", half_axes = [3, 2, 1], n = [4, 2]}\n"
    "position = [0, 0, 2.9]\n"
    "orientation = [1, 0, 0, 0]\n"
    "material = {youngs_modulus = \"3 GPa\", poissons_ratio = 0.4}\n";

std::filesystem::path file(const std::string& text) {
  const auto path = temporary("contact_test.toml");
  std::ofstream(path) << text;
  return path;
}

/// The good file with one piece of text replaced by another.
std::string replaced(const std::string& from, const std::string& to) {
  std::string text = body_1 + body_2;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& text) {
  try {
    read_contact_file(file(text));
  } catch (const osculate::InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("A contact file gives shapes, poses and materials in SI") {
  const auto contact = read_contact_file(file(body_1 + body_2));
  CHECK(std::get<osculate::Sphere>(contact.body_1.shape).radius == Approx(2e-3).epsilon(1e-15));
  CHECK(contact.body_1.pose.position == osculate::Vec3::Zero());
  CHECK(contact.body_1.material.youngs_modulus == 71e9);
  CHECK(contact.body_1.material_name == "glass");
  const auto& shape = std::get<osculate::Superquadric>(contact.body_2.shape);
  CHECK(shape.half_axes.y() == Approx(2e-3).epsilon(1e-15));
  CHECK(shape.exponents.n1 == 4.0);
  CHECK(contact.body_2.pose.position.z() == Approx(2.9e-3).epsilon(1e-15));
  CHECK(contact.body_2.material.youngs_modulus == Approx(3e9).epsilon(1e-15));
  CHECK(std::isinf(contact.radius_cap));
}

TEST_CASE("An orientation by axis and angle is the rotation by that many degrees") {
  const auto contact = read_contact_file(file(replaced("[1, 0, 0, 0]", "{axis = [0, 0, 2], angle = 90}")));
  const osculate::Vec3 turned = contact.body_2.pose.rotate_to_world({1, 0, 0});
  CHECK((turned - osculate::Vec3(0, 1, 0)).norm() < 1e-15);
  const auto radians = read_contact_file(file(replaced("[1, 0, 0, 0]", "{axis = [0, 0, 2], angle = \"1.5 rad\"}")));
  CHECK(radians.body_2.pose.rotate_to_world({1, 0, 0}).x() == Approx(std::cos(1.5)).epsilon(1e-14));
}

TEST_CASE("Every example among the contact files can be read") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(OSCULATE_EXAMPLES_DIR "/contacts")) {
    INFO(entry.path());
    CHECK_NOTHROW(read_contact_file(entry.path()));
    ++count;
  }
  CHECK(count >= 4);
}

TEST_CASE("A bad contact file is refused with file, line, key, what was found and what was expected") {
  CHECK_THAT(error_of(replaced("orientation", "orientatoin")),
             Contains("contact_test.toml:8") && Contains("orientatoin") && Contains("orientation"));
  CHECK_THAT(error_of(replaced("[1, 0, 0, 0]", "[1, 0, 0, 0.1]")),
             Contains("contact_test.toml:8") && Contains("body_2.orientation") && Contains("unit quaternion"));
  CHECK_THAT(error_of(replaced("[1, 0, 0, 0]", "{axis = [0, 0, 0], angle = 3}")),
             Contains("axis") && Contains("a direction"));
  CHECK_THAT(error_of(replaced("2.9]", "nan]")), Contains(":7:") && Contains("position") && Contains("nan"));
  CHECK_THAT(error_of(replaced("[3, 2, 1]", "[3, -2, 1]")),
             Contains(":6:") && Contains("half_axes") && Contains("-0.002"));
  CHECK_THAT(error_of(replaced("n = [4, 2]", "n = [4, 1]")), Contains(":6:") && Contains("64"));
  CHECK_THAT(error_of(replaced("material = \"glass\"\n", "")), Contains("body_1") && Contains("material"));
  CHECK_THAT(error_of(replaced("\"glass\"", "\"glas\"")), Contains(":4:") && Contains("glass") && Contains("steel"));
  CHECK_THAT(error_of(replaced("poissons_ratio = 0.4", "poissons_ratio = 0.6")), Contains(":9:") && Contains("0.5"));
  CHECK_THAT(error_of(body_1), Contains("body_2"));
  CHECK_THAT(error_of(replaced("\"mm\"", "\"mn\"")), Contains(":1:") && Contains("length_unit") && Contains("mm"));
  CHECK_THROWS_WITH(read_contact_file("no_such_contact.toml"), Contains("no_such_contact.toml"));
}

TEST_CASE("Slips of the unit are flagged where the numbers become absurd") {
  // GPa left out: 3 Pa is softer than anything that keeps a form.
  CHECK_THAT(error_of(replaced("\"3 GPa\"", "3")), Contains("youngs_modulus") && Contains("GPa"));
  // Millimetres read as metres.
  CHECK_THAT(error_of(replaced("2.9]", "\"2.9 m\"]")).substr(0), Contains("no error"));
  CHECK_THAT(error_of(replaced("2.9]", "\"29 m\"]")),
             Contains(":7:") && Contains("position") && Contains("near each other"));
  CHECK_THAT(error_of(replaced("radius = 2}", "radius = \"200 m\"}")), Contains(":3:") && Contains("400 m across"));
}

TEST_CASE("Two walls have no contact") {
  const std::string wall = "shape = {kind = \"half_space\"}";
  std::string text = replaced("shape = {kind = \"sphere\", radius = 2}", wall);
  const std::string other = "shape = {kind = \"superquadric\", half_axes = [3, 2, 1], n = [4, 2]}";
  text.replace(text.find(other), other.size(), wall);
  CHECK_THAT(error_of(text), Contains("two walls") && Contains("at least one particle"));
}
