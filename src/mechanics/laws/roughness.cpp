// Rough elastic contacts.

#include <array>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "mechanics/laws/spring.hpp"
#include "osculate/mechanics/greenwood_williamson.hpp"

namespace osculate::laws {
namespace {

constexpr auto excluded = LawParameter::Bound::excluded;
constexpr std::array parameters{LawParameter{.name = "density",
                                             .symbol = "χ",
                                             .unit = "1/m^2",
                                             .meaning = "asperities per area",
                                             .least = 0.0,
                                             .least_bound = excluded},
                                LawParameter{.name = "asperity_radius",
                                             .symbol = "β",
                                             .unit = "m",
                                             .meaning = "radius of an asperity's summit",
                                             .least = 0.0,
                                             .least_bound = excluded},
                                LawParameter{.name = "deviation",
                                             .symbol = "σ",
                                             .unit = "m",
                                             .meaning = "standard deviation of the summits' heights",
                                             .least = 0.0,
                                             .least_bound = excluded}};
constexpr std::array<std::string_view, 1> elliptical{"hertz"};
constexpr std::array conflicts{
    LawConflict{"normal", "its bulk is the elliptical contact of hertz", elliptical},
    LawConflict{"plasticity", "its asperities are elastic and share the overlap with an elastic bulk"}};

Part bind(const Binding& binding) {
  const double modulus = effective_modulus(binding.material_1, binding.material_2);
  const greenwood_williamson::Roughness roughness{
      .density = binding["density"], .radius = binding["asperity_radius"], .deviation = binding["deviation"]};
  greenwood_williamson::validate(roughness);
  const auto step = [modulus, roughness](Contact& contact, Memory memory) {
    const ContactEllipse& ellipse = contact.ellipse();
    const auto rough = greenwood_williamson::contact(ellipse, modulus, roughness, contact.overlap);
    const auto energy = RunningEnergy::read(memory, 0);
    const bool was_closed = energy.force > 0.0;
    contact.closed = rough.force > 0.0;
    if (!contact.closed) {
      if (was_closed) contact.hysteresis_loss += energy.stored;
      forget(memory, running_energy_memory);
      return;
    }
    contact.a_c = rough.a_c;
    contact.axis_ratio = ellipse.axis_ratio;
    contact.elastic = contact.friction_load = rough.force;
    contact.stiffness = rough.stiffness;
    const auto now = energy.next(contact, was_closed);
    contact.stored_normal = now.stored;
    now.write(memory, 0);
  };
  const double range = greenwood_williamson::largest_separation * roughness.deviation;
  return {.step = step, .range = [range](double, double) { return range; }};
}

}  // namespace

const Law greenwood_williamson{{.name = "greenwood_williamson",
                                .slot = LawSlot::roughness,
                                .title = "Gaussian asperities that share the overlap with the bulk",
                                .formula = "4/3 χ Ê β^{1/2} σ^{3/2} F_{3/2}(h) = Hertz's mean pressure at δ + σh",
                                .equations = "(29)-(36)",
                                .source = "GW66",
                                .parameters = parameters,
                                .memory = running_energy_memory,
                                .conflicts = conflicts},
                               bind};

}  // namespace osculate::laws
