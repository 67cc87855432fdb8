#pragma once
// The first few ranks of a job on their own, while the others wait.

#include <mpi.h>

namespace osculate::lammps {

int rank_in(MPI_Comm ranks);
int size_of(MPI_Comm ranks);

/// All ranks come here. Those that wait leave their processor to the others.
void meet(MPI_Comm ranks);

/// The first `size` ranks of MPI_COMM_WORLD, all of which make it. To be gone before MPI is.
class RankGroup {
 public:
  explicit RankGroup(int size);
  RankGroup(const RankGroup&) = delete;
  RankGroup& operator=(const RankGroup&) = delete;
  ~RankGroup();

  int size() const { return size_; }
  bool has_me() const { return ranks_ != MPI_COMM_NULL; }
  MPI_Comm ranks() const { return ranks_; }

 private:
  int size_;
  MPI_Comm ranks_ = MPI_COMM_NULL;
};

}  // namespace osculate::lammps
