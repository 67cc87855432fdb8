#include "app/lammps_program.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <system_error>

#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* program_name = "osculate-lammps";

std::optional<fs::path> find_program() {
  std::vector<fs::path> folders;
  std::error_code unknown;
  const fs::path self = fs::read_symlink("/proc/self/exe", unknown);
  if (!unknown) folders.push_back(self.parent_path());
  const char* const variable = std::getenv("PATH");
  std::istringstream path(variable == nullptr ? "" : variable);
  for (std::string folder; std::getline(path, folder, ':');) folders.emplace_back(folder);
  for (const fs::path& folder : folders) {
    fs::path program = folder / program_name;
    if (fs::is_regular_file(program, unknown) && ::access(program.c_str(), X_OK) == 0) return program;
  }
  return std::nullopt;
}

}  // namespace

void become_lammps(std::vector<std::string> arguments) {
  const std::optional<fs::path> program = find_program();
  if (!program)
    throw InputError("--engine lammps", "found no program osculate-lammps beside this one or along PATH",
                     "an Osculate built with it: cmake -DOSCULATE_WITH_LAMMPS=ON, where LAMMPS and MPI are (Debian: "
                     "apt-get install liblammps-dev libopenmpi-dev openmpi-bin)");
  std::string name = program->string();
  std::vector<char*> pointers{name.data()};
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  ::execv(name.c_str(), pointers.data());
  throw InputError(name, "cannot be started (" + std::system_category().message(errno) + ")", "a program");
}

}  // namespace osculate::app
