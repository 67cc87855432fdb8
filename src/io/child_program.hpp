#pragma once
// Programs of others that do a part of the work.

#include <string>
#include <vector>

namespace osculate::io {

/// A program to be found on the PATH.
struct ChildProgram {
  std::string name;
  std::string needed_for;      ///< "plot"
  std::string debian_package;  ///< that brings it
};

/// Runs it without input, waits, and returns what it wrote to its standard output. Throws InputError if it cannot be
/// run, std::runtime_error with its messages if it fails.
std::string run(const ChildProgram& program, const std::vector<std::string>& arguments);

}  // namespace osculate::io
