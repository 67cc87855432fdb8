#pragma once
// osculate-lammps SCENE --validate and --bench: the library's own engine and LAMMPS beside each other, on 1, 2, 4 …
// ranks up to those of the job.

#include "io/scene.hpp"

namespace osculate::lammps {

/// Trajectories, then bulk results of several beginnings. Whether all agree, on the first rank; true on the others.
bool validate_engines(const io::Scene& scene, int beginnings);

/// Prints the times of a particle and step, and their ratios.
void bench_engines(const io::Scene& scene, int rounds, std::uint64_t steps);

}  // namespace osculate::lammps
