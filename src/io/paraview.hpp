#pragma once
// Results for ParaView: particles in their true shapes.

#include <cstddef>
#include <filesystem>
#include <functional>

#include "io/results_file.hpp"

namespace osculate::io {

/// One frame as a VTK PolyData file (.vtp): the surfaces of all particles as triangles. On every point stand the
/// particle's id, shape, speed [m/s], velocity [m/s], angular_velocity [rad/s] and kinetic_energy [J], and the
/// surface's normal. Lengths in metres, 32 bits a number.
/// @param resolution  of the meshes, see surface_mesh
std::string particle_surfaces(const ParticleFrame& frame, const ResultsHead& head, int resolution);

/// Writes frames as a time series: `path`, which must end in .pvd, names the moments and a file for each in a folder
/// beside it. `written` is told after each frame how many are done.
/// Throws InputError for another ending and a place that cannot be written to.
void write_paraview(const ResultsFile& results, int resolution, const std::filesystem::path& path,
                    const std::function<void(std::size_t)>& written);

}  // namespace osculate::io
