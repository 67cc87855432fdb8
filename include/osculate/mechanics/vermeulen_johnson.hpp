#pragma once
// Vermeulen & Johnson: rolling with partial slip, from small creepage to sliding.                             [VJ64]
// Frame and signs as in kalker.hpp.

#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/kalker.hpp"

namespace osculate::vermeulen_johnson {

/// The semi-axis along which the contact rolls.
enum class RollingAxis { major, minor };

/// Creepage coefficients of Vermeulen & Johnson's own, elliptical area of stick that touches the leading edge:
/// rolling along the major axis  C11 = π(a/b)/(D − ν(D−C)),  C22 = π(a/b)/(D − νC),
/// along the minor axis          C11 = π/((1−ν)B + ν m1 C),  C22 = π/(B − ν m1 C),   m1 = (b_c/a_c)², a ≥ b the axes.
/// Circular: 16/(4−3ν) and 16/(4−ν), about a fifth above Kalker's exact ones. No spin: c23 = c33 = 0.
kalker::Coefficients coefficients(const ContactEllipse& ellipse, double poissons_ratio, RollingAxis axis);

/// What the law needs of a contact.
struct Contact {
  kalker::Coefficients coefficients;  ///< Kalker's, so that small creepage is the linear theory, or one's own above
  double shear_modulus;               ///< Kalker's composite G [Pa]
  double a_c;                         ///< semi-axes [m]
  double b_c;
  double limit;  ///< μF_n [N]
};

/// Throws InputError unless G, a_c, b_c and the coefficients c11, c22 are > 0 and μF_n ≥ 0, all finite.
Contact contact(const kalker::Coefficients& coefficients, double shear_modulus, double a_c, double b_c, double friction,
                double normal_force);

/// The creepage that a force (F_x, F_y) on body 1 needs, |F| ≤ μF_n, no spin:                              [KDY23 (92)]
///   ξ_i = −3 μF_n/(c² G C_ii) [1 − (1 − |F|/(μF_n))^{1/3}] F_i/|F|
kalker::Creepage creepage(const Contact& contact, double longitudinal, double lateral);

/// The force of a creepage, inverted in closed form:                                                       [KDY23 (93)]
///   |F| = μF_n [1 − (1 − τ)³], τ = |F_linear|/(3μF_n), and μF_n for τ ≥ 1, in the direction of the linear force.
/// Spin enters through the linear lateral force [SHE83], and the linear moment is reduced as the force is.
kalker::Force force(const Contact& contact, const kalker::Creepage& creepage);

}  // namespace osculate::vermeulen_johnson
