#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/laws_bench.hpp"
#include "app/narrow_bench.hpp"
#include "app/scenes_bench.hpp"
#include "io/progress.hpp"
#include "io/table.hpp"
#include "osculate/core/error.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate::app {
namespace {

constexpr const char* narrow_help =
    R"(Nanoseconds per contact on one core: point, normal, overlap, principal curvatures and directions of both bodies;
the median of the repetitions ± half the distance between their quartiles.
  warm       from the last answer, after a pose change of 1e-4
  cold       from nothing
  separated  a gap of 1 % R_vol, with the separating direction cached
  Hertz      the force from the radii of relative curvature
  GJK/EPA    libccd on the same support functions: one scalar contact without curvature, its depth good to a few per cent
Example:
  osculate bench narrow --json > narrow.json)";

constexpr const char* laws_help =
    R"(Nanoseconds per contact on one core, from the radii of relative curvature and the motion of the step to force and
memory; the median of the repetitions ± half the distance between their quartiles. Batched: many contacts in SIMD lanes;
scalar: the same law contact by contact in doubles.
Example:
  osculate bench laws --json > laws.json)";

constexpr const char* scenes_help =
    R"(Nanoseconds per particle and time step of particles that fell into a box and lie at rest, with Hertz, damping and
history friction; the median of the repetitions ± half the distance between their quartiles.
  one core     processor time of the whole step
  GJK/EPA      what libccd would take to find the same contacts between particles, without curvature, forces and motion
  stages       sums of forces and motion of the bodies, lists of pairs, narrow phase, contact law
  missed       overlaps above 1e-6 of the radius that an exhaustive search finds and the scene does not have
Settling takes a minute or two, 10^5 particles half an hour and more; --settled keeps the states for the next time.
Scenes and numbers of particles are timed in turns.
Examples:
  osculate bench scenes --scene boxes
  osculate bench scenes --scene ellipsoids --particles 1000 10000 100000 --settled settled --repetitions 5)";

struct BenchOptions {
  bool json = false;
  LawBenchSettings laws;
  std::vector<std::string> scene_names;
  SceneBenchSettings scenes;
  std::vector<std::string> classes;
  NarrowSettings narrow;
};

std::string text_of(const Timing& timing) {
  const int digits = timing.median < 100.0 ? 1 : 0;
  return fmt::format("{:.{}f} ± {:.{}f}", timing.median, digits, timing.spread, digits);
}

std::string ratio_text(const Timing& slow, const Timing& fast) {
  return fmt::format("{:.3g}", slow.median / fast.median);
}

nlohmann::ordered_json json_of(const Timing& timing) {
  return {{"median_ns", timing.median}, {"spread_ns", timing.spread}};
}

nlohmann::ordered_json json_of(const NarrowTimes& times) {
  return {{"class", times.name},
          {"warm_batched", json_of(times.warm_batched)},
          {"warm_scalar", json_of(times.warm_scalar)},
          {"cold_batched", json_of(times.cold_batched)},
          {"cold_scalar", json_of(times.cold_scalar)},
          {"separated_batched", json_of(times.separated_batched)},
          {"separated_scalar", json_of(times.separated_scalar)},
          {"ccd", json_of(times.ccd)},
          {"ccd_over_warm_batched", times.ccd.median / times.warm_batched.median},
          {"ccd_over_cold_batched", times.ccd.median / times.cold_batched.median},
          {"ccd_over_cold_scalar", times.ccd.median / times.cold_scalar.median},
          {"unresolved", times.unresolved},
          {"ccd_failures", times.ccd_failures},
          {"ccd_median_relative_depth_error", times.ccd_depth_error}};
}

