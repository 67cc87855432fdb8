#pragma once
// Linear spring and dashpot: F = k δ + c δ̇, with its closed forms and the ways to choose k.          [CS79; Wassgren06]

#include "osculate/mechanics/impact.hpp"

namespace osculate::linear_spring_dashpot {

struct Model {
  double stiffness;  ///< k > 0 [N/m]
  double damping;    ///< c ≥ 0 [N s/m]
};

/// Throws InputError unless k > 0 and c ≥ 0, both finite.
void validate(const Model& model);

/// F [N], positive pushes apart.
/// @param overlap  δ [m]; δ ≤ 0 gives no force
/// @param rate     δ̇ [m/s], positive while approaching
double force(const Model& model, double overlap, double rate, Attraction attraction);

/// ζ = c/(2 (k m)^{1/2})
double damping_ratio(const Model& model, double mass);

/// The damping ratio that gives restitution ε at any speed. With attraction ζ = −ln ε/(π² + ln² ε)^{1/2}; cut off, the
/// root of ε = exp(−2 ζ g), g = arccos ζ/(1 − ζ²)^{1/2} (arcosh beyond 1).                                      [SP07]
/// Throws InputError unless ε is in (0, 1].
double damping_ratio_for(double restitution, Attraction attraction);

/// ζ g(ζ) = ln of v/(ω_0 δ_max), where ω_0² = k/m: what damping does to the largest overlap. ζ ≥ 0.
double overlap_decrement(double damping_ratio);

/// One impact at speed v > 0. With attraction and ζ ≥ 1 the bodies never part: duration ∞, restitution 0.
Impact impact(const Model& model, double mass, double speed, Attraction attraction);

/// What the linear model shall have in common with the elastic Hertz impact at the same speed.
enum class Matching {
  duration,
  largest_overlap,
  strain_energy,  ///< k δ_H²/2 = m v²/2 at the Hertz impact's largest overlap
};

/// The model with restitution ε that matches Hertz at speed v in one respect. k ∝ v^{2/5}: it suits that speed only.
/// Throws InputError unless v > 0 and ε in (0, 1].
Model matched(const ImpactPair& pair, double speed, double restitution, Matching matching, Attraction attraction);

}  // namespace osculate::linear_spring_dashpot
