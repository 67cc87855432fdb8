#pragma once
// The bodies that one rank knows, in the form in which the contact loop wants them: driven bodies, which every rank
// has, then LAMMPS's atoms by their local index, owned ones first.

#include <cstdint>
#include <string>
#include <vector>

#include "dynamics/kinematics.hpp"
#include "dynamics/world.hpp"
#include "io/scene.hpp"

namespace osculate::lammps {

/// What an atom type stands for.
struct AtomKind {
  std::int32_t shape;     ///< index into Setup::shapes
  std::int32_t material;  ///< index into Setup::materials
};

/// Throws InputError for what only the embedded engine does: pours, meshes, sheared boxes.
void require_supported(const Setup& setup);

/// The kinds that a setup's free bodies are of, in the order of their shapes.
std::vector<AtomKind> kinds_of(const Setup& setup);

/// The kind of every name: those of the scene's particles. Throws InputError for a name that is none.
std::vector<AtomKind> kinds_by_name(const io::Scene& scene, const std::vector<std::string>& names);

struct RankBodies {
  World world;                  ///< its bodies are the driven ones, then one of each kind
  std::vector<AtomKind> kinds;  ///< of LAMMPS's types 1, 2, …
  std::size_t driven = 0;       ///< bodies at the front
  bool driven_act = false;      ///< whether the driven bodies are there at all
  std::size_t owned = 0, ghosts = 0;
  Bodies bodies;
  Kinematics kinematics;
  std::vector<double> radius;  ///< of the bounding spheres [m]
  std::vector<double> way;     ///< of any point of a body in the last step, at most [m]

  std::size_t index(int atom) const { return driven + static_cast<std::size_t>(atom); }
  bool is_driven(std::size_t body) const { return body < driven; }
  bool is_owned(std::size_t body) const { return body >= driven && body < driven + owned; }
  const BodyShape& shape(std::size_t body) const { return world.shapes[static_cast<std::size_t>(bodies.shape[body])]; }
  double density(const AtomKind& kind) const {
    return world.setup.materials[static_cast<std::size_t>(kind.material)].density;
  }
};

/// Throws InputError if the setup's laws do not cover the kinds.
RankBodies make_rank_bodies(Setup setup, const std::vector<AtomKind>& kinds);

/// Room for the atoms of a new neighbour list; `types` are LAMMPS's. Travels begin at zero.
void set_atoms(RankBodies& rank, std::size_t owned, std::size_t ghosts, const int* types);

/// Puts the driven bodies where they are at time t; a step that leads there has the length dt, 0 at the start.
/// @param far  no atom is further than this from `centre` [m]
void place_driven(RankBodies& rank, double t, double dt, const Vec3& centre, double far);

}  // namespace osculate::lammps
