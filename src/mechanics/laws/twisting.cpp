// A couple about the normal.

#include "osculate/mechanics/twisting.hpp"

#include <array>
#include <cmath>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "mechanics/laws/spring.hpp"

namespace osculate::laws {
namespace {

constexpr std::array parameters{friction_parameter};
constexpr std::array conflicts{LawConflict{"rolling", "the rolling law brings the spin moment of the same contact"}};

double stored(double moment, double stiffness) {
  return stiffness > 0.0 ? 0.5 * moment * moment / stiffness : 0.0;
}

Part bind(const Binding& binding) {
  // Materials that the theory refuses are refused here, not in the loop.
  twisting::contacts(binding.material_1, binding.material_2, {}, {});
  const auto step = [friction = binding["friction"], material_1 = binding.material_1, material_2 = binding.material_2](
                        std::span<Contact> contacts, std::span<const Memory> memories) {
    std::array<double, stretch> a_c, axis_ratio, stiffness, arm;
    const std::size_t count = contacts.size();
    for (std::size_t i = 0; i < count; ++i) a_c[i] = contacts[i].a_c, axis_ratio[i] = contacts[i].axis_ratio;
    const auto in = [count](const auto& column) { return std::span<const double>(column).first(count); };
    const auto out = [count](auto& column) { return std::span<double>(column).first(count); };
    twisting::contacts(material_1, material_2, {in(a_c), in(axis_ratio)}, {out(stiffness), out(arm)});
    for (std::size_t i = 0; i < count; ++i) {
      Contact& contact = contacts[i];
      const Memory& memory = memories[i];
      twisting::Memory twist{.moment = memory[0], .stiffness = memory[1]};
      const double before = twist.moment, stored_before = stored(twist.moment, twist.stiffness);
      if (!contact.closed || !(contact.a_c > 0.0)) {
        contact.friction_loss += stored_before;
        forget(memory, 2);
        continue;
      }
      const double angle = contact.angular_velocity.dot(contact.normal) * contact.time_step;
      const double moment = twisting::advance(
          twist, {.stiffness = stiffness[i], .limit = friction * friction_load(contact) * arm[i]}, angle);
      const double stored_now = stored(moment, twist.stiffness);
      contact.couple += moment * contact.normal;
      contact.stored_tangential += stored_now;
      contact.friction_loss += 0.5 * (before + moment) * angle + stored_before - stored_now;
      memory[0] = twist.moment, memory[1] = twist.stiffness;
    }
  };
  return {.step = step, .needs = {.angular_velocity = true}, .makes_couples = true};
}

}  // namespace

const Law twisting{{.name = "twisting",
                    .slot = LawSlot::twisting,
                    .title = "Torsional spring of the elliptical contact, and slider",
                    .formula = "dM = dφ/C_z, |M| ≤ 3/8 μ F_n a_c E(e²)",
                    .equations = "(77)",
                    .source = "Mindlin49, Johnson85",
                    .parameters = parameters,
                    .memory = 2,
                    .conflicts = conflicts},
                   bind};

}  // namespace osculate::laws
