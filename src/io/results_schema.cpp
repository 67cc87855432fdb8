#include "io/results_schema.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace osculate::io {
namespace {

void write_shape(hid_t file, const std::string& path, const Shape& shape) {
  struct Writer {
    hid_t file;
    const std::string& path;

    void half_axes(const Vec3& axes) const {
      write_rows(file, path + "/half_axes", Rows<double>{1, {axes.x(), axes.y(), axes.z()}});
    }
    void length(const char* name, double value) const { write_rows(file, path + "/" + name, Rows<double>{1, {value}}); }

    void operator()(const Superquadric& one) const {
      half_axes(one.half_axes);
      write_rows(file, path + "/exponents", Rows<double>{1, {one.exponents.n1, one.exponents.n2}});
    }
    void operator()(const Ellipsoid& one) const { half_axes(one.half_axes); }
    void operator()(const Sphere& one) const { length("radius", one.radius); }
    void operator()(const PotentialParticle& one) const {
      Rows<double> planes{4, {}};
      for (const FacePlane& plane : one.planes)
        planes.values.insert(planes.values.end(),
                             {plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.distance});
      write_rows(file, path + "/planes", planes);
      length("sphericity", one.sphericity);
      length("edge_radius", one.edge_radius);
      length("sphere_radius", one.sphere_radius);
    }
    void operator()(const HalfSpace&) const {}
    void operator()(const Cylinder& one) const {
      length("radius", one.radius);
      write_text(file, path + "/solid", one.solid == Cylinder::Solid::inside ? "inside" : "outside");
    }
    void operator()(const SphereContainer& one) const { length("radius", one.radius); }
  };
  write_text(file, path + "/kind", std::string(kind(shape)));
  std::visit(Writer{file, path}, shape);
}

Shape read_shape_at(hid_t file, const std::string& path) {
  const auto numbers = [&](const char* name, std::size_t count) {
    std::vector<double> values = read_rows(file, path + "/" + name, 1).values;
    if (values.size() != count) throw std::runtime_error(fmt::format("{} numbers in {}/{}", values.size(), path, name));
    return values;
  };
  const auto length = [&](const char* name) { return numbers(name, 1)[0]; };
  const auto half_axes = [&] {
    const std::vector<double> axes = numbers("half_axes", 3);
    return Vec3(axes[0], axes[1], axes[2]);
  };
  const std::string kind = read_text(file, path + "/kind");
  if (kind == "superquadric") {
    const std::vector<double> n = numbers("exponents", 2);
    return Superquadric{.half_axes = half_axes(), .exponents = {n[0], n[1]}};
  }
  if (kind == "ellipsoid") return Ellipsoid{half_axes()};
  if (kind == "sphere") return Sphere{length("radius")};
  if (kind == "half-space") return HalfSpace{};
  if (kind == "sphere container") return SphereContainer{length("radius")};
  if (kind == "cylinder") {
    const bool rod = read_text(file, path + "/solid") == "inside";
    return Cylinder{length("radius"), rod ? Cylinder::Solid::inside : Cylinder::Solid::outside};
  }
  if (kind != "potential particle") throw std::runtime_error("a shape of unknown kind \"" + kind + "\"");
  const Rows<double> planes = read_rows(file, path + "/planes", 4);
  PotentialParticle particle{.planes = {},
                             .sphericity = length("sphericity"),
                             .edge_radius = length("edge_radius"),
                             .sphere_radius = length("sphere_radius")};
  for (std::size_t i = 0; i < planes.size(); ++i)
    particle.planes.push_back({Vec3(&planes.values[4 * i]), planes.values[4 * i + 3]});
  return particle;
}

ResultsMesh read_mesh(hid_t file, const std::string& path) {
  const std::vector<std::uint32_t> id = read_indices(file, path + "/id", 1).values;
  if (id.size() != 1) throw std::runtime_error("a table where one value was expected");
  ResultsMesh mesh{.name = read_text(file, path + "/name"),
                   .id = id[0],
                   .triangles = {.vertices = read_vectors(file, path + "/vertices"), .triangles = {}}};
  const Rows<std::uint32_t> triangles = read_indices(file, path + "/triangles", 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangles.values[3 * i + k];
      if (vertex >= mesh.triangles.vertices.size()) throw std::runtime_error("a triangle without vertices in " + path);
      corners[k] = static_cast<int>(vertex);
    }
    mesh.triangles.triangles.push_back(corners);
  }
  return mesh;
}

std::string entry(const char* group, std::size_t i) {
  return fmt::format("{}/{:06}", group, i);
}

}  // namespace

