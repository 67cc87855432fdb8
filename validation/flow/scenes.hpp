#pragma once
// The example scenes of flow, and variations of them.

#include <initializer_list>
#include <string>
#include <string_view>

namespace osculate::validation {

/// examples/scenes/hopper.toml and angle-of-repose.toml, as they were when this was built.
std::string_view hopper_scene();
std::string_view repose_scene();

struct Replacement {
  std::string_view from;
  std::string to;
};
/// Throws InputError unless each `from` occurs exactly once.
std::string varied(std::string_view scene, std::initializer_list<Replacement> replacements);

}  // namespace osculate::validation
