#include "osculate/mechanics/walton_braun_friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/require.hpp"

namespace osculate::walton_braun_friction {
namespace {

/// Lengths below this have no direction that could be trusted.
constexpr double smallest = std::numeric_limits<double>::min();

/// Turns the direction by what the motion square to it adds to the force.
void add_sideways(Memory& memory, const TangentVector& force) {
  const TangentVector total = memory.force * memory.direction + force;
  const double size = norm(total);
  if (!(size > smallest)) return;
  if (memory.force == 0.0) memory.turning = 0.0;
  const double sign = std::copysign(1.0, memory.force);
  memory.force = sign * size;
  memory.direction = (sign / size) * total;
}

/// The way of one step along the direction; `way` has the sign of the motion.
void advance(const Model& model, double limit, double way, Memory& memory) {
  const bool backward = way < 0.0;
  if (backward != memory.backward) {
    memory.turning = memory.force;
    memory.backward = backward;
  }
  const double sign = backward ? -1.0 : 1.0;
  const double span = limit - sign * memory.turning;
  if (!(span > 0.0)) {
    memory.force = sign * limit;
    return;
  }
  // u = 1 − |T − T*|/span obeys du/ds = −K_0/span u^γ, so that u^{1−γ} falls linearly.
  const double u = std::clamp(1.0 - sign * (memory.force - memory.turning) / span, 0.0, 1.0);
  const double rest = 1.0 - model.exponent;
  const double w = std::pow(u, rest) - rest * model.stiffness * std::fabs(way) / span;
  const double after = w > 0.0 ? std::pow(w, 1.0 / rest) : 0.0;
  memory.force = std::clamp(memory.force + sign * span * (u - after), -limit, limit);
}

}  // namespace

void validate(const Model& model) {
  constexpr const char* here = "walton_braun_friction";
  require_positive(here, "stiffness", model.stiffness, "[N/m]");
  require_not_negative(here, "friction", model.friction, "");
  if (!(model.exponent > 0.0 && model.exponent < 1.0))
    throw InputError(here, "exponent " + std::to_string(model.exponent), "a value between 0 and 1");
}

TangentVector force(const Model& model, double normal_force, const TangentVector& displacement, Memory& memory) {
  const double limit = model.friction * normal_force;
  if (!(limit > 0.0)) {
    memory = {};
    return {};
  }
  if (memory.normal_force > 0.0) memory.turning *= normal_force / memory.normal_force;
  memory.normal_force = normal_force;
  memory.turning = std::clamp(memory.turning, -limit, limit);
  memory.force = std::clamp(memory.force, -limit, limit);

  const double length = norm(displacement);
  if (length > smallest) {
    if (dot(memory.direction, memory.direction) == 0.0) memory.direction = (1.0 / length) * displacement;
    const double along = dot(displacement, memory.direction);
    const TangentVector sideways = displacement - along * memory.direction;
    if (along != 0.0) advance(model, limit, along, memory);
    add_sideways(memory, model.stiffness * sideways);
    memory.force = std::clamp(memory.force, -limit, limit);
  }
  return -memory.force * memory.direction;
}

double recoverable_energy(const Model& model, const Memory& memory) {
  // On the way back from a turn at T_0, T = T_0 − (μF_n + T_0)(1 − u) and ds = −dT/(K_0 u^γ), all counted along T.
  const double size = std::fabs(memory.force), limit = model.friction * memory.normal_force;
  if (!(size > 0.0) || !(limit > 0.0)) return 0.0;
  const bool unloading = memory.backward == (memory.force > 0.0);
  const double turn = unloading ? std::max(std::copysign(1.0, memory.force) * memory.turning, size) : size;
  const double span = limit + turn, now = 1.0 - (turn - size) / span, end = 1.0 - turn / span;
  const auto integral = [&](double u) {
    return (turn - span) * std::pow(u, 1.0 - model.exponent) / (1.0 - model.exponent) +
           span * std::pow(u, 2.0 - model.exponent) / (2.0 - model.exponent);
  };
  return span / model.stiffness * (integral(now) - integral(end));
}

}  // namespace osculate::walton_braun_friction
