#include "io/body_keys.hpp"

#include <algorithm>

#include "io/material_presets.hpp"

namespace osculate::io {
namespace {

// Softer than any gel that keeps its form, stiffer than diamond: outside, a unit was forgotten.
const Range plausible_modulus{
    .lower = 1e3, .upper = 2e12, .hint = " (a modulus without a unit is in Pa; write \"70 GPa\")"};

}  // namespace

Quat read_orientation(const TomlTable& table) {
  if (!table.has("orientation")) return Quat::Identity();
  if (!table.is_table("orientation")) return table.quaternion("orientation");
  const TomlTable turn = table.table("orientation");
  const Vec3 axis = read_direction(turn, "axis");
  const double angle_value = turn.quantity("angle", angle(), Range::any(), "deg");
  turn.reject_unknown_keys();
  return Quat(Eigen::AngleAxisd(angle_value, axis));
}

Vec3 read_direction(const TomlTable& table, std::string_view key) {
  const Vec3 direction = table.vector(key);
  if (!(direction.norm() > 0.0)) throw table.error(key, "a vector of length 0", "a direction");
  return direction.normalized();
}

ElasticMaterial read_preset(const TomlTable& table, std::string_view key) {
  std::vector<std::string> names;
  for (const MaterialPreset& preset : material_presets) names.emplace_back(preset.name);
  const std::string name = table.choice(key, names);
  return std::find_if(material_presets.begin(), material_presets.end(),
                      [&](const MaterialPreset& preset) { return preset.name == name; })
      ->material;
}

ElasticMaterial read_elastic_constants(const TomlTable& table) {
  return {.youngs_modulus = table.quantity("youngs_modulus", pressure(), plausible_modulus),
          .poissons_ratio = table.number("poissons_ratio", Range::above(-1.0, 0.5))};
}

}  // namespace osculate::io
