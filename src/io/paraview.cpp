#include "io/paraview.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/particle_values.hpp"
#include "io/vtk_xml.hpp"
#include "osculate/core/error.hpp"
#include "osculate/shapes/mesh.hpp"

namespace osculate::io {
namespace {

void append(std::vector<float>& numbers, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>(v[axis]));
}

}  // namespace

std::string particle_surfaces(const ParticleFrame& frame, const ResultsHead& head, int resolution) {
  require_shapes(frame, head);
  std::vector<TriangleMesh> meshes;
  for (const ResultsShape& shape : head.shapes) meshes.push_back(surface_mesh(shape.shape, resolution));
  const std::vector<double> energies = kinetic_energies(frame, head);

  std::vector<float> points, normals, speed, velocity, angular_velocity, energy;
  std::vector<std::int32_t> triangles, id, shape;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const TriangleMesh& mesh = meshes[frame.shape[i]];
    const Pose pose = shape_pose_of(frame, head, i);
    const std::size_t first = points.size() / 3;
    if (first + mesh.vertices.size() > std::numeric_limits<std::int32_t>::max()) {
      throw InputError("ParaView file", fmt::format("more than 2^31 points in a frame of {} particles", frame.size()),
                       "a lower resolution");
    }
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
      append(points, pose.to_world(mesh.vertices[k]));
      append(normals, pose.rotate_to_world(mesh.normals[k]));
      append(velocity, frame.velocity[i]);
      append(angular_velocity, frame.angular_velocity[i]);
    }
    speed.insert(speed.end(), mesh.vertices.size(), static_cast<float>(frame.velocity[i].norm()));
    energy.insert(energy.end(), mesh.vertices.size(), static_cast<float>(energies[i]));
    id.insert(id.end(), mesh.vertices.size(), static_cast<std::int32_t>(frame.id[i]));
    shape.insert(shape.end(), mesh.vertices.size(), static_cast<std::int32_t>(frame.shape[i]));
    for (const auto& triangle : mesh.triangles) {
      for (const int corner : triangle) triangles.push_back(static_cast<std::int32_t>(first) + corner);
    }
  }
  VtkSurface surface(points, triangles);
  surface.set_time(frame.time);
  surface.add_point_data("speed", speed, 1);
  surface.add_point_data("id", id);
  surface.add_point_data("shape", shape);
  surface.add_point_data("velocity", velocity, 3);
  surface.add_point_data("angular_velocity", angular_velocity, 3);
  surface.add_point_data("kinetic_energy", energy, 1);
  surface.add_point_data("Normals", normals, 3);
  return surface.bytes();
}

std::string mesh_surfaces(const ParticleFrame& frame, const ResultsHead& head) {
  std::vector<float> points;
  std::vector<std::int32_t> triangles, id;
  for (std::size_t m = 0; m < head.meshes.size(); ++m) {
    const SurfaceTriangles& mesh = head.meshes[m].triangles;
    const auto first = static_cast<std::int32_t>(points.size() / 3);
    for (const Vec3& vertex : mesh.vertices) append(points, frame.meshes.at(m).to_world(vertex));
    id.insert(id.end(), mesh.vertices.size(), static_cast<std::int32_t>(head.meshes[m].id));
    for (const auto& triangle : mesh.triangles)
      for (const int corner : triangle) triangles.push_back(first + corner);
  }
  VtkSurface surface(points, triangles);
  surface.set_time(frame.time);
  surface.add_point_data("id", id);
  return surface.bytes();
}

void write_paraview(const ResultsFile& results, int resolution, const std::filesystem::path& path,
                    const std::function<void(std::size_t)>& written) {
  if (path.extension() != ".pvd") {
    throw InputError(path.string(), "an ending of \"" + path.extension().string() + "\"", ".pvd");
  }
  const std::filesystem::path folder = std::filesystem::path(path).replace_extension();
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);
  if (trouble) throw InputError(folder.string(), "cannot be created (" + trouble.message() + ")", "a folder");
  std::string series = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (std::size_t i = 0; i < results.frame_count(); ++i) {
    const ParticleFrame frame = results.frame(i);
    const std::string name = fmt::format("frame_{:06}.vtp", i);
    write_atomically((folder / name).string(), particle_surfaces(frame, results.head(), resolution));
    series += fmt::format("<DataSet timestep=\"{:.17g}\" part=\"0\" file=\"{}/{}\"/>\n", frame.time,
                          folder.filename().string(), name);
    if (!results.head().meshes.empty()) {
      const std::string meshes = fmt::format("meshes_{:06}.vtp", i);
      write_atomically((folder / meshes).string(), mesh_surfaces(frame, results.head()));
      series += fmt::format("<DataSet timestep=\"{:.17g}\" part=\"1\" file=\"{}/{}\"/>\n", frame.time,
                            folder.filename().string(), meshes);
    }
    written(i + 1);
  }
  write_atomically(path.string(), series + "</Collection>\n</VTKFile>\n");
}

}  // namespace osculate::io
