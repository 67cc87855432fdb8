#include "app/laws_bench.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include "io/progress.hpp"
#include "osculate/core/aligned_allocator.hpp"
#include "osculate/mechanics/hertz.hpp"
#include "osculate/mechanics/jamari_schipper.hpp"
#include "osculate/mechanics/johnson_greenwood.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::app {
namespace {

constexpr ElasticMaterial glass{.youngs_modulus = 71e9, .poissons_ratio = 0.22};
constexpr double pi = 3.14159265358979323846;
constexpr double overlap = 1e-6, friction = 0.3;

using Column = std::vector<double>;

/// Radii of relative curvature of 0.1 mm to 1 mm, R_i/R_j up to 100.
struct Radii {
  Column R_i, R_j;

  explicit Radii(std::size_t count) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (std::size_t i = 0; i < count; ++i) {
      R_j.push_back(1e-3 * (0.1 + uniform(random)));
      R_i.push_back(R_j.back() * std::pow(10.0, 2.0 * uniform(random)));
    }
  }
};

/// How the bodies move on each other, step after step.
enum class Path {
  oscillating,  ///< to and fro along one direction, partial slip
  impact,       ///< the overlap grows and shrinks while the tangential velocity turns
  wandering,    ///< overlap and both components at random
};

/// What is asked of the law.
enum class Asked { forces, energies };

/// Contacts at different phases of a path; their memories wander on from call to call.
class Bed {
 public:
  static constexpr std::size_t length = 64;

  Bed(const Radii& radii, Path path, Asked asked, std::size_t memory)
      : radii_(radii), asked_(asked), memory_(memory), status_(radii.R_i.size()), mass_(radii.R_i.size(), 1e-5) {
    const std::size_t count = radii.R_i.size();
    for (auto& column : frame_) column.resize(count);
    for (auto& column : out_) column.resize(count);
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> phase(count), way(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double turn = 2.0 * pi * uniform(random);
      phase[i] = 2.0 * pi * uniform(random), way[i] = 2.0 * pi * uniform(random);
      frame_[2][i] = 1.0, frame_[3][i] = std::cos(turn), frame_[4][i] = std::sin(turn);
    }
    for (std::size_t k = 0; k < length; ++k) {
      for (auto& column : steps_[k]) column.resize(count);
      for (std::size_t i = 0; i < count; ++i) {
        const Move move = moved(path, 2.0 * pi * static_cast<double>(k) / length, phase[i], random);
        steps_[k][0][i] = move.overlap;
        steps_[k][1][i] = (move.x * std::cos(way[i]) - move.y * std::sin(way[i])) / time_step;
        steps_[k][2][i] = (move.x * std::sin(way[i]) + move.y * std::cos(way[i])) / time_step;
        steps_[k][3][i] = -1e-3;
        steps_[k][4][i] = turning * std::cos(way[i]), steps_[k][5][i] = turning * std::sin(way[i]);
        steps_[k][6][i] = path == Path::oscillating ? 0.0 : 1e-4 / time_step;
      }
    }
  }

  void step(const ContactLaw& law) {
    const auto& now = steps_[next_];
    next_ = (next_ + 1) % length;
    LawOutput output{.force = {out_[0], out_[1], out_[2]},
                     .couple = {out_[9], out_[10], out_[11]},
                     .normal_force = out_[3],
                     .status = status_};
    if (asked_ == Asked::energies) {
      output.stored_normal = out_[4], output.stored_tangential = out_[5];
      output.viscous_loss = out_[6], output.friction_loss = out_[7], output.hysteresis_loss = out_[8];
    }
    law.evaluate({.R_i = radii_.R_i,
                  .R_j = radii_.R_j,
                  .overlap = now[0],
                  .normal = {frame_[0], frame_[1], frame_[2]},
                  .major_axis = {frame_[3], frame_[4], frame_[5]},
                  .velocity = {now[1], now[2], now[3]},
                  .angular_velocity = {now[4], now[5], now[6]},
                  .mean_angular_velocity = {now[4], now[5], now[6]},
                  .reduced_mass = mass_,
                  .time_step = time_step},
                 memory_, output);
  }

