#pragma once
// A scene at work: the simulation, its results, series and checkpoints in a folder.

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>

#include "app/run_progress.hpp"
#include "io/checkpoint.hpp"
#include "io/results_writer.hpp"
#include "io/scene.hpp"
#include "osculate/dynamics/simulation.hpp"

namespace osculate::app {

class SceneRun {
 public:
  /// From the start, or from a checkpoint of the same scene. The folder is made if it is missing; from the start, what
  /// an earlier run left there is replaced. Throws InputError if the folder cannot be written to or the scene cannot
  /// start; what was there is then as before.
  SceneRun(const io::Scene& scene, const std::filesystem::path& folder, const std::optional<io::Checkpoint>& from);

  /// To the end, or until `stop` is not zero. Throws InputError if the simulation or the file system fails; what was
  /// written stays.
  void run(const std::atomic<int>& stop);

  bool is_done() const { return simulation_.steps() >= steps_; }
  const Simulation& simulation() const { return simulation_; }
  double particle_steps() const { return particle_steps_; }  ///< of this run: steps of every free body

 private:
  void record();
  void add_row();
  void add_frame();
  void add_checkpoint();
  std::uint64_t steps_to_next_look() const;

  using Clock = std::chrono::steady_clock;

  const io::Scene& scene_;
  std::filesystem::path folder_;
  std::uint64_t steps_, frame_every_, row_every_;
  Simulation simulation_;
  io::ResultsWriter results_;
  io::NumberTable pending_;  ///< rows that are not yet in the results
  std::ofstream csv_;
  double step_seconds_ = 0.0;  ///< a recent guess
  double particle_steps_ = 0.0;
  Clock::time_point last_checkpoint_ = Clock::now();
};

/// The checkpoint from which a scene's run goes on. Throws InputError if there is none in the folder, or one of another
/// scene; a damaged one is warned about if the one before it serves.
io::Checkpoint checkpoint_for(const io::Scene& scene, const std::filesystem::path& folder);

std::filesystem::path results_path(const std::filesystem::path& folder);
std::filesystem::path series_path(const std::filesystem::path& folder);

}  // namespace osculate::app
