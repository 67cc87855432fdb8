#include "validation/contact_mechanics/reference_errors.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"
#include "osculate/mechanics/greenwood_williamson.hpp"
#include "osculate/mechanics/johnson_greenwood.hpp"
#include "osculate/mechanics/mindlin.hpp"
#include "osculate/mechanics/twisting.hpp"

namespace osculate::validation::contact_mechanics {
namespace {

using nlohmann::json;

/// Gathers the worst error of each quantity of a family, in the order in which they come.
class Family {
 public:
  explicit Family(std::string name) : name_(std::move(name)) {}

  /// A quantity that the row does not have, or has as null, is passed over.
  void compare(const json& row, const char* quantity, double computed, const char* lost_digits = "") {
    if (!row.contains(quantity) || row.at(quantity).is_null()) return;
    auto found = std::find_if(errors_.begin(), errors_.end(),
                              [&](const QuantityError& error) { return error.quantity == quantity; });
    if (found == errors_.end())
      found = errors_.insert(errors_.end(), {.family = name_, .quantity = quantity, .lost_digits = lost_digits});
    const double reference = row.at(quantity);
    const double error = std::fabs(reference == 0.0 ? computed : computed / reference - 1.0);
    // NaN is no small error.
    found->worst = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(found->worst, error);
    ++found->values;
  }

  const std::vector<QuantityError>& errors() const { return errors_; }

 private:
  std::string name_;
  std::vector<QuantityError> errors_;
};

Family hertz(const json& rows) {
  Family family("hertz");
  for (const json& row : rows) {
    // Radii scaled to integers: the double nearest 1.000001 is another ratio in e²'s tenth digit.
    const ContactEllipse ellipse = contact_ellipse(std::round(row.at("ratio").get<double>() * 1e6), 1e6);
    const CompleteElliptic integrals = complete_elliptic(ellipse.axis_ratio * ellipse.axis_ratio);
    family.compare(row, "e2", ellipse.e2);
    family.compare(row, "b_over_a", ellipse.axis_ratio);
    family.compare(row, "K", integrals.K);
    family.compare(row, "E", integrals.E);
    family.compare(row, "D", integrals.D);
    family.compare(row, "B", integrals.B);
    family.compare(row, "C", integrals.C);
    family.compare(row, "gamma", ellipse.gamma());
    family.compare(row, "beta", ellipse.beta());
  }
  return family;
}

Family roughness(const json& rows) {
  Family family("greenwood_williamson");
  for (const json& row : rows) {
    const auto integrals = greenwood_williamson::height_integrals(row.at("h"));
    family.compare(row, "F_half", integrals.half);
    family.compare(row, "F_one", integrals.one, "a difference that cancels as h²");
    family.compare(row, "F_three_halves", integrals.three_halves);
  }
  return family;
}

Family adhesion(const json& rows) {
  namespace jg = johnson_greenwood;
  Family family("johnson_greenwood");
  const char* near_hertz = "g − g_Hertz";
  for (const json& row : rows) {
    const double ratio = row.at("ratio");
    family.compare(row, "g_hertz", contact_ellipse(ratio, 1.0).axis_ratio);
    for (const json& state : row.at("states")) {
      const double g = state.at("g");
      family.compare(state, "Pi1", jg::shape_constant_major(ratio, g));
      family.compare(state, "Pi2", jg::shape_constant_minor(ratio, g));
      family.compare(state, "F_bar", jg::force_of(ratio, g), near_hertz);
      family.compare(state, "delta_bar", jg::overlap_of(ratio, g), near_hertz);
      family.compare(state, "A_bar", jg::area_of(ratio, g), near_hertz);
      if (state.at("gamma_JG").is_null()) continue;  // the overlap is negative there
      family.compare(state, "gamma_JG", jg::gamma(ratio, g), near_hertz);
      family.compare(state, "beta_JG", jg::beta(ratio, g), near_hertz);
    }
  }
  return family;
}

Family tangential(const json& rows) {
  Family family("tangential");
  for (const json& row : rows) {
    const double nu = row.at("nu"), e2 = row.at("e2"), pi = std::acos(-1.0);
    const CompleteElliptic integrals = complete_elliptic(1.0 - e2);
    const ContactEllipse ellipse{.R_c = 1.0,
                                 .axis_ratio = std::sqrt(1.0 - e2),
                                 .e2 = e2,
                                 .K = integrals.K,
                                 .E = integrals.E,
                                 .ratio_limited = false};
    const ElasticMaterial solid{.youngs_modulus = 2.0 * (1.0 + nu), .poissons_ratio = nu};  // G = 1
    const mindlin::Axes body = mindlin::body_compliance(ellipse, 1.0, solid);
    const mindlin::Axes factor = mindlin::shape_factor(ellipse, nu);
    family.compare(row, "compliance_major_times_2piGa_one_body", 2.0 * pi * body.major);
    family.compare(row, "compliance_minor_times_2piGa_one_body", 2.0 * pi * body.minor);
    family.compare(row, "Phi_major", factor.major);
    family.compare(row, "Phi_minor", factor.minor);
    family.compare(row, "twist_compliance_times_8Ga3_over_3_two_identical",
                   8.0 / 3.0 * twisting::compliance(ellipse, 1.0, solid, solid));
  }
  return family;
}

Family cycles(const json& rows) {
  Family family("mindlin_cycle");
  // In the file's units, (2−ν) μF_n Φ/(G a_c), the total compliance times μF_n is 1/4.
  const mindlin::Contact unit{.compliance = 0.25, .limit = 1.0};
  for (const json& row : rows) {
    const double peak = row.at("Ft_star_over_muFn");
    family.compare(row, "delta_peak", mindlin::displacement(unit, peak));
    family.compare(row, "delta_residual_at_Ft_zero", mindlin::unloading_displacement(unit, 0.0, peak),
                   "a difference of displacements");
    family.compare(row, "energy_lost_per_cycle", mindlin::cycle_energy(unit, peak));
  }
  return family;
}

}  // namespace

std::vector<QuantityError> reference_errors(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string(), "cannot be read", "a file like tests/data/contact_mechanics.json");
  std::vector<QuantityError> errors;
  try {
    const json reference = json::parse(stream);
    for (const Family& family : {hertz(reference.at("hertz")), roughness(reference.at("greenwood_williamson")),
                                 adhesion(reference.at("johnson_greenwood")), tangential(reference.at("tangential")),
                                 cycles(reference.at("mindlin_cycle"))})
      errors.insert(errors.end(), family.errors().begin(), family.errors().end());
  } catch (const json::exception& trouble) {
    throw InputError(file.string(), trouble.what(), "a file like tests/data/contact_mechanics.json");
  }
  return errors;
}

}  // namespace osculate::validation::contact_mechanics
