#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/commands.hpp"
#include "app/lammps_program.hpp"
#include "app/scene_run.hpp"
#include "io/quantity_text.hpp"
#include "io/scene.hpp"
#include "io/table.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/measures.hpp"

namespace osculate::app {
namespace {

constexpr const char* help =
    R"(A scene file says what there is (materials and their laws, particles, walls), how long it goes on and what is kept;
docs/scene-files.md explains its keys, examples/scenes has some to start from.

  osculate check examples/scenes/settling-box.toml      what it would do
  osculate run examples/scenes/settling-box.toml        do it: results in ./settling-box
  osculate run examples/scenes/settling-box.toml --resume   go on after a stop, a crash or a power cut

Into the folder go results.h5 (frames and series; docs/results-files.md), series.csv and two checkpoints. Ctrl-C stops
with a checkpoint. A resumed run gives the same numbers, bit by bit, as one that was never stopped; so does any number
of threads.

  mpirun -n 4 osculate run SCENE.toml --engine lammps   the same scene on LAMMPS, over MPI (docs/lammps.md)

Into the folder go frames.lammpstrj and log.lammps then.)";

// A signal handler can reach nothing else.
std::atomic<int> stop_signal{0};
static_assert(std::atomic<int>::is_always_lock_free);

/// While it lives, SIGINT and SIGTERM ask for a stop; a second one kills.
class StopOnSignal {
 public:
  StopOnSignal() {
    struct sigaction action {};
    action.sa_handler = [](int signal) { stop_signal = signal; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, &old_interrupt_);
    sigaction(SIGTERM, &action, &old_terminate_);
  }
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  ~StopOnSignal() {
    sigaction(SIGINT, &old_interrupt_, nullptr);
    sigaction(SIGTERM, &old_terminate_, nullptr);
  }

