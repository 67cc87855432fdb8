#include "validation/flow/scenes.hpp"

#include "osculate/core/error.hpp"

namespace osculate::validation {

std::string varied(std::string_view scene, std::initializer_list<Replacement> replacements) {
  std::string text(scene);
  for (const Replacement& one : replacements) {
    const std::size_t place = text.find(one.from);
    if (place == std::string::npos || text.find(one.from, place + 1) != std::string::npos)
      throw InputError("variation of a scene",
                       (place == std::string::npos ? "nowhere " : "twice ") + std::string(one.from), "it once");
    text.replace(place, one.from.size(), one.to);
  }
  return text;
}

}  // namespace osculate::validation
