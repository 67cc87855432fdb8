#pragma once
// Pictures one after the other.

#include <cstddef>
#include <filesystem>

namespace osculate::io {

/// PNG files of one size in a folder, numbered without a gap: frame_000012.png.
struct PictureSeries {
  std::filesystem::path folder;
  std::size_t first = 0;  ///< the first number
  std::size_t count = 0;

  std::filesystem::path file(std::size_t number) const;
};

/// Before the work of making pictures: throws InputError unless the name ends in .mp4 or .gif and ffmpeg is installed.
void require_animation(const std::filesystem::path& path);

/// Makes a film of a series by ffmpeg, which must be installed; the file appears whole or not at all.
/// Throws InputError as above and for a place that cannot be written to.
void write_animation(const PictureSeries& series, double frames_per_second, const std::filesystem::path& path);

}  // namespace osculate::io
