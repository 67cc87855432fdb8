#include "validation/halfspace/gap.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "osculate/geometry/superquadric_contacts.hpp"
#include "validation/halfspace/curvature_error.hpp"

using namespace osculate;
using namespace osculate::validation::halfspace;

namespace {

ContactGeometry contact_of(const Superquadric& a, const Pose& at_a, const Superquadric& b, const Pose& at_b) {
  SuperquadricPairs pairs;
  pairs.resize(1);
  pairs.set(0, a, at_a, b, at_b);
  ContactCaches caches;
  ContactColumns contacts;
  common_normals(pairs, caches, contacts);
  return contacts.get(0);
}

}  // namespace

TEST_CASE("The true gap of two spheres is that of two spheres") {
  const Superquadric small{Vec3::Constant(1.0), {}}, large{Vec3::Constant(3.0), {}};
  const Pose here, there{.position = 3.99 * Vec3(0.6, 0.0, 0.8), .orientation = Quat::Identity()};
  const GapField gap = true_gap(small, here, large, there, contact_of(small, here, large, there));
  for (const double r : {0.0, 1e-4, 0.05, 0.7}) {
    const double expected = 1.0 - std::sqrt(1.0 - r * r) + 3.0 - std::sqrt(9.0 - r * r);
    REQUIRE(gap(0.6 * r, -0.8 * r) == Approx(expected).margin(1e-14));
  }
  REQUIRE(std::isinf(gap(1.01, 0.0)));
}

TEST_CASE("Near the contact the true gap is the quadratic one of the relative curvatures") {
  const Superquadric a{Vec3(1.0, 1.2, 0.9), {3.0, 4.0}}, b{Vec3(0.8, 1.0, 1.1), {2.5, 3.5}};
  const Quat turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  const Pose here;
  Pose there{.position = Vec3(1.2, 1.0, 0.8), .orientation = turn};
  const ContactGeometry first = contact_of(a, here, b, there);
  there.position += (first.overlap - 1e-3) * first.normal;
  const ContactGeometry contact = contact_of(a, here, b, there);
  REQUIRE(contact.overlap == Approx(1e-3).epsilon(0.1));
  const GapField gap = true_gap(a, here, b, there, contact),
                 quadratic = quadratic_gap(contact.relative.R_i, contact.relative.R_j);
  for (const auto& [x, y] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {0.7, 0.7}, {0.7, -0.7}}) {
    const double r = 1e-4;
    // Odd terms of the surfaces cancel in the mean of opposite points; the rest is of order r² relative.
    const double mean = 0.5 * (gap(r * x, r * y) + gap(-r * x, -r * y));
    REQUIRE(mean == Approx(quadratic(r * x, r * y)).epsilon(1e-4));
  }
}

TEST_CASE("Two radii are enough on spheres and too few near the flat of a blocky face") {
  const auto errors =
      curvature_errors({.exponents = {2.0, 4.0}, .tilts = {0.1}, .overlaps = {1e-4, 1e-2}, .cells = 48}, [](double) {});
  REQUIRE(errors.size() == 4);
  for (const CurvatureError& error : errors) {
    REQUIRE(error.converged);
    REQUIRE(std::fabs(error.quadratic_error) < 2e-3);  // the solver on 48² cells
  }
  REQUIRE(std::fabs(errors[0].force_error) < 2e-3);
  REQUIRE(std::fabs(errors[1].force_error) < 5e-3);  // a sphere is no paraboloid: a²/R² at 1 %
  REQUIRE(std::fabs(errors[3].force_error) > 0.1);
}
