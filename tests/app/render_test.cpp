// osculate render and osculate export.

#include <catch2/catch.hpp>
#include <filesystem>

#include "app/program.hpp"
#include "io/results_samples.hpp"
#include "io/results_writer.hpp"

namespace {

using Catch::Contains;
using osculate::test::content_of;
using osculate::test::fresh_folder;
using osculate::test::run;

/// A folder with results.h5 of three frames.
std::filesystem::path folder_with_results(const std::string& name) {
  const auto folder = fresh_folder(name);
  osculate::io::ResultsWriter writer(folder / "results.h5", osculate::io::sample_head(), {});
  osculate::io::ParticleFrame frame = osculate::io::sample_frame();
  for (int i = 0; i < 3; ++i) {
    frame.time += 0.1;
    writer.append(frame, std::nullopt, {});
  }
  return folder;
}

bool is_png(const std::filesystem::path& path) {
  return content_of(path).starts_with("\x89PNG");
}

}  // namespace

TEST_CASE("render draws every frame, or the one asked for") {
  const auto folder = folder_with_results("render");
  const auto all = run(folder, "render results.h5 --size 320x240");
  INFO(all.err);
  CHECK(all.exit_code == 0);
  CHECK(all.out == "frames/frame_000000.png and 2 more\n");
  for (const char* name : {"frame_000000.png", "frame_000001.png", "frame_000002.png"}) {
    CHECK(is_png(folder / "frames" / name));
  }
  const auto one = run(folder, "render results.h5 -o end.png --frame last --size 320x240 --color energy --view 30,45");
  CHECK(one.exit_code == 0);
  CHECK(one.out == "end.png\n");
  CHECK(is_png(folder / "end.png"));
}

TEST_CASE("render refuses what it cannot draw and says what it expected") {
  const auto folder = folder_with_results("render_refused");
  const auto refused = [&](const std::string& options, const std::string& reason) {
    const auto result = run(folder, "render results.h5 " + options);
    INFO(options);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains(reason));
  };
  refused("--frame 3", "all, last or a number from 0 to 2");
  refused("--size 320", "such as 1200x900");
  refused("--size 20x20", "200 to 5000 px");
  refused("--view 30", "azimuth,elevation in degrees");
  refused("--view 0,90", "between -90° and 90°");
  refused("--max -1", "more than 0");
  refused("-o one.png", "a folder, or one picture by --frame");
  refused("--animation film.avi", ".mp4 or .gif");
  CHECK(run(folder, "render missing.h5").exit_code == 2);
}

TEST_CASE("export writes for ParaView and OVITO, and says which shape OVITO lacks") {
  const auto folder = folder_with_results("export");
  const auto result = run(folder, "export results.h5 --paraview run.pvd --ovito run.dump --resolution 4");
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.out, Contains("run.pvd: 3 frames") && Contains("run.dump: 3 frames") &&
                             Contains("OVITO has no potential particle: \"stone\" is drawn as the sphere"));
  CHECK(std::filesystem::exists(folder / "run" / "frame_000002.vtp"));
  CHECK_THAT(content_of(folder / "run.dump"), Contains("ITEM: NUMBER OF ATOMS\n5\n"));
  CHECK_THAT(run(folder, "export results.h5").err, Contains("at least one of them"));
}
