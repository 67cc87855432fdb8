#include "dynamics/fault_text.hpp"

#include <cstdio>

namespace osculate {

std::string fault_text(const PairChunk& chunk, const std::string& bodies) {
  char overlap[32];
  std::snprintf(overlap, sizeof overlap, "%.6g m", chunk.fault_overlap);
  switch (chunk.fault) {
    case Fault::too_deep:
      return bodies + " overlap by " + overlap + ", more than a quarter of the smaller one's half width";
    case Fault::degenerate:
      return bodies + " have a pose that is not finite";
    case Fault::step_too_long:
      return "the time step is too long for the contact of " + bodies +
             ", which lasts less than six steps; see time_step_limits";
    case Fault::not_converged:
      return "no common normal was found for " + bodies;
    default:
      return "the contact law gave no answer for " + bodies + " at an overlap of " + overlap;
  }
}

}  // namespace osculate
