#pragma once
// What went wrong with a pair, in words.

#include <string>

#include "dynamics/pair_chunk.hpp"

namespace osculate {

/// @param bodies  how the two bodies are called: "bodies 3 and 8"
/// @pre chunk.fault is not none
std::string fault_text(const PairChunk& chunk, const std::string& bodies);

}  // namespace osculate
