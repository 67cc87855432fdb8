#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "validation/curvature_models/spread.hpp"

namespace study = osculate::validation::curvature_models;
using osculate::CurvatureModel;
using study::CaseErrors;

namespace {

std::vector<CaseErrors> errors_of(const study::Sweep& sweep) {
  return study::errors(sweep, study::exact_hertz, [](double) {});
}

constexpr double no_cap = std::numeric_limits<double>::infinity();

std::size_t place_of(CurvatureModel model) {
  return static_cast<std::size_t>(std::find(study::models.begin(), study::models.end(), model) - study::models.begin());
}

}  // namespace

TEST_CASE("Random bodies are brought together to the overlap asked for") {
  for (const CaseErrors& error :
       errors_of({.exponents = {1.5, 4.0, 12.0}, .aspects = {0.2, 3.0}, .orientations = 20})) {
    CHECK(error.input.contact.overlap == Approx(error.input.overlap).margin(1e-12));  // of R_vol = 1
    CHECK(error.has_reference);
  }
}

TEST_CASE("For spheres every model of curvature is right and the geometric potential is the common normal") {
  for (const CaseErrors& error : errors_of({.exponents = {2.0}, .aspects = {1.0}, .orientations = 20})) {
    for (std::size_t i = 0; i < study::models.size(); ++i) {
      CHECK(std::fabs(error.force[i]) < 1e-12);
      CHECK(std::fabs(error.area[i]) < 1e-12);
    }
    CHECK(error.potential.point < 1e-9);
    CHECK(error.potential.normal < 1e-9);
    // Its level surfaces through the middle have the radius 1 − δ/2.
    CHECK(error.potential.force == Approx(std::sqrt(1.0 - 0.5 * error.input.overlap) - 1.0).margin(1e-9));
  }
}

TEST_CASE("The mean model errs by root two over gamma, and two over beta in the area: R = 2 R_c for any two bodies") {
  const std::size_t mean = place_of(CurvatureModel::mean);
  for (const CaseErrors& error :
       errors_of({.exponents = {2.0, 3.0, 6.0}, .aspects = {1.0, 2.5}, .orientations = 30, .cap = no_cap})) {
    const auto& relative = error.input.contact.relative;
    const auto ellipse = osculate::contact_ellipse(relative.R_i, relative.R_j);
    CHECK(error.force[mean] == Approx(std::sqrt(2.0) / ellipse.gamma() - 1.0).margin(1e-11));
    CHECK(error.area[mean] == Approx(2.0 / ellipse.beta() - 1.0).margin(1e-11));
  }
}

TEST_CASE("The geometric potential's normal and relative overlap go wrong in proportion to the overlap") {
  const auto groups = study::groups_of(
      errors_of({.exponents = {4.0}, .aspects = {2.0}, .overlaps = {1e-4, 1e-3}, .orientations = 100}));
  REQUIRE(groups.size() == 2);
  CHECK(groups[1].normal.median / groups[0].normal.median == Approx(10.0).epsilon(0.02));
  CHECK(groups[1].overlap_error.median / groups[0].overlap_error.median == Approx(10.0).epsilon(0.02));
  CHECK(groups[0].normal.median > 1e-6);
}

TEST_CASE("A reference is what errors are measured from, and contacts without one are counted") {
  const study::Sweep sweep{.exponents = {3.0}, .aspects = {1.0}, .overlaps = {1e-3}, .orientations = 10};
  const auto half = study::errors(
      sweep,
      [](const study::ContactCase& contact) -> std::optional<study::Load> {
        if (contact.orientation % 2 == 1) return std::nullopt;
        const study::Load exact = *study::exact_hertz(contact);
        return study::Load{.force = 2.0 * exact.force, .area = 4.0 * exact.area};
      },
      [](double) {});
  const auto groups = study::groups_of(half);
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].contacts == 5);
  CHECK(groups[0].unanswered == 5);
  CHECK(groups[0].force[place_of(CurvatureModel::exact)].median == Approx(-0.5).epsilon(1e-12));
  CHECK(groups[0].area[place_of(CurvatureModel::exact)].median == Approx(-0.75).epsilon(1e-12));
}

TEST_CASE("Quantiles are those of the ranked sample") {
  std::vector<double> sample;
  for (int i = 100; i >= 0; --i) sample.push_back(i);
  const study::Spread spread = study::spread_of(sample);
  CHECK(spread.low == Approx(5.0));
  CHECK(spread.median == Approx(50.0));
  CHECK(spread.high == Approx(95.0));
  CHECK(study::spread_of({1.0, 2.0}).median == Approx(1.5));
  CHECK(study::spread_of({}).median == 0.0);
}

TEST_CASE("A sweep without sense is refused") {
  CHECK_THROWS_AS(errors_of({.exponents = {1.0}}), osculate::InputError);
  CHECK_THROWS_AS(errors_of({.exponents = {}}), osculate::InputError);
  CHECK_THROWS_AS(errors_of({.aspects = {0.0}}), osculate::InputError);
  CHECK_THROWS_AS(errors_of({.overlaps = {0.2}}), osculate::InputError);
  CHECK_THROWS_AS(errors_of({.overlaps = {std::nan("")}}), osculate::InputError);
  CHECK_THROWS_AS(errors_of({.orientations = 0}), osculate::InputError);
  CHECK_THROWS_AS(errors_of({.cap = 0.0}), osculate::InputError);
}
