#pragma once
// The checks that every model's set-up makes of its numbers.

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate {

inline void require_positive(const std::string& where, const std::string& what, double value, const std::string& unit) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw InputError(where, what + " " + std::to_string(value), "a positive, finite value " + unit);
}

inline void require_not_negative(const std::string& where, const std::string& what, double value,
                                 const std::string& unit) {
  if (!(value >= 0.0) || !std::isfinite(value))
    throw InputError(where, what + " " + std::to_string(value), "a finite value of at least 0 " + unit);
}

inline void require_restitution(const std::string& where, double value) {
  if (!(value > 0.0 && value <= 1.0))
    throw InputError(where, "restitution " + std::to_string(value), "a value in (0, 1]");
}

/// Columns of one batch; asked in every step.
inline void require_columns(const char* where, std::size_t size, std::initializer_list<std::size_t> others) {
  for (const std::size_t other : others)
    if (other != size)
      throw InputError(where, "a column of " + std::to_string(other) + " values",
                       std::to_string(size) + " as in the first");
}

}  // namespace osculate
