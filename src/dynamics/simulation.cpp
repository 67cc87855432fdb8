#include "osculate/dynamics/simulation.hpp"

#include "dynamics/engine.hpp"

namespace osculate {

Simulation::Simulation(const Setup& setup) : engine_(std::make_unique<Engine>(setup)) {}
Simulation::Simulation(const Setup& setup, const State& state) : engine_(std::make_unique<Engine>(setup, state)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance(std::uint64_t steps) {
  engine_->advance(steps);
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
const PeriodicBox& Simulation::box() const {
  return engine_->box();
}
const Bodies& Simulation::bodies() const {
  return engine_->bodies();
}
std::int32_t Simulation::first_face(std::size_t mesh) const {
  return engine_->world().first_face.at(mesh);
}
std::span<const Poured> Simulation::poured() const {
  return engine_->poured();
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
std::size_t Simulation::contact_bytes() const {
  return engine_->contact_bytes();
}
State Simulation::state() const {
  return engine_->state();
}

std::vector<Contact> Simulation::contacts() const {
  return engine_->contacts();
}

}  // namespace osculate
