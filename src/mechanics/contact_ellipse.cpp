#include "osculate/mechanics/contact_ellipse.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "mechanics/contact_ellipse-inl.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"

namespace osculate {
namespace {

void require_radii(const char* where, double R_i, double R_j) {
  if (R_j > 0.0 && R_j <= std::numeric_limits<double>::max() && R_i >= R_j) return;
  throw InputError(where, "R_i = " + std::to_string(R_i) + ", R_j = " + std::to_string(R_j),
                   "R_i >= R_j > 0 with a finite R_j");
}

HWY_NAMESPACE::Ellipse<double> shape_of(const ContactEllipse& ellipse) {
  return {ellipse.R_c, ellipse.axis_ratio, ellipse.e2, ellipse.K, ellipse.E};
}

}  // namespace

double ContactEllipse::gamma() const {
  return HWY_NAMESPACE::gamma(shape_of(*this));
}

double ContactEllipse::beta() const {
  return HWY_NAMESPACE::beta(shape_of(*this));
}

ContactEllipse contact_ellipse(double R_i, double R_j) {
  require_radii("contact_ellipse", R_i, R_j);
  const double R_major = HWY_NAMESPACE::limited(R_i, R_j);
  const auto [R_c, axis_ratio, e2, K, E] = HWY_NAMESPACE::ellipse_of(R_major, R_j);
  return {.R_c = R_c, .axis_ratio = axis_ratio, .e2 = e2, .K = K, .E = E, .ratio_limited = R_major < R_i};
}

ContactEllipse contact_ellipse_approximate(double R_i, double R_j) {
  require_radii("contact_ellipse_approximate", R_i, R_j);
  const double R_major = HWY_NAMESPACE::limited(R_i, R_j);
  const double ratio = R_j / R_major;
  const double elongation =
      1.0 + std::sqrt(0.5 * std::log(16.0 / ratio) / ratio) - std::sqrt(std::log(4.0)) + 0.16 * std::log(ratio);
  const double axis_ratio = std::fmin(1.0 / elongation, 1.0);
  const CompleteElliptic integrals = complete_elliptic(axis_ratio * axis_ratio);
  return {.R_c = R_j / (1.0 + ratio),
          .axis_ratio = axis_ratio,
          .e2 = (1.0 - axis_ratio) * (1.0 + axis_ratio),
          .K = integrals.K,
          .E = integrals.E,
          .ratio_limited = R_major < R_i};
}

}  // namespace osculate
