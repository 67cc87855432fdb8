#include "io/toml_reader.hpp"

#include <catch2/catch.hpp>

#include "io/nearest_name.hpp"

using namespace osculate;
using Catch::Matchers::Contains;

namespace {

io::TomlTable file(const char* text) {
  return io::parse_toml(text, "grain.toml");
}

}  // namespace

TEST_CASE("A key is read with its type, range and unit") {
  const auto table = file("a = 2\nb = 1.5\nname = 'rice'\nwide = '3.5 mm'\nfar = 7\nq = [0.6, 0.8, 0, 0]\n");
  CHECK(table.number("a") == 2.0);
  CHECK(table.integer("a", 0, 3) == 2);
  CHECK(table.number("b", io::Range::positive()) == 1.5);
  CHECK(table.text("name") == "rice");
  CHECK(table.quantity("wide", io::length(), io::Range::positive()) == 3.5 * 1e-3);
  CHECK(table.quantity("far", io::length(), io::Range::positive(), "um") == 7.0 * 1e-6);
  CHECK(table.quaternion("q").w() == Approx(0.6));
  CHECK(table.number_or("absent", 4.0) == 4.0);
  CHECK_NOTHROW(table.reject_unknown_keys());
}

TEST_CASE("A wrong value is reported with file, line, column and key") {
  const auto table = file("# grain\na = 'two'\nb = -1.0\nc = nan\n[body]\naxes = [1.0, inf, 2.0]\nq = [1, 1, 0, 0]\n");
  CHECK_THROWS_WITH(table.number("a"), Contains("grain.toml:2:5: key a: found the string \"two\"; expected a number"));
  CHECK_THROWS_WITH(table.number("b", io::Range::positive()),
                    Contains("grain.toml:3:5: key b: found -1; expected a positive number"));
  CHECK_THROWS_WITH(table.number("c"), Contains("grain.toml:4:5: key c: found nan; expected a finite number"));
  const auto body = table.table("body");
  CHECK_THROWS_WITH(body.vector("axes"), Contains("grain.toml:6:14: key body.axes[1]: found inf"));
  CHECK_THROWS_WITH(body.numbers("axes", 2), Contains("key body.axes: found an array of 3 values"));
  CHECK_THROWS_WITH(body.quaternion("q"), Contains("grain.toml:7:5: key body.q") && Contains("norm 1.414214") &&
                                              Contains("unit quaternion [w, x, y, z]"));
  CHECK_THROWS_WITH(body.text("absent"), Contains("grain.toml:5:") && Contains("key body.absent: found no such key"));
  CHECK_THROWS_AS(table.table("a"), InputError);
}

TEST_CASE("A quantity in a unit of another kind is refused and the right units are named") {
  const auto table = file("E = '70 mm'\nF = '70'\nG = 'GPa'\n");
  for (const char* key : {"E", "F", "G"}) {
    CHECK_THROWS_WITH(table.quantity(key, io::pressure(), io::Range::positive()),
                      Contains("grain.toml:") && Contains("Pa, kPa, MPa, GPa"));
  }
}

TEST_CASE("A misspelt key is an error that suggests the nearest known key") {
  const auto table = file("half_axis = [1, 2, 3]\nkind = 'x'\n");
  CHECK_THROWS_WITH(table.vector("half_axes"),
                    Contains("grain.toml:1:13: key half_axes: found no such key, but the similar \"half_axis\""));
  CHECK(table.text("kind") == "x");
  CHECK_THROWS_WITH(table.reject_unknown_keys(),
                    Contains("grain.toml:1:1: key half_axis") && Contains("did you mean half_axes?"));
}

TEST_CASE("A word out of a closed list is suggested when nearly right") {
  const auto table = file("kind = 'elipsoid'\n");
  CHECK_THROWS_WITH(table.choice("kind", {"sphere", "ellipsoid"}),
                    Contains("grain.toml:1:8: key kind") && Contains("did you mean ellipsoid?"));
}

TEST_CASE("A file that is missing or no TOML says where") {
  CHECK_THROWS_WITH(io::read_toml("no/such/grain.toml"), Contains("no/such/grain.toml: found no such file"));
  CHECK_THROWS_WITH(file("a = 1\nb = = 2\n"), Contains("grain.toml:2:5") && Contains("valid TOML"));
}

TEST_CASE("Edit distance counts insertions, deletions, replacements and swaps once each") {
  CHECK(io::edit_distance("rice", "rice") == 0);
  CHECK(io::edit_distance("rice", "ice") == 1);
  CHECK(io::edit_distance("rice", "rcie") == 1);
  CHECK(io::edit_distance("tablet", "table") == 1);
  CHECK(io::edit_distance("", "abc") == 3);
}
