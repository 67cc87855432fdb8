#pragma once
// Kalker's linear theory of rolling: forces and spin moment of a contact that rolls steadily without slip.   [Kalker90]
// Frame of the contact: x along the rolling (the way the contact patch moves over the bodies), z = the normal from body
// 1 to body 2, y = z × x. Forces and moment are those on body 1; body 2 feels the opposite.

#include <array>

#include "osculate/core/types.hpp"
#include "osculate/mechanics/material.hpp"

namespace osculate::kalker {

/// Creepage coefficients; C32 = −C23.
struct Coefficients {
  double c11;          ///< longitudinal
  double c22;          ///< lateral
  double c23;          ///< lateral by spin, and moment by lateral
  double c33;          ///< moment by spin
  bool outside_table;  ///< the semi-axes' ratio was outside [0.1, 10]
};

/// Kalker's table at one Poisson's ratio, made once per pair of materials.
struct Table {
  static constexpr int nodes = 19;
  std::array<std::array<double, nodes>, 4> logarithm;  ///< ln C11, ln C22, ln C23, ln C33 at the table's ratios
  std::array<std::array<double, nodes>, 4> curvature;  ///< second derivatives of the splines by ln(a/b)
};

/// The published table (ν = 0, 1/4, 1/2; a/b = 0.1 … 10, three digits), interpolated in ν by the parabola through its
/// three columns. Throws InputError unless 0 ≤ ν ≤ 0.5.
Table table(double poissons_ratio);

/// The coefficients at a ratio a/b of the semi-axes *along over across* the rolling, by natural cubic splines of ln C
/// in ln(a/b): smooth, through every entry. Beyond [0.1, 10] the end tangents are continued and `outside_table` is set.
/// @pre a_over_b > 0
Coefficients coefficients(const Table& table, double a_over_b);

/// The ratio of semi-axes when the rolling direction makes `angle` with the major axis [rad]: that of the ellipse's
/// radii along and across. Exact on the axes; between them the theory has no table, and this is an interpolation.
double axes_along_rolling(double axis_ratio, double angle);

/// Kalker's composite of two materials: 1/G = (1/G1 + 1/G2)/2, ν/G = (ν1/G1 + ν2/G2)/2. Not Ĝ of the tangential laws.
struct Composite {
  double shear_modulus;  ///< [Pa]
  double poissons_ratio;
};
Composite composite(const ElasticMaterial& material_1, const ElasticMaterial& material_2);

/// How the surfaces creep: their relative velocity over the rolling velocity V.
struct Creepage {
  double longitudinal;  ///< ξ_x = (v_1 − v_2)·x/V                                                        [KDY23 (89)]
  double lateral;  ///< ξ_y = (v_1 − v_2)·y/V; the review prints ξ_x a second time                   [KDY23 (90)]
  double spin;     ///< ξ_sp = (ω_1 − ω_2)·z/V [1/m]                                                 [KDY23 (91)]
};

/// A body at the contact.
struct Motion {
  Vec3 velocity;          ///< of its material point at the contact, V + ω × r [m/s], world
  Vec3 angular_velocity;  ///< [rad/s], world
  Mat3 shape_operator;    ///< k_max d_1 d_1ᵀ + k_min d_2 d_2ᵀ [1/m], convex positive, world: how its normal turns
};

/// The rolling contact's frame and creepage.
struct Rolling {
  bool rolls;  ///< false when the patch stands still on the bodies (V = 0): no creepage is defined, all else is zero
  double velocity;  ///< V [m/s]
  Vec3 direction;   ///< x, world
  Vec3 lateral;     ///< y, world
  Creepage creepage;
};

/// From the bodies' motion. The patch moves over the bodies so that their normals stay opposite:
///   (S_1 + S_2) s = n × (ω_1 − ω_2) + (S_1 − S_2)(v_1 − v_2)/2  in the tangent plane,
/// s the patch's velocity against the mean of the two surfaces', V = |s|. Surfaces without relative curvature do not
/// roll.
Rolling rolling(const Vec3& normal, const Motion& body_1, const Motion& body_2);

/// What rolling does to body 1.
struct Force {
  double longitudinal;  ///< along x [N]
  double lateral;       ///< along y [N]
  double moment;        ///< about z [N m]
};

/// The linear theory, c = √(a_c b_c), valid while the forces are far below μF_n:
///   F_x = −c² G C11 ξ_x                                                                                   [KDY23 (86)]
///   F_y = −c² G C22 ξ_y − c³ G C23 ξ_sp                                                                   [KDY23 (87)]
///   M_z = +c³ G C23 ξ_y − c⁴ G C33 ξ_sp                                                                   [KDY23 (88)]
/// The review prints c with doubled powers.
Force linear_force(const Coefficients& coefficients, double shear_modulus, double a_c, double b_c,
                   const Creepage& creepage);

/// What friction can give: μF_n in the plane [N], and about the normal the moment of spinning in place [N m], both ≥ 0.
struct Limit {
  double force;
  double moment;
};

/// A force that asks for more than friction gives is scaled, moment and all, onto the surface of sliding,
/// (|F|/F_max)² + (M/M_max)² = 1 [HC96]: it still takes energy from the motion. One within is left as it is.
Force limited(const Force& force, const Limit& limit);

/// Sliding without rolling: the force on that surface which takes most from the slip v_1 − v_2 and the spin
/// (ω_1 − ω_2)·z, zero when both are.
Force sliding(double longitudinal_slip, double lateral_slip, double spin, const Limit& limit);

}  // namespace osculate::kalker
