#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/body_keys.hpp"
#include "io/scene_parts.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::io {
namespace {

// Lighter than aerogel, heavier than osmium: outside, a unit was forgotten.
const Range plausible_density{
    .lower = 1.0, .upper = 3e4, .hint = " (a density without a unit is in kg/m3; write \"2.5 g/cm3\")"};

std::vector<std::string> names_of(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  for (const Material& material : materials) names.push_back(material.name);
  return names;
}

Material read_material(const TomlTable& table, const std::vector<Material>& before) {
  Material material{.name = table.text("name"), .elastic = {}, .density = 0.0};
  const std::vector<std::string> taken = names_of(before);
  if (std::find(taken.begin(), taken.end(), material.name) != taken.end())
    throw table.error("name", fmt::format("a second material \"{}\"", material.name), "a name of its own");
  material.elastic = table.has("preset") ? read_preset(table, "preset") : read_elastic_constants(table);
  material.density = table.quantity("density", density(), plausible_density);
  table.reject_unknown_keys();
  return material;
}

/// The dimension whose SI unit this is, if it is one that files may write with other units.
const Dimension* dimension_of(std::string_view unit) {
  for (const Dimension* dimension : {&length(), &pressure(), &duration(), &surface_energy()})
    if (dimension->in_si(unit) == 1.0) return dimension;
  return nullptr;
}

double read_parameter(const TomlTable& table, const LawParameter& parameter) {
  const Dimension* const dimension = dimension_of(parameter.unit);
  const double value =
      dimension != nullptr ? table.quantity(parameter.name, *dimension, Range::any()) : table.number(parameter.name);
  if (!parameter.allows(value))
    throw table.error(parameter.name, fmt::format("{:g} {}", value, parameter.unit),
                      fmt::format("a value {} ({})", parameter.range(), parameter.meaning));
  return value;
}

/// The law in a slot: a name, or a table {law = name, parameter = value, …}.
ChosenLaw read_law(const TomlTable& table, LawSlot slot) {
  std::vector<std::string> laws;
  for (const LawDescription* law : law_registry())
    if (law->slot == slot) laws.emplace_back(law->name);
  const std::string_view key = name(slot);
  if (!table.is_table(key)) return {.name = table.choice(key, laws), .parameters = {}};
  const TomlTable inner = table.table(key);
  ChosenLaw chosen{.name = inner.choice("law", laws), .parameters = {}};
  for (const LawParameter& parameter : law_named(chosen.name).parameters)
    if (inner.has(parameter.name)) chosen.parameters[std::string(parameter.name)] = read_parameter(inner, parameter);
  inner.reject_unknown_keys();
  return chosen;
}

LawChoice read_laws(const TomlTable& table) {
  LawChoice choice;
  for (std::size_t slot = 0; slot < law_slots; ++slot)
    if (table.has(name(static_cast<LawSlot>(slot)))) choice.push_back(read_law(table, static_cast<LawSlot>(slot)));
  return choice;
}

void add_interaction(const TomlTable& table, const LawChoice& choice, std::int32_t one, std::int32_t two,
                     Setup& setup) {
  try {
    setup.interactions.push_back({one, two,
                                  make_contact_law(choice, setup.materials[static_cast<std::size_t>(one)].elastic,
                                                   setup.materials[static_cast<std::size_t>(two)].elastic)});
  } catch (const InputError& error) {
    throw InputError(table.where(), error);
  }
}

bool is_set(const Setup& setup, std::int32_t one, std::int32_t two) {
  return std::any_of(setup.interactions.begin(), setup.interactions.end(), [&](const Interaction& interaction) {
    return std::minmax(interaction.material_1, interaction.material_2) == std::minmax(one, two);
  });
}

std::int32_t index_of(const TomlTable& table, const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw table.error("between", fmt::format("\"{}\"", name),
                      fmt::format("materials out of {}", fmt::join(names, ", ")));
  return static_cast<std::int32_t>(found - names.begin());
}

}  // namespace

void read_materials(const TomlTable& file, Scene& scene) {
  Setup& setup = scene.setup;
  for (const TomlTable& table : file.tables("materials"))
    setup.materials.push_back(read_material(table, setup.materials));
  const std::vector<std::string> names = names_of(setup.materials);
  const auto count = static_cast<std::int32_t>(names.size());
  std::vector<std::pair<TomlTable, LawChoice>> for_all;
  for (const TomlTable& table : file.tables("interactions")) {
    const LawChoice choice = read_laws(table);
    if (!table.has("between")) {
      if (!for_all.empty())
        throw InputError(table.where(), "found a second interaction without \"between\"",
                         "one for all pairs that are not named");
      for_all.emplace_back(table, choice);
      table.reject_unknown_keys();
      continue;
    }
    const std::vector<std::string> pair = table.texts("between");
    if (pair.size() != 2)
      throw table.error("between", fmt::format("{} names", pair.size()), "two materials, [\"one\", \"other\"]");
    table.reject_unknown_keys();
    const std::int32_t one = index_of(table, names, pair[0]), two = index_of(table, names, pair[1]);
    if (is_set(setup, one, two))
      throw table.error("between", fmt::format("{} and {} again", pair[0], pair[1]), "one interaction for a pair");
    add_interaction(table, choice, one, two, setup);
  }
  for (const auto& [table, choice] : for_all)
    for (std::int32_t one = 0; one < count; ++one)
      for (std::int32_t two = one; two < count; ++two)
        if (!is_set(setup, one, two)) add_interaction(table, choice, one, two, setup);
}

std::int32_t material_index(const TomlTable& table, const Scene& scene) {
  const std::vector<std::string> names = names_of(scene.setup.materials);
  if (!table.has("material") && names.size() == 1) return 0;
  const std::string name = table.choice("material", names);
  return static_cast<std::int32_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace osculate::io
