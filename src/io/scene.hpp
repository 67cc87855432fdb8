#pragma once
// A scene read from a file: what a simulation is made of, how long it runs and what is kept of it.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "osculate/dynamics/insertion.hpp"
#include "osculate/dynamics/setup.hpp"
#include "osculate/dynamics/time_step.hpp"

namespace osculate::io {

/// How a body that is not free came into the scene.
struct SceneWall {
  std::string name;
  std::int32_t body;  ///< index into Setup::bodies
};

struct SceneOutput {
  double interval = 0.0;                  ///< between frames [s]
  double series_interval = 0.0;           ///< between rows of the series [s]
  double checkpoint_every = 0.0;          ///< of computing time [s]
  bool contacts = false;                  ///< whether frames hold them
  std::optional<Region> fraction_region;  ///< where the solid fraction is taken
};

struct Scene {
  std::filesystem::path file;
  std::string text;  ///< of the file
  std::string title;
  Setup setup;  ///< particles' shapes first, then those of walls; the time step is set, threads are not
  std::vector<std::string> shape_names;       ///< one for each of the setup's
  std::vector<std::int32_t> shape_materials;  ///< index into Setup::materials, one for each shape
  std::vector<SceneWall> walls;               ///< bodies whose shape is a wall, in the order of the bodies
  std::vector<std::string> mesh_names;        ///< one for each of the setup's
  double duration = 0.0;                      ///< [s]
  double speed = 0.0;                         ///< the fastest impact to be expected [m/s]
  TimeStepLimits limits{};
  SceneOutput output;
  std::vector<std::string> warnings;  ///< what is allowed and yet questionable

  std::uint64_t steps() const;                    ///< of the whole run
  std::uint64_t steps_in(double interval) const;  ///< 1 at least
};

/// Throws InputError "file:line:col: key …: found …; expected …". The keys are described in docs/scene-files.md.
Scene read_scene(const std::filesystem::path& path);

}  // namespace osculate::io
