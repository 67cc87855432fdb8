#include "osculate/mechanics/contact_law.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

constexpr const char* place = "ContactLaw::evaluate";

template <class Real>
std::span<Real> part_of(std::span<Real> column, std::size_t start, std::size_t count) {
  return column.empty() ? column : column.subspan(start, count);
}

enum class Presence : std::uint8_t { required, optional };

class Lengths {
 public:
  explicit Lengths(std::size_t size) : size_(size) {}

  template <class Column>
  void check(const char* name, const Column& column, Presence presence = Presence::required) const {
    if (column.size() == size_ || (presence == Presence::optional && column.empty())) return;
    throw InputError(place, std::string(name) + " of " + std::to_string(column.size()) + " values",
                     std::to_string(size_) + " as in R_i");
  }
  template <class Real>
  void check(const char* name, const Vectors<Real>& columns, Presence presence = Presence::required) const {
    for (const auto& column : {columns.x, columns.y, columns.z}) check(name, column, presence);
    if (columns.x.size() != columns.y.size() || columns.x.size() != columns.z.size())
      throw InputError(place, std::string(name) + " with some of its components", "all three, or none");
  }

 private:
  std::size_t size_;
};

Presence needed(bool need) {
  return need ? Presence::required : Presence::optional;
}

}  // namespace

std::string_view name(LawStatus status) {
  switch (status) {
    case LawStatus::open:
      return "open";
    case LawStatus::closed:
      return "closed";
    case LawStatus::large_contact:
      return "large contact";
    case LawStatus::not_converged:
      return "not converged";
    case LawStatus::bad_input:
      return "bad input";
  }
  return "unknown";
}

LawInput LawInput::part(std::size_t start, std::size_t count) const {
  return {.R_i = part_of(R_i, start, count),
          .R_j = part_of(R_j, start, count),
          .overlap = part_of(overlap, start, count),
          .normal = normal.part(start, count),
          .major_axis = major_axis.part(start, count),
          .velocity = velocity.part(start, count),
          .angular_velocity = angular_velocity.part(start, count),
          .mean_angular_velocity = mean_angular_velocity.part(start, count),
          .reduced_mass = part_of(reduced_mass, start, count),
          .effective_radius = part_of(effective_radius, start, count),
          .smallest_radius = part_of(smallest_radius, start, count),
          .time_step = time_step};
}

LawOutput LawOutput::part(std::size_t start, std::size_t count) const {
  return {.force = force.part(start, count),
          .couple = couple.part(start, count),
          .normal_force = part_of(normal_force, start, count),
          .status = part_of(status, start, count),
          .a_c = part_of(a_c, start, count),
          .axis_ratio = part_of(axis_ratio, start, count),
          .stiffness = part_of(stiffness, start, count),
          .stored_normal = part_of(stored_normal, start, count),
          .stored_tangential = part_of(stored_tangential, start, count),
          .viscous_loss = part_of(viscous_loss, start, count),
          .friction_loss = part_of(friction_loss, start, count),
          .hysteresis_loss = part_of(hysteresis_loss, start, count)};
}

ContactLaw::ContactLaw(const Traits& traits, LawEvaluation evaluation)
    : traits_(traits), evaluation_(std::move(evaluation)) {}

std::size_t ContactLaw::memory_length(std::size_t contacts) const {
  return (contacts + law_lanes - 1) / law_lanes * law_lanes * traits_.memory_size;
}

double ContactLaw::interaction_range(double R_i, double R_j) const {
  if (!(R_j > 0.0) || !(R_i >= R_j))
    throw InputError("ContactLaw::interaction_range", "radii " + std::to_string(R_i) + ", " + std::to_string(R_j),
                     "R_i >= R_j > 0 [m]");
  return traits_.range ? traits_.range(R_i, R_j) : 0.0;
}

void ContactLaw::evaluate(const LawInput& input, std::span<double> memory, const LawOutput& output) const {
  const Lengths lengths(input.R_i.size());
  lengths.check("R_j", input.R_j);
  lengths.check("overlap", input.overlap);
  lengths.check("normal", input.normal);
  lengths.check("major axis", input.major_axis);
  lengths.check("velocity", input.velocity);
  lengths.check("angular velocity", input.angular_velocity, needed(traits_.needs.angular_velocity));
  lengths.check("mean angular velocity", input.mean_angular_velocity, needed(traits_.needs.mean_angular_velocity));
  lengths.check("reduced mass", input.reduced_mass, needed(traits_.needs.reduced_mass));
  lengths.check("effective radius", input.effective_radius, needed(traits_.needs.effective_radius));
  lengths.check("smallest radius", input.smallest_radius, Presence::optional);
  lengths.check("force", output.force);
  lengths.check("couple", output.couple, needed(traits_.makes_couples));
  lengths.check("normal force", output.normal_force);
  lengths.check("status", output.status);
  lengths.check("major semi-axis", output.a_c, Presence::optional);
  lengths.check("axis ratio", output.axis_ratio, Presence::optional);
  lengths.check("stiffness", output.stiffness, Presence::optional);
  lengths.check("stored normal energy", output.stored_normal, Presence::optional);
  lengths.check("stored tangential energy", output.stored_tangential, Presence::optional);
  lengths.check("viscous loss", output.viscous_loss, Presence::optional);
  lengths.check("friction loss", output.friction_loss, Presence::optional);
  lengths.check("hysteresis loss", output.hysteresis_loss, Presence::optional);
  if (memory.size() != memory_length(input.R_i.size()))
    throw InputError(
        place, "a memory of " + std::to_string(memory.size()) + " doubles",
        std::to_string(memory_length(input.R_i.size())) + " for " + std::to_string(input.R_i.size()) + " contacts");
  if (!(input.time_step >= 0.0) || !std::isfinite(input.time_step))
    throw InputError(place, "time step " + std::to_string(input.time_step), "a finite value >= 0 [s]");
  evaluation_(input, memory.data(), output);
}

}  // namespace osculate
