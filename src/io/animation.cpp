#include "io/animation.hpp"

#include <fmt/format.h>

#include <string>
#include <system_error>
#include <vector>

#include "io/child_program.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

const ChildProgram ffmpeg{.name = "ffmpeg", .needed_for = "animation", .debian_package = "ffmpeg"};

}  // namespace

std::filesystem::path PictureSeries::file(std::size_t number) const {
  return folder / fmt::format("frame_{:06}.png", number);
}

void require_animation(const std::filesystem::path& path) {
  if (path.extension() != ".mp4" && path.extension() != ".gif") {
    throw InputError(path.string(), "an ending of \"" + path.extension().string() + "\"", ".mp4 or .gif");
  }
  run(ffmpeg, {"-version"});
}

void write_animation(const PictureSeries& series, double frames_per_second, const std::filesystem::path& path) {
  require_animation(path);
  const bool gif = path.extension() == ".gif";
  // Films of h.264 have even sides; a GIF has one table of 256 colours.
  const std::string filter = gif ? "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=sierra2_4a"
                                 : "crop=trunc(iw/2)*2:trunc(ih/2)*2";
  std::filesystem::path partial = path;
  partial.replace_extension(".partial" + path.extension().string());
  std::vector<std::string> arguments{"-nostdin",
                                     "-y",
                                     "-loglevel",
                                     "error",
                                     "-framerate",
                                     fmt::format("{:g}", frames_per_second),
                                     "-start_number",
                                     std::to_string(series.first),
                                     "-i",
                                     (series.folder / "frame_%06d.png").string(),
                                     "-frames:v",
                                     std::to_string(series.count),
                                     "-vf",
                                     filter};
  if (!gif) arguments.insert(arguments.end(), {"-pix_fmt", "yuv420p", "-crf", "18", "-movflags", "+faststart"});
  arguments.push_back(partial.string());
  run(ffmpeg, arguments);
  std::error_code trouble;
  std::filesystem::rename(partial, path, trouble);
  if (trouble) throw InputError(path.string(), "cannot be written (" + trouble.message() + ")", "a place to write to");
}

}  // namespace osculate::io
