#pragma once
// Errors at the edges: wrong input is an exception that says what was wrong, where, and what was expected.

#include <stdexcept>
#include <string>

namespace osculate {

/// Wrong input. `what()` reads "<where>: <what was found>; expected <expected>".
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& where, const std::string& found, const std::string& expected)
      : std::runtime_error((where.empty() ? "" : where + ": ") + found + "; expected " + expected) {}

  /// An error met further inside, with the place that led there.
  InputError(const std::string& where, const InputError& cause) : std::runtime_error(where + ": " + cause.what()) {}
};

}  // namespace osculate
