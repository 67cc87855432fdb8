#include "io/shape_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <system_error>

#include "io/nearest_name.hpp"
#include "io/polyhedron.hpp"
#include "tools/convex_hull.hpp"

namespace osculate::io {
namespace {

constexpr double largest_particle = 100.0;  // across [m]
constexpr double smallest_particle = 1e-9;

/// A particle's lengths, each of which decides its size.
struct LengthKey {
  const TomlTable& table;
  std::string_view unit;

  /// A radius or half-axis: what is twice as long must be a particle.
  double half_size(std::string_view key) const {
    const double value = table.quantity(key, length(), Range::positive(), unit);
    require_particle(key, 2.0 * value);
    return value;
  }

  Vec3 half_sizes(std::string_view key) const {
    Vec3 value = table.vector(key, length(), Range::positive(), unit);
    for (const double half : value) require_particle(key, 2.0 * half);
    return value;
  }

  double positive(std::string_view key) const { return table.quantity(key, length(), Range::positive(), unit); }

  void require_particle(std::string_view key, double across) const {
    if (across >= smallest_particle && across <= largest_particle) return;
    throw table.error(key, fmt::format("a body {:g} m across", across),
                      fmt::format("a particle between 1 nm and 100 m across; is unit = \"{}\" right?", unit));
  }
};

Exponents read_exponents(const TomlTable& table) {
  const bool as_n = table.has("n"), as_eta = table.has("eta");
  if (as_n && as_eta) throw table.error("eta", "both n and eta", "one of them: n = 2/eta");
  if (as_eta) {
    const Range range{.lower = 2.0 / 64.0, .upper = std::nextafter(2.0, 0.0), .hint = " (eta = 2/n, 1 < n <= 64)"};
    const auto eta = table.numbers("eta", 2, range);
    return Exponents::from_eta(eta[0], eta[1]);
  }
  Range range = Range::above(1.0, 64.0);
  range.hint = " (n = 2/eta; below 1 the body is not convex)";
  const auto n = table.numbers("n", 2, range);
  return {n[0], n[1]};
}

std::vector<FacePlane> read_planes(const TomlTable& table, double unit) {
  std::vector<FacePlane> planes;
  for (const auto& row : table.rows("planes", 4)) {
    const Vec3 direction(row[0], row[1], row[2]);
    const std::string key = fmt::format("planes[{}]", planes.size());
    if (!(direction.norm() > 0.0)) throw table.error(key, "the normal (0, 0, 0)", "a direction");
    if (!(row[3] > 0.0)) {
      throw table.error(key, fmt::format("the distance {}", row[3]),
                        "a positive distance d of the plane n·x = d, so that the origin lies inside");
    }
    planes.push_back({direction.normalized(), row[3] * unit});
  }
  return planes;
}

std::vector<FacePlane> read_hull(const TomlTable& table, double unit) {
  const std::filesystem::path path = table.file().parent_path() / table.text("polyhedron");
  try {
    std::vector<FacePlane> planes = tools::convex_hull(read_polyhedron(path).vertices).planes;
    for (FacePlane& plane : planes) plane.distance *= unit;
    return planes;
  } catch (const InputError& error) {
    throw InputError(table.where("polyhedron"), error);
  }
}

PotentialParticle read_potential_particle(const TomlTable& table, const LengthKey& lengths) {
  const double unit = *length().in_si(lengths.unit);
  const bool by_planes = table.has("planes"), by_file = table.has("polyhedron");
  if (by_planes && by_file) throw table.error("polyhedron", "both planes and polyhedron", "one of them");
  return {.planes = by_file ? read_hull(table, unit) : read_planes(table, unit),
          .sphericity = table.number("k", Range::above(0.0, 1.0)),
          .edge_radius = lengths.positive("r"),
          .sphere_radius = lengths.half_size("R")};
}

Shape read_kind(const TomlTable& table, std::string_view kind, const LengthKey& lengths) {
  if (kind == "superquadric") return Superquadric{lengths.half_sizes("half_axes"), read_exponents(table)};
  if (kind == "ellipsoid") return Ellipsoid{lengths.half_sizes("half_axes")};
  if (kind == "sphere") return Sphere{lengths.half_size("radius")};
  if (kind == "potential_particle") return read_potential_particle(table, lengths);
  if (kind == "sphere_container") return SphereContainer{lengths.positive("radius")};
  const bool rod = table.choice("side", {"rod", "drum"}) == "rod";
  return Cylinder{lengths.positive("radius"), rod ? Cylinder::Solid::inside : Cylinder::Solid::outside};
}

std::string read_unit(const TomlTable& table, std::string_view default_unit) {
  if (!table.has("unit") && !default_unit.empty()) return std::string(default_unit);
  std::vector<std::string> symbols;
  for (const Unit& unit : length().units) symbols.emplace_back(unit.symbol);
  return table.choice("unit", symbols);
}

std::vector<std::filesystem::path> folders_of(std::string_view list) {
  std::vector<std::filesystem::path> folders;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(':'), list.size());
    if (end > 0) folders.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return folders;
}

bool is_path(std::string_view text) {
  return text.find('/') != std::string_view::npos || text.ends_with(".toml");
}

}  // namespace

