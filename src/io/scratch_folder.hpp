#pragma once
// A place for files that nobody needs afterwards.

#include <filesystem>
#include <string>

namespace osculate::io {

/// A folder that is gone, with all that is in it, when this is. Throws InputError where none can be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace osculate::io
