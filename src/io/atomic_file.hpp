#pragma once
// Files that appear whole or not at all: written beside their place under a temporary name, then renamed.

#include <cstdio>
#include <string>
#include <string_view>

namespace osculate::io {

/// A file under construction. Until `commit` the path keeps what it held before; without `commit` nothing changes.
/// Through a symbolic link the file it points to is replaced. Devices and pipes are written to as they are.
/// Every member throws InputError naming the path when the file system refuses.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  void write(std::string_view text);
  void commit();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  std::string temporary_;
  std::FILE* file_ = nullptr;
};

/// The whole content at once.
void write_atomically(const std::string& path, std::string_view content);

}  // namespace osculate::io
