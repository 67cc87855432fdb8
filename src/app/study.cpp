// osculate study: sweeps that show where a model holds.

#include "app/commands.hpp"
#include "app/study_curvature.hpp"

#ifdef OSCULATE_HAS_FFTW
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "io/progress.hpp"
#include "io/table.hpp"
#include "validation/halfspace/curvature_error.hpp"
#endif

namespace osculate::app {

#ifdef OSCULATE_HAS_FFTW
namespace {

namespace halfspace = validation::halfspace;

constexpr const char* halfspace_help =
    R"(Hertz sees two radii of curvature where the bodies meet. This solves the contact of the bodies' true surfaces instead,
cell by cell on an elastic half-space (Boussinesq's deflection by FFT, conjugate gradients after Polonsky & Keer), and
prints how far the elliptical Hertz force at the same overlap is off. Two equal superquadrics of half-axes 1 : 1 : 1 meet
where their normal leans by the tilt from the axis of a face: for n > 2 the face is flat in its middle.
Examples:
  osculate study halfspace
  osculate study halfspace --exponent 4 --tilt 1 2 5 --overlap 1e-3 --cells 256
  osculate study halfspace --csv > halfspace.csv)";

enum class Format { table, csv, json };

struct Options {
  halfspace::CurvatureStudy study;
  bool csv = false;
  bool json = false;

  Format format() const { return json ? Format::json : csv ? Format::csv : Format::table; }
};

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

std::string percent(double error) {
  const double value = 100.0 * error;
  return fmt::format("{:+.{}f} %", value, std::fabs(value) < 10.0 ? 2 : 1);
}

void print_table(const std::vector<halfspace::CurvatureError>& errors, const halfspace::CurvatureStudy& study) {
  io::Table table{{"n", "tilt", "R_i / R_vol", "R_j / R_vol"}, {}};
  for (const double overlap : study.overlaps) table.header.push_back(fmt::format("δ = {:g} R_vol", overlap));
  double own = 0.0;
  std::size_t failures = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const halfspace::CurvatureError& error = errors[i];
    if (i % study.overlaps.size() == 0)
      table.rows.push_back({fmt::format("{:g}", error.input.exponent),
                            fmt::format("{:.3g}°", degrees(error.input.tilt)), fmt::format("{:.3g}", error.R_i),
                            fmt::format("{:.3g}", error.R_j)});
    table.rows.back().push_back(error.converged ? percent(error.force_error) : "no answer");
    own = std::max(own, std::fabs(error.quadratic_error));
    if (!error.converged) ++failures;
  }
  fmt::print(
      "Error of the elliptical Hertz force at a given overlap δ: what two radii of curvature miss of the bodies' true\n"
      "shape. Against an elastic half-space of {0} × {0} cells.\n\n{1}\n"
      "The solver itself, on gaps that are exactly quadratic: {2:.3f} % off Hertz at most.\n",
      study.cells, io::to_text(table), 100.0 * own);
  if (failures > 0) fmt::print("Not converged: {} of {}.\n", failures, errors.size());
}

void print_csv(const std::vector<halfspace::CurvatureError>& errors) {
  fmt::print(
      "exponent,tilt_deg,overlap_over_Rvol,Ri_over_Rvol,Rj_over_Rvol,force_over_E_Rvol2,area_over_Rvol2,force_error,"
      "area_error,peak_pressure_error,solver_error,ac_over_Rvol,converged\n");
  for (const auto& e : errors)
    fmt::print("{:g},{:.17g},{:g},{:.17g},{:.17g},{:.17g},{:.17g},{:.6e},{:.6e},{:.6e},{:.6e},{:.17g},{:d}\n",
               e.input.exponent, degrees(e.input.tilt), e.input.overlap, e.R_i, e.R_j, e.force, e.area, e.force_error,
               e.area_error, e.peak_error, e.quadratic_error, e.contact_size, e.converged);
}

void print_json(const std::vector<halfspace::CurvatureError>& errors, const halfspace::CurvatureStudy& study) {
  nlohmann::ordered_json report{{"cells", study.cells}, {"contacts", nlohmann::ordered_json::array()}};
  for (const auto& e : errors)
    report["contacts"].push_back({{"exponent", e.input.exponent},
                                  {"tilt_deg", degrees(e.input.tilt)},
                                  {"overlap_over_Rvol", e.input.overlap},
                                  {"Ri_over_Rvol", e.R_i},
                                  {"Rj_over_Rvol", e.R_j},
                                  {"force_over_E_Rvol2", e.force},
                                  {"area_over_Rvol2", e.area},
                                  {"force_error", e.force_error},
                                  {"area_error", e.area_error},
                                  {"peak_pressure_error", e.peak_error},
                                  {"solver_error", e.quadratic_error},
                                  {"ac_over_Rvol", e.contact_size},
                                  {"converged", e.converged}});
  fmt::print("{}\n", report.dump(2));
}

void study_halfspace(const Options& options) {
  std::vector<halfspace::CurvatureError> errors;
  {
    io::Progress progress("study halfspace");
    errors = halfspace::curvature_errors(options.study, [&](double fraction) { progress.update(fraction); });
  }
  switch (options.format()) {
    case Format::table:
      return print_table(errors, options.study);
    case Format::csv:
      return print_csv(errors);
    case Format::json:
      return print_json(errors, options.study);
  }
}

void add_halfspace(CLI::App& study) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = study.add_subcommand(
      "halfspace", "Error of the elliptical Hertz force of blocky bodies, against an elastic half-space solver");
  command->footer(halfspace_help);
  command->add_option("--exponent", options->study.exponents, "Exponents n of the superquadrics")
      ->capture_default_str();
  command->add_option("--tilt", options->study.tilts, "Angles between normal and face axis [degrees]")
      ->capture_default_str();
  command->add_option("--overlap", options->study.overlaps, "Overlaps over R_vol")->capture_default_str();
  command->add_option("--cells", options->study.cells, "Cells each way")->capture_default_str();
  CLI::Option* csv = command->add_flag("--csv", options->csv, "Print all numbers as CSV");
  command->add_flag("--json", options->json, "Print all numbers as JSON")->excludes(csv);
  command->callback([options] { study_halfspace(*options); });
}

}  // namespace
#endif

void add_study(CLI::App& program) {
  CLI::App* study = program.add_subcommand("study", "Sweep a model and see where it holds");
  study->require_subcommand(1);
  add_curvature_study(*study);
#ifdef OSCULATE_HAS_FFTW
  add_halfspace(*study);
#endif
}

}  // namespace osculate::app