 private:
  struct sigaction old_interrupt_ {
  }, old_terminate_{};
};

struct Options {
  std::string scene, folder, engine = "embedded";
  int threads = 0;
  bool resume = false, overwrite = false;
};

[[noreturn]] void run_on_lammps(const Options& options) {
  constexpr const char* where = "--engine lammps";
  if (options.resume) throw InputError(where, "found --resume", "a run from the start: LAMMPS has no checkpoints here");
  if (options.threads > 0) throw InputError(where, "found --threads", "ranks: mpirun -n N osculate run …");
  std::vector<std::string> arguments{options.scene};
  if (!options.folder.empty()) arguments.insert(arguments.end(), {"--out", options.folder});
  if (options.overwrite) arguments.emplace_back("--overwrite");
  become_lammps(arguments);
}

/// What came in of each pour; a warning for those whose particles found no place.
void print_pours(const Simulation& simulation) {
  const std::vector<Pour>& pours = simulation.setup().pours;
  if (pours.empty()) return;
  io::Table table{{"pour", "particles", "mass", "due"}, {}, 1};
  std::vector<std::size_t> behind;
  for (std::size_t p = 0; p < pours.size(); ++p) {
    const Poured& poured = simulation.poured()[p];
    const bool by_mass = pours[p].measure == Pour::Measure::mass;
    const auto mass_text = [](double mass) { return io::quantity_text(1e3 * mass, "g"); };
    const double wanted = due(pours[p], simulation.time()), came = arrived(pours[p], poured);
    table.rows.push_back({fmt::format("{}", p + 1), fmt::format("{}", poured.particles), mass_text(poured.mass),
                          by_mass ? mass_text(wanted) : fmt::format("{:.0f}", wanted)});
    // What was due at the last look and a particle more may be on its way.
    constexpr double share = 0.98;
    const double one = by_mass && poured.particles > 0 ? came / static_cast<double>(poured.particles) : 1.0;
    if (poured.particles < pours[p].most && came < share * wanted - 2.0 * one) behind.push_back(p + 1);
  }
  fmt::print("\n{}", io::to_text(table));
  for (const std::size_t p : behind)
    fmt::print(stderr, "osculate: warning: pour {} fell behind: its region was full\n", p);
}

void print_summary(const Simulation& simulation, double particle_steps, double seconds) {
  const EnergyLedger energy = simulation.energy();
  const Connectivity net = connectivity(simulation);
  const auto joule = [](double value) { return io::quantity_text(value, "J"); };
  const auto less = [&](double value) { return joule(0.0 - value); };  // nothing is 0, not -0
  fmt::print("{}", io::to_text(std::vector<io::Property>{
                       {"time", io::quantity_text(simulation.time(), "s")},
                       {"steps", fmt::format("{}", simulation.steps())},
                       {"computing", fmt::format("{}: {:.3g} µs per particle-step", io::clock_text(seconds),
                                                 1e6 * seconds / std::max(particle_steps, 1.0))},
                       {"particles", fmt::format("{}", net.particles)},
                       {"contacts", fmt::format("{}   {:.3g} a particle with walls, {:.3g} without", net.contacts,
                                                net.coordination, net.particle_coordination)},
                   }));
  const io::Table ledger{{"energy", "J"},
                         {{"kinetic", joule(energy.kinetic)},
                          {"rotational", joule(energy.rotational)},
                          {"gravity", joule(energy.gravity)},
                          {"stored along normals", joule(energy.stored_normal)},
                          {"stored in friction and rolling springs", joule(energy.stored_tangential)},
                          {"lost to viscosity", joule(energy.viscous_loss)},
                          {"lost to friction", joule(energy.friction_loss)},
                          {"lost to hysteresis", joule(energy.hysteresis_loss)},
                          {"less the work of driven bodies", less(energy.driven_work)},
                          {"less what particles poured brought", less(energy.poured)},
                          {"less what springs gained by curvature", less(energy.curvature_gain)},
                          {"sum, constant but for the time step", joule(energy.balance())}},
                         1};
  fmt::print("\n{}", io::to_text(ledger));
}

void run(const Options& options) {
  if (options.engine == "lammps") run_on_lammps(options);
  const StopOnSignal signals;
  io::Scene scene = io::read_scene(options.scene);
  scene.setup.threads =
      options.threads > 0 ? options.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const std::filesystem::path folder =
      options.folder.empty() ? scene.file.stem() : std::filesystem::path(options.folder);
  for (const std::string& warning : scene.warnings) fmt::print(stderr, "osculate: warning: {}\n", warning);
  std::optional<io::Checkpoint> from;
  if (options.resume)
    from = checkpoint_for(scene, folder);
  else if (!options.overwrite && std::filesystem::exists(results_path(folder)))
    throw InputError(results_path(folder).string(), "found results of an earlier run",
                     "--resume to go on, --overwrite to start anew, or another folder by --out");
  SceneRun scene_run(scene, folder, from);
  const auto begin = std::chrono::steady_clock::now();
  scene_run.run(stop_signal);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  fmt::print("{}\n\n", scene.title);
  print_summary(scene_run.simulation(), scene_run.particle_steps(), spent.count());
  print_pours(scene_run.simulation());
  fmt::print("\nResults: {} and {}\n", results_path(folder).string(), series_path(folder).string());
  if (scene_run.is_done()) return;
  fmt::print(stderr, "osculate: stopped at t = {} of {}; go on with: osculate run {} --out {} --resume\n",
             io::quantity_text(scene_run.simulation().time(), "s"), io::quantity_text(scene.duration, "s"),
             options.scene, folder.string());
  constexpr int stopped_by = 128;  // and the signal's number, as shells say it
  throw CLI::RuntimeError(stopped_by + stop_signal);
}

}  // namespace

void add_run(CLI::App& program) {
  CLI::App* command = program.add_subcommand("run", "Run a scene");
  command->footer(help);
  const auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "A scene file")->required();
  command->add_option("--out", options->folder, "The folder of the results; the scene's name if not given")
      ->type_name("DIR");
  command->add_option("--threads", options->threads, "How many; all cores if not given")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command->add_option("--engine", options->engine, "Osculate's own, or LAMMPS under mpirun")
      ->check(CLI::IsMember({"embedded", "lammps"}))
      ->capture_default_str();
  CLI::Option* resume = command->add_flag("--resume", options->resume, "Go on from the last checkpoint");
  command->add_flag("--overwrite", options->overwrite, "Replace the results of an earlier run")->excludes(resume);
  command->callback([options] { run(*options); });
}

}  // namespace osculate::app
