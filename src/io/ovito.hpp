#pragma once
// Results for OVITO: a LAMMPS-style dump of text, one block a frame.

#include <filesystem>
#include <functional>
#include <string>

#include "io/results_file.hpp"

namespace osculate::io {

/// How OVITO draws a particle: (|x/a|^(2/φ) + |y/b|^(2/φ))^(φ/θ) + |z/c|^(2/θ) = 1, its own form of a superquadric.
struct OvitoShape {
  Vec3 half_axes;            ///< a, b, c [m]: Aspherical Shape
  double phi, theta;         ///< Superquadric Roundness: φ = 2/n2 joins x to y, θ = 2/n1 joins z to them
  bool is_stand_in = false;  ///< true: the sphere of equal volume, for a shape that OVITO does not have
};
OvitoShape ovito_shape(const Shape& particle);

/// One frame as a block of the dump. OVITO finds by their names: id, type (the shape's index + 1), position, velocity,
/// angular velocity, half axes, orientation (x, y, z, w) and roundness. SI units.
std::string dump_block(const ParticleFrame& frame, const ResultsHead& head);

/// Writes all frames; the file appears whole or not at all. `written` is told after each frame how many are done.
void write_ovito(const ResultsFile& results, const std::filesystem::path& path,
                 const std::function<void(std::size_t)>& written);

}  // namespace osculate::io
