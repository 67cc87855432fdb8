#include "app/scene_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "app/scene_frames.hpp"
#include "io/atomic_file.hpp"
#include "io/checksum.hpp"
#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

constexpr double seconds_between_looks = 0.1;  // at signals and clocks

/// What went wrong in a step is put to whoever wrote the scene.
template <class Work>
auto for_scene(const io::Scene& scene, const Work& work) {
  try {
    return work();
  } catch (const StepError& error) {
    throw InputError(fmt::format("{}: {}", scene.file.string(), error.what()), "found a state that cannot be computed",
                     "bodies that start apart, a shorter step, a stiffer material or slower bodies; `osculate check` "
                     "says which body is which");
  }
}

std::ptrdiff_t free_bodies(const Bodies& bodies) {
  return std::count(bodies.motion.begin(), bodies.motion.end(), Bodies::free);
}

Simulation make_simulation(const io::Scene& scene, const std::optional<io::Checkpoint>& from) {
  return for_scene(scene, [&] { return from ? Simulation(scene.setup, from->state) : Simulation(scene.setup); });
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be made (" + error.message() + ")", "a place for the results");
}

io::ResultsWriter make_results(const io::Scene& scene, const std::filesystem::path& folder,
                               const Simulation& simulation, const std::optional<io::Checkpoint>& from) {
  if (from) return {results_path(folder), from->frames, from->rows};
  make_folder(folder);
  io::ResultsWriter results(results_path(folder), head_of(scene, simulation), series_names(scene));
  io::remove_checkpoints(folder);
  return results;
}

std::string csv_row(const std::vector<double>& row) {
  return fmt::format("{}\n", fmt::join(row, ","));
}

/// Holds the rows that are in the results, and is open for more.
std::ofstream open_csv(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       const io::NumberTable& rows) {
  const std::string path = series_path(folder).string();
  io::write_atomically(path, rows.rows() == 0 ? fmt::format("{}\n", fmt::join(names, ",")) : io::to_csv(rows));
  std::ofstream csv(path, std::ios::app);
  if (!csv) throw InputError(path, "cannot be opened", "a file to write the series to");
  return csv;
}

}  // namespace

io::Checkpoint checkpoint_for(const io::Scene& scene, const std::filesystem::path& folder) {
  std::optional<io::FoundCheckpoint> found = io::find_checkpoint(folder);
  if (!found)
    throw InputError(folder.string(), "found no checkpoint", "a folder of an earlier run; leave out --resume to start");
  for (const std::string& complaint : found->complaints)
    fmt::print(stderr, "osculate: warning: {}; going on from the one before it\n", complaint);
  if (found->checkpoint.scene != io::crc64(scene.text))
    throw InputError(folder.string(), "found a checkpoint of another scene",
                     fmt::format("one of {} as it is now: a run goes on with an unchanged scene", scene.file.string()));
  return std::move(found->checkpoint);
}

std::filesystem::path results_path(const std::filesystem::path& folder) {
  return folder / "results.h5";
}
std::filesystem::path series_path(const std::filesystem::path& folder) {
  return folder / "series.csv";
}

SceneRun::SceneRun(const io::Scene& scene, const std::filesystem::path& folder,
                   const std::optional<io::Checkpoint>& from)
    : scene_(scene),
      folder_(folder),
      steps_(scene.steps()),
      frame_every_(scene.steps_in(scene.output.interval)),
      row_every_(scene.steps_in(scene.output.series_interval)),
      simulation_(make_simulation(scene, from)),
      results_(make_results(scene, folder, simulation_, from)),
      pending_{series_names(scene), std::vector<std::vector<double>>(series_names(scene).size())},
      csv_(open_csv(folder, pending_.names, from ? results_.series() : pending_)) {
  if (from) return;
  record();
  add_checkpoint();
}

/// What is due at this step.
void SceneRun::record() {
  const std::uint64_t step = simulation_.steps();
  if (step % row_every_ == 0 || step == steps_) add_row();
  if (step % frame_every_ == 0 || step == steps_) add_frame();
}

void SceneRun::add_row() {
  const std::vector<double> row = series_row(scene_, simulation_);
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (!std::isfinite(row[k]))
      throw std::runtime_error(
          fmt::format("step {}: the series' {} is {}", simulation_.steps(), pending_.names[k], row[k]));
    pending_.columns[k].push_back(row[k]);
  }
  csv_ << csv_row(row) << std::flush;
  if (!csv_)
    throw InputError(series_path(folder_).string(), std::string("cannot be written (") + std::strerror(errno) + ")",
                     "a place where results can be written");
}

void SceneRun::add_frame() {
  std::optional<io::ContactFrame> contacts;
  if (scene_.output.contacts) contacts = contacts_of(simulation_);
  results_.append(frame_of(scene_, simulation_), contacts, pending_);
  for (auto& column : pending_.columns) column.clear();
}

void SceneRun::add_checkpoint() {
  // A checkpoint stands on rows that are safe.
  results_.append_series(pending_);
  for (auto& column : pending_.columns) column.clear();
  io::write_checkpoint(folder_, {.scene = io::crc64(scene_.text),
                                 .frames = results_.frames(),
                                 .rows = results_.rows(),
                                 .state = simulation_.state()});
  last_checkpoint_ = Clock::now();
}

std::uint64_t SceneRun::steps_to_next_look() const {
  const std::uint64_t step = simulation_.steps();
  std::uint64_t next = std::min({steps_ - step, frame_every_ - step % frame_every_, row_every_ - step % row_every_});
  const double affordable = step_seconds_ > 0.0 ? std::max(seconds_between_looks / step_seconds_, 1.0) : 1.0;
  if (affordable < static_cast<double>(next)) next = static_cast<std::uint64_t>(affordable);
  return next;
}

void SceneRun::run(const std::atomic<int>& stop) {
  RunProgress progress(simulation_.steps());
  const std::chrono::duration<double> checkpoint_every(scene_.output.checkpoint_every);
  while (!is_done() && stop == 0) {
    const std::uint64_t count = steps_to_next_look();
    const Clock::time_point before = Clock::now();
    particle_steps_ += static_cast<double>(count) * static_cast<double>(free_bodies(simulation_.bodies()));
    for_scene(scene_, [&] { simulation_.advance(count); });
    step_seconds_ = std::chrono::duration<double>(Clock::now() - before).count() / static_cast<double>(count);
    record();
    if (progress.is_due()) {
      const EnergyLedger energy = simulation_.energy();
      progress.show({.time = simulation_.time(),
                     .duration = scene_.duration,
                     .step = simulation_.steps(),
                     .steps = steps_,
                     .contacts = simulation_.counts().contacts,
                     .kinetic_energy = energy.kinetic + energy.rotational});
    }
    if (Clock::now() - last_checkpoint_ >= checkpoint_every) add_checkpoint();
  }
  add_checkpoint();
}

}  // namespace osculate::app
