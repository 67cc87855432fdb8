#pragma once
// pair_style osculate: contacts between the bodies that LAMMPS's atoms stand for, by Osculate's narrow phase and laws.
//
//   pair_style osculate
//   pair_coeff * * scene.toml name …
// The file is a scene file (docs/scene-files.md): materials, interactions, particles, walls and obstacles are taken
// from it. One name of particles for every atom type.

#include <memory>
#include <optional>

#include "lammps/lammps_headers.hpp"
#include "lammps/rank_pairs.hpp"

namespace osculate::lammps {

class FixContacts;
class FixRigid;

class PairOsculate : public LAMMPS_NS::Pair {
 public:
  explicit PairOsculate(LAMMPS_NS::LAMMPS* host);
  ~PairOsculate() override;

  /// In place of pair_coeff, by a program: types 1, 2, … are the kinds in their order.
  void set_kinds(const Setup& setup, const std::vector<AtomKind>& kinds);

  void settings(int count, char** arguments) override;
  void coeff(int count, char** arguments) override;
  void init_style() override;
  double init_one(int type_1, int type_2) override;
  void compute(int eflag, int vflag) override;
  int pack_forward_comm(int count, int* atoms, double* to, int pbc_flag, int* pbc) override;
  void unpack_forward_comm(int count, int first, double* from) override;
  double memory_usage() override;

  /// Contacts go with their atoms.
  void stow(std::vector<StowedContacts>& atoms);
  void set_contacts_fix(FixContacts* fix) { contacts_ = fix; }
  void set_rigid_fix(FixRigid* fix) { rigid_ = fix; }
  RankBodies& rank() { return *rank_; }
  PairSums pair_sums() const { return pairs_.sums(); }  ///< of this rank
  std::uint64_t lists() const { return lists_; }        ///< of pairs, made so far
  double time() const;                                  ///< [s]
  /// A ball around the box.
  std::pair<Vec3, double> extent() const;

 private:
  void relist();
  void start_records();
  void collect();
  void tally_virial();
  [[noreturn]] void stop_at(const PairChunk& chunk);

  std::optional<RankBodies> rank_;
  RankPairs pairs_;
  std::uint64_t lists_ = 0;
  FixContacts* contacts_ = nullptr;
  FixRigid* rigid_ = nullptr;
  std::vector<AtomPair> found_;
};

/// The pair style of a LAMMPS; stops it if there is none, saying who needs it.
PairOsculate& pair_of(LAMMPS_NS::LAMMPS* lmp, const char* who);

}  // namespace osculate::lammps
