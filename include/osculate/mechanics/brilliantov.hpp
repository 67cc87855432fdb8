#pragma once
// Viscoelastic dissipation in a contact of two bodies: the elastic law, with its elastic constants replaced by viscous
// ones and its displacements by their rates.                                            [BSHP96; BAAP07]
// The material's time first, then the dissipative forces on top of any elastic law, then what a collision loses.

#include "osculate/mechanics/johnson_greenwood.hpp"
#include "osculate/mechanics/material.hpp"

namespace osculate::brilliantov {

/// Viscous constants of a solid: stress = 2 η_1 (strain rate's deviator) + η_2 (its trace).
struct Viscosity {
  double shear;  ///< η_1 ≥ 0 [Pa s]
  double bulk;   ///< η_2 ≥ 0 [Pa s]
};
/// Throws InputError unless both are ≥ 0 and finite and not both zero.
void validate(const Viscosity& viscosity);

/// The dissipative time of a material [s]:
///   A = 1/3 (3η_2 − η_1)²/(3η_2 + 2η_1) · (1 − ν²)(1 − 2ν)/(E ν²).                                     [KDY23 (38)]
/// Throws InputError for a bad material or viscosity, and for ν = 0, where the theory has no value.
double dissipative_time(const ElasticMaterial& material, const Viscosity& viscosity);

/// Throws InputError unless A ≥ 0 and finite.
void validate_time(double dissipative_time);

/// Dissipative force of a Hertzian contact [N]: F_dis = A δ̇ dF/dδ = 2 A Ê R_c^{1/2} γ δ^{1/2} δ̇.      [KDY23 (37)]
/// @param dissipative_time  A [s]
/// @param stiffness         dF/dδ of hertz::contact [N/m]
/// @param rate              δ̇ [m/s], > 0 while approaching; the force then pushes apart
double dissipative_force(double dissipative_time, double stiffness, double rate);

/// Dissipative force of an adhesive contact [N]: F_dis = A ȧ ∂F/∂a, which along the equilibrium curve is A δ̇ dF/dδ.
/// Between pull-off and snap-off the curve's force falls while the contact shrinks, ∂F/∂a < 0 < ∂δ/∂a: there the
/// printed force would *drive* the motion, without bound towards snap-off, and is left out, so that no step can gain
/// energy.                                                                                            [KDY23 (39)]
double dissipative_force(double dissipative_time, const johnson_greenwood::State& state, double rate);

/// The same force of a circular contact by its radius: A ȧ [3a²/(D R) − 3/2 (6πW/D)^{1/2} a^{1/2}], D = 3/(4Ê); the
/// review's D lacks Ê, which its (39) has. As printed otherwise, that is with its negative branch.    [KDY23 (40)]
/// @param radius       R = (R_i R_j)^{1/2} [m]
/// @param radius_rate  ȧ [m/s]
double dissipative_force_circular(double dissipative_time, double radius, double modulus, double work_of_adhesion,
                                  double a_c, double radius_rate);

/// Whether elastic and dissipative force together may pull at the end of a collision.
enum class Attraction {
  allowed,  ///< the sum as it is; for adhesive contacts
  cut_off,  ///< never below zero: dry surfaces part where the sum vanishes                                  [SP08]
};
double total_force(double elastic, double dissipative, Attraction attraction);

/// Tangential dissipative force of Mindlin's contact in partial slip [N]:
///   F = (η_1/G) δ̇_t dF_t/dδ_t = 4 η_1 (Ĝ/G)(a_c/Φ) δ̇_t {1 − δ_t/δ_t,max}^{1/2},
/// which is what (60) gives for the review's first half; its printed second half differs.             [KDY23 (85)]
/// @param shear_viscosity   η_1 ≥ 0 [Pa s]
/// @param shear_modulus     G > 0 [Pa]
/// @param no_slip_stiffness 4 Ĝ a_c/Φ [N/m]: dF_t/dδ_t at δ_t = 0 (total relative displacement; Ĝ = G/(2 − ν) for
///                          two identical bodies)
/// @param slip              δ_t/δ_t,max, at which 1 is full slip; the force is zero from there on
/// @param rate              δ̇_t [m/s]
double tangential_dissipative_force(double shear_viscosity, double shear_modulus, double no_slip_stiffness, double slip,
                                    double rate);

/// Coefficient of restitution of a Hertzian collision, to second order in x = 3/2 A (k/m)^{2/5} v^{1/5}:
///   e = 1 − C_1 x + 3/5 C_1² x²,  C_1 = π^{1/2} Γ(3/5)/(2^{1/5} 5^{2/5} Γ(21/10)) = 1.15344.      [RPBS99; SP08]
/// The next term is 0.267 x^{5/2} when attraction is cut off; use below x = 0.3, where it is 1 %.
/// @param force_constant  k = F/δ^{3/2} = 4/3 Ê R_c^{1/2} γ [N/m^{3/2}]
/// @param reduced_mass    m = m_1 m_2/(m_1 + m_2) [kg]
/// @param speed           v ≥ 0 [m/s]
/// InputError on non-positive constants.
double restitution(double dissipative_time, double force_constant, double reduced_mass, double speed);

}  // namespace osculate::brilliantov
