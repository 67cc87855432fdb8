#pragma once
// What a simpler picture of a contact costs: the curvature models against the exact one, and the geometric-potential
// contact of other codes against the common normal.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "osculate/geometry/curvature_models.hpp"
#include "osculate/geometry/geometric_potential.hpp"
#include "osculate/shapes/superquadric.hpp"

namespace osculate::validation::curvature_models {

/// The models, in the order in which results hold them.
inline constexpr std::array models{CurvatureModel::exact, CurvatureModel::gaussian, CurvatureModel::mean,
                                   CurvatureModel::volume_equivalent};

/// Two equal superquadrics of half-axes 1 : 1 : aspect and exponents n1 = n2 = n, turned and approaching at random,
/// moved together until they overlap by δ.
struct Sweep {
  std::vector<double> exponents = {2.0, 3.0, 4.0, 6.0};
  std::vector<double> aspects = {1.0, 2.0};
  std::vector<double> overlaps = {1e-3, 1e-2, 5e-2};  ///< δ/R_vol
  int orientations = 200;                             ///< of each
  double cap = review_cap;                            ///< largest radius of curvature, in R_vol; ∞: none
  std::uint64_t seed = 1;
};

/// Both bodies of one contact, lengths in R_vol.
struct ContactCase {
  double exponent;
  double aspect;
  double overlap;  ///< δ/R_vol
  int orientation;
  Superquadric body;  ///< both bodies
  Pose pose_1, pose_2;
  ContactGeometry contact;  ///< the common normal
};

/// Force over Ê R_vol² and area over R_vol² of a contact.
struct Load {
  double force;
  double area;
};

/// What the models are held against. Nothing where it has no answer.
using Reference = std::function<std::optional<Load>(const ContactCase&)>;

/// The elliptical Hertz contact of the exact curvature without a cap.
std::optional<Load> exact_hertz(const ContactCase& contact);

/// How the geometric-potential contact differs from the common normal's.
struct PotentialError {
  ContactStatus status;
  double point;    ///< distance of the contact points, over δ
  double normal;   ///< angle between the normals [rad]
  double overlap;  ///< its overlap over δ, less 1
  double force;    ///< elliptical Hertz from its own overlap and curvatures over the reference, less 1
};

struct CaseErrors {
  ContactCase input;
  bool has_reference;                       ///< without, all errors of forces and areas are meaningless
  std::array<double, models.size()> force;  ///< the model's over the reference's, less 1
  std::array<double, models.size()> area;   ///< the same
  std::array<bool, models.size()> capped;   ///< a radius was replaced by the cap
  PotentialError potential;
};

/// All cases; `progress` is called with the fraction done. Throws InputError for exponents outside (1, 64], aspects
/// outside [0.01, 100], overlaps outside (0, 0.1], fewer than one orientation, a cap that is not positive.
std::vector<CaseErrors> errors(const Sweep& sweep, const Reference& reference,
                               const std::function<void(double)>& progress);

}  // namespace osculate::validation::curvature_models
