// Incrementally slipping friction.

#include "osculate/mechanics/walton_braun_friction.hpp"

#include <array>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "mechanics/laws/spring.hpp"

namespace osculate::laws {
namespace {

constexpr auto excluded = LawParameter::Bound::excluded;
constexpr std::array parameters{friction_parameter,
                                LawParameter{.name = "tangential_stiffness",
                                             .symbol = "K_0",
                                             .unit = "N/m",
                                             .meaning = "tangential stiffness without slip",
                                             .least = 0.0,
                                             .least_bound = excluded},
                                LawParameter{.name = "exponent",
                                             .symbol = "γ",
                                             .unit = "",
                                             .meaning = "how the stiffness falls; 1/3 is Mindlin's",
                                             .least = 0.0,
                                             .least_bound = excluded,
                                             .most = 1.0,
                                             .standard = 1.0 / 3.0}};

// Memory: direction and normal, world; T, T*, F_n, and whether the motion runs back.
constexpr std::size_t memory_size = 10;

Part bind(const Binding& binding) {
  const walton_braun_friction::Model model{
      .stiffness = binding["tangential_stiffness"], .friction = binding["friction"], .exponent = binding["exponent"]};
  walton_braun_friction::validate(model);
  const auto step = [model](Contact& contact, Memory memory) {
    const Vec3 direction = carried(contact, vector_at(memory, 0), vector_at(memory, 3));
    walton_braun_friction::Memory state{.direction = planar(contact, direction),
                                        .force = memory[6],
                                        .turning = memory[7],
                                        .normal_force = memory[8],
                                        .backward = memory[9] != 0.0};
    const double stored_before = walton_braun_friction::recoverable_energy(model, state);
    if (!contact.closed) {
      contact.friction_loss += stored_before;
      forget(memory, memory_size);
      return;
    }
    // The theory's displacement is that of body 1, and so is its direction.
    const TangentVector before = -state.force * state.direction;
    contact.force = walton_braun_friction::force(model, friction_load(contact), -1.0 * contact.displacement(), state);
    contact.stored_tangential = walton_braun_friction::recoverable_energy(model, state);
    contact.friction_loss += work(contact, before, contact.force) + stored_before - contact.stored_tangential;
    put(spatial(contact, state.direction), memory, 0);
    put(contact.normal, memory, 3);
    memory[6] = state.force, memory[7] = state.turning, memory[8] = state.normal_force;
    memory[9] = state.backward ? 1.0 : 0.0;
  };
  return {.step = step, .needs = {.mean_angular_velocity = true}};
}

}  // namespace

const Law walton_braun_friction{{.name = "walton_braun_friction",
                                 .slot = LawSlot::tangential,
                                 .title = "Tangential stiffness that falls as slip spreads",
                                 .formula = "dT/ds = K_0 [1 − (T − T*)/(μ F_n − T*)]^γ",
                                 .equations = "",
                                 .source = "WB86, Walton93",
                                 .parameters = parameters,
                                 .memory = memory_size,
                                 .conflicts = {}},
                                bind};

}  // namespace osculate::laws
