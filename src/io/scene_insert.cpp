#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/body_keys.hpp"
#include "io/number_table.hpp"
#include "io/scene_parts.hpp"
#include "osculate/dynamics/body_shape.hpp"
#include "osculate/dynamics/random.hpp"

namespace osculate::io {
namespace {

constexpr int most_particles = 100'000'000;

/// Where an insertion of the file gets its particles from, and what all kinds of insertion share.
struct Insertion {
  const TomlTable& table;
  const std::string& unit;
  Scene& scene;
  std::vector<Kind> kinds;
  std::uint64_t seed;
  Vec3 velocity = Vec3::Zero();
  double fluctuation = 0.0;
};

const ParticleKind& kind_named(const std::vector<ParticleKind>& kinds, const std::string& name) {
  return *std::find_if(kinds.begin(), kinds.end(), [&](const ParticleKind& kind) { return kind.name == name; });
}

void add_classes(const ParticleKind& kind, double share, std::vector<Kind>& into) {
  for (std::int32_t i = 0; i < kind.classes; ++i)
    into.push_back({.shape = kind.first_shape + i, .material = kind.material, .weight = share / kind.classes});
}

/// `particles`: a name, or an array of tables {name, share}.
std::vector<Kind> read_kinds(const TomlTable& table, const std::vector<ParticleKind>& kinds) {
  std::vector<std::string> names;
  for (const ParticleKind& kind : kinds) names.push_back(kind.name);
  std::vector<Kind> wanted;
  if (!table.has("particles") && kinds.size() == 1) {
    add_classes(kinds[0], 1.0, wanted);
  } else if (table.is_text("particles")) {
    add_classes(kind_named(kinds, table.choice("particles", names)), 1.0, wanted);
  } else {
    for (const TomlTable& part : table.tables("particles")) {
      add_classes(kind_named(kinds, part.choice("name", names)), part.number("share", Range::positive()), wanted);
      part.reject_unknown_keys();
    }
    if (wanted.empty()) throw table.error("particles", "an empty array", "one kind of particles at least");
  }
  return wanted;
}

double largest_diameter(const Insertion& insertion) {
  double largest = 0.0;
  for (const Kind& kind : insertion.kinds) {
    const Shape& shape = insertion.scene.setup.shapes[static_cast<std::size_t>(kind.shape)];
    largest = std::max(largest, 2.0 * body_shape(shape).bounding_radius);
  }
  return largest;
}

Vec3 thermal(Random& random, double fluctuation) {
  const double u = random.normal(), v = random.normal(), w = random.normal();
  return fluctuation * Vec3(u, v, w);
}

void insert_lattice(const Insertion& insertion) {
  const TomlTable& table = insertion.table;
  const Region region = read_region(table.table("region"), insertion.unit);
  const double diameter = largest_diameter(insertion);
  constexpr double touching = 1.0 + 1e-9;
  const double spacing = table.has("spacing") ? table.quantity("spacing", length(), Range::positive(), insertion.unit)
                                              : touching * diameter;
  if (spacing < diameter)
    throw table.error("spacing", fmt::format("{:.6g} m", spacing),
                      fmt::format("at least {:.6g} m, the largest particle's bounding diameter", diameter));
  std::vector<Vec3> points = lattice(region, spacing);
  if (points.empty()) throw table.error("region", "no room for a single particle", "a larger one");
  if (table.has("count")) {
    const auto count = static_cast<std::size_t>(table.integer("count", 1, most_particles));
    if (count > points.size())
      throw table.error("count", fmt::format("{} particles", count),
                        fmt::format("{} at most: more do not fit into the region", points.size()));
    points.resize(count);
  }
  const bool turned = !table.has("orientations") || table.choice("orientations", {"random", "aligned"}) == "random";
  Random random(insertion.seed);
  std::vector<double> weights;
  for (const Kind& kind : insertion.kinds) weights.push_back(kind.weight);
  for (const Vec3& point : points) {
    const Kind& kind = insertion.kinds[random.pick(weights)];
    const Quat orientation = turned ? random.orientation() : Quat(Quat::Identity());
    insertion.scene.setup.bodies.push_back({.shape = kind.shape,
                                            .material = kind.material,
                                            .pose = {point, orientation},
                                            .velocity = insertion.velocity + thermal(random, insertion.fluctuation)});
  }
}

void insert_at_random(const Insertion& insertion) {
  const TomlTable& table = insertion.table;
  constexpr int usual_tries = 10000;
  RandomInsertion random{
      .region = read_region(table.table("region"), insertion.unit),
      .kinds = insertion.kinds,
      .count = static_cast<std::uint64_t>(table.integer("count", 1, most_particles)),
      .seed = insertion.seed,
      .tries = table.has("tries") ? table.integer("tries", 1, std::numeric_limits<int>::max()) : usual_tries,
      .velocity = insertion.velocity,
      .fluctuation = insertion.fluctuation};
  if (table.has("gap")) random.gap = table.quantity("gap", length(), Range::not_negative(), insertion.unit);
  try {
    insert_randomly(insertion.scene.setup, random);
  } catch (const InputError& error) {
    throw InputError(table.where(), error);
  }
}

/// What comes in while the simulation runs.
void add_pour(const Insertion& insertion) {
  const TomlTable& table = insertion.table;
  if (table.has("rate") == table.has("mass_rate"))
    throw InputError(table.where(), table.has("rate") ? "found both rate and mass_rate" : "found no rate",
                     "either rate, in particles a second, or mass_rate, such as \"20 g/s\"");
  const bool by_mass = table.has("mass_rate");
  Pour pour{.region = read_region(table.table("region"), insertion.unit),
            .kinds = insertion.kinds,
            .rate = by_mass ? table.quantity("mass_rate", mass_rate(), Range::positive())
                            : table.number("rate", Range::positive()),
            .measure = by_mass ? Pour::Measure::mass : Pour::Measure::particles,
            .seed = insertion.seed,
            .velocity = insertion.velocity,
            .fluctuation = insertion.fluctuation};
  if (table.has("begin")) pour.begin = table.quantity("begin", duration(), Range::not_negative());
  if (table.has("end")) {
    pour.end = table.quantity("end", duration(), Range::positive());
    if (pour.end <= pour.begin)
      throw table.error("end", fmt::format("{:g} s", pour.end),
                        fmt::format("a time after the beginning, {:g} s", pour.begin));
  }
  if (table.has("count")) pour.most = static_cast<std::uint64_t>(table.integer("count", 1, most_particles));
  if (table.has("gap")) pour.gap = table.quantity("gap", length(), Range::not_negative(), insertion.unit);
  if (table.has("tries")) pour.tries = table.integer("tries", 1, std::numeric_limits<int>::max());
  insertion.scene.setup.pours.push_back(pour);
}

const Kind& only_kind(const Insertion& insertion) {
  if (insertion.kinds.size() != 1)
    throw insertion.table.error("particles", fmt::format("{} shapes", insertion.kinds.size()),
                                "particles of one shape and size");
  return insertion.kinds[0];
}

void insert_single(const Insertion& insertion) {
  const TomlTable& table = insertion.table;
  const Kind& kind = only_kind(insertion);
  BodyStart body{.shape = kind.shape,
                 .material = kind.material,
                 .pose = {table.vector("position", length(), Range::any(), insertion.unit), read_orientation(table)},
                 .velocity = insertion.velocity};
  if (table.has("angular_velocity"))
    body.angular_velocity = table.vector("angular_velocity", angular_velocity(), Range::any());
  insertion.scene.setup.bodies.push_back(body);
}

/// Columns in SI: x, y, z; qw, qx, qy, qz; vx, vy, vz; wx, wy, wz. All but the first three may be missing.
void insert_from_file(const Insertion& insertion) {
  const TomlTable& table = insertion.table;
  const Kind& kind = only_kind(insertion);
  const std::vector<std::string> columns{"x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"};
  const std::string path = (table.file().parent_path() / table.text("file")).string();
  const NumberTable numbers = read_numbers(path, columns);
  const auto value = [&](const char* name, std::size_t row, double otherwise) {
    const std::vector<double>* column = numbers.find(name);
    return column == nullptr ? otherwise : (*column)[row];
  };
  for (const char* name : {"x", "y", "z"})
    if (numbers.find(name) == nullptr)
      throw table.error("file", fmt::format("no column {} in {}", name, path), "the columns x, y and z [m]");
  constexpr double tolerance = 1e-6;
  for (std::size_t row = 0; row < numbers.rows(); ++row) {
    const Quat orientation(value("qw", row, 1.0), value("qx", row, 0.0), value("qy", row, 0.0), value("qz", row, 0.0));
    if (!(std::abs(orientation.norm() - 1.0) <= tolerance))
      throw InputError(fmt::format("{}:{}", path, row + 2),
                       fmt::format("a quaternion of norm {:.7g}", orientation.norm()),
                       "a unit quaternion qw, qx, qy, qz");
    const Vec3 own(value("vx", row, 0.0), value("vy", row, 0.0), value("vz", row, 0.0));
    insertion.scene.setup.bodies.push_back(
        {.shape = kind.shape,
         .material = kind.material,
         .pose = {{value("x", row, 0.0), value("y", row, 0.0), value("z", row, 0.0)}, orientation.normalized()},
         .velocity = insertion.velocity + own,
         .angular_velocity = {value("wx", row, 0.0), value("wy", row, 0.0), value("wz", row, 0.0)}});
  }
}

}  // namespace

Region read_region(const TomlTable& table, const std::string& unit) {
  const std::string kind = table.choice("kind", {"box", "cylinder", "sphere"});
  const auto point = [&](const char* key) { return table.vector(key, length(), Range::any(), unit); };
  const auto size = [&](const char* key) { return table.quantity(key, length(), Range::positive(), unit); };
  Region region;
  if (kind == "box")
    region = BoxRegion{.lower = point("lower"), .upper = point("upper")};
  else if (kind == "cylinder")
    region = CylinderRegion{.base = point("base"), .radius = size("radius"), .height = size("height")};
  else
    region = SphereRegion{.centre = point("centre"), .radius = size("radius")};
  table.reject_unknown_keys();
  try {
    validate(region);
  } catch (const InputError& error) {
    throw InputError(table.where(), error);
  }
  return region;
}

void read_insertions(const TomlTable& file, const std::string& unit, const std::vector<ParticleKind>& kinds,
                     Scene& scene) {
  std::uint64_t number = 0;
  for (const TomlTable& table : file.tables("insert")) {
    const std::string how = table.choice("how", {"lattice", "random", "pour", "single", "file"});
    Insertion insertion{.table = table,
                        .unit = unit,
                        .scene = scene,
                        .kinds = read_kinds(table, kinds),
                        // Insertions that do not say otherwise differ from each other.
                        .seed = table.has("seed") ? static_cast<std::uint64_t>(
                                                        table.integer("seed", 0, std::numeric_limits<int>::max()))
                                                  : ++number};
    if (table.has("velocity")) insertion.velocity = table.vector("velocity", velocity(), Range::any());
    const bool one_by_one = how == "single" || how == "file";
    if (!one_by_one && table.has("fluctuation"))
      insertion.fluctuation = table.quantity("fluctuation", velocity(), Range::not_negative());
    if (how == "lattice") insert_lattice(insertion);
    if (how == "random") insert_at_random(insertion);
    if (how == "pour") add_pour(insertion);
    if (how == "single") insert_single(insertion);
    if (how == "file") insert_from_file(insertion);
    table.reject_unknown_keys();
  }
}

}  // namespace osculate::io
