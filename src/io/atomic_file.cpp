#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "osculate/core/error.hpp"

namespace osculate::io {

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) throw InputError(path_, "this is a directory", "the name of a file to write");
  if (exists && !S_ISREG(status.st_mode)) {
    // A device or a pipe is written to, not replaced.
    file_ = std::fopen(path_.c_str(), "wb");
    if (file_ == nullptr) fail("cannot be opened");
    return;
  }
  // Through a link, the file it points to is the one to replace.
  if (exists) path_ = std::filesystem::canonical(path_).string();
  temporary_ = path_ + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary_.data());
  if (descriptor < 0) {
    temporary_.clear();
    fail("cannot be created");
  }
  // mkstemp makes the file private; give it what an ordinary new file would get.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, 0666 & ~mask);
  file_ = ::fdopen(descriptor, "wb");
  if (file_ == nullptr) {
    ::close(descriptor);
    ::unlink(temporary_.c_str());
    fail("cannot be opened");
  }
}

AtomicFile::~AtomicFile() {
  if (file_ != nullptr) std::fclose(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("cannot be written");
}

void AtomicFile::commit() {
  const bool is_temporary = !temporary_.empty();
  const bool flushed = std::fflush(file_) == 0 && (!is_temporary || ::fsync(::fileno(file_)) == 0);
  const bool closed = std::fclose(std::exchange(file_, nullptr)) == 0;
  if (!flushed || !closed) fail("cannot be written");
  if (!is_temporary) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot be put in its place");
  temporary_.clear();
}

void AtomicFile::fail(const char* what) const {
  throw InputError(path_, std::string(what) + " (" + std::strerror(errno) + ")", "a place where files can be written");
}

void write_atomically(const std::string& path, std::string_view content) {
  AtomicFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace osculate::io