void write_head(hid_t file, const ResultsHead& head) {
  write_text(file, "format", results_format);
  write_count(file, "version", results_version);
  write_number(file, "time_step", head.time_step);
  write_text(file, "title", head.title);
  write_text(file, "scene", head.scene);
  write_vectors(file, "gravity", {head.gravity});
  if (head.box.repeats()) write_vectors(file, "periodic_box", {head.box.origin, head.box.length});
  if (const auto& shear = head.box.shear)
    write_rows(file, "box_shear",
               Rows<double>{3, {static_cast<double>(shear->flow), static_cast<double>(shear->gradient), shear->rate}});
  make_group(file, "shapes");
  for (std::size_t i = 0; i < head.shapes.size(); ++i) {
    const ResultsShape& shape = head.shapes[i];
    const std::string path = entry("shapes", i);
    write_shape(file, path, shape.shape);
    write_text(file, path + "/name", shape.name);
    write_text(file, path + "/material", shape.material);
    write_rows(file, path + "/density", Rows<double>{1, {shape.density}});
    write_vectors(file, path + "/frame_position", {shape.frame.position});
    write_rotations(file, path + "/frame_orientation", {shape.frame.orientation});
  }
  make_group(file, "walls");
  for (std::size_t i = 0; i < head.walls.size(); ++i) {
    const std::string path = entry("walls", i);
    write_shape(file, path, head.walls[i].shape);
    write_text(file, path + "/name", head.walls[i].name);
    write_rows(file, path + "/id", Rows<std::uint32_t>{1, {head.walls[i].id}});
  }
  for (std::size_t i = 0; i < head.meshes.size(); ++i) {
    const std::string path = entry("meshes", i);
    const ResultsMesh& mesh = head.meshes[i];
    Rows<std::uint32_t> triangles{3, {}};
    for (const auto& triangle : mesh.triangles.triangles)
      for (const int vertex : triangle) triangles.values.push_back(static_cast<std::uint32_t>(vertex));
    write_vectors(file, path + "/vertices", mesh.triangles.vertices);
    write_rows(file, path + "/triangles", triangles);
    write_text(file, path + "/name", mesh.name);
    write_rows(file, path + "/id", Rows<std::uint32_t>{1, {mesh.id}});
  }
  const Hdf5Handle frames = make_group(file, "frames");
  write_count(frames, "count", 0);
}

void write_series_names(hid_t file, const std::vector<std::string>& names) {
  make_group(file, "series");
  write_text(file, "series_columns", fmt::format("{}", fmt::join(names, ",")));
  for (const std::string& name : names) make_growing_column(file, "series/" + name);
}

std::vector<std::string> read_series_names(hid_t file) {
  const std::string text = read_text(file, "series_columns");
  std::vector<std::string> names;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    names.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return names;
}

ResultsHead read_head(hid_t file) {
  if (!has_path(file, "format") || read_text(file, "format") != results_format)
    throw std::runtime_error("no mark of a results file");
  const std::uint64_t version = read_count(file, "version");
  if (version != results_version) throw std::runtime_error(fmt::format("version {} of the format", version));
  const auto one = [](const auto& values) {
    if (values.size() != 1) throw std::runtime_error("a table where one value was expected");
    return values[0];
  };
  ResultsHead head;
  head.time_step = read_number(file, "time_step");
  head.title = read_text(file, "title");
  head.scene = read_text(file, "scene");
  head.gravity = one(read_vectors(file, "gravity"));
  if (has_path(file, "periodic_box")) {
    const std::vector<Vec3> box = read_vectors(file, "periodic_box");
    if (box.size() != 2) throw std::runtime_error("a periodic box of another form than origin and length");
    head.box = {.origin = box[0], .length = box[1]};
    if (has_path(file, "box_shear")) {
      const std::vector<double> shear = read_rows(file, "box_shear", 3).values;
      if (shear.size() != 3) throw std::runtime_error("a shear of another form than flow, gradient and rate");
      head.box.shear = BoxShear{.flow = static_cast<Eigen::Index>(shear[0]),
                                .gradient = static_cast<Eigen::Index>(shear[1]),
                                .rate = shear[2]};
    }
  }
  for (const std::string& name : members(file, "shapes")) {
    const std::string path = "shapes/" + name;
    head.shapes.push_back({.name = read_text(file, path + "/name"),
                           .shape = read_shape_at(file, path),
                           .frame = {one(read_vectors(file, path + "/frame_position")),
                                     one(read_rotations(file, path + "/frame_orientation"))},
                           .material = read_text(file, path + "/material"),
                           .density = one(read_rows(file, path + "/density", 1).values)});
  }
  for (const std::string& name : members(file, "walls")) {
    const std::string path = "walls/" + name;
    head.walls.push_back({.name = read_text(file, path + "/name"),
                          .id = one(read_indices(file, path + "/id", 1).values),
                          .shape = read_shape_at(file, path)});
  }
  if (has_path(file, "meshes"))
    for (const std::string& name : members(file, "meshes")) head.meshes.push_back(read_mesh(file, "meshes/" + name));
  return head;
}

NumberTable read_series(hid_t file) {
  NumberTable table;
  for (const std::string& name : read_series_names(file)) {
    table.names.push_back(name);
    table.columns.push_back(read_rows(file, "series/" + name, 1).values);
    if (table.columns.back().size() != table.columns.front().size())
      throw std::runtime_error("columns of different length in series");
  }
  return table;
}

std::size_t read_frame_count(hid_t file) {
  return static_cast<std::size_t>(read_count(open_group(file, "frames"), "count"));
}

}  // namespace osculate::io
