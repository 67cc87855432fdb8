#include "lammps/scene_on_ranks.hpp"

#include "lammps/pair_osculate.hpp"

namespace osculate::lammps {

SceneOnRanks::SceneOnRanks(int ranks, const io::Scene& scene) : group_(ranks) {
  if (group_.has_me()) {
    lmp_ = start_lammps(group_.ranks(), {"-log", "none", "-screen", "none"});
    build_scene(*lmp_, scene);
  }
  meet(MPI_COMM_WORLD);
}

void SceneOnRanks::advance(std::uint64_t steps) {
  if (lmp_) lammps::advance(*lmp_, steps);
  meet(MPI_COMM_WORLD);
}

std::vector<BodyStart> SceneOnRanks::bodies(const Setup& setup) const {
  if (!lmp_) return {};
  return gather_bodies(*lmp_, setup);
}

PairSums SceneOnRanks::sums() const {
  if (!lmp_) return {};
  return gather_sums(*lmp_);
}

std::uint64_t SceneOnRanks::lists() const {
  return lmp_ ? pair_of(lmp_.get(), "a scene").lists() : 0;
}

std::vector<BodyStart> bodies_of(const Simulation& simulation) {
  std::vector<BodyStart> starts = simulation.setup().bodies;
  const Bodies& bodies = simulation.bodies();
  for (std::size_t i = 0; i < starts.size(); ++i) {
    starts[i].pose = bodies.pose(i);
    starts[i].velocity = bodies.velocity[i];
    starts[i].angular_velocity = bodies.angular_velocity(i);
  }
  return starts;
}

}  // namespace osculate::lammps
