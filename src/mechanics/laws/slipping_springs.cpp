// Friction by a spring that softens towards sliding, as Mindlin's first loading does.

#include <array>
#include <cmath>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "mechanics/laws/spring.hpp"
#include "osculate/mechanics/hertzian_tangential.hpp"
#include "osculate/mechanics/impact.hpp"
#include "osculate/mechanics/kalker.hpp"

namespace osculate::laws {
namespace {

using hertzian_tangential::Model;

constexpr std::array langston_parameters{
    friction_parameter,
    LawParameter{
        .name = "tangential_damping", .symbol = "η", .unit = "", .meaning = "share of the dashpot", .standard = 0.0}};
constexpr std::array zheng_parameters{friction_parameter, LawParameter{.name = "viscosity",
                                                                       .symbol = "η",
                                                                       .unit = "Pa s",
                                                                       .meaning = "viscosity of the bodies' material",
                                                                       .standard = 0.0}};
constexpr std::array<std::string_view, 2> hertzian{"hertz", "hertz_sphere"};
constexpr std::string_view reason = "its slip displacement is that of a Hertz contact; take cundall_strack instead";
constexpr std::array conflicts{LawConflict{"normal", reason, hertzian}, LawConflict{"adhesion", reason},
                               LawConflict{"roughness", reason}, LawConflict{"plasticity", reason}};

// Memory: stretch of body 2 against body 1, normal, overlap and load of the last step.
constexpr std::size_t memory_size = 8;

/// ∫ μF_n [1 − (1 − x)^{3/2}] ds from 0 to the stretch, x = s/δ_max [J].
double stored(const Model& model, double overlap, double load, const TangentVector& stretch) {
  const double reach = hertzian_tangential::slip_displacement(model, overlap);
  if (!(reach > 0.0)) return 0.0;
  const double x = std::min(norm(stretch) / reach, 1.0);
  return model.friction * load * reach * (x - 0.4 * (1.0 - std::pow(1.0 - x, 2.5)));
}

/// The spring alone.
TangentVector spring_force(const Model& model, double overlap, double load, const TangentVector& stretch) {
  hertzian_tangential::Memory memory{-1.0 * stretch};
  return hertzian_tangential::langston(
      model, 0.0, 0.0, {.overlap = overlap, .normal_force = load, .displacement = {}, .velocity = {}}, memory);
}

template <class Theory>
Part slipping_part(const Binding& binding, const LawNeeds& needs, const Theory& theory) {
  const Model model{.radius = 1.0,
                    .modulus = effective_modulus(binding.material_1, binding.material_2),
                    .shear_modulus = effective_shear_modulus(binding.material_1, binding.material_2),
                    .friction = binding["friction"]};
  const auto step = [model, theory](Contact& contact, Memory memory) {
    const Vec3 old_stretch = vector_at(memory, 0);
    const TangentVector stretch = planar(contact, carried(contact, old_stretch, vector_at(memory, 3)));
    const double stored_before = stored(model, memory[6], memory[7], stretch);
    if (!contact.closed) {
      contact.friction_loss += stored_before;
      forget(memory, memory_size);
      return;
    }
    Model here = model;
    here.radius = effective_radius(contact.ellipse());
    const TangentVector before = spring_force(here, memory[6], memory[7], stretch);
    const double load = friction_load(contact);
    hertzian_tangential::Memory now{-1.0 * stretch};
    contact.force = theory(contact, here,
                           {.overlap = contact.overlap,
                            .normal_force = load,
                            .displacement = -1.0 * contact.displacement(),
                            .velocity = -1.0 * contact.velocity},
                           now);
    const TangentVector after = -1.0 * now.displacement;
    const TangentVector spring = spring_force(here, contact.overlap, load, after);
    contact.stored_tangential = stored(here, contact.overlap, load, after);
    contact.friction_loss += work(contact, before, spring) + stored_before - contact.stored_tangential;
    contact.viscous_loss += dot(contact.force - spring, contact.displacement());
    put(spatial(contact, after), memory, 0);
    put(contact.normal, memory, 3);
    memory[6] = contact.overlap, memory[7] = load;
  };
  LawNeeds all = needs;
  all.mean_angular_velocity = true;
  return {.step = step, .needs = all};
}

Part bind_langston(const Binding& binding) {
  return slipping_part(binding, {.reduced_mass = true},
                       [damping = binding["tangential_damping"]](const Contact& contact, const Model& model,
                                                                 const hertzian_tangential::Step& step,
                                                                 hertzian_tangential::Memory& memory) {
                         return hertzian_tangential::langston(model, contact.reduced_mass, damping, step, memory);
                       });
}

Part bind_zheng(const Binding& binding) {
  const double modulus = kalker::composite(binding.material_1, binding.material_2).shear_modulus;
  return slipping_part(binding, {},
                       [viscosity = binding["viscosity"], modulus](const Contact&, const Model& model,
                                                                   const hertzian_tangential::Step& step,
                                                                   hertzian_tangential::Memory& memory) {
                         return hertzian_tangential::zheng(model, viscosity, modulus, step, memory);
                       });
}

}  // namespace

const Law langston{{.name = "langston",
                    .slot = LawSlot::tangential,
                    .title = "Mindlin's first loading for any path, with a dashpot",
                    .formula = "F_t = μ F_n [1 − (1 − s/δ_max)^{3/2}] + dashpot",
                    .equations = "",
                    .source = "LTH94",
                    .parameters = langston_parameters,
                    .memory = memory_size,
                    .conflicts = conflicts},
                   bind_langston};

const Law zheng{{.name = "zheng",
                 .slot = LawSlot::tangential,
                 .title = "The same spring with the dashpot of a viscoelastic solid",
                 .formula = "F_t = μ F_n [1 − (1 − s/δ_max)^{3/2}] + dashpot",
                 .equations = "",
                 .source = "ZZY12",
                 .parameters = zheng_parameters,
                 .memory = memory_size,
                 .conflicts = conflicts},
                bind_zheng};

}  // namespace osculate::laws
