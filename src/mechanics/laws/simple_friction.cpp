// Friction without memory.

#include <array>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "osculate/mechanics/tangential_springs.hpp"

namespace osculate::laws {
namespace {

constexpr LawParameter damping_parameter{
    .name = "tangential_damping", .symbol = "c_t", .unit = "N s/m", .meaning = "dashpot constant"};
constexpr std::array sliding_parameters{friction_parameter};
constexpr std::array viscous_parameters{damping_parameter};
constexpr std::array viscous_sliding_parameters{friction_parameter, damping_parameter};

Part bind_sliding(const Binding& binding) {
  return {.step = [friction = binding["friction"]](Contact& contact, Memory) {
    if (!contact.closed) return;
    contact.force = tangential_springs::sliding(friction, friction_load(contact), -1.0 * contact.velocity);
    contact.friction_loss += dot(contact.force, contact.displacement());
  }};
}

Part bind_viscous(const Binding& binding) {
  return {.step = [damping = binding["tangential_damping"]](Contact& contact, Memory) {
    if (!contact.closed) return;
    contact.force = tangential_springs::viscous(damping, -1.0 * contact.velocity);
    contact.viscous_loss += dot(contact.force, contact.displacement());
  }};
}

Part bind_viscous_sliding(const Binding& binding) {
  return {.step = [damping = binding["tangential_damping"], friction = binding["friction"]](Contact& contact, Memory) {
    if (!contact.closed) return;
    const double load = friction_load(contact);
    contact.force = tangential_springs::viscous_sliding(damping, friction, load, -1.0 * contact.velocity);
    const bool slides = damping * norm(contact.velocity) > friction * load;
    (slides ? contact.friction_loss : contact.viscous_loss) += dot(contact.force, contact.displacement());
  }};
}

}  // namespace

const Law sliding{{.name = "sliding",
                   .slot = LawSlot::tangential,
                   .title = "Sliding, which jumps where the velocity turns",
                   .formula = "F_t = μ F_n v/|v|",
                   .equations = "",
                   .source = "Wassgren06",
                   .parameters = sliding_parameters,
                   .memory = 0,
                   .conflicts = {}},
                  bind_sliding};

const Law viscous_friction{{.name = "viscous",
                            .slot = LawSlot::tangential,
                            .title = "Viscous, without limit",
                            .formula = "F_t = c_t v",
                            .equations = "",
                            .source = "Wassgren06",
                            .parameters = viscous_parameters,
                            .memory = 0,
                            .conflicts = {}},
                           bind_viscous};

const Law viscous_sliding{{.name = "viscous_sliding",
                           .slot = LawSlot::tangential,
                           .title = "Viscous up to sliding; creeps under any steady load",
                           .formula = "F_t = min(c_t |v|, μ F_n) v/|v|",
                           .equations = "",
                           .source = "Wassgren06",
                           .parameters = viscous_sliding_parameters,
                           .memory = 0,
                           .conflicts = {}},
                          bind_viscous_sliding};

}  // namespace osculate::laws
