#include "validation/kildashti2023/tables.hpp"

namespace osculate::validation::kildashti2023 {

const std::vector<Entry>& tables() {
  static const std::vector<Entry> list{{"table1", table1}, {"table2", table2}, {"table3", table3}};
  return list;
}

}  // namespace osculate::validation::kildashti2023
