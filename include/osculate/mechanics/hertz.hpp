#pragma once
// Elliptical Hertz: two smooth elastic bodies pressed together without friction or adhesion.
// One contact at a time, or many in batches through the same formulas.

#include <cstdint>
#include <span>
#include <string_view>

#include "osculate/mechanics/contact_ellipse.hpp"

namespace osculate::hertz {

/// Whether the half-space theory may be trusted.
enum class Validity : std::uint8_t {
  valid,
  large_contact,  ///< a_c ≥ R_min/2: the bodies are no half-spaces over the contact; numbers are the theory's all the
                  ///< same                                                                                  [FO57]
  line_contact,   ///< R_i/R_j was held at largest_radius_ratio; numbers are those of the held ratio
  bad_input,      ///< batches only: a number was NaN, infinite, not positive, or R_i < R_j; every output is zero
};

std::string_view name(Validity validity);

struct Contact {
  double force;          ///< F [N], pushes the bodies apart
  double a_c;            ///< major semi-axis [m], along the direction of R_i
  double b_c;            ///< minor semi-axis [m]
  double peak_pressure;  ///< p_0 = 3F/(2π a_c b_c) [Pa]
  double stiffness;      ///< dF/dδ = 3F/(2δ) [N/m]
  double strain_energy;  ///< ∫F dδ = 2/5 F δ [J]
  Validity validity;
};

/// Normal force at a given overlap.                                                                    [KDY23 (1)]
///   F = 4/3 Ê R_c^{1/2} δ^{3/2} γ
/// @param modulus  Ê > 0 [Pa], see effective_modulus
/// @param overlap  δ [m]; δ ≤ 0 gives 0
double force(const ContactEllipse& ellipse, double modulus, double overlap);

/// Everything about one contact; δ ≤ 0 gives zeros.
/// @param smallest_radius  R_min > 0 [m]: the smallest principal radius of curvature of the two *bodies* at the
/// contact,
///        min over both of 1/k_max. It is the size of the body that has to act as a half-space; the relative radius R_j
///        would be half of it for equal spheres and would call sound contacts invalid.
/// Throws InputError unless modulus > 0 and finite, overlap finite, smallest_radius > 0.
Contact contact(const ContactEllipse& ellipse, double modulus, double overlap, double smallest_radius);

/// Many contacts, structure of arrays; all spans of one length. Units as above.
struct BatchInput {
  std::span<const double> R_i;  ///< ∞ is a line contact
  std::span<const double> R_j;
  std::span<const double> smallest_radius;
  std::span<const double> modulus;
  std::span<const double> overlap;
};
struct BatchOutput {
  std::span<double> force;
  std::span<double> a_c;
  std::span<double> b_c;
  std::span<double> peak_pressure;
  std::span<double> stiffness;
  std::span<double> strain_energy;
  std::span<Validity> validity;
};

/// From radii to forces, the exact ellipse included. A contact's answer does not depend on its neighbours. Bad numbers
/// are said in `validity`; throws InputError only when the spans' lengths differ.
void contacts(const BatchInput& input, const BatchOutput& output);

}  // namespace osculate::hertz
