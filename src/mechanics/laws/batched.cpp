#include "mechanics/laws/batched.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "mechanics/laws/spring.hpp"
#include "mechanics/spring_contacts.hpp"
#include "osculate/mechanics/damped_hertz.hpp"
#include "osculate/mechanics/hertzian_tangential.hpp"
#include "osculate/mechanics/mindlin_contacts.hpp"
#include "osculate/mechanics/tangential_springs.hpp"

namespace osculate::laws {
namespace {

std::string name_of(const ChosenBySlot& chosen, LawSlot slot) {
  const auto found = chosen.find(slot);
  return found == chosen.end() ? "" : found->second->name;
}

double parameter(const ChosenBySlot& chosen, LawSlot slot, const std::string& name) {
  return chosen.at(slot)->parameters.at(name);
}

/// The dashpot along the normal, A dF/dδ + α (m k)^{1/2} δ^{1/4}.
struct Dashpot {
  double time = 0.0;
  double factor = 0.0;
};

std::optional<Dashpot> dashpot_of(const ChosenBySlot& chosen) {
  const std::string name = name_of(chosen, LawSlot::dissipation);
  if (name.empty()) return Dashpot{};
  if (name == "brilliantov") return Dashpot{.time = parameter(chosen, LawSlot::dissipation, "dissipative_time")};
  if (name == "tsuji")
    return Dashpot{.factor = damped_hertz::tsuji_factor(parameter(chosen, LawSlot::dissipation, "restitution"),
                                                        Attraction::cut_off)};
  return std::nullopt;
}

static_assert(stretch % law_lanes == 0);

LawStatus said(mindlin::BatchStatus status) {
  switch (status) {
    case mindlin::BatchStatus::pressed:
      return LawStatus::closed;
    case mindlin::BatchStatus::open:
      return LawStatus::open;
    case mindlin::BatchStatus::bad_input:
      break;
  }
  return LawStatus::bad_input;
}

void evaluate_mindlin(const mindlin::Pair& pair, const LawInput& input, double* memory, const LawOutput& output) {
  alignas(64) std::array<std::array<double, stretch>, 6> scratch;
  auto& [rate, x, y, z, spin, power] = scratch;
  std::array<mindlin::BatchStatus, stretch> status;
  std::array<double, stretch> radius;
  auto* blocks = reinterpret_cast<mindlin::MemoryBlock*>(memory);
  const double time_step = input.time_step;
  const auto& [vx, vy, vz] = input.velocity;
  const auto& [wx, wy, wz] = input.mean_angular_velocity;
  const auto& [nx, ny, nz] = input.normal;
  for (std::size_t start = 0; start < input.R_i.size(); start += stretch) {
    const std::size_t count = std::min(stretch, input.R_i.size() - start);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = start + i;
      rate[i] = -(vx[k] * nx[k] + vy[k] * ny[k] + vz[k] * nz[k]);
      spin[i] = time_step * (wx[k] * nx[k] + wy[k] * ny[k] + wz[k] * nz[k]);
      x[i] = time_step * vx[k], y[i] = time_step * vy[k], z[i] = time_step * vz[k];
    }
    const LawInput in = input.part(start, count);
    const LawOutput out = output.part(start, count);
    const auto column = [count](std::array<double, stretch>& of) { return std::span<double>(of.data(), count); };
    const bool asks_size = out.a_c.empty() && !in.smallest_radius.empty();
    const std::span<double> a_c = asks_size ? column(radius) : out.a_c;
    mindlin::contacts(pair,
                      {.R_i = in.R_i,
                       .R_j = in.R_j,
                       .overlap = in.overlap,
                       .overlap_rate = column(rate),
                       .normal = in.normal,
                       .major_axis = in.major_axis,
                       .displacement = {column(x), column(y), column(z)},
                       .spin = column(spin),
                       .reduced_mass = in.reduced_mass},
                      {blocks + start / law_lanes, (count + law_lanes - 1) / law_lanes},
                      {.force = out.force,
                       .normal_force = out.normal_force,
                       .a_c = a_c,
                       .axis_ratio = out.axis_ratio,
                       .status = {status.data(), count},
                       .stiffness = out.stiffness,
                       .stored_normal = out.stored_normal,
                       .stored_tangential = out.stored_tangential,
                       .viscous_power = out.viscous_loss.empty() ? std::span<double>() : column(power),
                       .friction_loss = out.friction_loss});
    for (std::size_t i = 0; i < out.viscous_loss.size(); ++i) out.viscous_loss[i] = time_step * power[i];
    std::ranges::fill(out.hysteresis_loss, 0.0);
    for (std::size_t i = 0; i < count; ++i) out.status[i] = said(status[i]);
    for (std::size_t i = 0; i < in.smallest_radius.size(); ++i)
      if (out.status[i] == LawStatus::closed && !(a_c[i] < 0.5 * in.smallest_radius[i]))
        out.status[i] = LawStatus::large_contact;
  }
}

ContactLaw mindlin_law(const mindlin::Pair& pair) {
  return {{.memory_size = sizeof(mindlin::MemoryBlock) / sizeof(double) / law_lanes,
           .needs = {.mean_angular_velocity = true, .reduced_mass = pair.damping_factor > 0.0}},
          [pair](const LawInput& input, double* memory, const LawOutput& output) {
            evaluate_mindlin(pair, input, memory, output);
          }};
}

ContactLaw spring_law(const spring_contacts::Pair& pair) {
  const bool rubs = pair.kind == spring_contacts::Friction::spring;
  return {{.memory_size = rubs ? spring_memory : 0,
           .needs = {.mean_angular_velocity = rubs, .reduced_mass = pair.damping_factor > 0.0}},
          [pair](const LawInput& input, double* memory, const LawOutput& output) {
            spring_contacts::evaluate(pair, input, memory, output);
          }};
}

}  // namespace

