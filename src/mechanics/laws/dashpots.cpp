// Dashpots along the normal.

#include <array>
#include <cmath>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "osculate/mechanics/damped_hertz.hpp"
#include "osculate/mechanics/linear_spring_dashpot.hpp"

namespace osculate::laws {
namespace {

constexpr std::array brilliantov_parameters{
    LawParameter{.name = "dissipative_time", .symbol = "A", .unit = "s", .meaning = "viscous time of the material"}};

constexpr std::array restitution_parameters{LawParameter{.name = "restitution",
                                                         .symbol = "ε",
                                                         .unit = "",
                                                         .meaning = "speed apart over speed together",
                                                         .least = 0.0,
                                                         .least_bound = LawParameter::Bound::excluded,
                                                         .most = 1.0,
                                                         .most_bound = LawParameter::Bound::included}};

constexpr std::array kuwabara_kono_parameters{
    LawParameter{.name = "damping", .symbol = "c", .unit = "N s/m^1.5", .meaning = "dashpot constant"}};
constexpr std::array dashpot_parameters{
    LawParameter{.name = "damping", .symbol = "c", .unit = "N s/m", .meaning = "dashpot constant"}};

constexpr std::array<std::string_view, 1> linear_only{"linear"};
constexpr std::array linear_conflicts{LawConflict{"normal", "its damping is matched to a linear spring", linear_only},
                                      LawConflict{"adhesion", "its damping is matched to a linear spring"},
                                      LawConflict{"roughness", "its damping is matched to a linear spring"},
                                      LawConflict{"plasticity", "its damping is matched to a linear spring"}};

constexpr std::array<std::string_view, 2> hertzian{"hertz", "hertz_sphere"};
constexpr std::array solid_conflicts{
    LawConflict{"linear", "its time is that of an elastic solid, which a linear spring is not; take linear_dashpot"},
    LawConflict{"walton_braun", "its time is that of an elastic solid; take dashpot"}};
constexpr std::array hertz_only{LawConflict{"normal", "its damping is matched to the force of Hertz", hertzian},
                                LawConflict{"adhesion", "its restitution is that of a contact without adhesion"},
                                LawConflict{"roughness", "its damping is matched to a smooth contact"},
                                LawConflict{"plasticity", "its restitution is that of an elastic contact"}};

Part bind_brilliantov(const Binding& binding) {
  const double time = binding["dissipative_time"];
  return {.step = [time](Contact& contact, Memory) {
    // Between pull-off and snap-off an adhesive contact's force falls; there the viscous force is left out.
    damp(contact, time * std::max(contact.stiffness, 0.0));
  }};
}

Part bind_kuwabara_kono(const Binding& binding) {
  const double damping = binding["damping"];
  return {.step = [damping](Contact& contact, Memory) {
    damp(contact, damping * std::sqrt(std::max(contact.overlap, 0.0)));
  }};
}

Part bind_linear_dashpot(const Binding& binding) {
  const double ratio = linear_spring_dashpot::damping_ratio_for(binding["restitution"], Attraction::cut_off);
  return {.step = [ratio](Contact& contact,
                          Memory) { damp(contact, 2.0 * ratio * std::sqrt(contact.reduced_mass * contact.stiffness)); },
          .needs = {.reduced_mass = true}};
}

Part bind_dashpot(const Binding& binding) {
  const double damping = binding["damping"];
  return {.step = [damping](Contact& contact, Memory) { damp(contact, damping); }};
}

Part bind_tsuji(const Binding& binding) {
  const double factor = damped_hertz::tsuji_factor(binding["restitution"], Attraction::cut_off);
  return {.step =
              [factor](Contact& contact, Memory) {
                damp(contact, factor * std::sqrt(2.0 / 3.0 * contact.reduced_mass * contact.stiffness));
              },
          .needs = {.reduced_mass = true}};
}

}  // namespace

const Law brilliantov{{.name = "brilliantov",
                       .slot = LawSlot::dissipation,
                       .title = "Viscoelastic solid",
                       .formula = "F_dis = A dF/dδ dδ/dt",
                       .equations = "(37)-(40)",
                       .source = "BSHP96, BAAP07",
                       .parameters = brilliantov_parameters,
                       .memory = 0,
                       .conflicts = solid_conflicts},
                      bind_brilliantov};

const Law tsuji{{.name = "tsuji",
                 .slot = LawSlot::dissipation,
                 .title = "Dashpot of constant restitution on Hertz",
                 .formula = "F_dis = √5 ζ(ε) (m k)^{1/2} δ^{1/4} dδ/dt, k = F/δ^{3/2}",
                 .equations = "",
                 .source = "TTI92, AE11",
                 .parameters = restitution_parameters,
                 .memory = 0,
                 .conflicts = hertz_only},
                bind_tsuji};

const Law kuwabara_kono{{.name = "kuwabara_kono",
                         .slot = LawSlot::dissipation,
                         .title = "Viscoelastic dashpot of given constant on Hertz",
                         .formula = "F_dis = c δ^{1/2} dδ/dt",
                         .equations = "",
                         .source = "KK87",
                         .parameters = kuwabara_kono_parameters,
                         .memory = 0,
                         .conflicts = hertz_only},
                        bind_kuwabara_kono};

const Law linear_dashpot{{.name = "linear_dashpot",
                          .slot = LawSlot::dissipation,
                          .title = "Dashpot of constant restitution on a linear spring",
                          .formula = "F_dis = 2 ζ(ε) (m k)^{1/2} dδ/dt",
                          .equations = "",
                          .source = "CS79, SP07",
                          .parameters = restitution_parameters,
                          .memory = 0,
                          .conflicts = linear_conflicts},
                         bind_linear_dashpot};

const Law dashpot{{.name = "dashpot",
                   .slot = LawSlot::dissipation,
                   .title = "Dashpot of constant c",
                   .formula = "F_dis = c dδ/dt",
                   .equations = "",
                   .source = "Wassgren06",
                   .parameters = dashpot_parameters,
                   .memory = 0,
                   .conflicts = {}},
                  bind_dashpot};

}  // namespace osculate::laws
