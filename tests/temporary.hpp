#pragma once
// Tests run side by side, each in a process of its own: what they write lies in a folder with the process's number in
// its name, which goes when the process ends.

#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace osculate::test {

class TemporaryFolder {
 public:
  TemporaryFolder()
      : owner_(::getpid()),
        path_(std::filesystem::temp_directory_path() / ("osculate_test_" + std::to_string(owner_))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    if (::getpid() == owner_) std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  pid_t owner_;
  std::filesystem::path path_;
};

/// Where a test may write under this name; nothing is made or removed.
inline std::filesystem::path temporary(const std::string& name) {
  static const TemporaryFolder folder;
  return folder.path() / name;
}

/// A folder for the files of one test, empty.
inline std::filesystem::path fresh_folder(const std::string& name) {
  const auto folder = temporary(name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace osculate::test
