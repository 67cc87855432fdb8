#pragma once
// Where each equation of the review [KDY23] lives in the library, and which test holds it.

#include <array>
#include <string_view>

#include "io/table.hpp"

namespace osculate::validation::kildashti2023 {

inline constexpr int equations = 93;

struct Coverage {
  int equation;
  std::string_view function;  ///< what carries the equation's key in its public comment, in namespace osculate
  std::string_view test;      ///< name of the test case
};

/// Every equation, in order. The tests hold this against the public headers and against the tests' own names.
const std::array<Coverage, equations>& coverage();

/// equation | function | test, neighbours with the same function and test in one line.
io::Table coverage_table();

}  // namespace osculate::validation::kildashti2023
