// osculate-lammps: LAMMPS with Osculate's contacts.

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "lammps/scene_host.hpp"
#include "lammps/styles.hpp"
#include "osculate/core/error.hpp"

namespace osculate::lammps {
namespace {

/// An ordinary LAMMPS input script, with LAMMPS's own arguments.
void run_script(int argc, char** argv) {
  LAMMPS_NS::LAMMPS lmp(argc, argv, MPI_COMM_WORLD);
  add_styles(lmp);
  lmp.input->file();
}

struct SceneArguments {
  std::string scene, dump;
  std::uint64_t steps = 0, dump_every = 0;
};

void run_scene_file(const SceneArguments& arguments) {
  const io::Scene scene = io::read_scene(arguments.scene);
  SceneOrders orders = orders_of(scene);
  if (arguments.steps > 0) orders.steps = arguments.steps;
  if (arguments.dump_every > 0) orders.dump_every = orders.thermo_every = arguments.dump_every;
  if (!arguments.dump.empty()) orders.dump = arguments.dump;
  std::string name = "osculate-lammps", log = "-log", none = "none";
  char* plain[] = {name.data(), log.data(), none.data(), nullptr};
  LAMMPS_NS::LAMMPS lmp(3, plain, MPI_COMM_WORLD);
  add_styles(lmp);
  run_scene(lmp, scene, orders);
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
      "  osculate-lammps SCENE.toml [options]   a scene file\n"
      "  osculate-lammps -in SCRIPT [options]   an ordinary LAMMPS input script and LAMMPS's options",
      "osculate-lammps");
  SceneArguments arguments;
  app.add_option("scene", arguments.scene, "scene file (docs/scene-files.md)")->required();
  app.add_option("--steps", arguments.steps, "time steps in place of the scene's duration");
  app.add_option("--dump", arguments.dump, "frames for OVITO; SCENE.lammpstrj if not given");
  app.add_option("--every", arguments.dump_every, "steps between frames and between lines of numbers");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  run_scene_file(arguments);
  return 0;
}

}  // namespace
}  // namespace osculate::lammps

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int result = 1;
  try {
    result = osculate::lammps::run(argc, argv);
  } catch (const std::exception& error) {
    // One rank may stand alone here: the others are not waited for.
    std::cerr << "osculate-lammps: " << error.what() << '\n';
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return result;
}
