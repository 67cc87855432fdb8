#pragma once
// An HDF5 file made in memory, so that it is written like every other file: whole or not at all.

#include <cstdint>
#include <string>
#include <vector>

namespace osculate::io {

/// Paths are absolute, "/group/name"; groups on the way are made as needed. Trouble inside HDF5 is a
/// std::runtime_error.
class Hdf5Image {
 public:
  Hdf5Image();
  Hdf5Image(const Hdf5Image&) = delete;
  Hdf5Image& operator=(const Hdf5Image&) = delete;
  ~Hdf5Image();

  /// A group that stands empty until something is put below it.
  void add_group(const std::string& path);
  void add_numbers(const std::string& path, const std::vector<double>& values);
  /// Attribute of an existing group or column, UTF-8.
  void set_text(const std::string& path, const char* name, const std::string& text);

  /// The file.
  std::string bytes() const;

 private:
  std::int64_t file_;
};

}  // namespace osculate::io