std::optional<ContactLaw> batched(const ChosenBySlot& chosen, const ElasticMaterial& material_1,
                                  const ElasticMaterial& material_2) {
  constexpr std::array batched_slots{LawSlot::normal, LawSlot::dissipation, LawSlot::tangential};
  for (const auto& [slot, law] : chosen)
    if (std::ranges::find(batched_slots, slot) == batched_slots.end()) return std::nullopt;
  if (name_of(chosen, LawSlot::normal) != "hertz") return std::nullopt;
  const auto dashpot = dashpot_of(chosen);
  if (!dashpot) return std::nullopt;

  const std::string friction = name_of(chosen, LawSlot::tangential);
  const auto number = [&](const char* name) { return parameter(chosen, LawSlot::tangential, name); };
  if (friction == "mindlin") {
    auto pair = mindlin::pair(material_1, material_2, number("friction"), dashpot->time);
    pair.damping_factor = dashpot->factor;
    return mindlin_law(pair);
  }
  spring_contacts::Pair pair{.kind = spring_contacts::Friction::spring,
                             .modulus = effective_modulus(material_1, material_2),
                             .damping_time = dashpot->time,
                             .damping_factor = dashpot->factor};
  const double no_slip =
      tangential_springs::stiffness_ratio(pair.modulus, effective_shear_modulus(material_1, material_2));
  if (friction.empty()) {
    pair.kind = spring_contacts::Friction::none;
    return spring_law(pair);
  }
  if (friction == "cundall_strack") {
    pair.friction = number("friction");
    pair.tangential_stiffness = number("tangential_stiffness");
    pair.tangential_damping = number("tangential_damping");
    return spring_law(pair);
  }
  if (friction == "di_renzo") {
    pair.friction = number("friction");
    pair.stiffness_ratio = 2.0 / 3.0 * no_slip;
    return spring_law(pair);
  }
  // With a dashpot Tsuji's slider is another one: it limits the spring alone, then the sum.
  if (friction == "tsuji_tangential" && number("tangential_damping") == 0.0) {
    pair.friction = number("friction");
    pair.stiffness_ratio = no_slip;
    return spring_law(pair);
  }
  return std::nullopt;
}

}  // namespace osculate::laws
