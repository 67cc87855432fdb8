#pragma once
// Random packings without gravity, floor or friction: particles in a periodic cube that shrinks until they jam.

#include <cstdint>
#include <functional>

#include "osculate/shapes/shape.hpp"

namespace osculate::validation {

struct PackingRecipe {
  Shape shape;              ///< of any size: only its form matters
  std::uint64_t particles;  ///< > 0
  std::uint64_t seed;
};

struct JammedPacking {
  double fraction;            ///< of the cell that the particles would fill without overlaps, N V / L³
  double fraction_by_points;  ///< of a lattice of points that lie inside particles: overlaps count once
  double coordination;        ///< contacts of a particle that is held, with others that are
  double rattlers;            ///< share of the particles that are not held
  double pressure;            ///< over Young's modulus
};

/// Contacts that hold a particle: fewer leave it a way out.
inline constexpr int holding_contacts = 4;

/// Particles start at random, apart and on the move. Whenever their contacts carry less pressure than 1e-5 of Young's
/// modulus the cube shrinks a little, fast as long as there is room; it is done when that pressure stays and the motion
/// has died away to a twentieth of the elastic energy.
/// @param done  is told now and then how far it is, 0 to 1
/// Throws std::runtime_error if the particles have not jammed after a million steps.
JammedPacking jam(const PackingRecipe& recipe, const std::function<void(double)>& done = {});

}  // namespace osculate::validation
