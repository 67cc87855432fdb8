#pragma once
// fix ID all osculate/rigid: moves all bodies freely, by the same splitting as the library's own engine.
//
// Orientations are the atom properties d_qw d_qx d_qy d_qz (body → world), made by this fix if fix property/atom has
// not made them before; four zeros are the identity. Mass and radius of each atom become those of its type. The fix's
// scalar is the rotational energy [J].

#include <array>
#include <vector>

#include "lammps/lammps_headers.hpp"
#include "osculate/core/types.hpp"

namespace osculate::lammps {

/// What a body's record holds besides place, and what the contact loop needs of it after a change of rank.
struct BodyMotion {
  static constexpr int doubles = 12;
  Vec3 velocity, mean_angular_velocity, last_velocity, last_angular_velocity;
};

class FixRigid : public LAMMPS_NS::Fix {
 public:
  FixRigid(LAMMPS_NS::LAMMPS* host, int count, char** arguments);
  ~FixRigid() override;

  int setmask() override;
  void post_constructor() override;
  void init() override;
  void initial_integrate(int vflag) override;
  void final_integrate() override;
  void pre_exchange() override;
  void grow_arrays(int most) override { motion_.resize(static_cast<std::size_t>(most)); }
  void copy_arrays(int from, int to, int) override;
  int pack_exchange(int index, double* to) override;
  int unpack_exchange(int index, double* from) override;
  double compute_scalar() override;
  double memory_usage() override;

  Quat orientation(int index) const;
  void set_orientation(int index, const Quat& q);
  const BodyMotion& motion(int index) const { return motion_[static_cast<std::size_t>(index)]; }

 private:
  void find_orientations();

  std::array<int, 4> orientation_{};  ///< w, x, y, z among the atoms' properties
  std::vector<BodyMotion> motion_;    ///< of each owned atom, while atoms change ranks
};

}  // namespace osculate::lammps
