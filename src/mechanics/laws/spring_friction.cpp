// Friction by one spring and a slider, of constant stiffness or of one that follows the Hertz contact.

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "mechanics/laws/spring.hpp"
#include "osculate/mechanics/hertzian_tangential.hpp"
#include "osculate/mechanics/impact.hpp"
#include "osculate/mechanics/tangential_springs.hpp"

namespace osculate::laws {
namespace {

constexpr LawParameter damping_parameter{.name = "tangential_damping",
                                         .symbol = "c_t",
                                         .unit = "N s/m",
                                         .meaning = "dashpot beside the spring",
                                         .standard = 0.0};
constexpr std::array spring_parameters{friction_parameter,
                                       LawParameter{.name = "tangential_stiffness",
                                                    .symbol = "k_t",
                                                    .unit = "N/m",
                                                    .meaning = "stiffness of the tangential spring",
                                                    .least = 0.0,
                                                    .least_bound = LawParameter::Bound::excluded},
                                       damping_parameter};
constexpr std::array di_renzo_parameters{friction_parameter};
constexpr std::array tsuji_parameters{friction_parameter, damping_parameter};

constexpr std::array<std::string_view, 2> hertzian{"hertz", "hertz_sphere"};
constexpr std::string_view reason = "its stiffness is that of a Hertz contact; take cundall_strack instead";
constexpr std::array hertz_stiffness{LawConflict{"normal", reason, hertzian}, LawConflict{"adhesion", reason},
                                     LawConflict{"roughness", reason}, LawConflict{"plasticity", reason}};

/// What a law of one spring answers to the spring's stretch and the step, both those of body 1.
struct Answer {
  TangentVector force, stretch;
  double stiffness;
};

template <class Model>
Part spring_part(const Model& model) {
  const auto step = [model](Contact& contact, Memory memory) {
    const Vec3 old_stretch = vector_at(memory, 0);
    const double old_stiffness = memory[6];
    const double stored_before = 0.5 * old_stiffness * old_stretch.squaredNorm();
    if (!contact.closed) {
      contact.friction_loss += stored_before;
      forget(memory, spring_memory);
      return;
    }
    const TangentVector stretch = planar(contact, carried(contact, old_stretch, vector_at(memory, 3)));
    const Answer answer = model(contact, -1.0 * stretch);
    const TangentVector now = -1.0 * answer.stretch;
    contact.force = contact.force + answer.force;
    contact.stored_tangential += 0.5 * answer.stiffness * dot(now, now);
    const double lost = work(contact, old_stiffness * stretch, answer.stiffness * now) + stored_before -
                        0.5 * answer.stiffness * dot(now, now);
    // The rest of the force is the dashpot's: it meets the motion as it is now.
    const TangentVector rest = answer.force - answer.stiffness * now;
    contact.friction_loss += lost;
    contact.viscous_loss += dot(rest, contact.displacement());
    put(spatial(contact, now), memory, 0);
    put(contact.normal, memory, 3);
    memory[6] = answer.stiffness;
  };
  return {.step = step, .needs = {.mean_angular_velocity = true}};
}

Part bind_cundall_strack(const Binding& binding) {
  const tangential_springs::Model model{.stiffness = binding["tangential_stiffness"],
                                        .damping = binding["tangential_damping"],
                                        .friction = binding["friction"]};
  tangential_springs::validate(model);
  return spring_part([model](Contact& contact, const TangentVector& stretch) -> Answer {
    tangential_springs::Memory memory{stretch};
    const TangentVector force = tangential_springs::force(model, friction_load(contact), -1.0 * contact.displacement(),
                                                          -1.0 * contact.velocity, memory);
    return {force, memory.stretch, model.stiffness};
  });
}

/// The circular contact's model with the stiffness of this contact: 2 Ê a = dF_n/dδ.
hertzian_tangential::Model model_of(const Binding& binding) {
  return {.radius = 1.0,
          .modulus = effective_modulus(binding.material_1, binding.material_2),
          .shear_modulus = effective_shear_modulus(binding.material_1, binding.material_2),
          .friction = binding["friction"]};
}

template <class Theory>
Part hertzian_part(const hertzian_tangential::Model& model, double share, const Theory& theory) {
  return spring_part([model, share, theory](Contact& contact, const TangentVector& stretch) -> Answer {
    hertzian_tangential::Model here = model;
    here.radius = effective_radius(contact.ellipse());
    const hertzian_tangential::Step step{.overlap = contact.overlap,
                                         .normal_force = friction_load(contact),
                                         .displacement = -1.0 * contact.displacement(),
                                         .velocity = -1.0 * contact.velocity};
    hertzian_tangential::Memory memory{stretch};
    const TangentVector force = theory(here, step, memory);
    const double stiffness =
        share * tangential_springs::stiffness_ratio(model.modulus, model.shear_modulus) * contact.stiffness;
    return {force, memory.displacement, stiffness};
  });
}

Part bind_di_renzo(const Binding& binding) {
  return hertzian_part(model_of(binding), 2.0 / 3.0, hertzian_tangential::di_renzo);
}

Part bind_tsuji_tangential(const Binding& binding) {
  const double damping = binding["tangential_damping"];
  return hertzian_part(model_of(binding), 1.0,
                       [damping](const hertzian_tangential::Model& model, const hertzian_tangential::Step& step,
                                 hertzian_tangential::Memory& memory) {
                         return hertzian_tangential::tsuji(model, damping, step, memory);
                       });
}

}  // namespace

const Law cundall_strack{{.name = "cundall_strack",
                          .slot = LawSlot::tangential,
                          .title = "Spring, dashpot and slider",
                          .formula = "F_t = k_t s + c_t v, |F_t| ≤ μ F_n",
                          .equations = "",
                          .source = "CS79",
                          .parameters = spring_parameters,
                          .memory = spring_memory,
                          .conflicts = {}},
                         bind_cundall_strack};

const Law di_renzo{{.name = "di_renzo",
                    .slot = LawSlot::tangential,
                    .title = "Spring of two thirds of the no-slip stiffness, and slider",
                    .formula = "F_t = 16/3 Ĝ a s, |F_t| ≤ μ F_n",
                    .equations = "",
                    .source = "DD05",
                    .parameters = di_renzo_parameters,
                    .memory = spring_memory,
                    .conflicts = hertz_stiffness},
                   bind_di_renzo};

const Law tsuji_tangential{{.name = "tsuji_tangential",
                            .slot = LawSlot::tangential,
                            .title = "Spring of the no-slip stiffness, dashpot and slider",
                            .formula = "F_t = 8 Ĝ a s + c_t v, |F_t| ≤ μ F_n",
                            .equations = "",
                            .source = "TTI92",
                            .parameters = tsuji_parameters,
                            .memory = spring_memory,
                            .conflicts = hertz_stiffness},
                           bind_tsuji_tangential};

}  // namespace osculate::laws
