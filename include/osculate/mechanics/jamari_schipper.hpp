#pragma once
// Elastic, elastic–plastic and fully plastic contact of two ellipsoidal surfaces, with unloading and reloading. [JS06]
// One contact at a time, or many in batches through the same formulas.

#include <cstdint>
#include <span>
#include <string_view>

namespace osculate::jamari_schipper {

/// How the softer of the two bodies yields. The numbers are measured ones: the theory has no defaults for them.
struct Plasticity {
  double hardness;        ///< H > 0 [Pa]
  double yield_factor;    ///< K_v > 0: peak pressure at first yield, over H
  double plastic_factor;  ///< c_h ≥ 2/3 K_v: mean pressure of fully plastic contact, over H; measured below 1   [JS06b]
  double area_ratio;      ///< c_A ≥ 5: contact area where full plasticity begins, over that at first yield

  double yield_pressure() const { return yield_factor * hardness; }      ///< K_v H [Pa], peak
  double plastic_pressure() const { return plastic_factor * hardness; }  ///< c_h H [Pa], mean
};

/// Throws InputError unless every number is in its range and, for every contact with 1 ≤ R_i/R_j ≤ `largest_ratio`,
/// unloading gives back less than loading took, whatever the overlap. Pressure that grows too fast between first yield
/// and full plasticity (c_h far above 2/3 K_v, with c_A small) would create energy, the sooner the slenderer the
/// contact.
void validate(const Plasticity& plasticity, double largest_ratio);

/// Where the regimes meet.
struct Limits {
  /// First yield, where the Hertz peak pressure reaches K_v H:                                          [KDY23 (41)]
  ///   δ_n1 = R_c (π β K_v H/(2 γ Ê))² = 2 R_c E K (K_v H/Ê)²   [m]
  double first_yield;
  /// Full plasticity, where the truncated area is c_A times that at first yield; circular: c_A δ_n1/2.  [KDY23 (44)]
  ///   δ_n2 = c_A β R_c/(2 (R_i R_j)^{1/2}) δ_n1   [m]
  double full_plasticity;
};

/// @pre R_i ≥ R_j > 0 [m] (R_i may be ∞: held, see contact_ellipse), modulus Ê > 0 [Pa]; else throws InputError
Limits limits(double R_i, double R_j, double modulus, const Plasticity& plasticity);

enum class Regime : std::uint8_t {
  separated,        ///< no force: no overlap, or less than the residual one
  elastic,          ///< Hertz; nothing has yielded yet
  elastic_plastic,  ///< loading between δ_n1 and δ_n2
  fully_plastic,    ///< loading beyond δ_n2
  unloaded,         ///< below the largest overlap of a contact that has yielded: elastic, both ways
  bad_input,        ///< batches only: a number was NaN, infinite or out of range; every output is zero
};

std::string_view name(Regime regime);

/// What a contact remembers. Starts at zero when two bodies meet. The surfaces themselves keep no dent: a contact that
/// opens altogether and forms anew is a new contact.
struct Memory {
  double largest_overlap = 0.0;  ///< δ_max [m]
};

struct Contact {
  double force;             ///< F [N], pushes the bodies apart
  double area;              ///< A [m²]
  double stiffness;         ///< dF/dδ [N/m] in the direction in which the contact is loaded or unloaded
  double strain_energy;     ///< what unloading gives back: 2/5 F (δ − δ_res) [J]
  double residual_overlap;  ///< δ_res [m], where the force ends when unloading
  double radius_growth;     ///< ψ ≥ 1: radii of relative curvature of the unloaded contact over R_i, R_j
  Regime regime;
};

/// One contact; brings `memory` up to date.
/// Loading, at the largest overlap so far:
///   elastic, δ ≤ δ_n1: Hertz, A = π β R_c δ
///   elastic–plastic:   A = A_e + (A_p − A_e)(3z² − 2z³), z = (δ − δ_n1)/(δ_n2 − δ_n1)                  [KDY23 (45)]
///                      F = A H [c_h − (c_h − 2/3 K_v) ln(δ_n2/δ)/ln(δ_n2/δ_n1)]                        [KDY23 (46)]
///   fully plastic:     A_p = 2π (R_i R_j)^{1/2} δ, the truncated area                                  [KDY23 (42)]
///                      F = c_h H A_p                                                                   [KDY23 (43)]
/// Unloading and reloading below δ_max: Hertz on radii enlarged by ψ (same ellipse), ψ and δ_res such that force and
/// area are continuous at δ_max, where F_H, A_e are the elastic force and area of overlap δ_max:
///   δ_max − δ_res = δ_max (F/F_H)(A_e/A)^{1/2},  ψ = (A/A_e) δ_max/(δ_max − δ_res),
///   F(δ) = F(δ_max) [(δ − δ_res)/(δ_max − δ_res)]^{3/2}
/// @param overlap  δ [m]; δ ≤ 0 gives no force
/// Throws InputError unless R_i ≥ R_j > 0, Ê > 0, overlap finite, memory ≥ 0. `plasticity` must have been validated.
Contact contact(double R_i, double R_j, double modulus, const Plasticity& plasticity, double overlap, Memory& memory);

/// Many contacts, structure of arrays; all spans of one length. Units as above.
struct BatchInput {
  std::span<const double> R_i;
  std::span<const double> R_j;
  std::span<const double> modulus;
  std::span<const double> yield_pressure;    ///< Plasticity::yield_pressure
  std::span<const double> plastic_pressure;  ///< Plasticity::plastic_pressure
  std::span<const double> area_ratio;        ///< c_A
  std::span<const double> overlap;
};
struct BatchOutput {
  std::span<double> largest_overlap;  ///< in and out: Memory::largest_overlap
  std::span<double> force;
  std::span<double> area;
  std::span<double> stiffness;
  std::span<double> strain_energy;
  std::span<double> residual_overlap;
  std::span<Regime> regime;
};

/// From radii to forces, the exact ellipse included. A contact's answer does not depend on its neighbours. Bad numbers
/// are said in `regime` and leave the memory as it was; throws InputError only when the spans' lengths differ.
void contacts(const BatchInput& input, const BatchOutput& output);

}  // namespace osculate::jamari_schipper
