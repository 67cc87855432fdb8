#include "validation/kildashti2023/models.hpp"

#include <fmt/core.h>

#include "osculate/mechanics/law_registry.hpp"
#include "osculate/mechanics/study_laws.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

/// Which of the three tables a kind of law belongs to.
std::size_t table_of(LawSlot slot) {
  switch (slot) {
    case LawSlot::normal:
    case LawSlot::adhesion:
    case LawSlot::roughness:
    case LawSlot::plasticity:
    case LawSlot::dissipation:
      return 0;
    case LawSlot::tangential:
      return 1;
    case LawSlot::rolling:
    case LawSlot::twisting:
      break;
  }
  return 2;
}

/// What law of the registry and theory for studies have in common.
template <class Law>
std::vector<std::string> row_of(const std::string& kind, const Law& law) {
  return {kind, std::string(law.name), std::string(law.title), law.equations.empty() ? "–" : std::string(law.equations),
          std::string(law.source)};
}

}  // namespace

std::vector<ModelTable> model_tables() {
  const io::Table empty{{"kind", "law", "what it is", "equations", "source"}, {}, 5};
  std::vector<ModelTable> tables{
      {"table4", "Table 4 of the review [KDY23]: models of the normal force", empty, ""},
      {"table5", "Table 5 of the review [KDY23]: models of the tangential force", empty, ""},
      {"table6", "Table 6 of the review [KDY23]: models of rolling and twisting", empty, ""}};
  for (const LawDescription* law : law_registry())
    tables[table_of(law->slot)].table.rows.push_back(row_of(std::string(name(law->slot)), *law));
  for (const StudyLaw* law : study_laws()) {
    ModelTable& table = tables[table_of(law->slot)];
    table.table.rows.push_back(row_of(fmt::format("{}, study", name(law->slot)), *law));
    table.note = "study: in no time step; `osculate law NAME` says why, and evaluates it.";
  }
  return tables;
}

std::string to_text(const ModelTable& table) {
  return fmt::format("{}\nas implemented here; which model stands in which table was inferred.\n\n{}{}{}", table.title,
                     io::to_text(table.table), table.note, table.note.empty() ? "" : "\n");
}

}  // namespace osculate::validation::kildashti2023
