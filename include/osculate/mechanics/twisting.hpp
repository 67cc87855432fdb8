#pragma once
// Twisting: two bodies in elliptical Hertz contact rotate against each other about their common normal.

#include <span>

#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/material.hpp"

namespace osculate::twisting {

/// Torsional compliance without slip, angle by moment, both bodies [rad/(N m)]:               [KDY23 (77); Mindlin49]
///   Σ over both bodies of 3/(2π G a_c³) · (B D − ν E C)/(E − 4 ν (b_c/a_c)² C)
/// Circular, equal bodies: 3/(8 G a_c³). G is the shear modulus and the length is a_c, both misprinted in the review.
/// Throws InputError unless a_c > 0 and −1 < ν < 0.5 (the incompressible limit is refused).
double compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material_1,
                  const ElasticMaterial& material_2);

/// The moment at which the whole contact spins about its centre, friction everywhere across the radius [N m]:
///   ∫ μ p r dA = 3/8 μ F_n a_c E(e²) for the Hertz pressure; circular: 3π/16 μ F_n a_c             [Johnson85 §3.9]
/// Throws InputError unless μ ≥ 0, a_c ≥ 0, F_n ≥ 0.
double limit(const ContactEllipse& ellipse, double a_c, double friction, double normal_force);

/// The contact at this instant.
struct Contact {
  double stiffness;  ///< 1/compliance [N m/rad]; 0 when open
  double limit;      ///< [N m]; 0 when open
};

/// Throws as `compliance` and `limit`.
Contact contact(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material_1,
                const ElasticMaterial& material_2, double friction, double normal_force);

/// Many contacts of one pair of materials, each zero or more long.
struct BatchInput {
  std::span<const double> a_c;         ///< ≥ 0, finite [m]
  std::span<const double> axis_ratio;  ///< b_c/a_c in (0, 1]
};
struct BatchOutput {
  std::span<double> stiffness;  ///< 1/compliance [N m/rad]
  std::span<double> arm;        ///< `limit` over μF_n [m]
};
/// Throws InputError unless −1 < ν < 0.5 and all columns are of one length.
void contacts(const ElasticMaterial& material_1, const ElasticMaterial& material_2, const BatchInput& input,
              const BatchOutput& output);

/// What a contact remembers. A zero-initialised one is a contact not yet made. Trivially copyable.
struct Memory {
  double moment;     ///< at the last step [N m]
  double stiffness;  ///< at the last step [N m/rad]
};

/// One step: body 2 turns by `twist` against body 1 about the normal [rad]. Returns the moment on body 1 along that
/// turn [N m]; body 2 feels the opposite. Elastic with the no-slip stiffness up to the limit, then sliding; the annulus
/// of slip that grows before the whole contact spins (Lubkin 1951) is not resolved.
/// A contact that grows keeps its moment, the new rim being unstrained; one that shrinks loses the share of the lost
/// stiffness. Thus energy is never created, nor does the moment exceed the limit.
double advance(Memory& memory, const Contact& contact, double twist);

}  // namespace osculate::twisting
