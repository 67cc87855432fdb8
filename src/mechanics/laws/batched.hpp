#pragma once
// Laws that run in SIMD batches.

#include <map>
#include <optional>
#include <string_view>

#include "mechanics/laws/law_part.hpp"

namespace osculate::laws {

/// The laws of a choice by slot; parameters complete.
using ChosenBySlot = std::map<LawSlot, const ChosenLaw*>;

/// The batched form of a choice, or nothing where there is none.
std::optional<ContactLaw> batched(const ChosenBySlot& chosen, const ElasticMaterial& material_1,
                                  const ElasticMaterial& material_2);

}  // namespace osculate::laws
