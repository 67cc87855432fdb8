#include "lammps/rank_group.hpp"

#include <chrono>
#include <thread>

namespace osculate::lammps {

int rank_in(MPI_Comm ranks) {
  int rank = 0;
  MPI_Comm_rank(ranks, &rank);
  return rank;
}

int size_of(MPI_Comm ranks) {
  int size = 0;
  MPI_Comm_size(ranks, &size);
  return size;
}

void meet(MPI_Comm ranks) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(ranks, &request);
  for (int all_here = 0;;) {
    MPI_Test(&request, &all_here, MPI_STATUS_IGNORE);
    if (all_here != 0) return;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

RankGroup::RankGroup(int size) : size_(size) {
  const int rank = rank_in(MPI_COMM_WORLD);
  MPI_Comm_split(MPI_COMM_WORLD, rank < size ? 0 : MPI_UNDEFINED, rank, &ranks_);
}

RankGroup::~RankGroup() {
  if (has_me()) MPI_Comm_free(&ranks_);
}

}  // namespace osculate::lammps
