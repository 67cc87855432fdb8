#include "osculate/mechanics/tangential_springs.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/require.hpp"
#include "osculate/mechanics/linear_spring_dashpot.hpp"

namespace osculate::tangential_springs {
namespace {

constexpr const char* here = "tangential_springs";

}  // namespace

TangentVector sliding(double friction, double normal_force, const TangentVector& velocity) {
  const double speed = norm(velocity);
  return speed > 0.0 ? (-friction * normal_force / speed) * velocity : TangentVector{};
}

TangentVector viscous(double damping, const TangentVector& velocity) {
  return -damping * velocity;
}

TangentVector viscous_sliding(double damping, double friction, double normal_force, const TangentVector& velocity) {
  return shortened(viscous(damping, velocity), friction * normal_force);
}

void validate(const Model& model) {
  require_positive(here, "stiffness", model.stiffness, "[N/m]");
  require_not_negative(here, "damping", model.damping, "[N s/m]");
  require_not_negative(here, "friction", model.friction, "");
}

TangentVector force(const Model& model, double normal_force, const TangentVector& displacement,
                    const TangentVector& velocity, Memory& memory) {
  memory.stretch = memory.stretch + displacement;
  const TangentVector dashpot = -model.damping * velocity;
  const TangentVector trial = dashpot - model.stiffness * memory.stretch;
  const double limit = model.friction * normal_force;
  if (norm(trial) <= limit) return trial;
  const TangentVector force = shortened(trial, limit);
  // The spring holds what the dashpot leaves over, and no more than the limit itself.
  memory.stretch = shortened((1.0 / model.stiffness) * (dashpot - force), limit / model.stiffness);
  return force;
}

double stiffness_ratio(double modulus, double shear_modulus) {
  require_positive(here, "effective modulus", modulus, "[Pa]");
  require_positive(here, "effective shear modulus", shear_modulus, "[Pa]");
  return 4.0 * shear_modulus / modulus;
}

double damping_for_restitution(double stiffness, double mass, double restitution) {
  require_positive(here, "stiffness", stiffness, "[N/m]");
  require_positive(here, "effective mass", mass, "[kg]");
  const double ratio = linear_spring_dashpot::damping_ratio_for(restitution, Attraction::allowed);
  return 2.0 * ratio * std::sqrt(2.0 / 7.0 * mass * stiffness);
}

}  // namespace osculate::tangential_springs
