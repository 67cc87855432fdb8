#pragma once
// fix ID all osculate/walls: the walls and obstacles of the pair style's scene file act, with their motions. The fix's
// vector is the force on them all [N].

#include "lammps/lammps_headers.hpp"

namespace osculate::lammps {

class FixWalls : public LAMMPS_NS::Fix {
 public:
  FixWalls(LAMMPS_NS::LAMMPS* host, int count, char** arguments);

  int setmask() override;
  void init() override;
  void post_integrate() override;
  double compute_vector(int component) override;
};

}  // namespace osculate::lammps
