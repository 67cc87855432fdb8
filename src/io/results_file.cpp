#include "io/results_file.hpp"

#include <fmt/format.h>

#include "io/journaled_file.hpp"
#include "io/results_schema.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {

struct ResultsFile::File {
  std::filesystem::path path;
  Hdf5Handle handle;
};

namespace {

constexpr const char* expected_file = "a results file that `osculate run` wrote";

/// Runs `work` and gives what HDF5 complains about a place.
template <class Work>
auto at_file(const std::filesystem::path& path, const Work& work) {
  const QuietHdf5 quiet;
  try {
    return work();
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw InputError(path.string(), fmt::format("found {}", error.what()), expected_file);
  }
}

Hdf5Handle open_to_read(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) {
    const bool there = std::filesystem::exists(path);
    throw InputError(path.string(), there ? "found no regular file" : "found no such file", expected_file);
  }
  const Hdf5Handle access(journaled_access(), H5Pclose);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  const std::string trouble = take_journal_trouble();
  if (file < 0)
    throw InputError(path.string(), trouble.empty() ? "found a file that is no HDF5, or damaged" : trouble,
                     expected_file);
  return {file, H5Fclose};
}

std::vector<Pose> read_poses(hid_t file, const std::string& what) {
  const std::vector<Vec3> positions = read_vectors(file, what + "_position");
  const std::vector<Quat> orientations = read_rotations(file, what + "_orientation");
  if (positions.size() != orientations.size())
    throw std::runtime_error("positions and orientations of different number in " + what);
  std::vector<Pose> poses;
  for (std::size_t k = 0; k < positions.size(); ++k) poses.push_back({positions[k], orientations[k]});
  return poses;
}

void require_sizes(const ParticleFrame& frame, const ResultsHead& head, const std::string& path) {
  const std::size_t count = frame.id.size();
  if (frame.shape.size() != count || frame.position.size() != count || frame.orientation.size() != count ||
      frame.velocity.size() != count || frame.angular_velocity.size() != count)
    throw std::runtime_error("columns of different length in " + path);
  for (const std::uint32_t shape : frame.shape)
    if (shape >= head.shapes.size()) throw std::runtime_error(fmt::format("shape {} in {}", shape, path));
  if (frame.walls.size() != head.walls.size())
    throw std::runtime_error(fmt::format("{} walls in {}", frame.walls.size(), path));
  if (frame.meshes.size() != head.meshes.size())
    throw std::runtime_error(fmt::format("{} meshes in {}", frame.meshes.size(), path));
}

}  // namespace

std::string frame_path(std::size_t i) {
  return fmt::format("frames/{:06}", i);
}

ResultsFile::ResultsFile(const std::filesystem::path& path) {
  const QuietHdf5 quiet;
  apply_journal(path);
  file_ = std::make_unique<File>(File{path, open_to_read(path)});
  at_file(path, [&] {
    head_ = read_head(file_->handle);
    frame_count_ = read_frame_count(file_->handle);
  });
}

ResultsFile::~ResultsFile() = default;
ResultsFile::ResultsFile(ResultsFile&&) noexcept = default;
ResultsFile& ResultsFile::operator=(ResultsFile&&) noexcept = default;

ParticleFrame ResultsFile::frame(std::size_t i) const {
  if (i >= frame_count_)
    throw InputError(file_->path.string(), fmt::format("frame {}", i),
                     frame_count_ == 0 ? "a file with frames; this one has none"
                                       : fmt::format("a frame from 0 to {}", frame_count_ - 1));
  return at_file(file_->path, [&] {
    const hid_t file = file_->handle;
    const std::string path = frame_path(i);
    const Hdf5Handle group = open_group(file, path);
    ParticleFrame frame{.time = read_number(group, "time"),
                        .step = read_count(group, "step"),
                        .id = read_indices(file, path + "/id", 1).values,
                        .shape = read_indices(file, path + "/shape", 1).values,
                        .position = read_vectors(file, path + "/position"),
                        .orientation = read_rotations(file, path + "/orientation"),
                        .velocity = read_vectors(file, path + "/velocity"),
                        .angular_velocity = read_vectors(file, path + "/angular_velocity"),
                        .walls = {}};
    frame.walls = read_poses(file, path + "/wall");
    if (!head_.meshes.empty()) frame.meshes = read_poses(file, path + "/mesh");
    require_sizes(frame, head_, path);
    return frame;
  });
}

bool ResultsFile::has_contacts(std::size_t i) const {
  return at_file(file_->path, [&] { return i < frame_count_ && has_path(file_->handle, frame_path(i) + "/contacts"); });
}

ContactFrame ResultsFile::contacts(std::size_t i) const {
  if (!has_contacts(i))
    throw InputError(file_->path.string(), fmt::format("no contacts in frame {}", i),
                     "a run whose scene has contacts = true under [output]");
  return at_file(file_->path, [&] {
    const hid_t file = file_->handle;
    const std::string path = frame_path(i) + "/contacts";
    ContactFrame frame{.bodies = {},
                       .point = read_vectors(file, path + "/point"),
                       .normal = read_vectors(file, path + "/normal"),
                       .overlap = read_rows(file, path + "/overlap", 1).values,
                       .force = read_vectors(file, path + "/force")};
    const Rows<std::uint32_t> bodies = read_indices(file, path + "/bodies", 2);
    for (std::size_t k = 0; k < bodies.size(); ++k)
      frame.bodies.push_back({bodies.values[2 * k], bodies.values[2 * k + 1]});
    const std::size_t count = frame.size();
    if (frame.point.size() != count || frame.normal.size() != count || frame.overlap.size() != count ||
        frame.force.size() != count)
      throw std::runtime_error("columns of different length in " + path);
    return frame;
  });
}

NumberTable ResultsFile::series() const {
  return at_file(file_->path, [&] { return read_series(file_->handle); });
}

}  // namespace osculate::io
