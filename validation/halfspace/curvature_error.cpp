#include "validation/halfspace/curvature_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"
#include "osculate/mechanics/hertz.hpp"
#include "osculate/shapes/surface.hpp"
#include "validation/halfspace/gap.hpp"
#include "validation/halfspace/solver.hpp"

namespace osculate::validation::halfspace {
namespace {

ContactGeometry contact_of(const Superquadric& body, const Pose& here, const Pose& there) {
  SuperquadricPairs pairs;
  pairs.resize(1);
  pairs.set(0, body, here, body, there);
  ContactCaches caches;
  ContactColumns contacts;
  common_normals(pairs, caches, contacts);
  return contacts.get(0);
}

CurvatureError compare(const CurvatureCase& input, int cells) {
  const Superquadric body{Vec3::Ones(), {input.exponent, input.exponent}};
  validate(body);
  const double size = volume_equivalent_radius(mass_properties(body).volume), overlap = input.overlap * size;
  // Off the face's own symmetry planes.
  constexpr double azimuth = 0.6;
  const Vec3 normal(std::cos(input.tilt), std::sin(input.tilt) * std::cos(azimuth),
                    std::sin(input.tilt) * std::sin(azimuth));
  const Pose here,
      there{.position = 2.0 * support_point(body, normal) - overlap * normal, .orientation = Quat::Identity()};
  const ContactGeometry contact = contact_of(body, here, there);
  const double R_i = contact.relative.R_i, R_j = contact.relative.R_j;
  if (!is_resolved(contact.status) || !std::isfinite(R_i))
    throw InputError("study halfspace",
                     "a contact that is " + std::string(name(contact.status)) +
                         " (n = " + std::to_string(input.exponent) + ", tilt " + std::to_string(input.tilt) + " rad)",
                     "a contact with curvature; lean further from the face");
  constexpr double modulus = 1.0;
  const double smallest = 1.0 / std::max(contact.curvature_1.max, contact.curvature_2.max);
  const hertz::Contact elastic = hertz::contact(contact_ellipse(R_i, R_j), modulus, contact.overlap, smallest);
  const auto solved = [&](const GapField& gap) {
    const Grid grid = grid_around(gap, contact.overlap, elastic.b_c, cells);
    return solve(grid, sampled(gap, grid), modulus, contact.overlap);
  };
  const Solution full = solved(true_gap(body, here, body, there, contact));
  const Solution quadratic = solved(quadratic_gap(R_i, R_j));
  return {.input = input,
          .R_i = R_i / size,
          .R_j = R_j / size,
          .force = full.force / (modulus * size * size),
          .area = full.area / (size * size),
          .force_error = elastic.force / full.force - 1.0,
          .area_error = std::numbers::pi * elastic.a_c * elastic.b_c / full.area - 1.0,
          .peak_error = elastic.peak_pressure / full.peak_pressure - 1.0,
          .quadratic_error = elastic.force / quadratic.force - 1.0,
          .contact_size = elastic.a_c / size,
          .converged = full.converged && quadratic.converged};
}

}  // namespace

std::vector<CurvatureError> curvature_errors(const CurvatureStudy& study, const std::function<void(double)>& progress) {
  const auto require = [](const std::vector<double>& values, double above, double most, const char* what,
                          const char* expected) {
    for (const double value : values)
      if (!(value > above && value <= most))
        throw InputError("study halfspace", std::string(what) + " " + std::to_string(value), expected);
  };
  require(study.exponents, 1.0, 64.0, "exponent", "a value in (1, 64]");
  require(study.tilts, 0.0, 45.0, "tilt", "an angle in (0, 45] degrees");
  require(study.overlaps, 0.0, 0.1, "overlap", "a value in (0, 0.1] R_vol");
  if (study.cells < 16 || study.cells > 1024)
    throw InputError("study halfspace", std::to_string(study.cells) + " cells", "16 to 1024");

  std::vector<CurvatureError> errors;
  const double count = static_cast<double>(study.exponents.size() * study.tilts.size() * study.overlaps.size());
  for (const double exponent : study.exponents)
    for (const double tilt : study.tilts)
      for (const double overlap : study.overlaps) {
        errors.push_back(compare({exponent, tilt * std::numbers::pi / 180.0, overlap}, study.cells));
        progress(static_cast<double>(errors.size()) / count);
      }
  return errors;
}

}  // namespace osculate::validation::halfspace
