#include "osculate/mechanics/law_registry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "mechanics/laws/batched.hpp"
#include "mechanics/laws/composed.hpp"
#include "mechanics/laws/laws.hpp"
#include "mechanics/laws/parameters.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/study_laws.hpp"

namespace osculate {
namespace {

constexpr const char* place = "contact law";
using laws::quoted;

/// Slot by slot, the usual choice first.
const std::array registry{
    &laws::hertz,
    &laws::hertz_sphere,
    &laws::linear,
    &laws::walton_braun,
    &laws::jkr,
    &laws::dmt,
    &laws::greenwood_williamson,
    &laws::jamari_schipper,
    &laws::brilliantov,
    &laws::tsuji,
    &laws::kuwabara_kono,
    &laws::linear_dashpot,
    &laws::dashpot,
    &laws::mindlin,
    &laws::cundall_strack,
    &laws::di_renzo,
    &laws::tsuji_tangential,
    &laws::langston,
    &laws::zheng,
    &laws::walton_braun_friction,
    &laws::sliding,
    &laws::viscous_friction,
    &laws::viscous_sliding,
    &laws::twisting,
    &laws::vermeulen_johnson,
    &laws::kalker,
};

const laws::Law* find(std::string_view name) {
  const auto found =
      std::ranges::find_if(registry, [&](const laws::Law* law) { return law->description.name == name; });
  return found == registry.end() ? nullptr : *found;
}

const laws::Law& known(std::string_view name) {
  if (const laws::Law* law = find(name)) return *law;
  if (const StudyLaw* law = study_law(name))
    throw InputError(place, quoted(name), "a law for time steps: " + std::string(law->reason));
  throw InputError(place, "a law " + quoted(name),
                   laws::one_of(registry, [](const laws::Law* law) { return law->description.name; }));
}

bool excludes(const LawConflict& conflict, const LawDescription& other) {
  if (conflict.other != other.name && conflict.other != name(other.slot)) return false;
  return std::ranges::find(conflict.but, other.name) == conflict.but.end();
}

void refuse_conflicts(const LawDescription& law, const LawDescription& other) {
  for (const LawConflict& conflict : law.conflicts)
    if (excludes(conflict, other))
      throw InputError(place, quoted(law.name) + " with " + quoted(other.name),
                       "another choice: " + std::string(conflict.reason));
}

/// The checked choice, by slot.
std::vector<ChosenLaw> checked(const LawChoice& choice) {
  std::array<const LawDescription*, law_slots> by_slot{};
  std::vector<ChosenLaw> result;
  for (const ChosenLaw& chosen : choice) {
    const LawDescription& law = known(chosen.name).description;
    const LawDescription*& slot = by_slot[static_cast<std::size_t>(law.slot)];
    if (slot != nullptr)
      throw InputError(place, quoted(slot->name) + " and " + quoted(law.name),
                       "one law of the slot " + quoted(name(law.slot)));
    slot = &law;
    result.push_back({chosen.name, laws::completed(chosen.parameters, law.parameters,
                                                   place + std::string(" ") + std::string(law.name))});
  }
  if (by_slot[static_cast<std::size_t>(LawSlot::normal)] == nullptr)
    throw InputError(place, "no normal law", "one of the slot \"normal\", for instance hertz");
  for (const LawDescription* law : by_slot)
    for (const LawDescription* other : by_slot)
      if (law != nullptr && other != nullptr && law != other) refuse_conflicts(*law, *other);
  std::ranges::sort(result, {}, [](const ChosenLaw& law) { return law_named(law.name).slot; });
  return result;
}

/// Where a law replaces the normal force, the normal law itself has nothing to do.
bool replaces_normal(LawSlot slot) {
  return slot == LawSlot::adhesion || slot == LawSlot::roughness || slot == LawSlot::plasticity;
}

/// What a contact is pressed and rubbed by runs in batches; these follow.
bool makes_couples(LawSlot slot) {
  return slot == LawSlot::twisting || slot == LawSlot::rolling;
}

laws::BoundPart bound(const ChosenLaw& law, const ElasticMaterial& material_1, const ElasticMaterial& material_2) {
  const laws::Law& entry = known(law.name);
  return {entry.bind({material_1, material_2, law.parameters}), entry.description.memory};
}

ContactLaw scalar_law(const std::vector<ChosenLaw>& chosen, const ElasticMaterial& material_1,
                      const ElasticMaterial& material_2) {
  const bool replaced =
      std::ranges::any_of(chosen, [](const ChosenLaw& law) { return replaces_normal(law_named(law.name).slot); });
  std::vector<laws::BoundPart> parts;
  for (const ChosenLaw& law : chosen) {
    if (replaced && law_named(law.name).slot == LawSlot::normal) continue;
    parts.push_back(bound(law, material_1, material_2));
  }
  return laws::composed(parts);
}

}  // namespace

std::string_view name(LawSlot slot) {
  switch (slot) {
    case LawSlot::normal:
      return "normal";
    case LawSlot::adhesion:
      return "adhesion";
    case LawSlot::roughness:
      return "roughness";
    case LawSlot::plasticity:
      return "plasticity";
    case LawSlot::dissipation:
      return "dissipation";
    case LawSlot::tangential:
      return "tangential";
    case LawSlot::twisting:
      return "twisting";
    case LawSlot::rolling:
      return "rolling";
  }
  return "unknown";
}

bool LawParameter::allows(double value) const {
  if (!std::isfinite(value)) return false;
  return (value > least || (value == least && least_bound == Bound::included)) &&
         (value < most || (value == most && most_bound == Bound::included));
}

std::string LawParameter::range() const {
  const bool low = std::isfinite(least), high = std::isfinite(most);
  const bool with_least = least_bound == Bound::included, with_most = most_bound == Bound::included;
  char text[64] = "any number";
  if (low && high)
    std::snprintf(text, sizeof text, "in %c%g, %g%c", with_least ? '[' : '(', least, most, with_most ? ']' : ')');
  else if (low)
    std::snprintf(text, sizeof text, "%s %g", with_least ? ">=" : ">", least);
  else if (high)
    std::snprintf(text, sizeof text, "%s %g", with_most ? "<=" : "<", most);
  return text;
}

std::span<const LawDescription* const> law_registry() {
  static const auto descriptions = [] {
    std::array<const LawDescription*, registry.size()> result{};
    std::ranges::transform(registry, result.begin(), [](const laws::Law* law) { return &law->description; });
    return result;
  }();
  return descriptions;
}

const LawDescription& law_named(std::string_view name) {
  return known(name).description;
}

ContactLaw make_contact_law(const LawChoice& choice, const ElasticMaterial& material_1,
                            const ElasticMaterial& material_2) {
  validate(material_1);
  validate(material_2);
  const std::vector<ChosenLaw> chosen = checked(choice);
  laws::ChosenBySlot by_slot;
  std::vector<laws::BoundPart> couples;
  for (const ChosenLaw& law : chosen) {
    const LawSlot slot = law_named(law.name).slot;
    if (makes_couples(slot))
      couples.push_back(bound(law, material_1, material_2));
    else
      by_slot.emplace(slot, &law);
  }
  if (auto law = laws::batched(by_slot, material_1, material_2))
    return couples.empty() ? *law : laws::followed(*law, couples);
  return scalar_law(chosen, material_1, material_2);
}

ContactLaw make_contact_law_scalar(const LawChoice& choice, const ElasticMaterial& material_1,
                                   const ElasticMaterial& material_2) {
  validate(material_1);
  validate(material_2);
  return scalar_law(checked(choice), material_1, material_2);
}

}  // namespace osculate
