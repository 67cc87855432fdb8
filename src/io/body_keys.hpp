#pragma once
// Keys that contact files and scene files share: orientations and elastic constants.

#include <string_view>

#include "io/toml_reader.hpp"
#include "osculate/core/types.hpp"
#include "osculate/mechanics/material.hpp"

namespace osculate::io {

/// `orientation`: a unit quaternion [w, x, y, z], or {axis = [x, y, z], angle = degrees}; the identity where it is
/// missing.
Quat read_orientation(const TomlTable& table);

/// A direction that is not zero, made a unit vector.
Vec3 read_direction(const TomlTable& table, std::string_view key);

/// The elastic constants of a preset that a key names.
ElasticMaterial read_preset(const TomlTable& table, std::string_view key);

/// `youngs_modulus` and `poissons_ratio`.
ElasticMaterial read_elastic_constants(const TomlTable& table);

}  // namespace osculate::io
