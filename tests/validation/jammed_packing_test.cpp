#include "validation/packing/jammed_packing.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "osculate/core/error.hpp"
#include "validation/packing/published_packings.hpp"

using namespace osculate;
using namespace osculate::validation;

TEST_CASE("A few dozen spheres jam near the density of random close packing, with about six contacts each") {
  const PackingRecipe recipe{.shape = Sphere{3.0}, .particles = 64, .seed = 1};
  double last = 0.0;
  const JammedPacking packing = jam(recipe, [&](double part) {
    CHECK(part >= last);
    last = part;
  });
  // So few spread by some hundredths from sample to sample; loose heaps (0.55) and crystals (0.74) stay outside.
  CHECK(packing.fraction > 0.58);
  CHECK(packing.fraction < 0.68);
  CHECK(packing.coordination > 5.5);
  CHECK(packing.coordination < 7.0);
  CHECK(packing.rattlers < 0.15);
  CHECK(packing.pressure >= 0.5e-5);
  // Overlaps of a thousandth of a radius hardly count; the lattice of 64³ points is as fine.
  CHECK(packing.fraction_by_points == Approx(packing.fraction).margin(5e-3));

  SECTION("the same again from the same seed, another one from another seed") {
    PackingRecipe again = recipe;
    CHECK(jam(again).fraction == packing.fraction);
    again.seed = 2;
    CHECK(jam(again).fraction != packing.fraction);
  }
}

TEST_CASE("Flat spheroids jam denser than spheres and need more contacts") {
  const auto jammed = [](const Shape& shape) { return jam({.shape = shape, .particles = 64, .seed = 3}); };
  const JammedPacking spheres = jammed(Sphere{1.0}), spheroids = jammed(Ellipsoid{{2.0, 2.0, 1.0}});
  CHECK(spheroids.fraction > spheres.fraction + 0.02);
  CHECK(spheroids.coordination > spheres.coordination + 1.5);
}

TEST_CASE("Means of packings come with their standard error, and need two at least") {
  const Mean mean = mean_of({1.0, 2.0, 6.0});
  CHECK(mean.value == Approx(3.0));
  CHECK(mean.error == Approx(1.5275252316519468));  // (7/3)^{1/2}
  CHECK_THROWS_AS(mean_of({1.0}), InputError);
}

TEST_CASE("A packing outside the published range by more than two standard errors differs") {
  PackingRow row{
      .published = published_packings().front(), .packings = {}, .fraction = {}, .coordination = {}, .rattlers = {}};
  row.coordination = {.value = 6.2, .error = 0.0};
  row.fraction = {.value = 0.64, .error = 0.0};
  CHECK(row.agrees());
  row.fraction = {.value = 0.62, .error = 0.004};
  CHECK_FALSE(row.agrees());
  row.fraction.error = 0.006;
  CHECK(row.agrees());
  row.coordination.value = 4.0;
  CHECK_FALSE(row.agrees());
}
