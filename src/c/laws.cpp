// Laws through the C API. A law keeps its memory in blocks of eight contacts, a host keeps it contact by contact: a
// part of the contacts at a time is gathered, evaluated and scattered.

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "c/boundary.hpp"
#include "c/handles.hpp"
#include "osculate/core/aligned_allocator.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace {

using namespace osculate;
using c::guarded;
using c::required;
using c::whole;

static_assert(OSCULATE_OPEN == static_cast<int>(LawStatus::open));
static_assert(OSCULATE_CLOSED == static_cast<int>(LawStatus::closed));
static_assert(OSCULATE_LARGE_CONTACT == static_cast<int>(LawStatus::large_contact));
static_assert(OSCULATE_LAW_NOT_CONVERGED == static_cast<int>(LawStatus::not_converged));
static_assert(OSCULATE_BAD_NUMBER == static_cast<int>(LawStatus::bad_input));

/// Contacts worked on at a time: whole blocks of memory that stay in the first level of cache.
constexpr std::size_t most_at_once = 8 * law_lanes;

LawChoice choice_of(std::span<const osculate_law_setting> settings) {
  LawChoice choice;
  for (const osculate_law_setting& setting : settings) {
    const std::string name = &required(setting.law, "settings, law");
    auto law = std::ranges::find(choice, name, &ChosenLaw::name);
    if (law == choice.end()) law = choice.insert(law, {name, {}});
    if (setting.parameter == nullptr) continue;
    if (!law->parameters.try_emplace(setting.parameter, setting.value).second)
      throw InputError(name, std::string("parameter ") + setting.parameter + " twice", "once");
  }
  return choice;
}

ElasticMaterial material_of(const osculate_material& material) {
  return {.youngs_modulus = material.youngs_modulus, .poissons_ratio = material.poissons_ratio};
}

template <class Real>
std::span<Real> column(Real* first, std::size_t size) {
  return first == nullptr ? std::span<Real>() : std::span<Real>(first, size);
}

template <class Real>
Vectors<Real> columns(Real* const (&first)[3], std::size_t size, const char* name) {
  if (!whole(first, name)) return {};
  return {{first[0], size}, {first[1], size}, {first[2], size}};
}

LawInput input_of(const osculate_approach_columns& from) {
  const std::size_t n = from.size;
  return {.R_i = column(from.R_i, n),
          .R_j = column(from.R_j, n),
          .overlap = column(from.overlap, n),
          .normal = columns(from.normal, n, "approach.normal"),
          .major_axis = columns(from.major_axis, n, "approach.major_axis"),
          .velocity = columns(from.velocity, n, "approach.velocity"),
          .angular_velocity = columns(from.angular_velocity, n, "approach.angular_velocity"),
          .mean_angular_velocity = columns(from.mean_angular_velocity, n, "approach.mean_angular_velocity"),
          .reduced_mass = column(from.reduced_mass, n),
          .effective_radius = column(from.effective_radius, n),
          .smallest_radius = column(from.smallest_radius, n),
          .time_step = from.time_step};
}

LawOutput output_of(const osculate_force_columns& to, std::size_t n) {
  return {.force = columns(to.force, n, "forces.force"),
          .couple = columns(to.couple, n, "forces.couple"),
          .normal_force = column(to.normal_force, n),
          .status = {},
          .a_c = column(to.a_c, n),
          .axis_ratio = column(to.axis_ratio, n),
          .stiffness = column(to.stiffness, n),
          .stored_normal = column(to.stored_normal, n),
          .stored_tangential = column(to.stored_tangential, n),
          .viscous_loss = column(to.viscous_loss, n),
          .friction_loss = column(to.friction_loss, n),
          .hysteresis_loss = column(to.hysteresis_loss, n)};
}

void require_needed(const osculate_approach_columns& approach, const osculate_force_columns& forces,
                    const ContactLaw& law) {
  const LawNeeds& needs = law.needs();
  required(approach.R_i, "approach.R_i");
  required(approach.R_j, "approach.R_j");
  required(approach.overlap, "approach.overlap");
  required(approach.normal[0], "approach.normal");
  required(approach.major_axis[0], "approach.major_axis");
  required(approach.velocity[0], "approach.velocity");
  if (needs.angular_velocity) required(approach.angular_velocity[0], "approach.angular_velocity");
  if (needs.mean_angular_velocity) required(approach.mean_angular_velocity[0], "approach.mean_angular_velocity");
  if (needs.reduced_mass) required(approach.reduced_mass, "approach.reduced_mass");
  if (needs.effective_radius) required(approach.effective_radius, "approach.effective_radius");
  required(forces.status, "forces.status");
  required(forces.force[0], "forces.force");
  if (law.makes_couples()) required(forces.couple[0], "forces.couple");
  required(forces.normal_force, "forces.normal_force");
}

