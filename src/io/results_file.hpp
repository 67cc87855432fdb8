#pragma once
// Results of a simulation as an HDF5 file; docs/results-files.md describes what stands where in it. SI units, world
// frame.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/number_table.hpp"
#include "osculate/dynamics/periodic_box.hpp"
#include "osculate/geometry/mesh_surface.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate::io {

/// All particles at one moment: entry i of every vector belongs to one. Walls are no particles; bodies of a particle's
/// shape that move as they are told are.
struct ParticleFrame {
  double time;  ///< [s]
  std::uint64_t step;
  std::vector<std::uint32_t> id;       ///< of the body, the same in all frames; increasing
  std::vector<std::uint32_t> shape;    ///< index into ResultsFile::shapes()
  std::vector<Vec3> position;          ///< of the centroid [m]; in a periodic box inside it
  std::vector<Quat> orientation;       ///< body → world
  std::vector<Vec3> velocity;          ///< of the centroid [m/s]
  std::vector<Vec3> angular_velocity;  ///< [rad/s], world
  std::vector<Pose> walls;             ///< where the walls are, one for each of ResultsFile::walls()
  std::vector<Pose> meshes = {};       ///< where the meshes are, one for each of ResultsHead::meshes

  std::size_t size() const { return position.size(); }
  Pose pose(std::size_t i) const { return {position[i], orientation[i]}; }
};

/// All contacts at one moment.
struct ContactFrame {
  std::vector<std::array<std::uint32_t, 2>> bodies;  ///< ids of particles or walls, the smaller first
  std::vector<Vec3> point;                           ///< [m], in a periodic box near the first body
  std::vector<Vec3> normal;                          ///< from the first to the second
  std::vector<double> overlap;                       ///< [m]
  std::vector<Vec3> force;                           ///< on the first [N]

  std::size_t size() const { return bodies.size(); }
};

struct ResultsShape {
  std::string name;
  Shape shape;
  Pose frame;  ///< of the shape in the body's frame, which has its origin in the centroid: a particle's shape
               ///< stands at frame.pose(i) ∘ frame. Identity but for lopsided potential particles.
  std::string material;
  double density;  ///< [kg/m³]
};

struct ResultsWall {
  std::string name;
  std::uint32_t id;  ///< of the body
  Shape shape;       ///< a wall
};

/// A surface of triangles that particles touch.
struct ResultsMesh {
  std::string name;
  std::uint32_t id;  ///< of its first face as a body; the others follow
  SurfaceTriangles triangles;
};

/// What is known before the first frame.
struct ResultsHead {
  std::string title;
  std::string scene;  ///< the text of the scene file
  std::vector<ResultsShape> shapes;
  std::vector<ResultsWall> walls;
  PeriodicBox box;
  Vec3 gravity = Vec3::Zero();  ///< [m/s²]
  double time_step = 0.0;       ///< [s]
  std::vector<ResultsMesh> meshes = {};
};

/// A results file to read. It may be one that is still being written: then it ends with the last whole frame.
/// Throws InputError for a file that is missing, no results file, of a later version, or damaged.
class ResultsFile {
 public:
  explicit ResultsFile(const std::filesystem::path& path);
  ~ResultsFile();
  ResultsFile(ResultsFile&&) noexcept;
  ResultsFile& operator=(ResultsFile&&) noexcept;

  const ResultsHead& head() const { return head_; }
  const std::vector<ResultsShape>& shapes() const { return head_.shapes; }
  const std::vector<ResultsWall>& walls() const { return head_.walls; }

  std::size_t frame_count() const { return frame_count_; }
  /// Throws InputError unless i < frame_count().
  ParticleFrame frame(std::size_t i) const;
  bool has_contacts(std::size_t i) const;
  /// Throws InputError if the frame has none stored.
  ContactFrame contacts(std::size_t i) const;
  /// Energies and other numbers along time; no columns if there are none.
  NumberTable series() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
  ResultsHead head_;
  std::size_t frame_count_ = 0;
};

/// The place of frame i: "frames/000012".
std::string frame_path(std::size_t i);

}  // namespace osculate::io
