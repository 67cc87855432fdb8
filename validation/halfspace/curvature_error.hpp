#pragma once
// Where two radii of curvature stop being enough: the elliptical Hertz force of blocky superquadrics against the
// half-space solution of their true gap.

#include <functional>
#include <vector>

namespace osculate::validation::halfspace {

/// Two equal superquadrics of half-axes (1, 1, 1) and exponents n1 = n2 = n, one the other's point reflection. They
/// meet where the normal of both leans by `tilt` from the axis of a face, which for n > 2 has no curvature in its
/// middle.
struct CurvatureCase {
  double exponent;  ///< n
  double tilt;      ///< [rad]
  double overlap;   ///< δ/R_vol
};

struct CurvatureError {
  CurvatureCase input;
  double R_i, R_j;         ///< of relative curvature, over R_vol
  double force, area;      ///< of the half-space solution, over Ê R_vol² and R_vol²
  double force_error;      ///< Hertz over it, less 1
  double area_error;       ///< the same of the contact area, which the solver counts in cells
  double peak_error;       ///< the same of the peak pressure
  double quadratic_error;  ///< the solver's own: Hertz over the solution of the quadratic gap on as many cells, less 1
  double contact_size;     ///< a_c of Hertz over R_vol: half-space theory wants it small
  bool converged;
};

struct CurvatureStudy {
  std::vector<double> exponents = {2.0, 2.5, 3.0, 4.0, 6.0, 8.0};
  std::vector<double> tilts = {0.1, 1.0, 3.0, 10.0, 30.0};  ///< [degrees]
  std::vector<double> overlaps = {1e-4, 1e-3, 1e-2};        ///< / R_vol
  int cells = 64;                                           ///< each way
};

/// Every exponent with every tilt and overlap; `progress` is called with the fraction done. Throws InputError for
/// numbers that make no sense: exponents outside (1, 64], tilts outside (0, 45] degrees, overlaps outside (0, 0.1],
/// cells outside [16, 1024].
std::vector<CurvatureError> curvature_errors(const CurvatureStudy& study, const std::function<void(double)>& progress);

}  // namespace osculate::validation::halfspace