void print_text(const std::vector<NarrowTimes>& all, const Timing& hertz, const NarrowSettings& settings) {
  fmt::print(
      "Narrow phase of superquadrics: nanoseconds per contact on one core\n"
      "{} pairs a class, overlap {:g} R_vol, pose change {:g}, {} repetitions, batches on {}\n\n",
      settings.pairs, settings.overlap, settings.pose_change, settings.repetitions, batch_instruction_set());
  io::Table batched{{"batched", "warm", "cold", "separated", "GJK/EPA", "GJK/EPA : warm", ": cold"}, {}};
  io::Table scalar{{"scalar", "warm", "cold", "separated", "GJK/EPA", "GJK/EPA : warm", ": cold"}, {}};
  for (const NarrowTimes& times : all) {
    batched.rows.push_back({times.name, text_of(times.warm_batched), text_of(times.cold_batched),
                            text_of(times.separated_batched), text_of(times.ccd),
                            ratio_text(times.ccd, times.warm_batched), ratio_text(times.ccd, times.cold_batched)});
    scalar.rows.push_back({times.name, text_of(times.warm_scalar), text_of(times.cold_scalar),
                           text_of(times.separated_scalar), text_of(times.ccd),
                           ratio_text(times.ccd, times.warm_scalar), ratio_text(times.ccd, times.cold_scalar)});
  }
  fmt::print("{}\n{}\n", io::to_text(batched), io::to_text(scalar));
  fmt::print("Elliptical Hertz, batched, from the radii to force, ellipse, pressure, stiffness, energy: {} ns\n",
             text_of(hertz));
  std::string failures;
  double worst = 0.0;
  for (const NarrowTimes& times : all) {
    worst = std::max(worst, times.ccd_depth_error);
    if (times.ccd_failures > 0)
      failures += fmt::format("{} {} ({})", failures.empty() ? "" : ",", times.ccd_failures, times.name);
    if (times.unresolved > 0)
      fmt::print("Not converged: {} of {} pairs ({})\n", times.unresolved, settings.pairs, times.name);
  }
  fmt::print("GJK/EPA: depth off by {:.1e} of itself (median, worst class)", worst);
  fmt::print("{}\n", failures.empty() ? "." : "; contacts it missed:" + failures + ".");
}

