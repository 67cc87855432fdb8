// Normal laws of smooth elastic bodies.

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"

namespace osculate::laws {
namespace {

Part bind_hertz(const Binding& binding) {
  const double modulus = effective_modulus(binding.material_1, binding.material_2);
  return {.step = [modulus](Contact& contact, Memory) { press_hertz(contact, modulus); }};
}

Part bind_hertz_sphere(const Binding& binding) {
  const double modulus = effective_modulus(binding.material_1, binding.material_2);
  return {.step =
              [modulus](Contact& contact, Memory) {
                contact.R_i = contact.R_j = contact.effective_radius;
                press_hertz(contact, modulus);
              },
          .needs = {.effective_radius = true}};
}

}  // namespace

const Law hertz{{.name = "hertz",
                 .slot = LawSlot::normal,
                 .title = "Elliptical Hertz",
                 .formula = "F = 4/3 Ê R_c^{1/2} δ^{3/2} γ",
                 .equations = "(1),(2),(11)-(13)",
                 .source = "KDY23, Johnson85",
                 .parameters = {},
                 .memory = 0,
                 .conflicts = {}},
                bind_hertz};

const Law hertz_sphere{{.name = "hertz_sphere",
                        .slot = LawSlot::normal,
                        .title = "Hertz on the volume-equivalent spheres",
                        .formula = "F = 4/3 Ê R^{1/2} δ^{3/2}, 1/R = 1/R_1 + 1/R_2 of the volume-equivalent radii",
                        .equations = "",
                        .source = "Wassgren06",
                        .parameters = {},
                        .memory = 0,
                        .conflicts = {}},
                       bind_hertz_sphere};

}  // namespace osculate::laws
