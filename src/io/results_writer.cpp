#include "io/results_writer.hpp"

#include <fmt/format.h>

#include "io/journaled_file.hpp"
#include "io/results_schema.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {

struct ResultsWriter::File {
  std::filesystem::path path;
  Hdf5Handle handle;
  std::vector<std::string> series;
  bool refused = false;  ///< by the file system, once: what came after would be lost
};

namespace {

constexpr const char* expected_place = "a place where results can be written";

/// Runs `work` and gives its trouble the reason of the file system, if that is what it was.
template <class Work>
auto at_file(const std::filesystem::path& path, const Work& work) {
  const QuietHdf5 quiet;
  take_journal_trouble();
  try {
    return work();
  } catch (const std::runtime_error& error) {
    const std::string trouble = take_journal_trouble();
    if (!trouble.empty()) throw InputError("results", trouble, expected_place);
    throw InputError(path.string(), fmt::format("found {}", error.what()), "a results file to write to");
  }
}

Hdf5Handle new_file(const std::filesystem::path& path) {
  const Hdf5Handle access(journaled_access(), H5Pclose);
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose};
}

Hdf5Handle old_file(const std::filesystem::path& path) {
  const Hdf5Handle access(journaled_access(), H5Pclose);
  return {H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose};
}

void set_frame_count(hid_t file, std::size_t count) {
  const Hdf5Handle frames = open_group(file, "frames");
  require_hdf5(H5Adelete(frames, "count"), "count frames");
  write_count(frames, "count", count);
}

void write_poses(hid_t file, const std::string& what, const std::vector<Pose>& poses) {
  std::vector<Vec3> positions;
  std::vector<Quat> orientations;
  for (const Pose& pose : poses) {
    positions.push_back(pose.position);
    orientations.push_back(pose.orientation);
  }
  write_vectors(file, what + "_position", positions);
  write_rotations(file, what + "_orientation", orientations);
}

void write_frame(hid_t file, const std::string& path, const ParticleFrame& frame) {
  const Hdf5Handle group = make_group(file, path);
  write_number(group, "time", frame.time);
  write_count(group, "step", frame.step);
  write_rows(file, path + "/id", Rows<std::uint32_t>{1, frame.id});
  write_rows(file, path + "/shape", Rows<std::uint32_t>{1, frame.shape});
  write_vectors(file, path + "/position", frame.position);
  write_rotations(file, path + "/orientation", frame.orientation);
  write_vectors(file, path + "/velocity", frame.velocity);
  write_vectors(file, path + "/angular_velocity", frame.angular_velocity);
  write_poses(file, path + "/wall", frame.walls);
  if (!frame.meshes.empty()) write_poses(file, path + "/mesh", frame.meshes);
}

void write_contacts(hid_t file, const std::string& path, const ContactFrame& frame) {
  Rows<std::uint32_t> bodies{2, {}};
  for (const auto& pair : frame.bodies) bodies.values.insert(bodies.values.end(), pair.begin(), pair.end());
  write_rows(file, path + "/bodies", bodies);
  write_vectors(file, path + "/point", frame.point);
  write_vectors(file, path + "/normal", frame.normal);
  write_rows(file, path + "/overlap", Rows<double>{1, frame.overlap});
  write_vectors(file, path + "/force", frame.force);
}

}  // namespace

ResultsWriter::ResultsWriter(const std::filesystem::path& path, const ResultsHead& head,
                             const std::vector<std::string>& series) {
  at_file(path, [&] {
    std::error_code unimportant;
    std::filesystem::remove(journal_path(path), unimportant);
    file_ = std::make_unique<File>(File{path, new_file(path), series});
    write_head(file_->handle, head);
    write_series_names(file_->handle, series);
    commit();
  });
}

ResultsWriter::ResultsWriter(const std::filesystem::path& path, std::size_t frames, std::size_t rows)
    : frames_(frames), rows_(rows) {
  at_file(path, [&] {
    apply_journal(path);
    file_ = std::make_unique<File>(File{path, old_file(path), {}});
    const hid_t file = file_->handle;
    read_head(file);
    file_->series = read_series_names(file);
    const std::size_t there = read_frame_count(file);
    if (there < frames) throw std::runtime_error(fmt::format("{} frames where {} were written", there, frames));
    for (const std::string& name : members(file, "frames"))
      if ("frames/" + name >= frame_path(frames))
        require_hdf5(H5Ldelete(file, ("frames/" + name).c_str(), H5P_DEFAULT), "remove frame " + name);
    for (const std::string& name : file_->series) {
      const std::string column = "series/" + name;
      if (column_size(file, column) < rows) throw std::runtime_error("too few rows in " + column);
      cut_column(file, column, rows);
    }
    set_frame_count(file, frames);
    commit();
  });
}

ResultsWriter::~ResultsWriter() {
  const QuietHdf5 quiet;
  file_.reset();
}
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;
ResultsWriter& ResultsWriter::operator=(ResultsWriter&&) noexcept = default;

// NOLINTNEXTLINE(readability-make-member-function-const): it changes the file.
void ResultsWriter::add_rows(const NumberTable& rows) {
  for (const std::string& name : file_->series) {
    const std::vector<double>* column = rows.find(name);
    if (column == nullptr) throw std::runtime_error("no column " + name + " in the series");
    append_to_column(file_->handle, "series/" + name, *column);
  }
}

void ResultsWriter::append_series(const NumberTable& rows) {
  at_file(file_->path, [&] {
    add_rows(rows);
    commit();
  });
  rows_ += rows.rows();
}

NumberTable ResultsWriter::series() const {
  return at_file(file_->path, [&] { return read_series(file_->handle); });
}

void ResultsWriter::commit() {
  if (file_->refused) throw std::runtime_error("a file that could not be written to before");
  file_->refused = H5Fflush(file_->handle, H5F_SCOPE_GLOBAL) < 0;
  if (file_->refused) throw std::runtime_error("a file that cannot be written to");
}

void ResultsWriter::append(const ParticleFrame& frame, const std::optional<ContactFrame>& contacts,
                           const NumberTable& series_rows) {
  at_file(file_->path, [&] {
    const hid_t file = file_->handle;
    write_frame(file, frame_path(frames_), frame);
    if (contacts) write_contacts(file, frame_path(frames_) + "/contacts", *contacts);
    add_rows(series_rows);
    set_frame_count(file, frames_ + 1);
    commit();
  });
  ++frames_;
  rows_ += series_rows.rows();
}

}  // namespace osculate::io