/// Radii and axes of a part in which some gaps were skipped: an open contact's radii do not matter, but laws want some.
struct FilledGaps {
  std::array<double, most_at_once> R_i, R_j, x, y, z;

  /// The part with its skipped gaps filled in, or as it is if there are none.
  LawInput fill(LawInput part) {
    const std::size_t size = part.R_i.size();
    const auto skipped = [&](std::size_t i) {
      return part.R_j[i] == 0.0 && part.R_i[i] == 0.0 && part.overlap[i] < 0.0;
    };
    std::size_t first = 0;
    while (first < size && !skipped(first)) ++first;
    if (first == size) return part;
    for (std::size_t i = 0; i < size; ++i) {
      Vec3 axis(part.major_axis.x[i], part.major_axis.y[i], part.major_axis.z[i]);
      const bool fill = skipped(i);
      if (fill) axis = Vec3(part.normal.x[i], part.normal.y[i], part.normal.z[i]).unitOrthogonal();
      R_i[i] = fill ? 1.0 : part.R_i[i];
      R_j[i] = fill ? 1.0 : part.R_j[i];
      x[i] = axis.x(), y[i] = axis.y(), z[i] = axis.z();
    }
    const auto own = [size](const std::array<double, most_at_once>& values) {
      return std::span<const double>(values.data(), size);
    };
    part.R_i = own(R_i), part.R_j = own(R_j);
    part.major_axis = {own(x), own(y), own(z)};
    return part;
  }
};

/// Memories from one contact after another to blocks, and back. What fills up the last block is left as it is.
void gather(const unsigned char* bytes, std::size_t count, std::size_t entries, double* blocks) {
  for (std::size_t i = 0; i < count; ++i, bytes += entries * sizeof(double)) {
    double* const lane = blocks + i / law_lanes * entries * law_lanes + i % law_lanes;
    for (std::size_t m = 0; m < entries; ++m)
      std::memcpy(lane + m * law_lanes, bytes + m * sizeof(double), sizeof(double));
  }
}
void scatter(const double* blocks, std::size_t count, std::size_t entries, unsigned char* bytes) {
  for (std::size_t i = 0; i < count; ++i, bytes += entries * sizeof(double)) {
    const double* const lane = blocks + i / law_lanes * entries * law_lanes + i % law_lanes;
    for (std::size_t m = 0; m < entries; ++m)
      std::memcpy(bytes + m * sizeof(double), lane + m * law_lanes, sizeof(double));
  }
}

/// Evaluates all contacts and returns the first whose numbers were bad, or their count if there is none.
std::size_t evaluate(const osculate_law& handle, const osculate_approach_columns& approach, unsigned char* memories,
                     const osculate_force_columns& forces) {
  const ContactLaw& law = handle.law;
  const std::size_t size = approach.size, entries = law.memory_size(), bytes = entries * sizeof(double);
  const LawInput input = input_of(approach);
  LawOutput output = output_of(forces, size);
  require_needed(approach, forces, law);
  if (entries > 0) required(memories, "memory");
  const Vectors<double> couple = output.couple;
  if (!law.makes_couples()) output.couple = {};

  std::vector<double, AlignedAllocator<double>> memory(law.memory_length(std::min(size, most_at_once)));
  std::array<LawStatus, most_at_once> status;
  FilledGaps gaps;
  std::size_t first_bad = size;
  for (std::size_t start = 0; start < size; start += most_at_once) {
    const std::size_t count = std::min(most_at_once, size - start);
    gather(memories + start * bytes, count, entries, memory.data());
    LawOutput part = output.part(start, count);
    part.status = std::span(status).first(count);
    const LawInput in = input.part(start, count);
    law.evaluate(handle.acts_across_gaps ? in : gaps.fill(in), std::span(memory).first(law.memory_length(count)), part);
    scatter(memory.data(), count, entries, memories + start * bytes);
    for (std::size_t i = 0; i < count; ++i) {
      forces.status[start + i] = static_cast<std::int32_t>(status[i]);
      if (status[i] == LawStatus::bad_input) first_bad = std::min(first_bad, start + i);
    }
  }
  if (!law.makes_couples())
    for (const std::span<double> component : {couple.x, couple.y, couple.z}) std::ranges::fill(component, 0.0);
  return first_bad;
}

