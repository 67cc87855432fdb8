#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/scene_frames.hpp"
#include "io/progress.hpp"
#include "io/quantity_text.hpp"
#include "io/scene.hpp"
#include "io/table.hpp"
#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

constexpr const char* help = R"(  osculate check examples/scenes/settling-box.toml

Reads the scene, places all particles, chooses the time step and computes the first forces; then says what a run would
do. Nothing is written. Exit code 2 if the scene cannot run.)";

/// Bodies of one shape in a row, as messages about bodies name them.
void print_bodies(const io::Scene& scene, const Simulation& simulation) {
  const std::vector<BodyStart>& bodies = scene.setup.bodies;
  io::Table table{{"shape", "kind", "material", "moves", "bodies", "first", "mass"}, {}, 4};
  std::vector<std::vector<std::size_t>> of_shape(scene.setup.shapes.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) of_shape[static_cast<std::size_t>(bodies[i].shape)].push_back(i);
  for (std::size_t shape = 0; shape < of_shape.size(); ++shape) {
    if (of_shape[shape].empty()) continue;
    const std::size_t first = of_shape[shape].front();
    const BodyStart& body = bodies[first];
    const bool is_free = body.motion == Bodies::free;
    const bool rests =
        !is_free && std::holds_alternative<Fixed>(scene.setup.motions[static_cast<std::size_t>(body.motion)]);
    table.rows.push_back({scene.shape_names[shape], std::string(kind(scene.setup.shapes[shape])),
                          scene.setup.materials[static_cast<std::size_t>(body.material)].name,
                          is_free ? "free" : (rests ? "fixed" : "driven"), fmt::format("{}", of_shape[shape].size()),
                          fmt::format("{}", first),
                          is_free ? io::quantity_text(1e3 * simulation.bodies().mass[first], "g") : ""});
  }
  fmt::print("\n{}", io::to_text(table));
}

/// The mean mass of a pour's particles [kg].
double mean_mass(const Setup& setup, const Pour& pour) {
  double mass = 0.0, weights = 0.0;
  for (const Kind& kind : pour.kinds) {
    mass += kind.weight * setup.materials[static_cast<std::size_t>(kind.material)].density *
            mass_properties(setup.shapes[static_cast<std::size_t>(kind.shape)]).volume;
    weights += kind.weight;
  }
  return mass / weights;
}

/// How many particles a pour brings in until the end of the run, on average.
double poured_particles(const io::Scene& scene, const Pour& pour) {
  const double amount = due(pour, scene.duration);
  return std::min(pour.measure == Pour::Measure::mass ? std::floor(amount / mean_mass(scene.setup, pour)) : amount,
                  static_cast<double>(pour.most));
}

double poured_particles(const io::Scene& scene) {
  double sum = 0.0;
  for (const Pour& pour : scene.setup.pours) sum += poured_particles(scene, pour);
  return sum;
}

/// Seconds a step takes at the start, from a few of them.
double measured_step(Simulation& simulation) {
  constexpr double enough = 0.3;  // s
  constexpr std::uint64_t most = 200;
  const auto begin = std::chrono::steady_clock::now();
  const auto spent = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  std::uint64_t steps = 0;
  for (; steps < most && spent() < enough; ++steps) simulation.advance(1);
  return spent() / static_cast<double>(steps);
}

void check(const std::string& path) {
  const io::Scene scene = io::read_scene(path);
  try {
    Simulation simulation(scene.setup);
    const io::ParticleFrame frame = frame_of(scene, simulation);
    const double steps = static_cast<double>(scene.steps());
    const double frames = std::floor(steps / static_cast<double>(scene.steps_in(scene.output.interval))) + 1.0;
    constexpr double bytes_a_particle = 2 * sizeof(std::uint32_t) + 13 * sizeof(double);
    const TimeStepLimits& limits = scene.limits;
    const auto seconds = [](double value) { return io::quantity_text(value, "s"); };
    std::vector<io::Property> lines{
        {"time", fmt::format("{} in {:.0f} steps", seconds(scene.duration), steps)},
        {"time step", seconds(scene.setup.time_step)},
        {"  shortest impact", fmt::format("{}   {}, at {}", seconds(limits.contact_duration), limits.shortest,
                                          io::quantity_text(scene.speed, "m/s"))},
        {"  Rayleigh time", seconds(limits.rayleigh_time)},
        {"  recommended", fmt::format("{}   the smaller of a {:.0f}th of the impact and {:.1f} Rayleigh times",
                                      seconds(limits.recommended), steps_per_contact, rayleigh_share)},
        {"particles",
         fmt::format(
             "{}{}", frame.size(),
             scene.setup.pours.empty() ? "" : fmt::format(", and about {:.0f} poured in", poured_particles(scene)))},
        {"contacts at start", fmt::format("{}", simulation.counts().contacts)},
        {"memory at start", io::quantity_text(static_cast<double>(simulation.memory_bytes()), "B")},
        {"frames", fmt::format("{:.0f}, every {}", frames, seconds(scene.output.interval))},
        {"results", fmt::format("{} at most, before compression{}",
                                io::quantity_text(frames * bytes_a_particle *
                                                      (static_cast<double>(frame.size()) + poured_particles(scene)),
                                                  "B"),
                                scene.output.contacts ? ", and the contacts" : "")}};
    lines.push_back({"computing", fmt::format("{} on one core at the speed of the first steps; more as bodies meet{}",
                                              io::clock_text(steps * measured_step(simulation)),
                                              scene.setup.pours.empty() ? "" : " and are poured in")});
    fmt::print("{}\n\n{}", scene.title, io::to_text(lines));
    print_bodies(scene, simulation);
  } catch (const StepError& error) {
    throw InputError(path, error.what(), "bodies that start apart and do not cross each other in a step");
  }
  for (const std::string& warning : scene.warnings) fmt::print("\nwarning: {}\n", warning);
}

}  // namespace

void add_check(CLI::App& program) {
  CLI::App* command = program.add_subcommand("check", "What a scene would do, without running it");
  command->footer(help);
  const auto path = std::make_shared<std::string>();
  command->add_option("SCENE", *path, "A scene file")->required();
  command->callback([path] { check(*path); });
}

}  // namespace osculate::app
