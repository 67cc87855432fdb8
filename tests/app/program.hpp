#pragma once
// Runs the built program as a user would and keeps what it said.

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "temporary.hpp"

namespace osculate::test {

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Run {
  int exit_code;
  std::string out;
  std::string err;
};

/// `arguments` as typed into a shell whose current folder is `folder`.
inline Run run(const std::filesystem::path& folder, const std::string& arguments) {
  const auto out = folder / "stdout.txt";
  const auto err = folder / "stderr.txt";
  const std::string command = "cd '" + folder.string() + "' && " OSCULATE_PROGRAM " " + arguments + " > '" +
                              out.string() + "' 2> '" + err.string() + "'";
  const int status = std::system(command.c_str());
  Run result{.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .out = content_of(out), .err = content_of(err)};
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return result;
}

}  // namespace osculate::test
