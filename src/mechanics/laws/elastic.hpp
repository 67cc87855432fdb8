#pragma once
// What several laws of the registry share.

#include <algorithm>

#include "mechanics/laws/law_part.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace osculate::laws {

/// For laws that have no contact ellipse of their own: the one of Hertz at this overlap.
inline void set_ellipse(Contact& contact) {
  constexpr double any_modulus = 1.0;  // the ellipse does not depend on it
  contact.a_c = hertz::contact(contact.ellipse(), any_modulus, contact.overlap, contact.R_j).a_c;
  contact.axis_ratio = contact.ellipse().axis_ratio;
}

/// Hertz's contact carries the load.
inline void press_hertz(Contact& contact, double modulus) {
  contact.closed = contact.overlap > 0.0;
  if (!contact.closed) return;
  const auto hertz = hertz::contact(contact.ellipse(), modulus, contact.overlap, contact.R_j);
  contact.a_c = hertz.a_c;
  contact.axis_ratio = contact.ellipse().axis_ratio;
  contact.elastic = contact.friction_load = hertz.force;
  contact.stiffness = hertz.stiffness;
  contact.stored_normal = hertz.strain_energy;
}

/// The dashpot c dδ/dt. Dry surfaces part where the whole force vanishes; adhesive ones may pull.
inline void damp(Contact& contact, double coefficient) {
  if (!contact.closed) return;
  const double force = coefficient * contact.rate;
  contact.dashpot = contact.pulls ? force : std::max(force, -std::max(contact.elastic, 0.0));
  contact.viscous_loss += contact.dashpot * contact.rate * contact.time_step;
}

/// What μ multiplies, the dashpot's share included.
inline double friction_load(const Contact& contact) {
  return std::max(contact.friction_load + contact.dashpot, 0.0);
}

/// The work of the surfaces' motion against a tangential force that grew from `before` to `now` (on body 1).
inline double work(const Contact& contact, const TangentVector& before, const TangentVector& now) {
  return 0.5 * dot(before + now, contact.displacement());
}

/// The energy of a law that has no closed form for it: the work since the contact was made, kept beside it.
inline constexpr std::size_t running_energy_memory = 3;
struct RunningEnergy {
  double overlap, force, stored;

  static RunningEnergy read(const Memory& memory, std::size_t entry) {
    return {memory[entry], memory[entry + 1], memory[entry + 2]};
  }
  void write(const Memory& memory, std::size_t entry) const {
    memory[entry] = overlap, memory[entry + 1] = force, memory[entry + 2] = stored;
  }
  /// By the trapezoidal rule over the step. A contact just made came from a force of zero.
  RunningEnergy next(const Contact& contact, bool was_closed) const {
    const double before = was_closed ? force : 0.0;
    const double way = was_closed ? contact.overlap - overlap : std::max(contact.rate, 0.0) * contact.time_step;
    const double kept = was_closed ? stored : 0.0;
    return {contact.overlap, contact.elastic, kept + 0.5 * (before + contact.elastic) * way};
  }
};

inline constexpr LawParameter friction_parameter{
    .name = "friction", .symbol = "μ", .unit = "", .meaning = "friction coefficient"};

}  // namespace osculate::laws
