#pragma once
// The parts of a scene file, section by section; each adds to the scene what its section says.

#include <map>
#include <string>
#include <vector>

#include "io/scene.hpp"
#include "io/toml_reader.hpp"

namespace osculate::io {

/// [[materials]] and [[interactions]].
void read_materials(const TomlTable& file, Scene& scene);
std::int32_t material_index(const TomlTable& table, const Scene& scene);

/// Particles of a name: its size classes are shapes in a row.
struct ParticleKind {
  std::string name;
  std::int32_t first_shape;
  std::int32_t classes;
  std::int32_t material;
};
/// [[particles]].
std::vector<ParticleKind> read_particles(const TomlTable& file, const std::string& unit, Scene& scene);

/// [[obstacles]], then [[walls]]: obstacles are particles by their shape, and these come first.
void read_boundaries(const TomlTable& file, const std::string& unit, Scene& scene);
Motion read_motion(const TomlTable& table, const std::string& unit);

/// [[insert]], in the order of the file.
void read_insertions(const TomlTable& file, const std::string& unit, const std::vector<ParticleKind>& kinds,
                     Scene& scene);
Region read_region(const TomlTable& table, const std::string& unit);

}  // namespace osculate::io
