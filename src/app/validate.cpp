// osculate validate: the library against independent witnesses.

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/validate_flow.hpp"
#include "app/validate_impact.hpp"
#include "app/validate_narrow.hpp"
#include "app/validate_packing.hpp"
#include "io/table.hpp"
#include "osculate/core/error.hpp"
#include "validation/contact_mechanics/reference_errors.hpp"

#ifdef OSCULATE_HAS_CGAL
#include <limits>

#include "validation/curvature/jet_curvature.hpp"
#endif

namespace osculate::app {
namespace {

#ifdef OSCULATE_HAS_CGAL

/// Below this, rounding of the points over h² hides the order.
constexpr double rounding = 1e-10;

void validate_curvature() {
  const auto fits = validation::jet_fits();
  io::Table table{{"shape", "place", "h / R_vol", "error of k_max", "error of k_min", "order"}, {}};
  double least_order = std::numeric_limits<double>::infinity(), last_error = 0.0;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const validation::JetFit& fit = fits[i];
    const double error = std::max(fit.error_max, fit.error_min);
    const bool shows_order = fit.order && error > rounding;
    table.rows.push_back({fit.shape, fit.place, fmt::format("{:g}", fit.radius), fmt::format("{:.2e}", fit.error_max),
                          fmt::format("{:.2e}", fit.error_min),
                          shows_order ? fmt::format("{:.2f}", *fit.order)
                          : fit.order ? "rounding"
                                      : ""});
    const bool is_smallest_h = i + 1 == fits.size() || !fits[i + 1].order;
    if (!is_smallest_h) continue;
    last_error = std::max(last_error, error);
    if (shows_order) least_order = std::min(least_order, *fit.order);
  }
  constexpr double scatter_of_order = 0.1;
  const bool agree = least_order > validation::guaranteed_order - scatter_of_order;
  fmt::print(
      "Principal curvatures against CGAL's Monge form: polynomials of degree {} fitted to surface points within h.\n"
      "Errors are relative to k_max, or to 1/R_vol where that is larger. If the curvatures are right the errors fall\n"
      "with h to the power {} at least, until rounding (below {:g}) takes over; if not, they stay.\n\n"
      "{}\n"
      "Lowest order at the smallest h: {:.2f}. Largest error there: {:.1e}. Verdict: {}.\n",
      validation::jet_degree, validation::guaranteed_order, rounding, io::to_text(table), least_order, last_error,
      agree ? "the curvatures agree" : "THE CURVATURES DISAGREE");
  if (!agree) throw CLI::RuntimeError(1);
}

#else

void validate_curvature() {
  throw InputError("validate curvature", "a program built without CGAL",
                   "one configured with -DOSCULATE_WITH_CGAL=ON, for the witness is CGAL's jet fitting");
}

#endif

void validate_mechanics(const std::string& file) {
  namespace reference = validation::contact_mechanics;
  io::Table table{{"family", "quantity", "loses digits in", "values", "worst relative error"}, {}, 3};
  double worst = 0.0;
  for (const reference::QuantityError& error : reference::reference_errors(file)) {
    table.rows.push_back({error.family, error.quantity, error.lost_digits, fmt::format("{}", error.values),
                          fmt::format("{:.1e}", error.worst)});
    worst = std::max(worst, error.worst);
  }
  const bool agree = worst <= reference::bar;
  fmt::print(
      "The laws against values computed with 40-digit arithmetic.\n\n{}\nWorst {:.1e}, asked {:.0e}. Verdict: {}.\n",
      io::to_text(table), worst, reference::bar, agree ? "the laws agree" : "THE LAWS DISAGREE");
  if (!agree) throw CLI::RuntimeError(1);
}

void add_mechanics(CLI::App& validate) {
  const auto file = std::make_shared<std::string>();
  CLI::App* command = validate.add_subcommand("mechanics", "The laws against reference values of 40-digit arithmetic");
  command->add_option("file", *file, "Such as tests/data/contact_mechanics.json")->required();
  command->callback([file] { validate_mechanics(*file); });
}

}  // namespace

void add_validate(CLI::App& program) {
  CLI::App* validate = program.add_subcommand("validate", "Check the library against independent witnesses");
  validate->require_subcommand(1);
  validate
      ->add_subcommand(
          "curvature",
          "Principal curvatures against polynomials fitted to surface points (CGAL), with convergence order")
      ->callback(validate_curvature);
  add_validate_flow(*validate);
  add_validate_impact(*validate);
  add_validate_narrow(*validate);
  add_validate_packing(*validate);
  add_mechanics(*validate);
}

}  // namespace osculate::app
