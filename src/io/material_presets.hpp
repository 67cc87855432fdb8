#pragma once
// Elastic constants of a few common materials, by name, each with its source.

#include <array>
#include <string_view>

#include "osculate/mechanics/material.hpp"

namespace osculate::io {

struct MaterialPreset {
  std::string_view name;
  ElasticMaterial material;
  std::string_view source;  ///< a key of docs/references.md
};

/// Middle values: handbook constants of real materials scatter by 5 % and more.
inline constexpr std::array<MaterialPreset, 4> material_presets{{
    {"glass", {.youngs_modulus = 71e9, .poissons_ratio = 0.22}, "Wassgren06"},
    {"steel", {.youngs_modulus = 200e9, .poissons_ratio = 0.30}, "Gere01"},
    {"aluminium", {.youngs_modulus = 70e9, .poissons_ratio = 0.33}, "Gere01"},
    {"nylon", {.youngs_modulus = 2.8e9, .poissons_ratio = 0.40}, "Gere01"},
}};

}  // namespace osculate::io
