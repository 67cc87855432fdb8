#pragma once
// Analytic principal curvatures against a witness that knows nothing of gauges or Hessians: CGAL's Monge form, a
// polynomial fitted to points of the surface [CP05]. GPL: see CMakeLists.txt.

#include <optional>
#include <string>
#include <vector>

namespace osculate::validation {

/// One fit.
struct JetFit {
  std::string shape, place;
  double radius;                ///< h, of the fitted neighbourhood, in R_vol
  double error_max, error_min;  ///< |k_fitted − k| of k_max and k_min, over the greater of k_max and 1/R_vol
  std::optional<double> order;  ///< log2 of the larger error at 2h over that at h; none for the first h
};

/// The fitted polynomial is of degree 4: its second derivatives are off by h³ in general, by h⁴ on symmetric samples.
constexpr int jet_degree = 4;
constexpr double guaranteed_order = jet_degree - 1.0;

/// Superquadrics with n = 2.5, 4 and 6 and a potential cube, on a face, an edge and a corner of each, at shrinking h.
std::vector<JetFit> jet_fits();

}  // namespace osculate::validation
