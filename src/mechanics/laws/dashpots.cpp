// Dashpots along the normal.

#include <array>
#include <cmath>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "osculate/mechanics/damped_hertz.hpp"

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

constexpr std::array<std::string_view, 2> hertzian{"hertz", "hertz_sphere"};
constexpr std::array hertz_only{
    LawConflict{"normal", "its damping is matched to Hertz's force, so that restitution does not depend on speed",
                hertzian},
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
                       .conflicts = {}},
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

}  // namespace osculate::laws
