// Prints every table of the review that is reproduced, without the osculate program.

#include <fmt/core.h>

#include "validation/kildashti2023/models.hpp"
#include "validation/kildashti2023/tables.hpp"

int main() {
  namespace validation = osculate::validation;
  for (const auto& table : validation::kildashti2023::tables())
    fmt::print("{}\n", validation::to_text(table.compute()));
  for (const auto& models : validation::kildashti2023::model_tables())
    fmt::print("{}\n", validation::kildashti2023::to_text(models));
}
