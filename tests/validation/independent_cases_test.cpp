#include "validation/independent_cases.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

using osculate::validation::Case;
using osculate::validation::Done;
using osculate::validation::run_independent;

TEST_CASE("Every case runs once and progress ends at the whole") {
  std::vector<int> runs(37, 0);
  std::vector<Case> cases;
  for (int& count : runs)
    cases.push_back([&count](const Done& done) {
      done(0.5);
      ++count;
    });
  double last = 0.0;
  run_independent(cases, 3, [&](double part) {
    CHECK(part >= last);
    last = part;
  });
  CHECK(runs == std::vector<int>(37, 1));
  CHECK(last == Approx(1.0));
  run_independent({}, 2, {});
}

TEST_CASE("The error of a case comes out when all have ended") {
  std::vector<Case> cases{[](const Done&) {}, [](const Done&) { throw std::runtime_error("no room"); },
                          [](const Done&) {}};
  CHECK_THROWS_WITH(run_independent(cases, 2, {}), "no room");
}
