#pragma once
// Tables 4 to 6 of the review [KDY23] list contact models. Here they are the registry of the laws that are implemented.

#include <string>
#include <string_view>
#include <vector>

#include "io/table.hpp"

namespace osculate::validation::kildashti2023 {

struct ModelTable {
  std::string_view name;  ///< "table4"
  std::string title;
  io::Table table;  ///< kind | law | what it is | equations of the review | source
  std::string note;
};

/// Normal, tangential, rolling and twisting laws; every law of the registry is in exactly one of the three.
std::vector<ModelTable> model_tables();

std::string to_text(const ModelTable& table);

}  // namespace osculate::validation::kildashti2023
