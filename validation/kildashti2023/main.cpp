// Prints every table of the review that is reproduced, without the osculate program.

#include <fmt/core.h>

#include "validation/kildashti2023/tables.hpp"

int main() {
  for (const auto& table : osculate::validation::kildashti2023::tables())
    fmt::print("{}\n", osculate::validation::to_text(table.compute()));
}
