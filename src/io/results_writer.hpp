#pragma once
// Writes results files frame by frame. A crash, a kill or a full disk loses at most the frame being written.

#include <memory>
#include <optional>

#include "io/results_file.hpp"

namespace osculate::io {

class ResultsWriter {
 public:
  /// A new file in the place of any that was there. Throws InputError if it cannot be written.
  ResultsWriter(const std::filesystem::path& path, const ResultsHead& head, const std::vector<std::string>& series);
  /// An existing file, cut back to a number of frames and of rows of the series, to go on from there. Throws InputError
  /// if it has fewer, or cannot be written.
  ResultsWriter(const std::filesystem::path& path, std::size_t frames, std::size_t rows);
  ~ResultsWriter();
  ResultsWriter(ResultsWriter&&) noexcept;
  ResultsWriter& operator=(ResultsWriter&&) noexcept;

  /// Appends; after it, the frame and what came before are on the disk. Throws InputError, with the reason the file
  /// system gives, if they are not; the file then ends with the frame before.
  void append(const ParticleFrame& frame, const std::optional<ContactFrame>& contacts, const NumberTable& series_rows);

  /// Appends rows of the series alone, as safely.
  void append_series(const NumberTable& rows);

  /// The rows so far.
  NumberTable series() const;

  std::size_t frames() const { return frames_; }
  std::size_t rows() const { return rows_; }

 private:
  struct File;
  void add_rows(const NumberTable& rows);
  void commit();

  std::unique_ptr<File> file_;
  std::size_t frames_ = 0, rows_ = 0;
};

}  // namespace osculate::io
