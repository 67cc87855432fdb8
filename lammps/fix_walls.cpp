#include "lammps/fix_walls.hpp"

#include "lammps/pair_osculate.hpp"

namespace osculate::lammps {
namespace {
constexpr const char* who = "fix osculate/walls";
}

FixWalls::FixWalls(LAMMPS_NS::LAMMPS* host, int count, char** arguments) : Fix(host, count, arguments) {
  if (count != 3) stop_all(error, "fix osculate/walls takes no arguments");
  if (igroup != 0) stop_all(error, "fix osculate/walls acts on the group all");
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
}

int FixWalls::setmask() {
  return LAMMPS_NS::FixConst::POST_INTEGRATE;
}

void FixWalls::init() {
  RankBodies& rank = pair_of(lmp, who).rank();
  rank.driven_act = true;
  for (std::size_t i = 0; i < rank.driven; ++i)
    if (is_particle(rank.shape(i).shape) &&
        (domain->periodicity[0] || domain->periodicity[1] || domain->periodicity[2]))
      stop_all(error, "found obstacles in a periodic box; expected walls only, or a box that does not repeat");
}

/// Pairs are listed up to the skin: half of it is for the atoms.
void FixWalls::post_integrate() {
  const RankBodies& rank = pair_of(lmp, who).rank();
  for (std::size_t i = 0; i < rank.driven; ++i)
    if (rank.kinematics.travel[i] > 0.5 * neighbor->skin) next_reneighbor = update->ntimestep;
}

double FixWalls::compute_vector(int component) {
  const RankBodies& rank = pair_of(lmp, who).rank();
  double mine = 0.0, all = 0.0;
  for (std::size_t i = 0; i < rank.driven; ++i) mine += rank.bodies.force[i][component];
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

}  // namespace osculate::lammps
