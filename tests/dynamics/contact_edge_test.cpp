#include "dynamics/contact_edge.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace osculate;

TEST_CASE("The Hurwitz zeta function of negative integers is a Bernoulli polynomial") {
  for (const double x : {1e-3, 0.2, 0.5, 0.77, 1.0}) {
    CHECK(hurwitz_zeta_of_negative(1.0, x) == Approx(-(x * x - x + 1.0 / 6.0) / 2.0).margin(1e-12));
    CHECK(hurwitz_zeta_of_negative(2.0, x) == Approx(-(x * x * x - 1.5 * x * x + 0.5 * x) / 3.0).margin(1e-12));
  }
  // ζ(−3/2, 1) = ζ(−3/2).                                                                        [AS64 23.2]
  CHECK(hurwitz_zeta_of_negative(1.5, 1.0) == Approx(-0.025485201889833036).margin(1e-12));
}

TEST_CASE("With the edge's force the samples of a Hertz force add up to its integral") {
  constexpr double k = 3e9, deepest = 1e-6;
  for (const double theta : {0.01, 0.3, 0.7, 0.99}) {
    double plain[2], corrected[2];
    for (int refinement = 0; refinement < 2; ++refinement) {
      // The last sample is the deepest overlap, with half the weight of the others.
      const int samples = 30 << refinement;
      const double way = deepest / (samples + theta);
      double sum = 0.0;
      for (int i = 0; i <= samples; ++i) sum += (i == samples ? 0.5 : 1.0) * k * std::pow((i + theta) * way, 1.5) * way;
      // The smooth end: −h²/12 f′.
      sum -= way * way / 12.0 * 1.5 * k * std::sqrt(deepest);
      const double exact = 0.4 * k * std::pow(deepest, 2.5), first = theta * way;
      const double stored = 0.4 * k * std::pow(first, 2.5), stiffness = 1.5 * k * std::sqrt(first);
      plain[refinement] = std::fabs(sum / exact - 1.0);
      corrected[refinement] = std::fabs((sum + way * edge_force(first, way, stored, stiffness)) / exact - 1.0);
    }
    CHECK(corrected[0] < 1e-3 * plain[0]);
    CHECK(corrected[1] < corrected[0] / 8.0);
  }
}

TEST_CASE("Away from the edge nothing is added") {
  CHECK(edge_force(2e-7, 1e-7, 1e-9, 1e5) == 0.0);
  CHECK(edge_force(-1e-9, 1e-7, 0.0, 0.0) == 0.0);
}
