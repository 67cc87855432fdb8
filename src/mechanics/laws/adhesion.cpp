// Adhesive contacts of smooth bodies.

#include <array>
#include <cmath>
#include <numbers>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "mechanics/laws/spring.hpp"
#include "osculate/mechanics/johnson_greenwood.hpp"

namespace osculate::laws {
namespace {

constexpr std::array parameters{
    LawParameter{.name = "work_of_adhesion", .symbol = "W", .unit = "J/m^2", .meaning = "energy to part unit area"}};
constexpr std::array<std::string_view, 1> elliptical{"hertz"};
constexpr std::array conflicts{
    LawConflict{"normal", "its elastic contact is the elliptical one of hertz", elliptical},
    LawConflict{"roughness", "elastic asperities that only push cannot carry the tension of an adhesive contact"},
    LawConflict{"plasticity",
                "no theory here says how an indented surface peels: the pull-off of its flattened contact "
                "is not that of the elastic one"}};

johnson_greenwood::Pair pair_of(double R_i, double R_j, double modulus, double work) {
  return {.R_i = R_i, .R_j = R_j, .modulus = modulus, .work_of_adhesion = work};
}

constexpr std::size_t ellipse_memory = 2;

/// One column a quantity, for up to `stretch` contacts.
using Column = std::array<double, stretch>;

/// What has been found of a contact becomes its force and its memory.
void close(Contact& contact, const johnson_greenwood::Memory& ellipse, johnson_greenwood::Status status, double work,
           Memory memory) {
  using johnson_greenwood::Status;
  const bool was_closed = johnson_greenwood::Memory{memory[0], memory[1]}.closed();
  contact.pulls = true;
  contact.closed = status == Status::closed || status == Status::not_converged;
  contact.converged = status != Status::not_converged;
  const auto energy = RunningEnergy::read(memory, ellipse_memory);
  if (!contact.closed) {
    contact.elastic = contact.a_c = contact.stiffness = 0.0;
    if (was_closed) contact.hysteresis_loss += energy.stored;
    forget(memory, ellipse_memory + running_energy_memory);
    return;
  }
  contact.axis_ratio = ellipse.axis_ratio;
  // Thornton: friction holds against the load and twice the pull-off force, 3/2 π R W for a circle.    [TN98]
  contact.friction_load =
      std::max(contact.elastic + 3.0 * std::numbers::pi * std::sqrt(contact.R_i * contact.R_j) * work, 0.0);
  const auto now = energy.next(contact, was_closed);
  contact.stored_normal = now.stored;
  memory[0] = ellipse.a_c, memory[1] = ellipse.axis_ratio;
  now.write(memory, ellipse_memory);
}

Part bind_jkr(const Binding& binding) {
  const double modulus = effective_modulus(binding.material_1, binding.material_2);
  const double work = binding["work_of_adhesion"];
  const auto step = [modulus, work](std::span<Contact> contacts, std::span<const Memory> memories) {
    Column R_i, R_j, moduli, works, overlap, force, a_c, b_c, stiffness;
    std::array<johnson_greenwood::Memory, stretch> ellipses;
    std::array<johnson_greenwood::Status, stretch> status;
    const std::size_t count = contacts.size();
    for (std::size_t i = 0; i < count; ++i) {
      R_i[i] = contacts[i].R_i, R_j[i] = contacts[i].R_j, overlap[i] = contacts[i].overlap;
      moduli[i] = modulus, works[i] = work;
      ellipses[i] = {memories[i][0], memories[i][1]};
    }
    const auto in = [count](const Column& column) { return std::span(column).first(count); };
    const auto out = [count](Column& column) { return std::span(column).first(count); };
    johnson_greenwood::contacts({in(R_i), in(R_j), in(moduli), in(works), in(overlap)},
                                std::span(ellipses).first(count),
                                {out(force), out(a_c), out(b_c), out(stiffness), std::span(status).first(count)});
    for (std::size_t i = 0; i < count; ++i) {
      contacts[i].elastic = force[i];
      contacts[i].a_c = a_c[i];
      contacts[i].stiffness = std::max(stiffness[i], 0.0);
      close(contacts[i], ellipses[i], status[i], work, memories[i]);
    }
  };
  const auto range = [modulus, work](double R_i, double R_j) {
    if (!(work > 0.0)) return 0.0;
    return -johnson_greenwood::snap_off(pair_of(std::min(R_i, largest_radius_ratio * R_j), R_j, modulus, work)).overlap;
  };
  return {.step = step, .range = range};
}

Part bind_dmt(const Binding& binding) {
  const double modulus = effective_modulus(binding.material_1, binding.material_2);
  const double work = binding["work_of_adhesion"];
  return {.step = [modulus, work](Contact& contact, Memory) {
    contact.pulls = true;
    press_hertz(contact, modulus);
    if (!contact.closed) return;
    const auto state =
        johnson_greenwood::derjaguin_muller_toporov(pair_of(contact.R_i, contact.R_j, modulus, work), contact.overlap);
    contact.stored_normal -= (contact.elastic - state->force) * contact.overlap;
    contact.elastic = state->force;
  }};
}

}  // namespace

const Law jkr{{.name = "jkr",
               .slot = LawSlot::adhesion,
               .title = "Elliptical JKR with snap-in and snap-off",
               .formula = "F(δ) along Johnson and Greenwood's equilibrium curve; closes at δ = 0, opens at snap-off",
               .equations = "(19)-(28)",
               .source = "JG05",
               .parameters = parameters,
               .memory = ellipse_memory + running_energy_memory,
               .conflicts = conflicts},
              bind_jkr};

const Law dmt{{.name = "dmt",
               .slot = LawSlot::adhesion,
               .title = "Hertz less the rigid attraction, for small hard contacts",
               .formula = "F = F_Hertz − 2π (R_i R_j)^{1/2} W while δ > 0",
               .equations = "",
               .source = "DMT75",
               .parameters = parameters,
               .memory = 0,
               .conflicts = conflicts},
              bind_dmt};

}  // namespace osculate::laws
