#include "osculate/mechanics/study_laws.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "osculate/core/error.hpp"

using namespace osculate;
using Catch::Matchers::Contains;

namespace {

using Numbers = std::map<std::string, double>;

/// Answers by name.
Numbers answers_of(std::string_view name, const Numbers& parameters) {
  const StudyLaw* law = study_law(name);
  REQUIRE(law != nullptr);
  const std::vector<double> values = evaluate(*law, parameters);
  REQUIRE(values.size() == law->results.size());
  Numbers result;
  for (std::size_t k = 0; k < values.size(); ++k) result.emplace(law->results[k].name, values[k]);
  return result;
}

Numbers with(Numbers numbers, const std::string& key, double value) {
  numbers[key] = value;
  return numbers;
}

void refused(std::string_view name, const Numbers& parameters, const std::string& reason) {
  CHECK_THROWS_AS(evaluate(*study_law(name), parameters), InputError);
  CHECK_THROWS_WITH(evaluate(*study_law(name), parameters), Contains(reason));
}

constexpr double E = 71e9, nu = 0.22;
const double modulus = E / (2.0 * (1.0 - nu * nu));
const Numbers rough{{"density", 1e11}, {"asperity_radius", 1e-5}, {"deviation", 1e-7}};
const Numbers yielding{{"density", 1e11}, {"R_i", 1e-5}, {"R_j", 1e-5}, {"deviation", 1e-7}, {"hardness", 1e9}};
const Numbers slipping{{"asperity_radius", 1e-5}, {"deviation", 1e-7}, {"asperities", 1e5}, {"friction", 0.3}};
constexpr double rounding = 1e-10;  // of quadratures and their closed forms

}  // namespace

TEST_CASE("Every theory that no time step takes is described, and is no law of the registry") {
  std::set<std::string_view> names;
  for (const LawDescription* law : law_registry()) names.insert(law->name);
  for (const StudyLaw* law : study_laws()) {
    INFO(law->name);
    CHECK(names.insert(law->name).second);
    CHECK(study_law(law->name) == law);
    for (const auto text : {law->title, law->formula, law->equations, law->source, law->reason}) CHECK(!text.empty());
    for (const LawParameter& parameter : law->parameters) {
      CHECK((!parameter.symbol.empty() && !parameter.meaning.empty()));
      if (parameter.standard) CHECK(parameter.allows(*parameter.standard));
    }
    const auto shown = std::ranges::find(law->parameters, law->shown, &LawParameter::name);
    REQUIRE(shown != law->parameters.end());
    CHECK(shown->standard);
    CHECK(law->shown_from < law->shown_to);
    CHECK_THROWS_WITH(law_named(law->name), Contains(std::string(law->reason)));
  }
  CHECK(study_law("hertz") == nullptr);
}

TEST_CASE("At no separation the elastic patch has the moments of half a normal distribution") {
  // ∫_0^∞ z^p φ dz = 2^{p/2} Γ((p+1)/2) / (2√π); χA = 1e5.
  const auto moment = [](double p) {
    return std::pow(2.0, p / 2.0) * std::tgamma((p + 1.0) / 2.0) / (2.0 * std::sqrt(std::numbers::pi));
  };
  const Numbers patch = answers_of("greenwood_williamson_patch", with(rough, "h", 0.0));
  CHECK(patch.at("force") ==
        Approx(1e5 * 4.0 / 3.0 * modulus * std::sqrt(1e-5) * std::pow(1e-7, 1.5) * moment(1.5)).epsilon(rounding));
  CHECK(patch.at("real_area") == Approx(1e5 * std::numbers::pi * 1e-5 * 1e-7 * moment(1.0)).epsilon(rounding));
  CHECK(patch.at("touching") == Approx(5e4).epsilon(rounding));
  CHECK(patch.at("stiffness") ==
        Approx(1e5 * 2.0 * modulus * std::sqrt(1e-5) * std::pow(1e-7, 0.5) * moment(0.5)).epsilon(rounding));
}

TEST_CASE("Yielding asperities share force and area by regime, and are elastic where they are hard") {
  const Numbers soft = answers_of("jeng_wang", yielding);
  CHECK(soft.at("force") ==
        Approx(soft.at("force_elastic") + soft.at("force_elastic_plastic") + soft.at("force_plastic")));
  CHECK(soft.at("real_area") ==
        Approx(soft.at("area_elastic") + soft.at("area_elastic_plastic") + soft.at("area_plastic")));
  // h is where the series is taken.
  CHECK(soft.at("force_series") == Approx(soft.at("force")).epsilon(rounding));
  CHECK(soft.at("area_series") == Approx(soft.at("real_area")).epsilon(rounding));

  const Numbers hard = answers_of("jeng_wang", with(yielding, "hardness", 1e14));
  const Numbers elastic = answers_of("greenwood_williamson_patch", rough);
  CHECK(hard.at("force") == Approx(elastic.at("force")).epsilon(1e-9));
  CHECK(hard.at("real_area") == Approx(elastic.at("real_area")).epsilon(1e-9));
  CHECK(soft.at("force") < hard.at("force"));
}