ShapeFile parse_shape(const TomlTable& table, std::string_view default_unit) {
  ShapeFile file{.name = table.text_or("name", ""),
                 .title = table.text_or("title", ""),
                 .source = table.text_or("source", ""),
                 .unit = "",
                 .shape = HalfSpace{},
                 .file = table.file()};
  const std::string kind = table.choice("kind", {"superquadric", "ellipsoid", "sphere", "potential_particle",
                                                 "half_space", "cylinder", "sphere_container"});
  if (kind != "half_space") {
    file.unit = read_unit(table, default_unit);
    file.shape = read_kind(table, kind, {table, file.unit});
  }
  table.reject_unknown_keys();
  try {
    validate(file.shape);
  } catch (const InputError& error) {
    throw InputError(table.where("kind"), error);
  }
  return file;
}

ShapeFile read_shape(const std::filesystem::path& path) {
  ShapeFile file = parse_shape(read_toml(path));
  if (file.name.empty()) file.name = path.stem().string();
  return file;
}

ShapeFile parse_shape_of(const TomlTable& table, std::string_view key, std::string_view default_unit) {
  if (table.is_table(key)) return parse_shape(table.table(key), default_unit);
  if (table.has(key) && !table.is_text(key)) {
    throw table.error(key, "neither a string nor a table",
                      "a catalogue name, the path of a shape file, or a table {kind = …}");
  }
  const std::string name = table.text(key);
  try {
    return find_shape(name, table.file().parent_path());
  } catch (const InputError& error) {
    throw InputError(table.where(key), error);
  }
}

std::vector<std::filesystem::path> catalogue_folders() {
  const char* const variable = std::getenv("OSCULATE_SHAPES");
  std::vector<std::filesystem::path> folders = folders_of(variable == nullptr ? "" : variable);
  // An installed program that was moved as a whole still finds its data.
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (!unknown) folders.push_back(program.parent_path().parent_path() / OSCULATE_DATA_DIR "/osculate/shapes");
  folders.emplace_back(OSCULATE_SOURCE_SHAPES);
  std::erase_if(folders, [](const auto& folder) { return !std::filesystem::is_directory(folder); });
  return folders;
}

std::vector<CatalogueEntry> catalogue() {
  std::map<std::string, std::filesystem::path> files;
  for (const auto& folder : catalogue_folders()) {
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      if (file.path().extension() == ".toml") files.try_emplace(file.path().stem().string(), file.path());
    }
  }
  std::vector<CatalogueEntry> entries;
  for (const auto& [name, file] : files) entries.push_back({name, file});
  return entries;
}

ShapeFile find_shape(std::string_view name_or_path, const std::filesystem::path& base) {
  if (is_path(name_or_path)) return read_shape(base / name_or_path);
  const std::vector<CatalogueEntry> entries = catalogue();
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : entries) {
    if (entry.name == name_or_path) return read_shape(entry.file);
    names.push_back(entry.name);
  }
  throw InputError("shape", fmt::format("found no shape \"{}\"{}", name_or_path, suggestion(name_or_path, names)),
                   fmt::format("a catalogue name ({}), or the path of a shape file (with a '/' or ending in .toml)",
                               fmt::join(names, ", ")));
}

}  // namespace osculate::io
