#include "io/hdf5_image.hpp"

#include <stdexcept>

#include "io/hdf5_handle.hpp"

namespace osculate::io {
namespace {

using Handle = Hdf5Handle;

void require(herr_t result) {
  require_hdf5(result, "write");
}

/// A property that makes the groups on the way to a new object.
hid_t new_way() {
  const hid_t way = H5Pcreate(H5P_LINK_CREATE);
  require(H5Pset_create_intermediate_group(way, 1));
  return way;
}

hid_t file_in_memory() {
  constexpr std::size_t grow_by = 1U << 20U;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_fapl_core(access, grow_by, 0));
  const hid_t file = H5Fcreate("image", H5F_ACC_TRUNC, H5P_DEFAULT, access);
  if (file < 0) throw std::runtime_error("HDF5 refused to make a file");
  return file;
}

}  // namespace

Hdf5Image::Hdf5Image() : file_(file_in_memory()) {}

Hdf5Image::~Hdf5Image() {
  H5Fclose(file_);
}

// NOLINTBEGIN(readability-make-member-function-const): these change the file behind the handle.
void Hdf5Image::add_group(const std::string& path) {
  const Handle way(new_way(), H5Pclose);
  const Handle group(H5Gcreate2(file_, path.c_str(), way, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
}

void Hdf5Image::add_numbers(const std::string& path, const std::vector<double>& values) {
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle way(new_way(), H5Pclose);
  const Handle data(H5Dcreate2(file_, path.c_str(), H5T_IEEE_F64LE, space, way, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  require(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

void Hdf5Image::set_text(const std::string& path, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, text.empty() ? 1 : text.size()));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate_by_name(file_, path.c_str(), name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, type, text.c_str()));
}
// NOLINTEND(readability-make-member-function-const)

std::string Hdf5Image::bytes() const {
  require(H5Fflush(file_, H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
  if (size < 0) throw std::runtime_error("HDF5 could not give its file");
  std::string image(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file_, image.data(), image.size()) != size)
    throw std::runtime_error("HDF5 could not give its file");
  return image;
}

}  // namespace osculate::io
