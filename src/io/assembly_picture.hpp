#pragma once
// A picture of the particles of a simulation, in their true shapes, between their walls.

#include <string>
#include <vector>

#include "io/picture.hpp"
#include "io/results_file.hpp"
#include "io/wall_faces.hpp"

namespace osculate::io {

/// What the colour of a particle tells.
enum class ParticleColour { speed, kinetic_energy, id, shape };

/// What stays the same in all pictures of a simulation, so that they make an animation.
struct AssemblyLook {
  std::string title = {};
  ParticleColour colour = ParticleColour::speed;
  double most = 1.0;        ///< the upper end of the colour bar [m/s], [J]; values above keep its colour
  double azimuth = -60.0;   ///< of the viewer about z from x [deg]
  double elevation = 20.0;  ///< of the viewer above the x–y plane [deg], in (−90, 90)
  Box extent = {};          ///< of everything to be seen [m]
  int width = 1200;         ///< [px]
  int height = 900;
};

/// A box around all particles of a frame, by their bounding spheres, around drums that are not far larger,
/// and around the periodic box where it is finite.
/// Throws InputError for a frame without particles or with a shape that the results do not have.
Box extent_of(const ParticleFrame& frame, const ResultsHead& head);
Box united(const Box& one, const Box& other);

/// The speed [m/s] or kinetic energy [J] of every particle of a frame; nothing for the other colours.
std::vector<double> values_of(const ParticleFrame& frame, const ResultsHead& head, ParticleColour colour);

/// Throws InputError as above and for an elevation outside (−90, 90) degrees.
Picture assembly_picture(const ParticleFrame& frame, const ResultsHead& head, const AssemblyLook& look);

}  // namespace osculate::io
