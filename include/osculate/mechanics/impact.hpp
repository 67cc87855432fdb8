#pragma once
// Head-on impact of two bodies: what the normal models of spheres need and what their closed forms give.
// The models serve any contact: through the Hertz coefficient of its ellipse, or the volume-equivalent radii.

#include <string_view>

#include "osculate/mechanics/contact_ellipse.hpp"

namespace osculate {

/// What a damped contact does when its damping outweighs its spring on the way apart.
enum class Attraction {
  allowed,  ///< the force pulls, and the contact ends at zero overlap
  cut_off,  ///< the force is never attractive, and the contact ends where it falls to zero
};

/// How an impact ends. Closed forms of one impact from touch to parting.
struct Impact {
  double duration;         ///< [s]
  double largest_overlap;  ///< δ_max [m]
  double restitution;      ///< ε in [0, 1]: speed apart over speed together
};

/// Two bodies that collide, as the sphere models see them.
struct ImpactPair {
  double mass;     ///< effective mass m = m1 m2/(m1 + m2) > 0 [kg]
  double radius;   ///< effective radius R > 0 [m]: 1/R = 1/R1 + 1/R2 for spheres
  double modulus;  ///< Ê > 0 [Pa], see effective_modulus

  /// k_H = 4/3 Ê R^{1/2} of F = k_H δ^{3/2} [N/m^{3/2}]
  double hertz_coefficient() const;
};

/// Throws InputError unless mass, radius and modulus are positive and finite.
void validate(const ImpactPair& pair);

/// The pair of two spheres; also of two particles by their volume-equivalent radii. A wall has infinite radius and
/// mass. Throws InputError unless radii, masses and modulus are positive and at least one of each pair finite.
ImpactPair sphere_pair(double radius_1, double mass_1, double radius_2, double mass_2, double modulus);

/// The radius of the circular contact with the elliptical contact's force: R = R_c γ²; for spheres their R again.
double effective_radius(const ContactEllipse& ellipse);

}  // namespace osculate

namespace osculate::hertz_impact {

/// T/(m²/(Ê² R v))^{1/5} of an elastic Hertz impact, exactly
///   (4/5) π^{1/2} Γ(2/5)/Γ(9/10) (15/16)^{2/5} = 2.8682656…
/// printed as 2.86 and 2.870 in lecture notes.                                              [Wassgren06; Johnson85
/// §11.4]
double duration_constant();

/// Elastic impact: δ_max = (5 m v²/(4 k_H))^{2/5}, ε = 1.
/// @param speed  v > 0 [m/s]; else throws InputError
Impact impact(const ImpactPair& pair, double speed);

}  // namespace osculate::hertz_impact
