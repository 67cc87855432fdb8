#include "osculate/dynamics/simulation.hpp"

#include "dynamics/engine.hpp"

namespace osculate {

Simulation::Simulation(const Setup& setup) : engine_(std::make_unique<Engine>(setup)) {}
Simulation::Simulation(const Setup& setup, const State& state) : engine_(std::make_unique<Engine>(setup, state)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance(std::uint64_t steps) {
  for (std::uint64_t i = 0; i < steps; ++i) engine_->step();
}

double Simulation::time() const {
  return engine_->time();
}
std::uint64_t Simulation::steps() const {
  return engine_->steps();
}
const Setup& Simulation::setup() const {
  return engine_->world().setup;
}
const Bodies& Simulation::bodies() const {
  return engine_->bodies();
}
std::span<const BodyShape> Simulation::shapes() const {
  return engine_->world().shapes;
}
EnergyLedger Simulation::energy() const {
  return engine_->energy();
}
StepCounts Simulation::counts() const {
  return engine_->counts();
}
StageTimes Simulation::times() const {
  return engine_->times();
}
std::size_t Simulation::memory_bytes() const {
  return engine_->memory_bytes();
}
State Simulation::state() const {
  return engine_->state();
}

std::vector<Contact> Simulation::contacts() const {
  std::vector<Contact> contacts;
  const World& world = engine_->world();
  const Bodies& bodies = engine_->bodies();
  std::vector<std::int32_t> slots;
  for (const PairChunk& chunk : engine_->pairs().chunks) {
    const ContactColumns geometry = slot_geometry(chunk, world, bodies, slots);
    for (std::size_t row = 0; row < slots.size(); ++row) {
      const auto slot = static_cast<std::size_t>(slots[row]);
      const BodyPair& pair = chunk.pairs[static_cast<std::size_t>(chunk.slots.owner[slot])];
      const ContactGeometry found = geometry.get(row);
      const Vec3 difference = bodies.position[static_cast<std::size_t>(pair.second)] -
                              bodies.position[static_cast<std::size_t>(pair.first)];
      const PeriodicBox& box = world.setup.box;
      const Vec3 shift = box.repeats() ? nearest_image_shift(box, difference) : Vec3::Zero();
      contacts.push_back({.body_1 = pair.first,
                          .body_2 = pair.second,
                          .point = chunk.slots.point[slot],
                          .normal = found.normal,
                          .overlap = found.overlap,
                          .force = chunk.slots.force[slot],
                          .couple = chunk.slots.couple.empty() ? Vec3::Zero() : chunk.slots.couple[slot],
                          .branch = difference + shift});
    }
  }
  return contacts;
}

}  // namespace osculate
