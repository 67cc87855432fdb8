// osculate export: results for other programs.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "io/ovito.hpp"
#include "io/paraview.hpp"
#include "io/progress.hpp"
#include "io/results_file.hpp"
#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

struct ExportOptions {
  std::string results;
  std::string paraview;
  std::string ovito;
  int resolution = 6;
};

constexpr const char* help = R"(Examples:

  osculate export results.h5 --paraview run.pvd   open run.pvd in ParaView: a time series of the particles' surfaces,
                                                  with id, shape, speed, velocity and energy to colour them by
  osculate export results.h5 --ovito run.dump     open run.dump in OVITO: it finds half axes, orientation and roundness
                                                  by the names of the columns and draws superquadrics itself)";

void export_results(const ExportOptions& options) {
  if (options.paraview.empty() && options.ovito.empty()) {
    throw InputError("export", "neither --paraview nor --ovito", "at least one of them");
  }
  const io::ResultsFile results(options.results);
  if (results.frame_count() == 0) throw InputError(options.results, "no frame", "at least one");
  const auto telling = [&](io::Progress& progress) {
    return [&](std::size_t frames) {
      progress.update(static_cast<double>(frames) / static_cast<double>(results.frame_count()));
    };
  };
  if (!options.paraview.empty()) {
    {
      io::Progress progress("Writing for ParaView");
      write_paraview(results, options.resolution, options.paraview, telling(progress));
    }
    fmt::print("{}: {} frames\n", options.paraview, results.frame_count());
  }
  if (!options.ovito.empty()) {
    {
      io::Progress progress("Writing for OVITO");
      write_ovito(results, options.ovito, telling(progress));
    }
    fmt::print("{}: {} frames\n", options.ovito, results.frame_count());
    for (const io::ResultsShape& shape : results.shapes()) {
      if (!io::ovito_shape(shape.shape).is_stand_in) continue;
      fmt::print("  OVITO has no {}: \"{}\" is drawn as the sphere of equal volume.\n", kind(shape.shape), shape.name);
    }
  }
}

}  // namespace

void add_export(CLI::App& program) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand("export", "Results for ParaView and OVITO");
  command->footer(help);
  command->add_option("results", options->results, "Results file of `osculate run`")->required();
  command->add_option("--paraview", options->paraview, "A .pvd file and a folder of .vtp files beside it");
  command->add_option("--ovito", options->ovito, "A LAMMPS-style dump");
  command->add_option("--resolution", options->resolution, "Of the surfaces for ParaView: 12 n² triangles a particle")
      ->capture_default_str()
      ->check(CLI::Range(2, 64));
  command->callback([options] { export_results(*options); });
}

}  // namespace osculate::app
