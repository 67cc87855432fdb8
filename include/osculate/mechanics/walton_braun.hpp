#pragma once
// Hysteretic linear contact: loads along k_1, unloads and reloads along a steeper k_2.                  [WB86;
// Wassgren06]

#include "osculate/mechanics/impact.hpp"

namespace osculate::walton_braun {

/// k_2 = unloading + hardening · F_max, where F_max = k_1 δ_max is the force at the largest overlap.
struct Model {
  double loading;          ///< k_1 > 0 [N/m]
  double unloading;        ///< ≥ k_1 [N/m]
  double hardening = 0.0;  ///< S ≥ 0 [1/m]
};

/// Throws InputError unless 0 < k_1 ≤ unloading and S ≥ 0, all finite.
void validate(const Model& model);

/// Constant unloading stiffness k_2 = k_1/ε²: restitution ε at any speed. Throws InputError unless ε is in (0, 1].
Model constant_unloading(double loading, double restitution);

/// Unloading stiffness that grows with the force reached: k_2 = k_1 + S F_max, ε = (1 + S v/ω_1)^{−1/2}, ω_1² = k_1/m.
Model variable_unloading(double loading, double hardening);

/// Starts at zero when two bodies meet.
struct Memory {
  double largest_overlap = 0.0;  ///< δ_max [m]
};

/// F = k_1 δ at the largest overlap, k_2 (δ − δ_res) below it, never attractive; brings `memory` up to date.
double force(const Model& model, double overlap, Memory& memory);

/// δ_res = δ_max (1 − k_1/k_2) [m]
double residual_overlap(const Model& model, const Memory& memory);

/// One impact at speed v > 0, ending where the force does: T = π/2 (1/ω_1 + 1/ω_2).
Impact impact(const Model& model, double mass, double speed);

}  // namespace osculate::walton_braun
