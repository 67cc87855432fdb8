#pragma once
// Everything a simulation needs to go on bit by bit where it was, as plain arrays with names.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace osculate {

struct StateArray {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::uint64_t>> values;
};

/// The arrays in a fixed order. To store and restore them as they are is enough.
struct State {
  std::vector<StateArray> arrays;

  /// Throws InputError if there is none of that name.
  const StateArray& at(std::string_view name) const;
};

}  // namespace osculate