 private:
  static constexpr double time_step = 1e-6, turning = 50.0;  // [s], [rad/s], of the rolling
  struct Move {
    double overlap, x, y;
  };
  static Move moved(Path path, double s, double phase, std::mt19937_64& random) {
    constexpr double slip = friction * overlap;  // about what slides a contact altogether
    std::uniform_real_distribution<double> uniform(-0.5, 0.5);
    switch (path) {
      case Path::oscillating:
        return {overlap, slip * (std::sin(s + phase) - std::sin(s + phase - 2.0 * pi / length)), 0.0};
      case Path::impact:
        return {overlap * (0.02 + std::fabs(std::sin(0.5 * s + phase))), 0.01 * slip, 0.005 * slip * std::cos(s)};
      case Path::wandering:
        break;
    }
    return {overlap * (1.0 + 0.2 * uniform(random)), 0.2 * slip * uniform(random), 0.2 * slip * uniform(random)};
  }

  const Radii& radii_;
  Asked asked_;
  std::array<std::array<Column, 7>, length> steps_;
  std::array<Column, 6> frame_;
  std::array<Column, 12> out_;
  std::vector<double, AlignedAllocator<double>> memory_;
  std::vector<LawStatus> status_;
  Column mass_;
  std::size_t next_ = 0;
};

Timing time_law(const ContactLaw& law, const Radii& radii, Path path, Asked asked, int repetitions) {
  Bed bed(radii, path, asked, law.memory_length(radii.R_i.size()));
  const auto run = [&] {
    for (std::size_t k = 0; k < Bed::length; ++k) bed.step(law);
  };
  return time_of(
      radii.R_i.size() * Bed::length, repetitions, [] {}, run);
}

LawTimes time_hertz_alone(const Radii& radii, int repetitions) {
  const std::size_t count = radii.R_i.size();
  const Column modulus(count, effective_modulus(glass, glass)), depth(count, overlap);
  std::array<Column, 6> out;
  for (Column& column : out) column.resize(count);
  std::vector<hertz::Validity> validity(count);
  const auto batched = [&] {
    hertz::contacts({radii.R_i, radii.R_j, radii.R_j, modulus, depth},
                    {out[0], out[1], out[2], out[3], out[4], out[5], validity});
  };
  const auto scalar = [&] {
    for (std::size_t i = 0; i < count; ++i)
      out[0][i] = hertz::contact(contact_ellipse(radii.R_i[i], radii.R_j[i]), modulus[i], depth[i], radii.R_j[i]).force;
  };
  return {"elliptical Hertz", "",
          time_of(
              count, repetitions, [] {}, batched),
          time_of(
              count, repetitions, [] {}, scalar)};
}

LawTimes time_jkr(const Radii& radii, int repetitions) {
  constexpr double work = 0.05;
  const std::size_t count = radii.R_i.size();
  const Column modulus(count, effective_modulus(glass, glass)), adhesion(count, work);
  std::array<Column, Bed::length> depth;
  for (std::size_t k = 0; k < Bed::length; ++k)
    for (std::size_t i = 0; i < count; ++i)
      depth[k].push_back(0.1 * overlap *
                         (1.0 + std::sin(2.0 * pi * static_cast<double>(k) / Bed::length + static_cast<double>(i))));
  std::array<Column, 4> out;
  for (Column& column : out) column.resize(count);
  std::vector<johnson_greenwood::Memory> memory(count);
  std::vector<johnson_greenwood::Status> status(count);
  const auto batched = [&] {
    for (const Column& now : depth)
      johnson_greenwood::contacts({radii.R_i, radii.R_j, modulus, adhesion, now}, memory,
                                  {out[0], out[1], out[2], out[3], status});
  };
  const auto scalar = [&] {
    for (std::size_t i = 0; i < count; ++i) {
      const johnson_greenwood::Pair pair{radii.R_i[i], radii.R_j[i], modulus[i], work};
      out[0][i] = johnson_greenwood::at_overlap(pair, depth[0][i]).value().force;
    }
  };
  return {"JKR", "overlap to and fro",
          time_of(
              count * Bed::length, repetitions, [] {}, batched),
          time_of(
              count, repetitions, [] {}, scalar)};
}

