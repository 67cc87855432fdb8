#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "io/scene_parts.hpp"
#include "osculate/dynamics/body_shape.hpp"

namespace osculate::io {
namespace {

constexpr double usual_checkpoint_every = 60.0;  // s of computing: what a crash may cost
constexpr int usual_series_rows = 10;            // a frame
constexpr double most_steps = 1e15;              // whole numbers up to there are exact in a double

std::string length_unit(const TomlTable& file) {
  std::string unit = file.text_or("length_unit", "m");
  if (!length().in_si(unit)) throw file.error("length_unit", "\"" + unit + "\"", "one of " + length().symbols());
  return unit;
}

BoxShear read_shear(const TomlTable& table) {
  const std::vector<std::string> axes{"x", "y", "z"};
  const auto axis = [&](const char* key) {
    return std::find(axes.begin(), axes.end(), table.choice(key, axes)) - axes.begin();
  };
  const BoxShear shear{
      .flow = axis("flow"), .gradient = axis("gradient"), .rate = table.quantity("rate", shear_rate(), Range::any())};
  table.reject_unknown_keys();
  return shear;
}

/// `x = [lower, upper]` and so on under [periodic].
PeriodicBox read_periodic(const TomlTable& file, const std::string& unit) {
  PeriodicBox box;
  if (!file.has("periodic")) return box;
  const TomlTable table = file.table("periodic");
  const double metre = *length().in_si(unit);
  const char* const axes[] = {"x", "y", "z"};
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (!table.has(axes[k])) continue;
    const std::vector<double> ends = table.numbers(axes[k], 2);
    if (!(ends[0] < ends[1])) throw table.error(axes[k], "ends that do not increase", "[lower, upper]");
    box.origin[k] = metre * ends[0];
    box.length[k] = metre * (ends[1] - ends[0]);
  }
  if (table.has("shear")) box.shear = read_shear(table.table("shear"));
  table.reject_unknown_keys();
  try {
    validate(box);
  } catch (const InputError& error) {
    throw InputError(table.where(), error);
  }
  return box;
}

/// Particles start with the flow of a sheared box, on top of their own velocities.
void add_flow(Setup& setup) {
  const Vec3 middle = setup.box.origin + 0.5 * setup.box.length;
  for (BodyStart& body : setup.bodies)
    if (body.motion == Bodies::free) body.velocity += image_velocity(setup.box, body.pose.position - middle);
}

double speed_of(const Motion& motion, const Vec3& from, double reach) {
  struct Speed {
    Vec3 from;
    double reach;
    double operator()(const Fixed&) const { return 0.0; }
    double operator()(const Translation& one) const { return one.velocity.norm(); }
    double operator()(const Rotation& one) const {
      return std::fabs(one.rate) * ((from - one.point).cross(one.axis).norm() + reach);
    }
    double operator()(const Oscillation& one) const {
      return 2.0 * std::acos(-1.0) * one.frequency * one.amplitude.norm();
    }
    double operator()(const Path& one) const {
      double most = 0.0;
      for (std::size_t i = 1; i < one.times.size(); ++i)
        most = std::max(most,
                        (one.displacements[i] - one.displacements[i - 1]).norm() / (one.times[i] - one.times[i - 1]));
      return most;
    }
  };
  return std::visit(Speed{from, reach}, motion);
}

double reach_of(const Shape& shape) {
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->radius;
  if (const auto* sphere = std::get_if<SphereContainer>(&shape)) return sphere->radius;
  return is_particle(shape) ? bounding_radius(shape) : 0.0;
}

/// What bodies bring with them, and what a fall through the whole scene adds. Walls of planes count with their points.
double expected_speed(const Setup& setup) {
  double own = 0.0, driven = 0.0;
  const double g = setup.gravity.norm();
  const Vec3 down = g > 0.0 ? Vec3(setup.gravity / g) : Vec3::Zero();
  double highest = std::numeric_limits<double>::infinity(), lowest = -highest;
  for (const BodyStart& body : setup.bodies) {
    const Shape& shape = setup.shapes[static_cast<std::size_t>(body.shape)];
    const double reach = reach_of(shape), depth = down.dot(body.pose.position);
    const bool curved = std::holds_alternative<Cylinder>(shape) || std::holds_alternative<SphereContainer>(shape);
    if (body.motion == Bodies::free) {
      own = std::max(own, body.velocity.norm() + reach * body.angular_velocity.norm());
      highest = std::min(highest, depth);
      lowest = std::max(lowest, depth);
    } else {
      driven =
          std::max(driven, speed_of(setup.motions[static_cast<std::size_t>(body.motion)], body.pose.position, reach));
      lowest = std::max(lowest, curved ? depth + reach : depth);
    }
  }
  for (const MeshStart& mesh : setup.meshes) {
    double far = 0.0;
    for (const Vec3& vertex : mesh.triangles.vertices) {
      far = std::max(far, vertex.norm());
      lowest = std::max(lowest, down.dot(mesh.pose.to_world(vertex)));
    }
    driven = std::max(driven, speed_of(setup.motions[static_cast<std::size_t>(mesh.motion)], mesh.pose.position, far));
  }
  constexpr double deviations = 3.0;
  for (const Pour& pour : setup.pours) {
    own = std::max(own, pour.velocity.norm() + deviations * pour.fluctuation);
    const BoxRegion region = bounds(pour.region);
    highest = std::min(highest, down.cwiseMin(0.0).dot(region.upper) + down.cwiseMax(0.0).dot(region.lower));
  }
  if (setup.box.shear) driven += std::fabs(setup.box.shear->rate) * setup.box.length[setup.box.shear->gradient];
  return own + driven + std::sqrt(2.0 * g * std::max(lowest - highest, 0.0));
}

void read_time(const TomlTable& file, Scene& scene) {
  const TomlTable table = file.table("time");
  Setup& setup = scene.setup;
  scene.duration = table.quantity("duration", duration(), Range::positive());
  scene.speed = table.has("speed") ? table.quantity("speed", velocity(), Range::positive()) : expected_speed(setup);
  if (!(scene.speed > 0.0))
    throw InputError(table.where(), "found a scene in which nothing moves",
                     "gravity, a velocity, a moving wall, or the key speed: the fastest impact to be expected");
  try {
    scene.limits = time_step_limits(setup, scene.speed);
  } catch (const InputError& error) {
    throw InputError(scene.file.string(), error);
  }
  const bool automatic = !table.has("step") || (table.is_text("step") && table.text("step") == "auto");
  if (automatic) {
    setup.time_step = scene.limits.recommended * table.number_or("safety", 1.0, Range::above(0.0, 4.0));
  } else {
    setup.time_step = table.quantity("step", duration(), Range::positive());
    if (setup.time_step > scene.limits.largest)
      throw table.error(
          "step", fmt::format("{:.4g} s", setup.time_step),
          fmt::format("at most {:.4g} s: the impact of {} at {:.3g} m/s lasts {:.4g} s", scene.limits.largest,
                      scene.limits.shortest, scene.speed, scene.limits.contact_duration));
    if (setup.time_step > scene.limits.recommended)
      scene.warnings.push_back(fmt::format("{}: a step of {:.4g} s is longer than the {:.4g} s recommended",
                                           table.where("step"), setup.time_step, scene.limits.recommended));
  }
  if (scene.duration / setup.time_step > most_steps)
    throw table.error("duration", fmt::format("{:g} s in steps of {:g} s", scene.duration, setup.time_step),
                      "fewer than 1e15 steps");
  table.reject_unknown_keys();
}

void read_output(const TomlTable& file, const std::string& unit, Scene& scene) {
  const TomlTable table = file.table("output");
  SceneOutput& output = scene.output;
  output.interval = table.quantity("interval", duration(), Range::positive());
  output.series_interval = table.has("series_interval")
                               ? table.quantity("series_interval", duration(), Range::positive())
                               : output.interval / usual_series_rows;
  output.checkpoint_every = table.has("checkpoint_every")
                                ? table.quantity("checkpoint_every", duration(), Range::positive())
                                : usual_checkpoint_every;
  output.contacts = table.flag("contacts");
  if (table.has("fraction_region")) output.fraction_region = read_region(table.table("fraction_region"), unit);
  table.reject_unknown_keys();
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void require_particles(const TomlTable& file, const Scene& scene) {
  const auto& bodies = scene.setup.bodies;
  if (scene.setup.pours.empty() &&
      std::none_of(bodies.begin(), bodies.end(), [](const BodyStart& body) { return body.motion == Bodies::free; }))
    throw InputError(file.where(), "found a scene without particles", "an [[insert]] that brings some in");
}

/// What is allowed and seldom meant.
void add_warnings(const TomlTable& file, Scene& scene) {
  const auto& bodies = scene.setup.bodies;
  const bool any_driven =
      !scene.setup.meshes.empty() ||
      std::any_of(bodies.begin(), bodies.end(), [](const BodyStart& body) { return body.motion != Bodies::free; });
  if (!scene.setup.gravity.isZero(0.0) && !any_driven)
    scene.warnings.push_back(
        fmt::format("{}: gravity, and neither walls nor obstacles: everything falls for ever", file.where("gravity")));
  for (const Pour& pour : scene.setup.pours)
    if (pour.begin >= scene.duration)
      scene.warnings.push_back(fmt::format("{}: a pour begins at {:.4g} s, when the run of {:.4g} s is over",
                                           scene.file.string(), pour.begin, scene.duration));
  if (scene.output.interval > scene.duration)
    scene.warnings.push_back(
        fmt::format("{}: an interval of {:.4g} s is longer than the run: frames of the start and the end only",
                    file.table("output").where("interval"), scene.output.interval));
  if (scene.output.series_interval < scene.setup.time_step)
    scene.warnings.push_back(fmt::format("{}: an interval below the time step of {:.4g} s: a row or frame every step",
                                         file.where("output"), scene.setup.time_step));
}

}  // namespace

std::uint64_t Scene::steps() const {
  return steps_in(duration);
}

std::uint64_t Scene::steps_in(double interval) const {
  return static_cast<std::uint64_t>(std::max(1.0, std::round(interval / setup.time_step)));
}

Scene read_scene(const std::filesystem::path& path) {
  const TomlTable file = read_toml(path);
  Scene scene;
  scene.file = path;
  scene.text = text_of(path);
  scene.title = file.text_or("title", path.stem().string());
  const std::string unit = length_unit(file);
  Setup& setup = scene.setup;
  if (file.has("gravity")) setup.gravity = file.vector("gravity", acceleration(), Range::any());
  setup.box = read_periodic(file, unit);
  if (file.has("radius_cap")) setup.radius_cap = file.number("radius_cap", Range::positive());
  if (file.has("skin")) setup.skin = file.number("skin", Range::positive());
  read_materials(file, scene);
  const std::vector<ParticleKind> kinds = read_particles(file, unit, scene);
  read_boundaries(file, unit, scene);
  read_insertions(file, unit, kinds, scene);
  require_particles(file, scene);
  if (setup.box.shear) add_flow(setup);
  read_time(file, scene);
  read_output(file, unit, scene);
  file.reject_unknown_keys();
  add_warnings(file, scene);
  try {
    validate(setup);
  } catch (const InputError& error) {
    throw InputError(path.string(), error);
  }
  return scene;
}

}  // namespace osculate::io
