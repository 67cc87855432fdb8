#pragma once
// The reference values of tests/data/contact_mechanics.json.

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"

/// All rows of one family.
inline nlohmann::json reference_rows(const std::string& family) {
  std::ifstream file(std::string(OSCULATE_TEST_DATA) + "/contact_mechanics.json");
  return nlohmann::json::parse(file).at(family);
}

/// The ellipse of a given e², which the reference gives where no radii are needed.
inline osculate::ContactEllipse ellipse_of(double e2) {
  const auto integrals = osculate::complete_elliptic(1.0 - e2);
  return {.R_c = 1.0,
          .axis_ratio = std::sqrt(1.0 - e2),
          .e2 = e2,
          .K = integrals.K,
          .E = integrals.E,
          .ratio_limited = false};
}