std::vector<PairClass> chosen_classes(const std::vector<std::string>& names) {
  std::vector<PairClass> all = narrow_classes();
  if (names.empty()) return all;
  std::vector<PairClass> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const PairClass& one) { return one.name == name; });
    if (found == all.end()) {
      std::string expected = "one of";
      for (const PairClass& one : all) expected += " " + one.name;
      throw InputError("--class", "\"" + name + "\"", expected);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

void bench_narrow(const BenchOptions& options) {
  std::vector<NarrowTimes> all;
  {
    io::Progress progress("bench narrow");
    const std::vector<PairClass> classes = chosen_classes(options.classes);
    for (const PairClass& pair_class : classes) {
      all.push_back(time_narrow_phase(pair_class, options.narrow));
      progress.update(static_cast<double>(all.size()) / static_cast<double>(classes.size()));
    }
  }
  const Timing hertz = time_hertz(options.narrow);
  if (!options.json) return print_text(all, hertz, options.narrow);
  nlohmann::ordered_json report{
      {"instruction_set", batch_instruction_set()}, {"pairs", options.narrow.pairs},
      {"repetitions", options.narrow.repetitions},  {"overlap_over_R_vol", options.narrow.overlap},
      {"pose_change", options.narrow.pose_change},  {"hertz_batched", json_of(hertz)},
      {"classes", nlohmann::ordered_json::array()}};
  for (const NarrowTimes& times : all) report["classes"].push_back(json_of(times));
  fmt::print("{}\n", report.dump(2));
}

void bench_laws(const BenchOptions& options) {
  const std::vector<LawTimes> all = time_laws(options.laws);
  if (!options.json) {
    io::Table table{{"law", "path", "batched", "scalar", "scalar : batched"}, {}, 2};
    for (const LawTimes& times : all)
      table.rows.push_back({times.name, times.path, text_of(times.batched), times.scalar ? text_of(*times.scalar) : "",
                            times.scalar ? ratio_text(*times.scalar, times.batched) : ""});
    fmt::print("Contact laws: nanoseconds per contact on one core\n{} contacts, {} repetitions, batches on {}\n\n{}",
               options.laws.contacts, options.laws.repetitions, batch_instruction_set(), io::to_text(table));
    return;
  }
  nlohmann::ordered_json report{{"instruction_set", batch_instruction_set()},
                                {"contacts", options.laws.contacts},
                                {"repetitions", options.laws.repetitions},
                                {"laws", nlohmann::ordered_json::array()}};
  for (const LawTimes& times : all) {
    nlohmann::ordered_json one{{"law", times.name}, {"path", times.path}, {"batched", json_of(times.batched)}};
    if (times.scalar) {
      one["scalar"] = json_of(*times.scalar);
      one["scalar_over_batched"] = times.scalar->median / times.batched.median;
    }
    report["laws"].push_back(one);
  }
  fmt::print("{}\n", report.dump(2));
}

std::vector<BenchScene> chosen_scenes(const std::vector<std::string>& names) {
  const std::vector<BenchScene> all = bench_scenes();
  if (names.empty()) return all;
  std::vector<BenchScene> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const BenchScene& one) { return one.name == name; });
    if (found == all.end()) {
      std::string expected = "one of";
      for (const BenchScene& one : all) expected += " " + one.name;
      throw InputError("--scene", "\"" + name + "\"", expected);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

void print_scenes(const std::vector<SceneTimes>& all, const SceneBenchSettings& settings) {
  fmt::print(
      "Settled scenes: nanoseconds per particle and time step\nhertz, tsuji, {}; {} repetitions of {} steps, batches "
      "on {}\n\n",
      settings.tangential, settings.repetitions, settings.steps, batch_instruction_set());
  const auto percent = [](double share) { return fmt::format("{:.0f} %", 100.0 * share); };
  io::Table times{{"scene", "particles", "one core", "GJK/EPA", "GJK/EPA : one core", "two threads : one"}, {}, 1};
  io::Table stages{{"scene", "motion", "lists", "narrow", "law", "steps a list"}, {}, 1};
  io::Table numbers{
      {"scene", "coordination", "contacts", "in the list", "spheres", "bytes", "a contact", "missed"}, {}, 1};
  for (const SceneTimes& one : all) {
    times.rows.push_back({one.name, fmt::format("{}", one.particles), text_of(one.step), text_of(one.ccd),
                          ratio_text(one.ccd, one.step), ratio_text(one.one_thread_wall, one.two_threads)});
    stages.rows.push_back({one.name, percent(one.shares.move), percent(one.shares.broad), percent(one.shares.narrow),
                           percent(one.shares.law), fmt::format("{:.0f}", one.steps_between_lists)});
    numbers.rows.push_back({one.name, fmt::format("{:.2f}", one.coordination), fmt::format("{:.2f}", one.contacts),
                            fmt::format("{:.2f}", one.candidates), fmt::format("{:.1f}", one.sphere_neighbours),
                            fmt::format("{:.0f}", one.bytes), fmt::format("{:.0f}", one.bytes_of_contact),
                            fmt::format("{}", one.missed)});
  }
  fmt::print("{}\nShares of the time on one core\n{}\nPer particle\n{}", io::to_text(times), io::to_text(stages),
             io::to_text(numbers));
}

nlohmann::ordered_json json_of(const SceneTimes& one) {
  return {{"scene", one.name},
          {"shape", one.shape},
          {"particles", one.particles},
          {"step", json_of(one.step)},
          {"ccd", json_of(one.ccd)},
          {"ccd_over_step", one.ccd.median / one.step.median},
          {"one_thread_wall", json_of(one.one_thread_wall)},
          {"two_threads_wall", json_of(one.two_threads)},
          {"two_threads_speed_up", one.one_thread_wall.median / one.two_threads.median},
          {"shares",
           {{"motion", one.shares.move},
            {"lists", one.shares.broad},
            {"narrow", one.shares.narrow},
            {"law", one.shares.law}}},
          {"steps_between_lists", one.steps_between_lists},
          {"coordination", one.coordination},
          {"contacts_per_particle", one.contacts},
          {"listed_pairs_per_particle", one.candidates},
          {"sphere_neighbours", one.sphere_neighbours},
          {"bytes_per_particle", one.bytes},
          {"bytes_per_contact", one.bytes_of_contact},
          {"missed", one.missed}};
}

void bench_scenes_command(const BenchOptions& options) {
  const std::vector<BenchScene> scenes = chosen_scenes(options.scene_names);
  std::vector<SceneTimes> all;
  {
    io::Progress progress("bench scenes");
    all = time_scenes(scenes, options.scenes, [&](double share) { progress.update(share); });
  }
  if (!options.json) return print_scenes(all, options.scenes);
  nlohmann::ordered_json report{{"instruction_set", batch_instruction_set()},
                                {"tangential", options.scenes.tangential},
                                {"repetitions", options.scenes.repetitions},
                                {"steps", options.scenes.steps},
                                {"scenes", nlohmann::ordered_json::array()}};
  for (const SceneTimes& one : all) report["scenes"].push_back(json_of(one));
  fmt::print("{}\n", report.dump(2));
}

}  // namespace

