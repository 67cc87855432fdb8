#pragma once
// Rough contact with elliptical asperities that yield: elastic, elastic-plastic and plastic.      [JW03]
// One asperity first, then a patch of them at a prescribed separation, then the patch's Taylor series.

#include <array>
#include <string_view>

#include "osculate/mechanics/contact_ellipse.hpp"

namespace osculate::jeng_wang {

/// R_i/R_j of the asperity whose contact ellipse has eccentricity e: B/((1 − e²) D), which is the review's quotient of
/// elliptic integrals without its 0/0: 1 as e → 0, to full precision.                                 [KDY23 (49)]
/// @param e in [0, 1); InputError outside
double radius_ratio(double e);

/// Elliptical summits of one shape, Gaussian in height, and what they are made of.
struct Surface {
  double density;               ///< χ > 0, asperities per area [1/m²]
  double R_i;                   ///< larger summit radius [m]
  double R_j;                   ///< smaller summit radius [m]
  double deviation;             ///< σ > 0, standard deviation of the summits' heights [m]
  double modulus;               ///< Ê > 0 [Pa]
  double hardness;              ///< H > 0 of the softer body [Pa]
  double yield_ratio = 0.4;     ///< k in (0, 1): mean pressure at first yield over H                        [ZMC00]
  double plastic_ratio = 54.0;  ///< δ_n2/δ_n1 > 1: full over first plasticity                                [ZMC00]
};
/// Throws InputError unless every number lies in its range and is finite, R_i ≥ R_j.
void validate(const Surface& surface);

/// How an asperity deforms.
enum class Deformation { elastic, elastic_plastic, plastic };
std::string_view name(Deformation deformation);

/// One asperity, its constants found once.
struct Asperity {
  double force_factor;    ///< elastic F = force_factor w^{3/2}: 4/3 Ê R_c^{1/2} γ [N/m^{3/2}]
  double area_factor;     ///< elastic A = area_factor w: π β R_c [m]
  double plastic_factor;  ///< plastic A = plastic_factor w: 2π (R_i R_j)^{1/2} [m], the summit cut off at depth w
  double hardness;        ///< [Pa]
  double yield_ratio;     ///< k
  double first_yield;     ///< δ_n1 [m]
  double full_plastic;    ///< δ_n2 [m]
};
/// First yield where the mean elastic pressure is kH: δ_n1 = (kH area_factor/force_factor)².          [KDY23 (50)]
/// Full plasticity at δ_n2 = plastic_ratio δ_n1.                                                      [KDY23 (52)]
/// Throws InputError on a bad surface.
Asperity asperity(const Surface& surface);

/// State of one asperity pressed by w [m]; w ≤ 0 gives zeros.
struct Load {
  double force;  ///< [N]
  double area;   ///< [m²]
  Deformation deformation;
};
/// The asperity law. Elastic (Hertz) to δ_n1; plastic, F = H A, from δ_n2; between them the area joins the two with
/// equal slopes, A = A_e + (A_p − A_e)(3s² − 2s³), s = (w − δ_n1)/(δ_n2 − δ_n1), and the mean pressure is
/// H [1 − (1 − k)(ln δ_n2 − ln w)/(ln δ_n2 − ln δ_n1)]: force and area are continuous.           [ZMC00; KDY23 (51)]
Load load(const Asperity& asperity, double compression);

/// A patch of asperities at a prescribed separation.
struct Patch {
  double force;                           ///< F [N]
  double area;                            ///< true contact [m²]
  std::array<double, 3> force_by_regime;  ///< of elastic, elastic-plastic, plastic asperities [N]
  std::array<double, 3> area_by_regime;   ///< [m²]
};
/// Force: χ A ∫ F(σ(z − h)) φ dz over h < z < h + δ_n1*, h + δ_n1* < z < h + δ_n2*, z > h + δ_n2*, with δ* = δ/σ: each
/// regime between its own limits, where the review's mix. Adaptive quadrature, relative error below 1e-10.
///                                                                                                    [KDY23 (47)]
/// Area: the same with A(w); the last integral starts at h + δ_n2*.                                   [KDY23 (48)]
/// InputError on a bad surface, nominal area < 0, h not finite.
Patch patch_at(const Surface& surface, double nominal_area, double h);

/// Force and area of a patch as Taylor series in h about a centre: a fast stand-in where h moves little. The
/// coefficients are exact, ∫ F(σw)(−1)^n He_n(w + h_0) φ(w + h_0) dw/n!.                              [KDY23 (53)]
class TaylorSeries {
 public:
  static constexpr int order = 8;

  /// Same conditions as patch_at.
  TaylorSeries(const Surface& surface, double nominal_area, double centre);

  double force(double h) const;
  double area(double h) const;
  /// Size of the last term of the force's series over its sum: what the answer at h may be wrong by.
  double last_term(double h) const;

 private:
  double centre_;
  std::array<double, order + 1> force_{}, area_{};
};

}  // namespace osculate::jeng_wang
