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
  const double friction = binding["friction"];
  // Materials that the theory refuses are refused here, not in the loop.
  constexpr double any = 1.0;
  twisting::compliance(contact_ellipse(any, any), any, binding.material_1, binding.material_2);
  const auto step = [friction, material_1 = binding.material_1, material_2 = binding.material_2](Contact& contact,
                                                                                                 Memory memory) {
    twisting::Memory twist{.moment = memory[0], .stiffness = memory[1]};
    const double before = twist.moment, stored_before = stored(twist.moment, twist.stiffness);
    if (!contact.closed || !(contact.a_c > 0.0)) {
      contact.friction_loss += stored_before;
      forget(memory, 2);
      return;
    }
    const auto state =
        twisting::contact(contact.ellipse(), contact.a_c, material_1, material_2, friction, friction_load(contact));
    const double angle = contact.angular_velocity.dot(contact.normal) * contact.time_step;
    const double moment = twisting::advance(twist, state, angle);
    const double stored_now = stored(moment, twist.stiffness);
    contact.couple += moment * contact.normal;
    contact.stored_tangential += stored_now;
    contact.friction_loss += 0.5 * (before + moment) * angle + stored_before - stored_now;
    memory[0] = twist.moment, memory[1] = twist.stiffness;
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