[[noreturn]] void refuse(const std::string& contact) {
  throw InputError(contact, "a number that is not finite or of the wrong sign",
                   "R_i >= R_j > 0, all that the law needs finite, masses and radii > 0");
}

}  // namespace

int osculate_new_law(size_t count, const osculate_law_setting* settings, const osculate_material* material_1,
                     const osculate_material* material_2, osculate_law** law) {
  return guarded("osculate_new_law", [&] {
    if (count > 0) required(settings, "settings");
    required(law, "law");
    const ElasticMaterial one = material_of(required(material_1, "material_1")),
                          two = material_of(required(material_2, "material_2"));
    ContactLaw made = make_contact_law(choice_of({settings, count}), one, two);
    const bool acts_across_gaps = made.interaction_range(1.0, 1.0) > 0.0;
    *law = new osculate_law{std::move(made), acts_across_gaps};
  });
}

void osculate_free_law(osculate_law* law) {
  delete law;
}

size_t osculate_memory_size(const osculate_law* law) {
  return law == nullptr ? 0 : law->law.memory_size() * sizeof(double);
}

int osculate_law_needs(const osculate_law* law) {
  if (law == nullptr) return 0;
  const LawNeeds& needs = law->law.needs();
  return (needs.angular_velocity ? OSCULATE_NEEDS_ANGULAR_VELOCITY : 0) |
         (needs.mean_angular_velocity ? OSCULATE_NEEDS_MEAN_ANGULAR_VELOCITY : 0) |
         (needs.reduced_mass ? OSCULATE_NEEDS_REDUCED_MASS : 0) |
         (needs.effective_radius ? OSCULATE_NEEDS_EFFECTIVE_RADIUS : 0) |
         (law->law.makes_couples() ? OSCULATE_MAKES_COUPLES : 0);
}

int osculate_interaction_range(const osculate_law* law, double R_i, double R_j, double* range) {
  return guarded("osculate_interaction_range",
                 [&] { required(range, "range") = required(law, "law").law.interaction_range(R_i, R_j); });
}

int osculate_evaluate_force(const osculate_law* law, const osculate_approach* approach, void* memory,
                            osculate_force* force) {
  return guarded("osculate_evaluate_force", [&] {
    const osculate_approach& from = required(approach, "approach");
    osculate_force& to = required(force, "force");
    const osculate_approach_columns in{
        .size = 1,
        .R_i = &from.R_i,
        .R_j = &from.R_j,
        .overlap = &from.overlap,
        .normal = {from.normal, from.normal + 1, from.normal + 2},
        .major_axis = {from.major_axis, from.major_axis + 1, from.major_axis + 2},
        .velocity = {from.velocity, from.velocity + 1, from.velocity + 2},
        .angular_velocity = {from.angular_velocity, from.angular_velocity + 1, from.angular_velocity + 2},
        .mean_angular_velocity = {from.mean_angular_velocity, from.mean_angular_velocity + 1,
                                  from.mean_angular_velocity + 2},
        .reduced_mass = &from.reduced_mass,
        .effective_radius = &from.effective_radius,
        .smallest_radius = from.smallest_radius == 0.0 ? nullptr : &from.smallest_radius,
        .time_step = from.time_step};
    osculate_force found{};
    const osculate_force_columns out{.status = &found.status,
                                     .force = {found.force, found.force + 1, found.force + 2},
                                     .couple = {found.couple, found.couple + 1, found.couple + 2},
                                     .normal_force = &found.normal_force,
                                     .a_c = &found.a_c,
                                     .axis_ratio = &found.axis_ratio,
                                     .stiffness = &found.stiffness,
                                     .stored_normal = &found.stored_normal,
                                     .stored_tangential = &found.stored_tangential,
                                     .viscous_loss = &found.viscous_loss,
                                     .friction_loss = &found.friction_loss,
                                     .hysteresis_loss = &found.hysteresis_loss};
    const bool bad = evaluate(required(law, "law"), in, static_cast<unsigned char*>(memory), out) == 0;
    to = found;
    if (bad) refuse("approach");
  });
}

int osculate_evaluate_forces(const osculate_law* law, const osculate_approach_columns* approach, void* memories,
                             const osculate_force_columns* forces) {
  return guarded("osculate_evaluate_forces", [&] {
    const osculate_approach_columns& from = required(approach, "approach");
    const std::size_t first_bad =
        evaluate(required(law, "law"), from, static_cast<unsigned char*>(memories), required(forces, "forces"));
    if (first_bad < from.size) refuse("contact " + std::to_string(first_bad));
  });
}
