#pragma once
// The way to LAMMPS. osculate-lammps is a program of its own: this one links neither LAMMPS, which is GPL, nor MPI.

#include <string>
#include <vector>

namespace osculate::app {

/// Becomes osculate-lammps with these arguments, in the same process, which MPI knows already. Throws InputError if
/// there is no such program beside this one or along PATH.
[[noreturn]] void become_lammps(std::vector<std::string> arguments);

}  // namespace osculate::app
