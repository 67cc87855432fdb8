#include "osculate/mechanics/hertzian_tangential.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/require.hpp"

namespace osculate {

double effective_shear_modulus(const ElasticMaterial& material_1, const ElasticMaterial& material_2) {
  const auto compliance = [](const ElasticMaterial& material) {
    return (2.0 - material.poissons_ratio) / material.shear_modulus();
  };
  return 1.0 / (compliance(material_1) + compliance(material_2));
}

namespace hertzian_tangential {
namespace {

constexpr const char* here = "hertzian_tangential";

/// A spring of stiffness k, a dashpot c, and the limit μ F_n; what slips leaves the memory.
TangentVector limited_spring(double stiffness, double damping, double limit, const Step& step, Memory& memory) {
  memory.displacement = shortened(memory.displacement + step.displacement, limit / stiffness);
  return shortened(-stiffness * memory.displacement - damping * step.velocity, limit);
}

/// Mindlin's loading curve at constant load, and what is left of its slope: (1 − s)^{1/2}.
struct SlippingSpring {
  TangentVector force;
  double remaining;
};

SlippingSpring slipping_spring(double limit, double slip_displacement, const Step& step, Memory& memory) {
  memory.displacement = shortened(memory.displacement + step.displacement, slip_displacement);
  const double length = norm(memory.displacement);
  if (!(length > 0.0)) return {{}, 1.0};
  const double part = std::min(length / slip_displacement, 1.0);
  const double remaining = std::sqrt(1.0 - part);
  // 1 − (1 − s)^{3/2} = s (1 + r + r²)/(1 + r), without cancellation at small s.
  const double grown = part * (1.0 + remaining + remaining * remaining) / (1.0 + remaining);
  return {(-limit * grown / length) * memory.displacement, remaining};
}

/// No contact, or nothing to hold it: the memory ends.
bool is_idle(const Model& model, const Step& step, Memory& memory) {
  const bool idle = !(step.overlap > 0.0 && step.normal_force > 0.0 && model.friction > 0.0);
  if (idle) memory = {};
  return idle;
}

double no_slip_stiffness(const Model& model, double overlap) {
  return 8.0 * model.shear_modulus * std::sqrt(model.radius * overlap);
}

}  // namespace

void validate(const Model& model) {
  require_positive(here, "effective radius", model.radius, "[m]");
  require_positive(here, "effective modulus", model.modulus, "[Pa]");
  require_positive(here, "effective shear modulus", model.shear_modulus, "[Pa]");
  require_not_negative(here, "friction", model.friction, "");
}

double slip_displacement(const Model& model, double overlap) {
  return model.friction * overlap * model.modulus / (4.0 * model.shear_modulus);
}

TangentVector di_renzo(const Model& model, const Step& step, Memory& memory) {
  if (is_idle(model, step, memory)) return {};
  return limited_spring(2.0 / 3.0 * no_slip_stiffness(model, step.overlap), 0.0, model.friction * step.normal_force,
                        step, memory);
}

TangentVector tsuji(const Model& model, double damping, const Step& step, Memory& memory) {
  if (is_idle(model, step, memory)) return {};
  return limited_spring(no_slip_stiffness(model, step.overlap), damping, model.friction * step.normal_force, step,
                        memory);
}

TangentVector langston(const Model& model, double mass, double damping, const Step& step, Memory& memory) {
  if (is_idle(model, step, memory)) return {};
  const double limit = model.friction * step.normal_force, reach = slip_displacement(model, step.overlap);
  const auto [spring, remaining] = slipping_spring(limit, reach, step, memory);
  const double dashpot = damping * std::sqrt(6.0 * mass * limit * remaining / reach);
  return shortened(spring - dashpot * step.velocity, limit);
}

TangentVector zheng(const Model& model, double viscosity, double body_shear_modulus, const Step& step, Memory& memory) {
  if (is_idle(model, step, memory)) return {};
  const double limit = model.friction * step.normal_force, reach = slip_displacement(model, step.overlap);
  const auto [spring, remaining] = slipping_spring(limit, reach, step, memory);
  const double q = viscosity / (2.0 * body_shear_modulus * reach);
  const double dashpot = q * std::max(0.0, 1.0 - 0.4 * q * norm(step.velocity)) * 1.5 * limit * remaining;
  return shortened(spring - dashpot * step.velocity, limit);
}

}  // namespace hertzian_tangential
}  // namespace osculate
