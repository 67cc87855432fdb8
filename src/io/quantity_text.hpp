#pragma once
// Quantities as people read them: six digits and the unit prefix that suits the size.

#include <string>
#include <string_view>

#include "osculate/core/types.hpp"

namespace osculate::io {

/// "2.31000 mm" for (2.31e-3, "m"); zero, infinities and what lies beyond pico and tera are written without a prefix.
std::string quantity_text(double value, std::string_view unit);

/// The prefixed unit that suits a value, and what one such unit is in the unprefixed one.
struct PrefixedUnit {
  std::string symbol;
  double size;
};
PrefixedUnit prefixed_unit(double value, std::string_view unit);

/// "( 1.20000, -0.500000,  3.00000)": three numbers in units of `scale`, `digits` behind the point.
std::string vector_text(const Vec3& vector, double scale, int digits);

}  // namespace osculate::io
