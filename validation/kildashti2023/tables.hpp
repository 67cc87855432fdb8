#pragma once
// The tables of the review [KDY23], computed anew. One file a table; the list is what `osculate review` offers.

#include <string_view>
#include <vector>

#include "validation/comparison.hpp"

namespace osculate::validation::kildashti2023 {

/// Table 1: normal force of the accurate and of the simplified model in three poses.
ReproducedTable table1();

/// Table 2: normal force with adhesion.
ReproducedTable table2();

/// Table 3: normal force of rough bodies.
ReproducedTable table3();

struct Entry {
  std::string_view name;
  ReproducedTable (*compute)();
};

const std::vector<Entry>& tables();

}  // namespace osculate::validation::kildashti2023
