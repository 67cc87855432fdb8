#pragma once
// What the contact laws of a time step cost: batched against contact by contact, in the same run.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/stopwatch.hpp"

namespace osculate::app {

struct LawBenchSettings {
  std::size_t contacts = 2048;
  int repetitions = 31;
};

/// Times per contact.
struct LawTimes {
  std::string name;
  std::string path;  ///< how the contacts move
  Timing batched;
  std::optional<Timing> scalar;  ///< nothing for a law whose scalar form is not kept
};

std::vector<LawTimes> time_laws(const LawBenchSettings& settings);

}  // namespace osculate::app
