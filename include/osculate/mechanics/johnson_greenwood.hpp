#pragma once
// Adhesive elastic contact of smooth bodies: the JKR theory for elliptical contacts.            [JG05]
// States along the equilibrium curve first, then the curve under force or overlap control, then contacts with memory.
//
// The traction over an ellipse of semi-axes a ≥ b is (P_0 − P_1 x²/a² − P_2 y²/b²)/(1 − x²/a² − y²/b²)^{1/2}: P_1 and
// P_2 bend the surfaces into the bodies' curvatures, and the tension left at the edge is Griffith's at the ends of both
// axes. Every state then follows from g = b/a alone. R = (R_i R_j)^{1/2} throughout. W → 0 is Hertz.

#include <optional>
#include <span>
#include <string_view>

#include "osculate/mechanics/elliptic_integrals.hpp"

namespace osculate::johnson_greenwood {

/// Two bodies at a contact.
struct Pair {
  double R_i;               ///< larger radius of relative curvature, along the major axis [m]
  double R_j;               ///< smaller radius of relative curvature [m]
  double modulus;           ///< Ê [Pa], see effective_modulus
  double work_of_adhesion;  ///< W ≥ 0 [J/m²]: energy to part unit area; 0 is Hertz
};

/// Throws InputError unless 0 < R_j ≤ R_i ≤ largest_radius_ratio R_j, Ê > 0, W ≥ 0, all finite.
void validate(const Pair& pair);

/// One equilibrium of the contact.
struct State {
  double axis_ratio;  ///< g = b_c/a_c in [g_Hertz, 1]
  double a_c;         ///< major semi-axis [m]
  double b_c;         ///< minor semi-axis [m]
  double force;       ///< F [N], > 0 pushes the bodies apart
  double overlap;     ///< δ [m]
  double stiffness;   ///< dF/dδ along the equilibrium curve [N/m]; −∞ where the overlap is least

  double area() const;  ///< π a_c b_c [m²]
};

/// The scales by which the theory becomes free of dimensions; all vanish with W.
struct Units {
  double force;    ///< 3π R W [N]
  double length;   ///< (9π W R²/(4Ê))^{1/3} [m]
  double overlap;  ///< length²/R [m]
};
Units units(const Pair& pair);

// ---- Functions of the axis ratio g and of radius_ratio = R_i/R_j ≥ 1. Each throws InputError outside
// ---- g_Hertz < g < 1, except the two shape constants, which serve any g in (0, 1].

/// Shape constant of the major axis: P_1 = Π_1 Ê a_c/(2 g R).                                         [KDY23 (22)]
double shape_constant_major(double radius_ratio, double axis_ratio);
/// Shape constant of the minor axis: P_2 = Π_2 g Ê a_c/(2 R). Where Π_2 g² = Π_1 the pressure is Hertz's. [KDY23 (23)]
double shape_constant_minor(double radius_ratio, double axis_ratio);

/// ∫ sin²/Δ from 0 to π/2 at e² = 1 − g².                                                             [KDY23 (24)]
double integral_D(double axis_ratio);
/// ∫ cos²/Δ.                                                                                          [KDY23 (25)]
double integral_B(double axis_ratio);
/// ∫ sin² cos²/Δ³ = (D − B)/e², π/16 for a circle, and no digit lost near it.                         [KDY23 (26)]
double integral_C(double axis_ratio);

/// Force in units of 3π R W.                                                                          [KDY23 (19)]
double force_of(double radius_ratio, double axis_ratio);
/// Overlap in units of length²/R.                                                                     [KDY23 (20)]
double overlap_of(double radius_ratio, double axis_ratio);
/// a_c b_c in units of length².                                                                       [KDY23 (21)]
double area_of(double radius_ratio, double axis_ratio);
/// γ of F = 4/3 Ê R^{1/2} δ^{3/2} γ, with R = (R_i R_j)^{1/2}: at g_Hertz it is (R_c/R)^{1/2} times the γ of (11).
/// InputError where δ ≤ 0 and no γ exists.                                                            [KDY23 (27)]
double gamma(double radius_ratio, double axis_ratio);
/// β of a_c b_c = β R δ, with the factor 2 on K that the review's denominator lacks: at g_Hertz it is R_c/R times the β
/// of (12). InputError where δ ≤ 0.                                                                   [KDY23 (28)]
double beta(double radius_ratio, double axis_ratio);

// ---- The equilibrium curve of a pair. All throw InputError on a bad pair.

/// The state of major semi-axis a_c > 0 [m], whether stable or not.
State at_major_axis(const Pair& pair, double a_c);
/// The least force a contact can bear: where it parts when the force is prescribed (dead load). −1.5π R W for a circle.
/// W > 0, else InputError.
State pull_off(const Pair& pair);
/// The least overlap: where it parts when the overlap is prescribed, as in a DEM step. W > 0, else InputError.
State snap_off(const Pair& pair);
/// The stable state under a prescribed force; nothing below pull-off, or for F ≤ 0 when W = 0.
std::optional<State> at_force(const Pair& pair, double force);
/// The stable state of a closed contact under a prescribed overlap; nothing below snap-off, or for δ ≤ 0 when W = 0.
std::optional<State> at_overlap(const Pair& pair, double overlap);
/// Energy lost when a contact snaps in at δ = 0 and tears at snap-off: −∫ F dδ between the two [J], ≥ 0.
double hysteresis_loss(const Pair& pair);

// ---- Which adhesion theory a contact belongs to.

/// Tabor's parameter (R W²/(Ê² z_0³))^{1/3}: stretch of the neck over the range of the attraction.         [Tabor77]
/// @param range z_0 > 0 [m], the equilibrium distance of the surfaces, about 0.2 nm to 0.4 nm
double tabor_parameter(const Pair& pair, double range);
enum class Regime {
  hard,          ///< μ_T < 0.1: rigid enough for DMT
  intermediate,  ///< neither
  soft,          ///< μ_T > 5: JKR and this theory
};
Regime regime(double tabor_parameter);
std::string_view name(Regime regime);
/// DMT, the limit of small hard contacts: Hertz's force and ellipse less the rigid attraction 2π R W (exact for rigid
/// paraboloids by Derjaguin's approximation). Nothing for δ < 0.                                           [DMT75]
std::optional<State> derjaguin_muller_toporov(const Pair& pair, double overlap);

// ---- Contacts in a DEM step.

/// What a contact remembers: its last ellipse, which is also where the next search starts. a_c = 0: apart.
struct Memory {
  double a_c = 0.0;
  double axis_ratio = 0.0;

  bool closed() const { return a_c > 0.0; }
};

enum class Status : unsigned char {
  apart,          ///< no contact, no force
  closed,         ///< in contact; force may be negative
  not_converged,  ///< the search ran out of steps; the numbers are its last
  bad_input,      ///< a number was NaN, infinite or out of range; every output is zero
};
std::string_view name(Status status);

/// Many contacts, structure of arrays; all spans of one length.
struct BatchInput {
  std::span<const double> R_i, R_j, modulus, work_of_adhesion, overlap;
};
struct BatchOutput {
  std::span<double> force, a_c, b_c, stiffness;
  std::span<Status> status;
};
/// Overlap control with hysteresis: a contact closes at δ ≥ 0 and opens below its snap-off overlap.
/// Throws InputError only when lengths differ.
void contacts(const BatchInput& input, std::span<Memory> memory, const BatchOutput& output);

}  // namespace osculate::johnson_greenwood
