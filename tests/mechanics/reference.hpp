#pragma once
// The reference values of tests/data/contact_mechanics.json.

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

/// All rows of one family.
inline nlohmann::json reference_rows(const std::string& family) {
  std::ifstream file(std::string(OSCULATE_TEST_DATA) + "/contact_mechanics.json");
  return nlohmann::json::parse(file).at(family);
}
