#include "io/quantity_text.hpp"

#include <catch2/catch.hpp>
#include <limits>

using osculate::io::quantity_text;
using osculate::io::vector_text;

TEST_CASE("A quantity takes the prefix that leaves one to three digits before the point") {
  CHECK(quantity_text(2.31e-3, "m") == "2.31000 mm");
  CHECK(quantity_text(71e9, "Pa") == "71.0000 GPa");
  CHECK(quantity_text(-4.5e-7, "m") == "-450.000 nm");
  CHECK(quantity_text(1.0, "N") == "1.00000 N");
  CHECK(quantity_text(999.9999, "N") == "1.00000 kN");
  CHECK(quantity_text(1e-3, "m") == "1.00000 mm");
  CHECK(quantity_text(1e6, "Pa") == "1.00000 MPa");
}

TEST_CASE("Zero, infinity and what no prefix reaches are written without one") {
  CHECK(quantity_text(0.0, "N") == "0.00000 N");
  CHECK(quantity_text(std::numeric_limits<double>::infinity(), "m") == "inf m");
  CHECK(quantity_text(1e-20, "J") == "1.00000e-20 J");
}

TEST_CASE("Vectors line up whatever their signs, and zero has none") {
  CHECK(vector_text({1.2e-3, -0.5e-3, 0.0}, 1e-3, 3) == "( 1.200, -0.500,  0.000)");
  CHECK(vector_text({-0.0, -0.04, 1.0}, 1.0, 1) == "( 0.0,  0.0,  1.0)");
}
