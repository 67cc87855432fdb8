#include "lammps/fix_contacts.hpp"

#include <algorithm>

#include "lammps/pair_osculate.hpp"

namespace osculate::lammps {

FixContacts::FixContacts(LAMMPS_NS::LAMMPS* host, int count, char** arguments) : Fix(host, count, arguments) {
  if (count != 3) stop_all(error, "fix osculate/contacts takes no arguments");
  maxexchange_dynamic = 1;
  maxexchange = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(LAMMPS_NS::Atom::GROW);
}

FixContacts::~FixContacts() {
  atom->delete_callback(id, LAMMPS_NS::Atom::GROW);
}

int FixContacts::setmask() {
  return LAMMPS_NS::FixConst::PRE_EXCHANGE | LAMMPS_NS::FixConst::POST_RUN;
}

void FixContacts::init() {
  pair_of(lmp, "fix osculate/contacts").set_contacts_fix(this);
}

void FixContacts::pre_exchange() {
  post_run();
  make_room();
}

void FixContacts::post_run() {
  pair_of(lmp, "fix osculate/contacts").stow(stowed_);
}

/// For what the fullest atom packs.
void FixContacts::make_room() {
  std::size_t most = 0;
  for (int i = 0; i < atom->nlocal; ++i) most = std::max(most, stowed_[static_cast<std::size_t>(i)].size());
  maxexchange = static_cast<int>(most) + 1;
}

void FixContacts::copy_arrays(int from, int to, int) {
  stowed_[static_cast<std::size_t>(to)] = stowed_[static_cast<std::size_t>(from)];
}

int FixContacts::pack_exchange(int index, double* to) {
  const StowedContacts& stowed = stowed_[static_cast<std::size_t>(index)];
  *to++ = static_cast<double>(stowed.size());
  std::copy(stowed.begin(), stowed.end(), to);
  return static_cast<int>(stowed.size()) + 1;
}

int FixContacts::unpack_exchange(int index, double* from) {
  const auto length = static_cast<std::size_t>(*from++);
  stowed_[static_cast<std::size_t>(index)].assign(from, from + length);
  return static_cast<int>(length) + 1;
}

double FixContacts::memory_usage() {
  double bytes = 0.0;
  for (const StowedContacts& one : stowed_) bytes += static_cast<double>(sizeof(one) + one.capacity() * sizeof(double));
  return bytes;
}

}  // namespace osculate::lammps
