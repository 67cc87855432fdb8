#pragma once
// The contacts' memory on its way between neighbour lists and ranks: travels with the atoms. The pair style makes this
// fix itself.

#include <vector>

#include "lammps/lammps_headers.hpp"
#include "lammps/rank_pairs.hpp"

namespace osculate::lammps {

class FixContacts : public LAMMPS_NS::Fix {
 public:
  FixContacts(LAMMPS_NS::LAMMPS* host, int count, char** arguments);
  ~FixContacts() override;

  int setmask() override;
  void init() override;
  /// Atoms may be others than they were when the last run ended: what they have was stowed then.
  void setup_pre_exchange() override { make_room(); }
  void pre_exchange() override;
  void post_run() override;
  void grow_arrays(int most) override { stowed_.resize(static_cast<std::size_t>(most)); }
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int index) override { stowed_[static_cast<std::size_t>(index)].clear(); }
  int pack_exchange(int index, double* to) override;
  int unpack_exchange(int index, double* from) override;
  double memory_usage() override;

  const std::vector<StowedContacts>& stowed() const { return stowed_; }

 private:
  void make_room();

  std::vector<StowedContacts> stowed_;  ///< of each owned atom
};

}  // namespace osculate::lammps
