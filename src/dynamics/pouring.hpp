#pragma once
// The particles of a pour whose time has come.

#include <vector>

#include "dynamics/world.hpp"

namespace osculate {

/// A pour looks for places once in so many steps: each time something comes in, pairs are listed anew.
inline constexpr std::uint64_t steps_between_pours = 10;

/// Those that are due and find a place between the bodies, in their order; `poured` counts them. What the numbers and
/// the seed make of particle k, and where it looks in a step, does not depend on what happened before.
std::vector<BodyStart> poured_now(const World& world, const Bodies& bodies, const Pour& pour, std::uint64_t step,
                                  Poured& poured);

/// Throws InputError with what is wrong.
void check_pour(const Setup& setup, const Pour& pour, const std::string& where);

}  // namespace osculate
