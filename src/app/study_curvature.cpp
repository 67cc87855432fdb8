#include "app/study_curvature.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "app/study_curvature_report.hpp"
#include "io/atomic_file.hpp"
#include "io/progress.hpp"
#include "osculate/core/error.hpp"
#include "validation/curvature_models/sweep.hpp"

#ifdef OSCULATE_HAS_FFTW
#include "osculate/mechanics/hertz.hpp"
#include "validation/halfspace/gap.hpp"
#include "validation/halfspace/solver.hpp"
#endif

namespace osculate::app {
namespace {

namespace study = validation::curvature_models;

constexpr const char* help =
    R"(Simpler pictures of a contact than the common normal with both bodies' principal curvatures: one radius a body, from the
Gaussian curvature with the review's cap, from the mean curvature, or of the sphere of equal volume; and the contact of
the geometric potential, which several codes use. Random orientations, as two bodies meet that come together along a
random line. The reference is the elliptical Hertz contact of the exact curvatures or, with --halfspace, an elastic
half-space under the bodies' true surfaces, which judges the exact curvatures too.
Examples:
  osculate study curvature
  osculate study curvature --exponent 2 4 8 --aspect 0.5 1 3 --orientations 1000 --out curvature/
  osculate study curvature --halfspace --orientations 20 --cells 64)";

struct Options {
  study::Sweep sweep;
  bool csv = false;
  bool json = false;
  bool halfspace = false;
  int cells = 64;
  std::string folder;
};

#ifdef OSCULATE_HAS_FFTW
namespace halfspace = validation::halfspace;

/// The contact of the bodies' true surfaces. Nothing where the solver has no answer, or no grid holds the contact.
std::optional<study::Load> on_halfspace(const study::ContactCase& contact, int cells) {
  if (contact.contact.status != ContactStatus::touching || !study::exact_hertz(contact)) return std::nullopt;
  const double overlap = contact.contact.overlap;
  const RelativeCurvature& relative = contact.contact.relative;
  const double smallest = 1.0 / std::max(contact.contact.curvature_1.max, contact.contact.curvature_2.max);
  const hertz::Contact guess = hertz::contact(contact_ellipse(relative.R_i, relative.R_j), 1.0, overlap, smallest);
  const halfspace::GapField gap =
      halfspace::true_gap(contact.body, contact.pose_1, contact.body, contact.pose_2, contact.contact);
  const halfspace::Grid grid = halfspace::grid_around(gap, overlap, guess.b_c, cells);
  const halfspace::Solution solution = halfspace::solve(grid, halfspace::sampled(gap, grid), 1.0, overlap);
  if (!solution.converged) return std::nullopt;
  return study::Load{.force = solution.force, .area = solution.area};
}

study::Reference reference_of(const Options& options) {
  if (!options.halfspace) return study::exact_hertz;
  return [cells = options.cells](const study::ContactCase& contact) { return on_halfspace(contact, cells); };
}
#else
study::Reference reference_of(const Options& options) {
  if (options.halfspace)
    throw InputError("study curvature", "--halfspace in a program built without FFTW",
                     "one configured with -DOSCULATE_WITH_FFTW=ON");
  return study::exact_hertz;
}
#endif

void write_files(const std::filesystem::path& folder, const std::vector<study::CaseErrors>& errors,
                 const CurvatureStudyTitle& title) {
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);
  if (trouble) throw InputError(folder.string(), trouble.message(), "a folder that can be made");
  const std::string path = (folder / "curvature").string();
  const std::vector<StudyColumn> columns = curvature_study_columns(errors);
  const io::Plot plot = curvature_study_plot(errors, title);
  io::write_atomically(path + ".csv", csv_of(columns));
  io::write_atomically(path + ".h5", hdf5_of(columns, title));
  io::write_plot(plot, path + ".svg");
  io::write_plot(plot, path + ".png");
}

void study_curvature(const Options& options) {
  std::vector<study::CaseErrors> errors;
  {
    io::Progress progress("study curvature");
    errors = study::errors(options.sweep, reference_of(options), [&](double done) { progress.update(done); });
  }
  const CurvatureStudyTitle title{
      .reference = options.halfspace ? fmt::format("an elastic half-space of {0} × {0} cells", options.cells)
                                     : "elliptical Hertz with the exact curvatures",
      .orientations = options.sweep.orientations};
  if (options.csv)
    fmt::print("{}", csv_of(curvature_study_columns(errors)));
  else if (options.json)
    fmt::print("{}\n", json_of(curvature_study_columns(errors)));
  else
    fmt::print("{}", curvature_study_text(errors, title));
  if (options.folder.empty()) return;
  write_files(options.folder, errors, title);
  if (!options.csv && !options.json)
    fmt::print("\nEvery contact, and the picture: curvature.csv, .h5, .svg and .png in {}\n", options.folder);
}

}  // namespace

void add_curvature_study(CLI::App& study) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = study.add_subcommand(
      "curvature",
      "Error of simpler models of curvature, and of the geometric potential, over shapes and orientations");
  command->footer(help);
  command->add_option("--exponent", options->sweep.exponents, "Exponents n of the superquadrics")
      ->capture_default_str();
  command->add_option("--aspect", options->sweep.aspects, "Aspect ratios c/a, half-axes 1 : 1 : c/a")
      ->capture_default_str();
  command->add_option("--overlap", options->sweep.overlaps, "Overlaps over R_vol")->capture_default_str();
  command->add_option("--orientations", options->sweep.orientations, "Random orientations of each")
      ->capture_default_str();
  command->add_option("--cap", options->sweep.cap, "Largest radius of curvature, in R_vol; inf for none")
      ->capture_default_str();
  command->add_option("--seed", options->sweep.seed, "Of the orientations")->capture_default_str();
  command->add_flag("--halfspace", options->halfspace, "Judge by an elastic half-space under the true surfaces");
  command->add_option("--cells", options->cells, "Cells each way of the half-space")
      ->check(CLI::Range(16, 1024))
      ->capture_default_str();
  CLI::Option* csv = command->add_flag("--csv", options->csv, "Print every contact as CSV");
  command->add_flag("--json", options->json, "Print every contact as JSON, by columns")->excludes(csv);
  command->add_option("--out", options->folder, "Write every contact as CSV and HDF5, and a picture, into a folder");
  command->callback([options] { study_curvature(*options); });
}

}  // namespace osculate::app