TEST_CASE("A rough contact pulled sideways starts at its stiffness and ends sliding") {
  const Numbers stuck = answers_of("hisakado_tsukizoe", with(slipping, "displacement", 1e-14));
  // Slip has spread by 1e-14 of some 1e-8.
  CHECK(stuck.at("tangential_force") == Approx(stuck.at("stiffness") * 1e-14).epsilon(1e-5));
  CHECK(stuck.at("sliding_share") < 1e-5);
  const Numbers sliding = answers_of("hisakado_tsukizoe", with(slipping, "displacement", 1e-6));
  CHECK(sliding.at("tangential_force") == Approx(0.3 * sliding.at("normal_force")).epsilon(rounding));
  CHECK(sliding.at("sliding_share") == Approx(1.0).epsilon(rounding));
  // As many asperities on as much area as the elastic patch has.
  CHECK(sliding.at("normal_force") ==
        Approx(answers_of("greenwood_williamson_patch", rough).at("force")).epsilon(rounding));
  CHECK(sliding.at("asperity_contact_radius") == Approx(std::sqrt(1e-5 * 1e-7)).epsilon(rounding));
}

TEST_CASE("A round contact's viscous tangential force is the viscous time times Mindlin's stiffness") {
  const Numbers round{{"shear_viscosity", 1e3}, {"R_i", 1e-3}, {"R_j", 1e-3}, {"overlap", 1e-6}, {"rate", 0.2}};
  const double G = E / (2.0 * (1.0 + nu)), a = std::sqrt(1e-3 * 1e-6);
  const double stiffness = 4.0 * G * a / (2.0 - nu);
  const Numbers start = answers_of("tangential_dissipation", round);
  CHECK(start.at("no_slip_stiffness") == Approx(stiffness).epsilon(rounding));
  CHECK(start.at("force") == Approx(1e3 / G * stiffness * 0.2).epsilon(rounding));
  CHECK(start.at("force_y") == Approx(start.at("force")).epsilon(rounding));
  CHECK(answers_of("tangential_dissipation", with(round, "slip", 0.75)).at("force") ==
        Approx(0.5 * start.at("force")).epsilon(rounding));
  CHECK(answers_of("tangential_dissipation", with(round, "slip", 1.0)).at("force") == 0.0);
  refused("tangential_dissipation", with(round, "R_j", 2e-3), "R_i >= R_j");
}

TEST_CASE("Squares that meet corner to corner overlap in a square") {
  // The diagonals are 2 mm long; at 1.9 mm the corners reach 0.1 mm into each other: A = d²/2, −dW/dx = k d.
  const Numbers corners{{"coefficient", 1e5}, {"x", 1.9e-3}, {"y", 0.0}, {"turn", 0.0}};
  const Numbers met = answers_of("polygon_energy", corners);
  CHECK(met.at("area") == Approx(0.5e-8).epsilon(rounding));
  CHECK(met.at("energy") == Approx(0.5e-3).epsilon(rounding));
  CHECK(met.at("force_x") == Approx(10.0).epsilon(rounding));
  CHECK(std::fabs(met.at("force_y")) < 1e-12);
  const Numbers squared = answers_of("polygon_energy", with(corners, "exponent", 2.0));
  CHECK(squared.at("force_x") == Approx(2.0 * 0.5e-8 * 10.0).epsilon(rounding));
  const Numbers apart = answers_of("polygon_energy", with(corners, "x", 2.1e-3));
  for (const auto& [name, value] : apart) {
    INFO(name);
    CHECK((value == 0.0 && !std::signbit(value)));
  }
  refused("polygon_energy", with(corners, "sides_1", 3.5), "whole number");
  refused("polygon_energy", with(corners, "sides_1", 2.0), "in [3, 1000]");
}

TEST_CASE("Numbers that a theory does not take are refused with what it takes") {
  refused("greenwood_williamson_patch", {}, "no \"density\"");
  refused("greenwood_williamson_patch", with(rough, "deviation", 0.0), "> 0");
  refused("greenwood_williamson_patch", with(rough, "h", std::nan("")), "\"h\"");
  refused("greenwood_williamson_patch", with(rough, "hardness", 1.0), "one of density");
  refused("hisakado_tsukizoe", with(slipping, "friction", -0.1), ">= 0");
  refused("jeng_wang", with(yielding, "R_i", 0.9e-5), "R_i >= R_j");
}
