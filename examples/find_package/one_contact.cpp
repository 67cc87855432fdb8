// Two glass ellipsoids touch: where, how, and with what force.
#include <algorithm>
#include <cstdio>

#include "osculate/geometry/common_normal.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/hertz.hpp"
#include "osculate/mechanics/material.hpp"

using namespace osculate;

int main() {
  const Ellipsoid lower{.half_axes = {5e-3, 3e-3, 2e-3}}, upper{.half_axes = {4e-3, 3e-3, 2.5e-3}};  // [m]
  const Pose below{}, above{.position = {2e-3, 1e-3, 5.2329e-3}, .orientation = {0.8660254037844386, 0.0, 0.5, 0.0}};
  const ElasticMaterial glass{.youngs_modulus = 71e9, .poissons_ratio = 0.22};

  const ContactGeometry found = common_normal(lower, below, upper, above);
  const ContactEllipse ellipse = contact_ellipse(found.relative.R_i, found.relative.R_j);
  const double smallest_radius = 1.0 / std::max(found.curvature_1.max, found.curvature_2.max);
  const hertz::Contact contact =
      hertz::contact(ellipse, effective_modulus(glass, glass), found.overlap, smallest_radius);

  std::printf("%s, overlap %.4g um: %.4g N on an ellipse of %.4g x %.4g um\n", name(found.status).data(),
              found.overlap * 1e6, contact.force, contact.a_c * 1e6, contact.b_c * 1e6);
  return found.status == ContactStatus::touching ? 0 : 1;
}
