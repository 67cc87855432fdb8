#pragma once
// What the frames of results say of single particles.

#include <vector>

#include "io/results_file.hpp"

namespace osculate::io {

/// Throws InputError, naming the particle, for an index of a shape that the results do not have.
void require_shapes(const ParticleFrame& frame, const ResultsHead& head);

/// Where a particle's shape is.
Pose shape_pose_of(const ParticleFrame& frame, const ResultsHead& head, std::size_t particle);

/// Translational and rotational [J], one a particle. Throws InputError as above.
std::vector<double> kinetic_energies(const ParticleFrame& frame, const ResultsHead& head);

}  // namespace osculate::io
