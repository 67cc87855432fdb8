#pragma once
// Makes the styles of this room known to a LAMMPS.

#include "lammps/lammps_headers.hpp"

namespace osculate::lammps {

/// pair_style osculate; fix osculate/rigid, osculate/walls, osculate/contacts.
void add_styles(LAMMPS_NS::LAMMPS& lmp);

}  // namespace osculate::lammps
