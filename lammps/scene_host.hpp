#pragma once
// A scene file on LAMMPS: box, atoms and styles are made from it.

#include <cstdint>
#include <string>

#include "io/scene.hpp"
#include "lammps/lammps_headers.hpp"

namespace osculate::lammps {

struct SceneOrders {
  std::uint64_t steps;       ///< to be run
  std::uint64_t dump_every;  ///< steps between frames
  std::uint64_t thermo_every;
  std::string dump;  ///< path of the frames that OVITO opens
};

/// What the scene's own times say.
SceneOrders orders_of(const io::Scene& scene);

/// Body k of the scene becomes the atom with the tag k + 1. Throws InputError for what LAMMPS has no place for.
void run_scene(LAMMPS_NS::LAMMPS& lmp, const io::Scene& scene, const SceneOrders& orders);

}  // namespace osculate::lammps
