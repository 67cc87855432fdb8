// osculate-lammps: LAMMPS with Osculate's contacts.

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lammps/engine_report.hpp"
#include "lammps/scene_host.hpp"
#include "lammps/styles.hpp"
#include "osculate/core/error.hpp"

namespace osculate::lammps {
namespace {

constexpr int missed_bar = 1, wrong_input = 2, internal_error = 3;  // as of the program osculate

/// An ordinary LAMMPS input script, with LAMMPS's own arguments.
void run_script(int argc, char** argv) {
  LAMMPS_NS::LAMMPS lmp(argc, argv, MPI_COMM_WORLD);
  add_styles(lmp);
  lmp.input->file();
}

struct SceneArguments {
  std::string scene, folder;
  std::uint64_t steps = 0, every = 0;
  bool overwrite = false, validate = false, bench = false;
  int beginnings = 5, rounds = 15;
};

/// What every rank reads, or nothing if one of them cannot: the first of these says why.
template <class Read>
auto on_all_ranks(const Read& read) -> std::optional<decltype(read())> {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::optional<decltype(read())> value;
  std::string complaint;
  try {
    value = read();
  } catch (const InputError& error) {
    complaint = error.what();
  }
  const int mine = value ? ranks : rank;
  int first = ranks;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (first == ranks) return value;
  if (first == rank) std::cerr << "osculate-lammps: " << complaint << '\n';
  return std::nullopt;
}

int run_scene_file(const SceneArguments& arguments) {
  const auto scene = on_all_ranks([&] { return io::read_scene(arguments.scene); });
  if (!scene) return wrong_input;
  if (arguments.validate) return validate_engines(*scene, arguments.beginnings) ? 0 : missed_bar;
  if (arguments.bench) {
    bench_engines(*scene, arguments.rounds, arguments.steps > 0 ? arguments.steps : 200);
    return 0;
  }
  const std::filesystem::path folder =
      arguments.folder.empty() ? scene->file.stem() : std::filesystem::path(arguments.folder);
  if (!on_all_ranks([&] { return ready_folder(folder, arguments.overwrite); })) return wrong_input;
  SceneOrders orders = orders_of(*scene, folder);
  if (arguments.steps > 0) orders.steps = arguments.steps;
  if (arguments.every > 0) orders.frame_every = orders.row_every = arguments.every;
  const auto lmp = start_lammps(MPI_COMM_WORLD, {"-log", log_path(folder).string()});
  if (lmp->comm->me == 0)
    for (const std::string& warning : scene->warnings) std::cerr << "osculate-lammps: warning: " << warning << '\n';
  build_scene(*lmp, *scene);
  run_scene(*lmp, orders);
  return 0;
}

int run(int argc, char** argv) {
  // With an option in front it is LAMMPS's command line.
  const bool is_script =
      argc > 1 && std::string_view(argv[1]).starts_with("-") && std::string_view(argv[1]) != "--help";
  if (is_script) {
    run_script(argc, argv);
    return 0;
  }
  CLI::App app(
      "LAMMPS with Osculate's contacts, under mpirun or alone.\n"
      "  osculate-lammps SCENE.toml [options]   a scene file, as osculate run SCENE.toml --engine lammps\n"
      "  osculate-lammps -in SCRIPT [options]   an ordinary LAMMPS input script and LAMMPS's options",
      "osculate-lammps");
  SceneArguments arguments;
  app.add_option("SCENE", arguments.scene, "A scene file (docs/scene-files.md)")->required();
  app.add_option("--out", arguments.folder, "The folder of the results; the scene's name if not given")
      ->type_name("DIR");
  app.add_flag("--overwrite", arguments.overwrite, "Replace the results of an earlier run");
  app.add_option("--steps", arguments.steps, "Time steps in place of the scene's duration");
  app.add_option("--every", arguments.every, "Steps between frames and between lines of numbers");
  app.add_flag("--validate", arguments.validate,
               "Run it on Osculate's own engine too, and on 1, 2, 4 … of the ranks: do they agree?");
  app.add_option("--beginnings", arguments.beginnings, "How many runs of each engine bulk results are taken from")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app.add_flag("--bench", arguments.bench,
               "Run it to its end on Osculate's own engine, then measure what a step costs from there, on both");
  app.add_option("--rounds", arguments.rounds, "Turns of each engine in a bench, of --steps steps, 200 if not given")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  return run_scene_file(arguments);
}

}  // namespace
}  // namespace osculate::lammps

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int result = 0;
  try {
    result = osculate::lammps::run(argc, argv);
  } catch (const osculate::InputError& error) {
    // One rank may stand alone here: the others are not waited for.
    std::cerr << "osculate-lammps: " << error.what() << '\n';
    MPI_Abort(MPI_COMM_WORLD, osculate::lammps::wrong_input);
  } catch (const std::exception& error) {
    std::cerr << "osculate-lammps: internal error: " << error.what() << '\n';
    MPI_Abort(MPI_COMM_WORLD, osculate::lammps::internal_error);
  }
  MPI_Finalize();
  return result;
}
