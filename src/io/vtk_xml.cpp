#include "io/vtk_xml.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <stdexcept>

namespace osculate::io {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say that they are little-endian");

template <class Number>
std::string_view raw(const std::vector<Number>& values) {
  return {reinterpret_cast<const char*>(values.data()), sizeof(Number) * values.size()};
}

/// Blocks of a megabyte, compressed one by one, after a table of their sizes.
std::string compressed(std::string_view raw) {
  constexpr std::size_t block = 1U << 20U;
  const std::size_t blocks = (raw.size() + block - 1) / block;
  std::vector<std::uint64_t> head{blocks, block, raw.size() % block};
  std::string body;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::string_view part = raw.substr(i * block, block);
    uLongf size = compressBound(static_cast<uLong>(part.size()));
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(part.data()),
                  static_cast<uLong>(part.size()), Z_BEST_SPEED) != Z_OK) {
      throw std::runtime_error("zlib could not compress");
    }
    head.push_back(size);
    body.append(packed, 0, size);
  }
  return std::string(reinterpret_cast<const char*>(head.data()), sizeof(std::uint64_t) * head.size()) + body;
}

}  // namespace

VtkSurface::VtkSurface(const std::vector<float>& points, const std::vector<std::int32_t>& triangles)
    : points_(points.size() / 3), triangles_(triangles.size() / 3) {
  point_array_ = array("Float32", "Points", 3, raw(points));
  connectivity_ = array("Int32", "connectivity", 1, raw(triangles));
  std::vector<std::int32_t> offsets;
  for (std::size_t i = 1; i <= triangles_; ++i) offsets.push_back(static_cast<std::int32_t>(3 * i));
  offsets_ = array("Int32", "offsets", 1, raw(offsets));
}

void VtkSurface::add_point_data(std::string_view name, const std::vector<float>& values, int columns) {
  point_data_ += array("Float32", name, columns, raw(values));
}

void VtkSurface::add_point_data(std::string_view name, const std::vector<std::int32_t>& values) {
  point_data_ += array("Int32", name, 1, raw(values));
}

std::string VtkSurface::array(std::string_view type, std::string_view name, int columns, std::string_view raw) {
  const std::size_t offset = data_.size();
  data_ += compressed(raw);
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type, name,
      columns, offset);
}

std::string VtkSurface::bytes() const {
  return fmt::format(
             "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n<FieldData>\n"
             "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
             "format=\"ascii\">{:.17g}</DataArray>\n"
             "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
             "NumberOfPolys=\"{}\">\n<PointData Scalars=\"speed\" Normals=\"Normals\">\n{}</PointData>\n"
             "<Points>\n{}</Points>\n<Polys>\n{}{}</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_",
             time_, points_, triangles_, point_data_, point_array_, connectivity_, offsets_) +
         data_ + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace osculate::io
