// osculate render: pictures and films of results.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "io/animation.hpp"
#include "io/assembly_picture.hpp"
#include "io/progress.hpp"
#include "io/results_file.hpp"
#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

struct RenderOptions {
  std::string results;
  std::string out = "frames";
  std::string frames = "all";
  std::string size = "1200x900";
  std::string view = "-60,20";
  io::ParticleColour colour = io::ParticleColour::speed;
  std::optional<double> most;
  std::string animation;
  double frames_per_second = 20.0;
};

constexpr const char* help = R"(Draws the particles in their true shapes, without a display:

  osculate render results.h5                              frames/frame_000000.png ...
  osculate render results.h5 -o end.png --frame last      one picture
  osculate render results.h5 --animation run.mp4          a film (.mp4 or .gif; needs ffmpeg)
  osculate render results.h5 --color energy --view 30,45  azimuth and elevation of the viewer in degrees

All pictures of a run share the scale of colours and lengths. Only the far sides of walls are drawn.)";

/// Two numbers with something between them.
template <class Number>
std::pair<Number, Number> number_pair(const std::string& option, const std::string& text, char between,
                                      const std::string& expected) {
  std::pair<Number, Number> numbers;
  const char* const end = text.data() + text.size();
  const auto one = std::from_chars(text.data(), end, numbers.first);
  if (one.ec == std::errc() && one.ptr != end && *one.ptr == between) {
    const auto other = std::from_chars(one.ptr + 1, end, numbers.second);
    if (other.ec == std::errc() && other.ptr == end) return numbers;
  }
  throw InputError(option, "\"" + text + "\"", expected);
}

struct FrameRange {
  std::size_t first, count;
};

FrameRange frame_range(const std::string& text, std::size_t frames) {
  if (frames == 0) throw InputError("results", "no frame", "at least one");
  if (text == "all") return {0, frames};
  if (text == "last") return {frames - 1, 1};
  std::size_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || number >= frames) {
    throw InputError("--frame", "\"" + text + "\"", fmt::format("all, last or a number from 0 to {}", frames - 1));
  }
  return {number, 1};
}

/// The upper end of the colours: few particles go beyond, so that a fast one does not leave the others dark.
double upper_end(std::vector<double>& values) {
  if (values.empty()) return 1.0;
  constexpr double below = 0.995;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(std::ceil(below * static_cast<double>(values.size() - 1)));
  std::ranges::nth_element(values, at);
  const double quantile = *at;
  if (quantile > 0.0) return quantile;
  const double largest = *std::ranges::max_element(values);
  return largest > 0.0 ? largest : 1.0;
}

io::AssemblyLook look_of(const RenderOptions& options, const io::ResultsFile& results, const FrameRange& range) {
  io::AssemblyLook look{.title = results.head().title, .colour = options.colour};
  std::tie(look.width, look.height) =
      number_pair<int>("--size", options.size, 'x', "width x height in pixels, such as 1200x900");
  std::tie(look.azimuth, look.elevation) =
      number_pair<double>("--view", options.view, ',', "azimuth,elevation in degrees, such as -60,20");
  io::Progress progress("Looking through the frames");
  std::vector<double> values;
  std::optional<io::Box> all;
  for (std::size_t i = 0; i < range.count; ++i) {
    const io::ParticleFrame frame = results.frame(range.first + i);
    if (frame.size() == 0) continue;  // nothing has been poured yet
    const io::Box extent = extent_of(frame, results.head());
    all = all ? united(*all, extent) : extent;
    const std::vector<double> of_frame = values_of(frame, results.head(), look.colour);
    values.insert(values.end(), of_frame.begin(), of_frame.end());
    progress.update(static_cast<double>(i + 1) / static_cast<double>(range.count));
  }
  if (!all) throw InputError(options.results, "no particle in any frame asked for", "one at least");
  look.extent = *all;
  look.most = options.most.value_or(upper_end(values));
  return look;
}

void render(const RenderOptions& options) {
  const io::ResultsFile results(options.results);
  const FrameRange range = frame_range(options.frames, results.frame_count());
  if (!options.animation.empty()) io::require_animation(options.animation);
  if (options.most && !(*options.most > 0.0))
    throw InputError("--max", fmt::format("{}", *options.most), "more than 0");
  const bool to_file = std::filesystem::path(options.out).extension() == ".png";
  if (to_file && range.count > 1) {
    throw InputError("-o", options.out + " for " + std::to_string(range.count) + " pictures",
                     "a folder, or one picture by --frame");
  }
  const io::AssemblyLook look = look_of(options, results, range);
  const io::PictureSeries series{.folder = options.out, .first = range.first, .count = range.count};
  if (!to_file) {
    std::error_code trouble;
    std::filesystem::create_directories(series.folder, trouble);
    if (trouble) throw InputError(options.out, "cannot be created (" + trouble.message() + ")", "a folder to write to");
  }
  {
    io::Progress progress("Rendering");
    for (std::size_t i = 0; i < range.count; ++i) {
      const std::size_t number = range.first + i;
      const std::filesystem::path file = to_file ? std::filesystem::path(options.out) : series.file(number);
      io::write_png(assembly_picture(results.frame(number), results.head(), look), file);
      progress.update(static_cast<double>(i + 1) / static_cast<double>(range.count));
    }
  }
  if (!options.animation.empty()) {
    if (to_file) throw InputError("--animation", "a single picture", "several frames in a folder");
    write_animation(series, options.frames_per_second, options.animation);
  }
  const std::filesystem::path first = to_file ? std::filesystem::path(options.out) : series.file(range.first);
  fmt::print("{}{}\n", first.string(), range.count == 1 ? "" : fmt::format(" and {} more", range.count - 1));
  if (!options.animation.empty()) fmt::print("{}\n", options.animation);
}

}  // namespace

void add_render(CLI::App& program) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "Pictures and films of a simulation's results");
  command->footer(help);
  command->add_option("results", options->results, "Results file of `osculate run`")->required();
  command->add_option("-o,--out", options->out, "Folder for the pictures, or one .png file")->capture_default_str();
  command->add_option("--frame", options->frames, "all, last or a number")->capture_default_str();
  command->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
  const std::map<std::string, io::ParticleColour> colours{{"speed", io::ParticleColour::speed},
                                                          {"energy", io::ParticleColour::kinetic_energy},
                                                          {"shape", io::ParticleColour::shape},
                                                          {"id", io::ParticleColour::id}};
  command->add_option("--color,--colour", options->colour, "speed, energy (kinetic), shape or id")
      ->transform(CLI::Transformer(colours));
  command->add_option("--max", options->most, "Upper end of the colours, m/s or J; default: 99.5 % stay below");
  command->add_option("--view", options->view, "Azimuth and elevation of the viewer in degrees")->capture_default_str();
  command->add_option("--animation", options->animation, "Also a film, .mp4 or .gif");
  command->add_option("--fps", options->frames_per_second, "Frames of the film a second")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 240.0));
  command->callback([options] { render(*options); });
}

}  // namespace osculate::app
