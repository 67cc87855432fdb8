#include "osculate/geometry/curvature_models.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace osculate;

namespace {

const Vec3 up = Vec3::UnitZ();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr CurvatureModel simplified[] = {CurvatureModel::gaussian, CurvatureModel::mean,
                                         CurvatureModel::volume_equivalent};

ContactBody body(double max, double min, double volume_radius) {
  return {.curvature = {.max = max, .min = min, .max_direction = Vec3::UnitX()}, .volume_radius = volume_radius};
}

/// γ √R_c of a circular contact, γ = √2: what the force is proportional to.
double circular_factor(const RelativeCurvature& r) {
  return std::sqrt(2.0) * std::sqrt(r.R_i * r.R_j / (r.R_i + r.R_j));
}

}  // namespace

TEST_CASE("All curvature models agree for spheres") {
  const ContactBody one = body(2.0, 2.0, 0.5), two = body(0.5, 0.5, 2.0);
  const double R = 1.0 / 2.5;
  for (const CurvatureModel model :
       {CurvatureModel::exact, CurvatureModel::gaussian, CurvatureModel::mean, CurvatureModel::volume_equivalent}) {
    CAPTURE(name(model));
    const RelativeCurvature relative = relative_curvature(model, up, one, two);
    CHECK(relative.R_i == Approx(R).epsilon(1e-14));
    CHECK(relative.R_j == Approx(R).epsilon(1e-14));
    CHECK(circular_factor(relative) == Approx(std::sqrt(R)).epsilon(1e-14));
  }
}

TEST_CASE("Two flat faces at the cap of 10 R_vol give the review's simplified value √5") {
  const ContactBody face = body(3.0, 0.0, 1.0);  // flat one way: the Gaussian curvature is zero
  const RelativeCurvature relative = relative_curvature(CurvatureModel::gaussian, up, face, face);
  CHECK(relative.capped);
  CHECK(circular_factor(relative) == Approx(2.2361).epsilon(2e-5));  // printed to 5 digits
}

TEST_CASE("Gaussian and mean models take the geometric and arithmetic mean of the curvatures") {
  const ContactBody wall = body(0.0, 0.0, infinity), particle = body(8.0, 2.0, 1.0);
  CHECK(relative_curvature(CurvatureModel::gaussian, up, particle, wall).R_i == Approx(1.0 / 4.0));
  CHECK(relative_curvature(CurvatureModel::mean, up, particle, wall).R_i == Approx(1.0 / 5.0));
  CHECK(relative_curvature(CurvatureModel::volume_equivalent, up, particle, wall).R_i == Approx(1.0));
  CHECK_FALSE(relative_curvature(CurvatureModel::gaussian, up, particle, wall).capped);
}

TEST_CASE("A hollow wall relieves every model") {
  const ContactBody bowl = body(-0.5, -0.5, infinity), ball = body(2.0, 2.0, 0.5);
  for (const CurvatureModel model : simplified) {
    CHECK(relative_curvature(model, up, ball, bowl).R_i == Approx(1.0 / 1.5).epsilon(1e-14));
  }
  const ContactBody too_large = body(0.25, 0.25, 4.0);
  for (const CurvatureModel model : simplified) {
    CHECK(std::isinf(relative_curvature(model, up, too_large, bowl).R_i));
  }
}

TEST_CASE("The exact model caps at ten times the smaller R_vol, or not at all on demand") {
  const ContactBody face = body(0.0, 0.0, 1.0), larger = body(0.0, 0.0, 3.0);
  const RelativeCurvature capped = relative_curvature(CurvatureModel::exact, up, larger, face);
  CHECK(capped.R_i == 10.0);
  CHECK(capped.R_j == 10.0);
  CHECK(capped.capped);
  CHECK(std::isinf(relative_curvature(CurvatureModel::exact, up, larger, face, infinity).R_i));
  CHECK(std::isinf(relative_curvature(CurvatureModel::gaussian, up, larger, face, infinity).R_i));
}
