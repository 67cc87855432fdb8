#pragma once
// Columns of numbers, texts and attributes in HDF5 files.

#include <cstdint>
#include <string>
#include <vector>

#include "io/hdf5_handle.hpp"
#include "osculate/core/types.hpp"

namespace osculate::io {

/// Numbers row by row.
template <class Number>
struct Rows {
  std::size_t width;  ///< of a row; 1 makes a column without a second dimension
  std::vector<Number> values;

  std::size_t size() const { return values.size() / width; }
};

/// The groups on the way are made as needed. Large ones are stored in chunks, shuffled and deflated. Each throws
/// std::runtime_error naming the path where HDF5 refuses.
void write_rows(hid_t file, const std::string& path, const Rows<double>& rows);
void write_rows(hid_t file, const std::string& path, const Rows<std::uint32_t>& rows);
void write_vectors(hid_t file, const std::string& path, const std::vector<Vec3>& vectors);
/// As w, x, y, z.
void write_rotations(hid_t file, const std::string& path, const std::vector<Quat>& rotations);
void write_text(hid_t file, const std::string& path, const std::string& text);
void write_number(hid_t object, const char* attribute, double value);
void write_count(hid_t object, const char* attribute, std::uint64_t value);

/// A column to which rows are appended.
void make_growing_column(hid_t file, const std::string& path);
void append_to_column(hid_t file, const std::string& path, const std::vector<double>& values);
void cut_column(hid_t file, const std::string& path, std::size_t rows);
std::size_t column_size(hid_t file, const std::string& path);

/// Throw if there is no such thing or it has another form.
Rows<double> read_rows(hid_t file, const std::string& path, std::size_t width);
Rows<std::uint32_t> read_indices(hid_t file, const std::string& path, std::size_t width);
std::vector<Vec3> read_vectors(hid_t file, const std::string& path);
std::vector<Quat> read_rotations(hid_t file, const std::string& path);
std::string read_text(hid_t file, const std::string& path);
double read_number(hid_t object, const char* attribute);
std::uint64_t read_count(hid_t object, const char* attribute);

bool has_path(hid_t file, const std::string& path);
/// Names of a group's members, sorted.
std::vector<std::string> members(hid_t file, const std::string& path);
Hdf5Handle make_group(hid_t file, const std::string& path);
Hdf5Handle open_group(hid_t file, const std::string& path);

}  // namespace osculate::io
