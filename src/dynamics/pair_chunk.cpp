#include "dynamics/pair_chunk.hpp"

#include <algorithm>
#include <iterator>

namespace osculate {

std::span<double> read_memory(const Slots& slots, std::size_t slot, std::span<double> values) {
  const std::size_t first = slot / law_lanes * values.size();
  for (std::size_t m = 0; m < values.size(); ++m) values[m] = slots.memory[first + m].lanes[slot % law_lanes];
  return values;
}

void write_memory(Slots& slots, std::size_t slot, std::span<const double> values) {
  const std::size_t first = slot / law_lanes * values.size();
  for (std::size_t m = 0; m < values.size(); ++m) slots.memory[first + m].lanes[slot % law_lanes] = values[m];
}

std::size_t take_slot(PairChunk& chunk, std::size_t pair, const ContactLaw& law) {
  Slots& slots = chunk.slots;
  const auto found = std::find(slots.owner.begin(), slots.owner.end(), Slots::unused);
  const auto slot = static_cast<std::size_t>(std::distance(slots.owner.begin(), found));
  if (found == slots.owner.end()) {
    const std::size_t size = slots.size() + law_lanes;  // whole blocks: the law works on all of them
    slots.owner.resize(size, Slots::unused);
    slots.memory.resize(size / law_lanes * law.memory_size(), MemoryLine{});
    slots.reduced_mass.resize(size, 1.0);
    slots.effective_radius.resize(size, 1.0);
    slots.force.resize(size, Vec3::Zero());
    slots.point.resize(size, Vec3::Zero());
    if (law.makes_couples()) slots.couple.resize(size, Vec3::Zero());
  }
  slots.owner[slot] = static_cast<std::int32_t>(pair);
  chunk.slot[pair] = static_cast<std::int32_t>(slot);
  return slot;
}

}  // namespace osculate
