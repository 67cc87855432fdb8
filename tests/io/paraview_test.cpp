#include "io/paraview.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/child_program.hpp"
#include "io/particle_values.hpp"
#include "io/results_samples.hpp"
#include "io/results_writer.hpp"
#include "io/scratch_folder.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/body_shape.hpp"

using namespace osculate;
using namespace osculate::io;
using Catch::Matchers::Contains;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("A time series for ParaView names a file for every frame of the results") {
  const ScratchFolder folder;
  {
    ResultsWriter writer(folder.file("results.h5"), sample_head(), {});
    ParticleFrame frame = sample_frame();
    writer.append(frame, std::nullopt, {});
    frame.time = 0.5;
    writer.append(frame, std::nullopt, {});
  }
  const ResultsFile results(folder.file("results.h5"));
  std::size_t told = 0;
  write_paraview(results, 4, folder.file("run.pvd"), [&](std::size_t frames) { told = frames; });
  CHECK(told == 2);
  const std::string series = content(folder.file("run.pvd"));
  CHECK_THAT(series, Contains("timestep=\"0.25\" part=\"0\" file=\"run/frame_000000.vtp\""));
  CHECK_THAT(series, Contains("timestep=\"0.5\" part=\"0\" file=\"run/frame_000001.vtp\""));
  CHECK(content(folder.file("run/frame_000001.vtp")) == [&] {
    ParticleFrame frame = sample_frame();
    frame.time = 0.5;
    return particle_surfaces(frame, results.head(), 4);
  }());
  CHECK_THROWS_WITH(write_paraview(results, 4, folder.file("run.xyz"), [](std::size_t) {}),
                    Contains("ending of \".xyz\"; expected .pvd"));
}

TEST_CASE("A particle of a shape that the results do not have is named") {
  ParticleFrame frame = sample_frame();
  frame.shape[2] = 4;
  CHECK_THROWS_WITH(particle_surfaces(frame, sample_head(), 4),
                    Contains("particle 12: shape 4; expected one of the 4 shapes"));
}

#ifdef OSCULATE_VTK_PYTHON
TEST_CASE("VTK's reader finds every particle with its shape, place, volume and speed") {
  const ScratchFolder folder;
  const std::string file = folder.file("frame.vtp");
  const ParticleFrame frame = sample_frame();
  const ResultsHead head = sample_head();
  constexpr int resolution = 24;
  std::ofstream(file, std::ios::binary) << particle_surfaces(frame, head, resolution);
  std::istringstream found(run({.name = OSCULATE_VTK_PYTHON, .needed_for = "test", .debian_package = "python3-vtk9"},
                               {OSCULATE_SOURCE_DIR "/tests/io/read_surfaces.py", file}));
  std::string word;
  double time = 0.0;
  std::size_t points = 0, triangles = 0;
  found >> word >> time >> word >> points >> word >> triangles;
  CHECK(time == frame.time);
  CHECK(triangles == 5 * 12 * resolution * resolution);
  CHECK(points == 5 * (6 * resolution * resolution + 2));  // Euler: a closed surface each
  for (std::size_t i = 0; i < frame.size(); ++i) {
    std::uint32_t id = 0, shape = 0;
    double speed = 0.0, volume = 0.0, x = 0.0, y = 0.0, z = 0.0;
    REQUIRE(found >> id >> shape >> speed >> volume >> x >> y >> z);
    CHECK(id == frame.id[i]);
    CHECK(shape == frame.shape[i]);
    constexpr double single = 1e-6;  // 32-bit numbers
    CHECK(speed == Approx(frame.velocity[i].norm()).epsilon(single));
    const BodyShape body = body_shape(head.shapes[shape].shape);
    // A mesh lies inside: its volume is short by a part of the order of 1/resolution².
    CHECK(volume < body.volume);
    CHECK(volume > 0.98 * body.volume);
    // The stone's frame in the samples is made up, so its middle is where that puts it.
    const Vec3 middle = shape_pose_of(frame, head, i).to_world(mass_properties(head.shapes[shape].shape).centroid);
    CHECK((Vec3(x, y, z) - middle).norm() < 2e-3 * body.bounding_radius);
  }
}
#endif
