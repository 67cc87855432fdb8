#pragma once
// The 630 reference contacts of tests/data, read the simplest way.

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "validation/narrow_phase/random_pairs.hpp"

namespace osculate::test {

struct ReferenceContact {
  validation::Pair pair;  // its label is the class
  Vec3 normal;
  double depth;
  double gap_to_next;
};

inline std::vector<ReferenceContact> reference_contacts() {
  std::ifstream file(OSCULATE_TEST_DATA "/superquadric_common_normal.csv");
  std::string line, name, field;
  std::getline(file, line);
  std::vector<ReferenceContact> contacts;
  while (std::getline(file, line)) {
    std::stringstream fields(line);
    std::getline(fields, name, ',');
    std::vector<double> v;
    while (std::getline(fields, field, ',')) v.push_back(std::stod(field));
    if (v.size() != 40) throw std::runtime_error("superquadric_common_normal.csv: not 40 numbers in: " + line);
    const auto shape = [&v](std::size_t i) {
      return Superquadric{.half_axes = {v[i], v[i + 1], v[i + 2]}, .exponents = {.n1 = v[i + 3], .n2 = v[i + 4]}};
    };
    const auto pose = [&v](std::size_t i) {
      return Pose{.position = {v[i], v[i + 1], v[i + 2]}, .orientation = {v[i + 3], v[i + 4], v[i + 5], v[i + 6]}};
    };
    contacts.push_back({.pair = {shape(0), pose(10), shape(5), pose(17), name},
                        .normal = {v[24], v[25], v[26]},
                        .depth = v[27],
                        .gap_to_next = v[38]});
  }
  return contacts;
}

}  // namespace osculate::test
