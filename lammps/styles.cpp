#include "lammps/styles.hpp"

#include "lammps/fix_contacts.hpp"
#include "lammps/fix_rigid.hpp"
#include "lammps/fix_walls.hpp"
#include "lammps/pair_osculate.hpp"

namespace osculate::lammps {
namespace {

template <class Style>
LAMMPS_NS::Fix* make_fix(LAMMPS_NS::LAMMPS* lmp, int count, char** arguments) {
  return new Style(lmp, count, arguments);  // LAMMPS deletes it
}

LAMMPS_NS::Pair* make_pair(LAMMPS_NS::LAMMPS* lmp) {
  return new PairOsculate(lmp);  // LAMMPS deletes it
}

}  // namespace

void add_styles(LAMMPS_NS::LAMMPS& lmp) {
  (*lmp.force->pair_map)["osculate"] = &make_pair;
  auto& fixes = *lmp.modify->fix_map;
  fixes["osculate/contacts"] = &make_fix<FixContacts>;
  fixes["osculate/rigid"] = &make_fix<FixRigid>;
  fixes["osculate/walls"] = &make_fix<FixWalls>;
}

}  // namespace osculate::lammps