void add_bench(CLI::App& program) {
  CLI::App* bench = program.add_subcommand("bench", "Measure what a contact costs on this machine");
  bench->require_subcommand(1);
  CLI::App* narrow = bench->add_subcommand("narrow", "Time of one contact of two superquadrics, class by class");
  narrow->footer(narrow_help);
  const auto options = std::make_shared<BenchOptions>();
  narrow->add_flag("--json", options->json, "Print the numbers as JSON");
  narrow->add_option("--class", options->classes, "Only these classes (sphere, ellipsoid, blocky, box, cylinder, ...)");
  narrow->add_option("--pairs", options->narrow.pairs, "Pairs a class")
      ->check(CLI::Range(16, 1000000))
      ->capture_default_str();
  narrow->add_option("--repetitions", options->narrow.repetitions, "Timed repetitions")
      ->check(CLI::Range(3, 100000))
      ->capture_default_str();
  narrow
      ->add_option("--epa-tolerance", options->narrow.epa_tolerance,
                   "When libccd's EPA stops, in squared lengths of R_vol")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  narrow->callback([options] { bench_narrow(*options); });

  CLI::App* laws = bench->add_subcommand("laws", "Time of one contact of each law of a time step");
  laws->footer(laws_help);
  laws->add_flag("--json", options->json, "Print the numbers as JSON");
  laws->add_option("--contacts", options->laws.contacts, "Contacts")
      ->check(CLI::Range(16, 1000000))
      ->capture_default_str();
  laws->add_option("--repetitions", options->laws.repetitions, "Timed repetitions")
      ->check(CLI::Range(3, 100000))
      ->capture_default_str();
  laws->callback([options] { bench_laws(*options); });

  CLI::App* scenes = bench->add_subcommand("scenes", "Time of a step of settled particles");
  scenes->footer(scenes_help);
  scenes->add_flag("--json", options->json, "Print the numbers as JSON");
  scenes->add_option("--scene", options->scene_names, "Only these scenes (blocky, boxes, ellipsoids)");
  scenes->add_option("--particles", options->scenes.particles, "Particles, in place of each scene's own number")
      ->expected(1, 20)
      ->check(CLI::Range(1, 10000000));
  scenes->add_option("--settled", options->scenes.settled, "Folder of settled states: taken from there, left there");
  scenes->add_option("--tangential", options->scenes.tangential, "Law of friction")
      ->check(CLI::IsMember({"di_renzo", "mindlin"}))
      ->capture_default_str();
  scenes->add_option("--repetitions", options->scenes.repetitions, "Timed repetitions")
      ->check(CLI::Range(3, 100000))
      ->capture_default_str();
  scenes->callback([options] { bench_scenes_command(*options); });
}

}  // namespace osculate::app
