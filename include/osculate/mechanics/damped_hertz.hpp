#pragma once
// Hertz with a dashpot: F = k_H δ^{3/2} + c δ^p δ̇. Three models of the literature, two exponents p.

#include "osculate/mechanics/impact.hpp"

namespace osculate::damped_hertz {

/// The dashpot's dependence on the overlap.
enum class Damping {
  quarter,  ///< c δ^{1/4} δ̇: restitution does not depend on the speed [TTI92]
  half,  ///< c δ^{1/2} δ̇: viscoelastic solid; restitution falls as 1 − C v^{1/5}                      [KK87; BSHP96]
};

struct Model {
  double stiffness;  ///< k_H > 0 [N/m^{3/2}], see ImpactPair::hertz_coefficient
  double damping;    ///< c ≥ 0 [N s/m^{1+p}]
  Damping kind;
};

/// Throws InputError unless k_H > 0 and c ≥ 0, both finite.
void validate(const Model& model);

/// F [N], positive pushes apart; δ ≤ 0 gives no force. Rate δ̇ > 0 while approaching [m/s].
double force(const Model& model, double overlap, double rate, Attraction attraction);

/// Tsuji, Tanaka, Ishida: c = α (m k_H)^{1/2}. With z = δ^{5/4} and dτ = δ^{1/4} dt the motion is a damped linear
/// oscillator of ζ = α/√5, so that ε fixes α exactly: α = √5 ζ(ε) with the linear model's ζ; no fit is needed.
/// [TTI92; AE11]
double tsuji_factor(double restitution, Attraction attraction);  ///< α; throws InputError unless ε is in (0, 1]
Model tsuji(const ImpactPair& pair, double restitution, Attraction attraction);

/// Kuwabara and Kono: c given [N s/m^{3/2}].                                                                     [KK87]
Model kuwabara_kono(const ImpactPair& pair, double damping);

/// Brilliantov, Spahn, Hertzsch, Pöschel: F = k_H (δ^{3/2} + 3/2 A δ^{1/2} δ̇), the same form with c = 3/2 A k_H.
/// @param dissipative_time  A ≥ 0 [s], a constant of the material                                             [BSHP96]
Model brilliantov(const ImpactPair& pair, double dissipative_time);

/// One impact at speed v > 0 [m/s].
/// quarter: exact: restitution and overlap in closed form, duration by quadrature of ∫ z^{−1/5} dτ to 1e-12.
/// half:    by integrating the one-parameter equation x″ + β x^{1/2} x′ + x^{3/2} = 0 to 1e-10 or better.
/// With attraction, tsuji with ζ ≥ 1 never parts: duration ∞, restitution 0.
Impact impact(const Model& model, double mass, double speed, Attraction attraction);

/// The viscoelastic model (half) whose restitution at speed v is ε, to 1e-10.
/// Throws InputError unless v > 0 and ε in (0, 1].
Model viscoelastic_with(const ImpactPair& pair, double speed, double restitution, Attraction attraction);

/// 1 − ε of the viscoelastic model to first order in the damping: C c k_H^{−3/5} m^{−2/5} v^{1/5} with
///   C = (4/5) (5/4)^{3/5} B(3/5, 3/2) = 1.15345                                                               [SP98]
double viscoelastic_loss_first_order(const Model& model, double mass, double speed);

}  // namespace osculate::damped_hertz
