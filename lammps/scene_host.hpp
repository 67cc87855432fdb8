#pragma once
// A scene file on LAMMPS: box, atoms and styles are made from it.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/scene.hpp"
#include "lammps/lammps_headers.hpp"
#include "lammps/rank_pairs.hpp"

namespace osculate::lammps {

struct SceneOrders {
  std::uint64_t steps;        ///< to be run
  std::uint64_t frame_every;  ///< steps
  std::uint64_t row_every;    ///< steps between lines of numbers
  std::filesystem::path frames;
};

/// What the scene's own times say.
SceneOrders orders_of(const io::Scene& scene, const std::filesystem::path& folder);

/// Makes the folder. Throws InputError if it has results and they may not be overwritten.
std::filesystem::path ready_folder(const std::filesystem::path& folder, bool overwrite);
std::filesystem::path frames_path(const std::filesystem::path& folder);  ///< OVITO opens it
std::filesystem::path log_path(const std::filesystem::path& folder);

/// A LAMMPS that knows the styles of this room, with LAMMPS's own options.
std::unique_ptr<LAMMPS_NS::LAMMPS> start_lammps(MPI_Comm ranks, std::vector<std::string> options);

/// Box, atoms, styles and time step. Body k of the scene becomes the atom with the tag k + 1. Throws InputError for
/// what LAMMPS has no place for.
void build_scene(LAMMPS_NS::LAMMPS& lmp, const io::Scene& scene);

/// To the end, with frames and lines of numbers.
/// @pre the scene was built
void run_scene(LAMMPS_NS::LAMMPS& lmp, const SceneOrders& orders);

/// Goes on with a built scene where it is.
void advance(LAMMPS_NS::LAMMPS& lmp, std::uint64_t steps);

/// The scene's bodies as they are now, free ones by LAMMPS, on the first rank; nothing on the others.
std::vector<BodyStart> gather_bodies(LAMMPS_NS::LAMMPS& lmp, const Setup& setup);

/// Over all ranks, on the first one.
PairSums gather_sums(LAMMPS_NS::LAMMPS& lmp);

}  // namespace osculate::lammps
