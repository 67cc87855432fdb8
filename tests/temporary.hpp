#pragma once
// Tests run side by side, each in a process of its own: what they write has the process's number in its name.

#include <unistd.h>

#include <filesystem>
#include <string>

inline std::filesystem::path temporary(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("osculate_" + std::to_string(::getpid()) + "_" + name);
}