LawTimes time_jamari(const Radii& radii, int repetitions) {
  constexpr jamari_schipper::Plasticity plasticity{
      .hardness = 1.2e9, .yield_factor = 0.577, .plastic_factor = 0.7, .area_ratio = 160.0};
  const std::size_t count = radii.R_i.size();
  const Column modulus(count, effective_modulus(glass, glass)), yield(count, plasticity.yield_pressure()),
      plastic(count, plasticity.plastic_pressure()), ratio(count, plasticity.area_ratio);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Column largest, depth;
  for (std::size_t i = 0; i < count; ++i) {
    const double first = jamari_schipper::limits(radii.R_i[i], radii.R_j[i], modulus[i], plasticity).first_yield;
    largest.push_back(first * std::pow(10.0, 3.0 * uniform(random) - 0.5));
    depth.push_back(largest.back() * (0.5 + uniform(random)));
  }
  Column memory = largest;
  std::array<Column, 5> out;
  for (Column& column : out) column.resize(count);
  std::vector<jamari_schipper::Regime> regime(count);
  const auto begin = [&] { memory = largest; };
  const auto batched = [&] {
    jamari_schipper::contacts({radii.R_i, radii.R_j, modulus, yield, plastic, ratio, depth},
                              {memory, out[0], out[1], out[2], out[3], out[4], regime});
  };
  const auto scalar = [&] {
    for (std::size_t i = 0; i < count; ++i) {
      jamari_schipper::Memory one{memory[i]};
      out[0][i] = jamari_schipper::contact(radii.R_i[i], radii.R_j[i], modulus[i], plasticity, depth[i], one).force;
      memory[i] = one.largest_overlap;
    }
  };
  return {"Jamari-Schipper", "all regimes", time_of(count, repetitions, begin, batched),
          time_of(count, repetitions, begin, scalar)};
}

}  // namespace

std::vector<LawTimes> time_laws(const LawBenchSettings& settings) {
  const Radii radii(settings.contacts);
  const ChosenLaw hertz{"hertz", {}}, viscous{"brilliantov", {{"dissipative_time", 1e-8}}},
      tsuji{"tsuji", {{"restitution", 0.8}}};
  const ChosenLaw mindlin{"mindlin", {{"friction", friction}}}, history{"tsuji_tangential", {{"friction", friction}}};
  const ChosenLaw spring{"cundall_strack", {{"friction", friction}, {"tangential_stiffness", 1e6}}};
  const ChosenLaw twisting{"twisting", {{"friction", friction}}},
      rolling{"vermeulen_johnson", {{"friction", friction}}};
  const ChosenLaw jkr{"jkr", {{"work_of_adhesion", 0.05}}};
  const ChosenLaw plastic{
      "jamari_schipper",
      {{"hardness", 1.2e9}, {"yield_factor", 0.577}, {"plastic_factor", 0.7}, {"area_ratio", 160.0}}};
  struct Case {
    const char* name;
    LawChoice choice;
    Path path;
    const char* path_name;
    Asked asked = Asked::forces;
    bool has_scalar = true;  ///< the normal force of others is always found in batches
  };
  const Case cases[] = {
      {"Hertz, viscous, Mindlin", {hertz, viscous, mindlin}, Path::oscillating, "one direction, to and fro"},
      {"Hertz, viscous, Mindlin", {hertz, viscous, mindlin}, Path::impact, "impact, slip turning"},
      {"Hertz, viscous, Mindlin", {hertz, viscous, mindlin}, Path::wandering, "at random"},
      {"Hertz, Tsuji, one spring", {hertz, tsuji, history}, Path::impact, "impact, slip turning"},
      {"Hertz, viscous, one spring", {hertz, viscous, history}, Path::wandering, "at random"},
      {"Hertz, viscous, Mindlin", {hertz, viscous, mindlin}, Path::impact, "impact, and its energies", Asked::energies},
      {"Hertz, Tsuji, one spring", {hertz, tsuji, history}, Path::impact, "impact, and its energies", Asked::energies},
      {"Hertz, viscous, Mindlin, twisting", {hertz, viscous, mindlin, twisting}, Path::impact, "impact, slip turning"},
      {"Hertz, viscous, rolling", {hertz, viscous, rolling}, Path::wandering, "at random"},
      {"JKR, viscous, one spring",
       {hertz, jkr, viscous, spring},
       Path::impact,
       "impact, slip turning",
       Asked::forces,
       false},
      {"Jamari-Schipper, one spring",
       {hertz, plastic, spring},
       Path::impact,
       "impact, slip turning",
       Asked::forces,
       false}};

  io::Progress progress("bench laws");
  std::vector<LawTimes> times{time_hertz_alone(radii, settings.repetitions), time_jkr(radii, settings.repetitions),
                              time_jamari(radii, settings.repetitions)};
  for (const Case& one : cases) {
    const auto time = [&](const ContactLaw& law) {
      return time_law(law, radii, one.path, one.asked, settings.repetitions);
    };
    LawTimes result{one.name, one.path_name, time(make_contact_law(one.choice, glass, glass)), std::nullopt};
    if (one.has_scalar) result.scalar = time(make_contact_law_scalar(one.choice, glass, glass));
    times.push_back(result);
    progress.update(static_cast<double>(times.size()) / static_cast<double>(3 + std::size(cases)));
  }
  return times;
}

}  // namespace osculate::app
