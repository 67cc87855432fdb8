#include "io/hdf5_columns.hpp"

#include <algorithm>
#include <array>

namespace osculate::io {
namespace {

constexpr hsize_t chunk_rows = 16384;
constexpr hsize_t growing_chunk_rows = 512;
constexpr hsize_t smallest_compressed = 64;  // rows; below, the headers weigh more
constexpr unsigned deflate_level = 4;

/// A property that makes the groups on the way to a new object.
Hdf5Handle new_way() {
  Hdf5Handle way(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  require_hdf5(H5Pset_create_intermediate_group(way, 1), "make groups");
  return way;
}

void compress(const Hdf5Handle& creation, const std::array<hsize_t, 2>& chunk, int rank) {
  require_hdf5(H5Pset_chunk(creation, rank, chunk.data()), "set chunks");
  require_hdf5(H5Pset_shuffle(creation), "set the shuffle filter");
  require_hdf5(H5Pset_deflate(creation, deflate_level), "set the deflate filter");
}

void write(hid_t file, const std::string& path, hid_t stored, hid_t given, std::size_t width, std::size_t count,
           const void* values) {
  const int rank = width == 1 ? 1 : 2;
  const std::array<hsize_t, 2> size{count, width};
  const Hdf5Handle space(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (count >= smallest_compressed) compress(creation, {std::min<hsize_t>(count, chunk_rows), width}, rank);
  const Hdf5Handle data(H5Dcreate2(file, path.c_str(), stored, space, new_way(), creation, H5P_DEFAULT), H5Dclose);
  if (count > 0) require_hdf5(H5Dwrite(data, given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write " + path);
}

template <class Number>
Rows<Number> read(hid_t file, const std::string& path, hid_t type, std::size_t width) {
  if (!has_path(file, path)) throw std::runtime_error("no " + path);
  const Hdf5Handle data(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(data), H5Sclose);
  std::array<hsize_t, 2> size{0, 1};
  const int rank = width == 1 ? 1 : 2;
  if (H5Sget_simple_extent_ndims(space) != rank || H5Sget_simple_extent_dims(space, size.data(), nullptr) != rank ||
      size[1] != width)
    throw std::runtime_error(path + " of another form than rows of " + std::to_string(width) + " numbers");
  Rows<Number> rows{width, std::vector<Number>(static_cast<std::size_t>(size[0]) * width)};
  if (size[0] > 0) require_hdf5(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.values.data()), "read " + path);
  return rows;
}

void write_attribute(hid_t object, const char* name, hid_t stored, hid_t given, const void* value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(object, name, stored, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require_hdf5(H5Awrite(attribute, given, value), std::string("write the attribute ") + name);
}

void read_attribute(hid_t object, const char* name, hid_t type, void* value) {
  if (H5Aexists(object, name) <= 0) throw std::runtime_error(std::string("no attribute ") + name);
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  require_hdf5(H5Aread(attribute, type, value), std::string("read the attribute ") + name);
}

Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require_hdf5(H5Tset_size(type, std::max<std::size_t>(size, 1)), "make a text type");
  require_hdf5(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
  return type;
}

}  // namespace

void write_rows(hid_t file, const std::string& path, const Rows<double>& rows) {
  write(file, path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, rows.width, rows.size(), rows.values.data());
}

void write_rows(hid_t file, const std::string& path, const Rows<std::uint32_t>& rows) {
  write(file, path, H5T_STD_U32LE, H5T_NATIVE_UINT32, rows.width, rows.size(), rows.values.data());
}

void write_vectors(hid_t file, const std::string& path, const std::vector<Vec3>& vectors) {
  Rows<double> rows{3, {}};
  rows.values.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) rows.values.insert(rows.values.end(), {v.x(), v.y(), v.z()});
  write_rows(file, path, rows);
}

void write_rotations(hid_t file, const std::string& path, const std::vector<Quat>& rotations) {
  Rows<double> rows{4, {}};
  rows.values.reserve(4 * rotations.size());
  for (const Quat& q : rotations) rows.values.insert(rows.values.end(), {q.w(), q.x(), q.y(), q.z()});
  write_rows(file, path, rows);
}

void write_text(hid_t file, const std::string& path, const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file, path.c_str(), type, space, new_way(), H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  require_hdf5(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.empty() ? "" : text.data()), "write " + path);
}

void write_number(hid_t object, const char* attribute, double value) {
  write_attribute(object, attribute, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

void write_count(hid_t object, const char* attribute, std::uint64_t value) {
  write_attribute(object, attribute, H5T_STD_U64LE, H5T_NATIVE_UINT64, &value);
}

void make_growing_column(hid_t file, const std::string& path) {
  const hsize_t none = 0, unlimited = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  compress(creation, {growing_chunk_rows, 1}, 1);
  const Hdf5Handle data(H5Dcreate2(file, path.c_str(), H5T_IEEE_F64LE, space, new_way(), creation, H5P_DEFAULT),
                        H5Dclose);
}

void append_to_column(hid_t file, const std::string& path, const std::vector<double>& values) {
  if (values.empty()) return;
  const hsize_t start = column_size(file, path), count = values.size(), end = start + count;
  const Hdf5Handle data(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  require_hdf5(H5Dset_extent(data, &end), "extend " + path);
  const Hdf5Handle space(H5Dget_space(data), H5Sclose);
  require_hdf5(H5Sselect_hyperslab(space, H5S_SELECT_SET, &start, nullptr, &count, nullptr), "select in " + path);
  const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  require_hdf5(H5Dwrite(data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()), "write " + path);
}

void cut_column(hid_t file, const std::string& path, std::size_t rows) {
  const hsize_t size = rows;
  const Hdf5Handle data(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  require_hdf5(H5Dset_extent(data, &size), "cut " + path);
}

std::size_t column_size(hid_t file, const std::string& path) {
  const Hdf5Handle data(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(data), H5Sclose);
  hsize_t size = 0;
  if (H5Sget_simple_extent_ndims(space) != 1 || H5Sget_simple_extent_dims(space, &size, nullptr) != 1)
    throw std::runtime_error(path + " of another form than a column");
  return static_cast<std::size_t>(size);
}

Rows<double> read_rows(hid_t file, const std::string& path, std::size_t width) {
  return read<double>(file, path, H5T_NATIVE_DOUBLE, width);
}

Rows<std::uint32_t> read_indices(hid_t file, const std::string& path, std::size_t width) {
  return read<std::uint32_t>(file, path, H5T_NATIVE_UINT32, width);
}

std::vector<Vec3> read_vectors(hid_t file, const std::string& path) {
  const Rows<double> rows = read_rows(file, path, 3);
  std::vector<Vec3> vectors(rows.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = Vec3(&rows.values[3 * i]);
  return vectors;
}

std::vector<Quat> read_rotations(hid_t file, const std::string& path) {
  const Rows<double> rows = read_rows(file, path, 4);
  std::vector<Quat> rotations(rows.size());
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const double* const q = &rows.values[4 * i];
    rotations[i] = Quat(q[0], q[1], q[2], q[3]);
  }
  return rotations;
}

std::string read_text(hid_t file, const std::string& path) {
  if (!has_path(file, path)) throw std::runtime_error("no " + path);
  const Hdf5Handle data(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle stored(H5Dget_type(data), H5Tclose);
  if (H5Tget_class(stored) != H5T_STRING || H5Tis_variable_str(stored) > 0)
    throw std::runtime_error(path + " of another form than a text");
  std::string text(H5Tget_size(stored), '\0');
  const Hdf5Handle type = text_type(text.size());
  require_hdf5(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "read " + path);
  if (text == std::string(1, '\0')) text.clear();
  return text;
}

double read_number(hid_t object, const char* attribute) {
  double value = 0.0;
  read_attribute(object, attribute, H5T_NATIVE_DOUBLE, &value);
  return value;
}

std::uint64_t read_count(hid_t object, const char* attribute) {
  std::uint64_t value = 0;
  read_attribute(object, attribute, H5T_NATIVE_UINT64, &value);
  return value;
}

bool has_path(hid_t file, const std::string& path) {
  for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', end + 1))
    if (end > 0 && H5Lexists(file, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
  return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> members(hid_t file, const std::string& path) {
  const Hdf5Handle group = open_group(file, path);
  std::vector<std::string> names;
  const H5L_iterate_t visit = [](hid_t, const char* name, const H5L_info_t*, void* into) -> herr_t {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return 0;
  };
  require_hdf5(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, visit, &names), "list " + path);
  std::sort(names.begin(), names.end());
  return names;
}

Hdf5Handle make_group(hid_t file, const std::string& path) {
  return {H5Gcreate2(file, path.c_str(), new_way(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
}

Hdf5Handle open_group(hid_t file, const std::string& path) {
  if (!has_path(file, path)) throw std::runtime_error("no group " + path);
  return {H5Gopen2(file, path.c_str(), H5P_DEFAULT), H5Gclose};
}

}  // namespace osculate::io
