#include "mechanics/laws/composed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "osculate/core/aligned_allocator.hpp"

namespace osculate::laws {
namespace {

Vec3 at(const Vectors<const double>& columns, std::size_t i) {
  return columns.x.empty() ? Vec3::Zero() : Vec3(columns.x[i], columns.y[i], columns.z[i]);
}

double at(std::span<const double> column, std::size_t i) {
  return column.empty() ? 0.0 : column[i];
}

void put(const Vec3& value, const Vectors<double>& columns, std::size_t i) {
  if (columns.x.empty()) return;
  columns.x[i] = value.x(), columns.y[i] = value.y(), columns.z[i] = value.z();
}

template <class Value>
void put(Value value, std::span<Value> column, std::size_t i) {
  if (!column.empty()) column[i] = value;
}

Contact contact_at(const LawInput& input, std::size_t i) {
  Contact contact{};
  contact.R_j = input.R_j[i];
  contact.R_i = std::min(input.R_i[i], largest_radius_ratio * contact.R_j);
  contact.overlap = input.overlap[i];
  contact.normal = at(input.normal, i);
  contact.major = at(input.major_axis, i);
  contact.minor = contact.normal.cross(contact.major);
  const Vec3 velocity = at(input.velocity, i);
  contact.rate = -velocity.dot(contact.normal);
  contact.velocity = {velocity.dot(contact.major), velocity.dot(contact.minor)};
  contact.reduced_mass = at(input.reduced_mass, i);
  contact.effective_radius = at(input.effective_radius, i);
  contact.time_step = input.time_step;
  contact.angular_velocity = at(input.angular_velocity, i);
  contact.spin = at(input.mean_angular_velocity, i).dot(contact.normal) * input.time_step;
  return contact;
}

bool is_sound(const Contact& contact, const LawInput& input, std::size_t i, const LawNeeds& needs) {
  const double all = std::fabs(contact.overlap) + std::fabs(contact.rate) + contact.normal.cwiseAbs().sum() +
                     contact.major.cwiseAbs().sum() + std::fabs(contact.velocity.x) + std::fabs(contact.velocity.y) +
                     contact.angular_velocity.cwiseAbs().sum() + std::fabs(contact.spin);
  if (!std::isfinite(all)) return false;
  if (!(contact.R_j > 0.0) || !std::isfinite(contact.R_j) || !(input.R_i[i] >= contact.R_j)) return false;
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  return (!needs.reduced_mass || positive(contact.reduced_mass)) &&
         (!needs.effective_radius || positive(contact.effective_radius));
}

LawStatus status_of(const Contact& contact, const LawInput& input, std::size_t i) {
  if (!contact.converged) return LawStatus::not_converged;
  if (!contact.closed) return LawStatus::open;
  const bool large = !input.smallest_radius.empty() && !(contact.a_c < 0.5 * input.smallest_radius[i]);
  return large ? LawStatus::large_contact : LawStatus::closed;
}

void write(const Contact& contact, LawStatus status, const LawOutput& output, std::size_t i) {
  put(Vec3(contact.force.x * contact.major + contact.force.y * contact.minor - contact.normal_force() * contact.normal),
      output.force, i);
  put(contact.couple, output.couple, i);
  output.normal_force[i] = contact.normal_force();
  output.status[i] = status;
  put(contact.a_c, output.a_c, i);
  put(contact.axis_ratio, output.axis_ratio, i);
  put(contact.stiffness, output.stiffness, i);
  put(contact.stored_normal, output.stored_normal, i);
  put(contact.stored_tangential, output.stored_tangential, i);
  put(contact.viscous_loss, output.viscous_loss, i);
  put(contact.friction_loss, output.friction_loss, i);
  put(contact.hysteresis_loss, output.hysteresis_loss, i);
}

Contact nothing() {
  Contact contact{};
  contact.normal = contact.major = contact.minor = Vec3::Zero();
  return contact;
}

void add_to(ContactLaw::Traits& traits, const std::vector<BoundPart>& parts) {
  for (const auto& [part, memory] : parts) {
    traits.memory_size += memory;
    traits.needs.angular_velocity |= part.needs.angular_velocity;
    traits.needs.mean_angular_velocity |= part.needs.mean_angular_velocity;
    traits.needs.reduced_mass |= part.needs.reduced_mass;
    traits.needs.effective_radius |= part.needs.effective_radius;
    traits.makes_couples |= part.makes_couples;
    if (part.range) traits.range = part.range;
  }
}

/// What the parts that follow a law in batches add to its answer.
void add(const Contact& contact, const LawOutput& output, std::size_t i) {
  const Vec3 force = contact.force.x * contact.major + contact.force.y * contact.minor;
  output.force.x[i] += force.x(), output.force.y[i] += force.y(), output.force.z[i] += force.z();
  put(contact.couple, output.couple, i);
  const auto more = [i](double value, std::span<double> column) {
    if (!column.empty()) column[i] += value;
  };
  more(contact.stored_tangential, output.stored_tangential);
  more(contact.friction_loss, output.friction_loss);
}

}  // namespace

ContactLaw followed(const ContactLaw& first, const std::vector<BoundPart>& parts) {
  ContactLaw::Traits traits{.memory_size = first.memory_size(), .needs = first.needs()};
  add_to(traits, parts);
  const auto evaluation = [first, parts, needs = traits.needs, size = traits.memory_size](
                              const LawInput& input, double* memory, const LawOutput& output) {
    std::array<double, stretch> overlap, a_c, axis_ratio;
    std::array<Contact, stretch> contacts;
    std::array<Memory, stretch> memories;
    std::array<std::size_t, stretch> place;
    const std::size_t own = first.memory_size() * law_lanes, all = size * law_lanes;  // of a block
    std::vector<double, AlignedAllocator<double>> own_memory(stretch / law_lanes * own);
    for (std::size_t start = 0; start < input.R_i.size(); start += stretch) {
      const std::size_t size_here = std::min(stretch, input.R_i.size() - start);
      LawInput in = input.part(start, size_here);
      LawOutput out = output.part(start, size_here);
      if (out.a_c.empty()) out.a_c = std::span(a_c).first(size_here);
      if (out.axis_ratio.empty()) out.axis_ratio = std::span(axis_ratio).first(size_here);
      for (std::size_t i = 0; i < size_here; ++i) {
        contacts[i] = contact_at(in, i);
        // What is unsound to those that follow must be so to the first, which else would remember it.
        overlap[i] = is_sound(contacts[i], in, i, needs) ? in.overlap[i] : std::numeric_limits<double>::quiet_NaN();
      }
      in.overlap = std::span<const double>(overlap).first(size_here);

      // The first law's entries are the first of each block; it wants blocks of these alone.
      double* blocks = memory + start * size;
      const std::size_t block_count = (size_here + law_lanes - 1) / law_lanes;
      for (std::size_t b = 0; b < block_count; ++b) std::copy_n(blocks + b * all, own, own_memory.data() + b * own);
      first.evaluate(in, std::span(own_memory).first(block_count * own), out);
      for (std::size_t b = 0; b < block_count; ++b) std::copy_n(own_memory.data() + b * own, own, blocks + b * all);

      std::size_t count = 0;  // of sound ones
      for (std::size_t i = 0; i < size_here; ++i) {
        if (out.status[i] == LawStatus::bad_input) {
          put(Vec3(Vec3::Zero()), out.couple, i);
          continue;
        }
        if (count < i) contacts[count] = contacts[i];
        Contact& contact = contacts[count];
        contact.closed = out.status[i] != LawStatus::open;
        contact.a_c = out.a_c[i], contact.axis_ratio = out.axis_ratio[i];
        contact.friction_load = out.normal_force[i];  // the dashpot's share is in it
        place[count++] = i;
      }
      std::size_t entry = first.memory_size();
      for (const auto& [part, length] : parts) {
        for (std::size_t k = 0; k < count; ++k)
          memories[k] = Memory(blocks + place[k] / law_lanes * all + entry * law_lanes + place[k] % law_lanes);
        part.step(std::span(contacts).first(count), std::span<const Memory>(memories).first(count));
        entry += length;
      }
      for (std::size_t k = 0; k < count; ++k) add(contacts[k], out, place[k]);
    }
  };
  return {traits, evaluation};
}

ContactLaw composed(const std::vector<BoundPart>& parts) {
  ContactLaw::Traits traits;
  add_to(traits, parts);
  const auto evaluation = [parts, needs = traits.needs, size = traits.memory_size](
                              const LawInput& input, double* memory, const LawOutput& output) {
    std::array<Contact, stretch> contacts;
    std::array<std::size_t, stretch> place;
    std::array<Memory, stretch> memories;
    for (std::size_t start = 0; start < input.R_i.size(); start += stretch) {
      const std::size_t end = std::min(start + stretch, input.R_i.size());
      std::size_t count = 0;  // of sound ones
      for (std::size_t i = start; i < end; ++i) {
        contacts[count] = contact_at(input, i);
        place[count] = i;
        if (is_sound(contacts[count], input, i, needs))
          ++count;
        else
          write(nothing(), LawStatus::bad_input, output, i);
      }
      std::size_t entry = 0;
      for (const auto& [part, length] : parts) {
        for (std::size_t k = 0; k < count; ++k)
          memories[k] = Memory(memory + (place[k] / law_lanes * size + entry) * law_lanes + place[k] % law_lanes);
        part.step(std::span(contacts).first(count), std::span<const Memory>(memories).first(count));
        entry += length;
      }
      for (std::size_t k = 0; k < count; ++k)
        write(contacts[k], status_of(contacts[k], input, place[k]), output, place[k]);
    }
  };
  return {traits, evaluation};
}

}  // namespace osculate::laws
