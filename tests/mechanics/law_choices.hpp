#pragma once
// Compositions that together hold every law of the registry, for 1 mm bodies of glass.

#include <string>
#include <vector>

#include "osculate/mechanics/law_registry.hpp"

struct NamedChoice {
  std::string name;
  osculate::LawChoice choice;
  /// Whether its energy is what the force is a derivative of: not so for a spring whose stiffness follows the overlap.
  bool conserves = true;
};

inline std::vector<NamedChoice> law_choices() {
  using osculate::ChosenLaw;
  const ChosenLaw hertz{"hertz", {}}, linear{"linear", {{"stiffness", 1e6}}};
  const ChosenLaw brilliantov{"brilliantov", {{"dissipative_time", 1e-7}}}, tsuji{"tsuji", {{"restitution", 0.8}}};
  const ChosenLaw spring{"cundall_strack",
                         {{"friction", 0.3}, {"tangential_stiffness", 8e5}, {"tangential_damping", 0.5}}};
  const ChosenLaw mindlin{"mindlin", {{"friction", 0.3}}}, twisting{"twisting", {{"friction", 0.3}}};
  const ChosenLaw jkr{"jkr", {{"work_of_adhesion", 0.5}}};
  const ChosenLaw plastic{"jamari_schipper",
                          {{"hardness", 2e9}, {"yield_factor", 0.6}, {"plastic_factor", 0.9}, {"area_ratio", 120.0}}};
  const ChosenLaw rough{"greenwood_williamson", {{"density", 1e11}, {"asperity_radius", 1e-5}, {"deviation", 1e-7}}};
  return {
      {"hertz", {hertz}},
      {"hertz, mindlin", {hertz, mindlin}},
      {"hertz, brilliantov, mindlin, twisting", {hertz, brilliantov, mindlin, twisting}},
      {"hertz, tsuji, mindlin", {hertz, tsuji, mindlin}},
      {"hertz sphere, tsuji, mindlin", {{"hertz_sphere", {}}, tsuji, mindlin}},
      {"hertz, spring", {hertz, spring}},
      {"hertz, kuwabara kono, spring", {hertz, {"kuwabara_kono", {{"damping", 500.0}}}, spring}},
      {"hertz, tsuji, di renzo", {hertz, tsuji, {"di_renzo", {{"friction", 0.3}}}}, false},
      {"hertz, tsuji, tsuji",
       {hertz, tsuji, {"tsuji_tangential", {{"friction", 0.3}, {"tangential_damping", 0.5}}}},
       false},
      {"hertz, langston", {hertz, {"langston", {{"friction", 0.3}, {"tangential_damping", 0.2}}}}, false},
      {"hertz, zheng", {hertz, {"zheng", {{"friction", 0.3}, {"viscosity", 100.0}}}}, false},
      {"hertz, walton braun friction",
       {hertz, {"walton_braun_friction", {{"friction", 0.3}, {"tangential_stiffness", 8e5}}}},
       false},
      {"hertz, sliding", {hertz, {"sliding", {{"friction", 0.3}}}}},
      {"hertz, viscous", {hertz, {"viscous", {{"tangential_damping", 0.5}}}}},
      {"hertz, viscous sliding", {hertz, {"viscous_sliding", {{"friction", 0.3}, {"tangential_damping", 0.5}}}}},
      {"hertz, vermeulen johnson", {hertz, {"vermeulen_johnson", {{"friction", 0.3}}}}},
      {"linear, dashpot of restitution, spring", {linear, {"linear_dashpot", {{"restitution", 0.8}}}, spring}},
      {"linear, dashpot, spring, twisting", {linear, {"dashpot", {{"damping", 0.5}}}, spring, twisting}},
      {"walton braun, spring",
       {{"walton_braun", {{"loading_stiffness", 1e6}, {"unloading_stiffness", 1.5e6}, {"hardening", 1e4}}}, spring}},
      {"jkr", {hertz, jkr}},
      {"jkr, brilliantov, spring, twisting", {hertz, jkr, brilliantov, spring, twisting}},
      {"dmt, brilliantov, spring", {hertz, {"dmt", {{"work_of_adhesion", 0.5}}}, brilliantov, spring}},
      {"rough, brilliantov, spring", {hertz, rough, brilliantov, spring}},
      {"plastic", {hertz, plastic}},
      {"plastic, spring, twisting", {hertz, plastic, spring, twisting}},
      {"hertz, kalker", {hertz, {"kalker", {{"friction", 0.3}}}}},
  };
}
