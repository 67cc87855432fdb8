// Linear springs of spheres, elastic and hysteretic.

#include <array>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "osculate/mechanics/walton_braun.hpp"

namespace osculate::laws {
namespace {

constexpr auto excluded = LawParameter::Bound::excluded;

constexpr std::array linear_parameters{LawParameter{.name = "stiffness",
                                                    .symbol = "k",
                                                    .unit = "N/m",
                                                    .meaning = "stiffness of the spring",
                                                    .least = 0.0,
                                                    .least_bound = excluded}};

constexpr std::array walton_braun_parameters{LawParameter{.name = "loading_stiffness",
                                                          .symbol = "k_1",
                                                          .unit = "N/m",
                                                          .meaning = "stiffness at the largest overlap",
                                                          .least = 0.0,
                                                          .least_bound = excluded},
                                             LawParameter{.name = "unloading_stiffness",
                                                          .symbol = "k_2",
                                                          .unit = "N/m",
                                                          .meaning = "stiffness below it, at least k_1",
                                                          .least = 0.0,
                                                          .least_bound = excluded},
                                             LawParameter{.name = "hardening",
                                                          .symbol = "S",
                                                          .unit = "1/m",
                                                          .meaning = "growth of k_2 with the largest force",
                                                          .standard = 0.0}};

Part bind_linear(const Binding& binding) {
  const double stiffness = binding["stiffness"];
  return {.step = [stiffness](Contact& contact, Memory) {
    contact.closed = contact.overlap > 0.0;
    if (!contact.closed) return;
    set_ellipse(contact);
    contact.elastic = contact.friction_load = stiffness * contact.overlap;
    contact.stiffness = stiffness;
    contact.stored_normal = 0.5 * contact.elastic * contact.overlap;
  }};
}

/// What loading to an overlap for the first time takes and unloading does not give back.
double lost(const walton_braun::Model& model, double largest) {
  const double force = model.loading * largest;
  return 0.5 * force * (largest - force / (model.unloading + model.hardening * force));
}

Part bind_walton_braun(const Binding& binding) {
  const walton_braun::Model model{.loading = binding["loading_stiffness"],
                                  .unloading = binding["unloading_stiffness"],
                                  .hardening = binding["hardening"]};
  walton_braun::validate(model);
  return {.step = [model](Contact& contact, Memory memory) {
    contact.closed = contact.overlap > 0.0;
    if (!contact.closed) {
      memory[0] = 0.0;
      return;
    }
    set_ellipse(contact);
    walton_braun::Memory largest{memory[0]};
    contact.elastic = contact.friction_load = walton_braun::force(model, contact.overlap, largest);
    const double unloading = model.unloading + model.hardening * model.loading * largest.largest_overlap;
    const bool loading = contact.overlap >= largest.largest_overlap;
    contact.stiffness = contact.elastic > 0.0 ? (loading ? model.loading : unloading) : 0.0;
    contact.stored_normal = 0.5 * contact.elastic * contact.elastic / unloading;
    contact.hysteresis_loss += lost(model, largest.largest_overlap) - lost(model, memory[0]);
    memory[0] = largest.largest_overlap;
  }};
}

}  // namespace

const Law linear{{.name = "linear",
                  .slot = LawSlot::normal,
                  .title = "Linear spring",
                  .formula = "F = k δ",
                  .equations = "",
                  .source = "CS79, Wassgren06",
                  .parameters = linear_parameters,
                  .memory = 0,
                  .conflicts = {}},
                 bind_linear};

const Law walton_braun{{.name = "walton_braun",
                        .slot = LawSlot::normal,
                        .title = "Hysteretic linear spring",
                        .formula = "F = k_1 δ at the largest overlap, k_2 (δ − δ_res) below",
                        .equations = "",
                        .source = "WB86, Wassgren06",
                        .parameters = walton_braun_parameters,
                        .memory = 1,
                        .conflicts = {}},
                       bind_walton_braun};

}  // namespace osculate::laws
