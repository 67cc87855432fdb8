#pragma once
// LAMMPS's headers, and what they want of a libfmt older than Debian's. All files of this room include them from here.

#include <fmt/format.h>
#include <mpi.h>

namespace fmt {
template <class... Args, class Text>
auto make_args_checked(const Text&, const std::remove_reference_t<Args>&... args) {
  return fmt::make_format_args(args...);
}
}  // namespace fmt

#include <lammps/lammps.h>
// The one above comes first.
#include <lammps/atom.h>
#include <lammps/comm.h>
#include <lammps/domain.h>
#include <lammps/error.h>
#include <lammps/fix.h>
#include <lammps/force.h>
#include <lammps/input.h>
#include <lammps/memory.h>
#include <lammps/modify.h>
#include <lammps/neigh_list.h>
#include <lammps/neighbor.h>
#include <lammps/pair.h>
#include <lammps/update.h>

#include <source_location>
#include <string>

namespace osculate::lammps {

// LAMMPS was built with its own libfmt: of its error functions only those that take a whole std::string are in the
// library.

/// Ends the run with a message, on all ranks together: every rank must come here.
[[noreturn]] inline void stop_all(LAMMPS_NS::Error* error, const std::string& what,
                                  const std::source_location& where = std::source_location::current()) {
  error->all(where.file_name(), static_cast<int>(where.line()), what);
}
/// The same, from one rank.
[[noreturn]] inline void stop_one(LAMMPS_NS::Error* error, const std::string& what,
                                  const std::source_location& where = std::source_location::current()) {
  error->one(where.file_name(), static_cast<int>(where.line()), what);
}

}  // namespace osculate::lammps
