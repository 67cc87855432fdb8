#pragma once
// A scene on LAMMPS on the first few ranks of a job, beside the same scene elsewhere.

#include "lammps/rank_group.hpp"
#include "lammps/scene_host.hpp"
#include "osculate/dynamics/simulation.hpp"

namespace osculate::lammps {

/// All ranks of the job make it and call it together; those outside the group wait.
class SceneOnRanks {
 public:
  SceneOnRanks(int ranks, const io::Scene& scene);

  int ranks() const { return group_.size(); }
  void advance(std::uint64_t steps);
  /// On the first rank; nothing elsewhere.
  std::vector<BodyStart> bodies(const Setup& setup) const;
  PairSums sums() const;
  std::uint64_t lists() const;  ///< of neighbours, made so far, on the first rank

 private:
  RankGroup group_;
  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp_;  ///< none outside the group
};

/// The same of the library's own engine.
std::vector<BodyStart> bodies_of(const Simulation& simulation);

}  // namespace osculate::lammps
