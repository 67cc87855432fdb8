// What a state holds, in order; and how much memory the engine takes.

#include <algorithm>
#include <array>
#include <type_traits>

#include "dynamics/engine.hpp"
#include "dynamics/state_pack.hpp"

namespace osculate {

const StateArray& State::at(std::string_view name) const {
  const auto found =
      std::find_if(arrays.begin(), arrays.end(), [&](const StateArray& array) { return array.name == name; });
  if (found == arrays.end()) throw InputError("state", "no array " + std::string(name), "one");
  return *found;
}

namespace {

/// A chunk's numbers of fixed count.
struct Header {
  std::uint64_t pairs, slots, kind, law, checked, contacts;
};
struct Totals {
  double viscous_loss, friction_loss, hysteresis_loss, stored_normal, stored_tangential, stiffest;
};
using Cache = std::array<double, ContactCaches::width>;

/// Stores one vector after another under one name.
class ChunkWriter {
 public:
  ChunkWriter(StateWriter& writer, std::vector<PairChunk>& chunks) : writer_(writer), chunks_(chunks) {}

  template <class Number, class Part, class Length>
  void field(const std::string& name, const Part& part, const Length&) {
    std::remove_cvref_t<decltype(part(chunks_.front()))> all;
    for (PairChunk& chunk : chunks_) {
      const auto& one = part(chunk);
      all.insert(all.end(), one.begin(), one.end());
    }
    writer_.template array<Number>(name, all);
  }

 private:
  StateWriter& writer_;
  std::vector<PairChunk>& chunks_;
};

/// Cuts it into the chunks' vectors again.
class ChunkReader {
 public:
  ChunkReader(StateReader& reader, std::vector<PairChunk>& chunks) : reader_(reader), chunks_(chunks) {}

  template <class Number, class Part, class Length>
  void field(const std::string& name, const Part& part, const Length& length) {
    std::remove_cvref_t<decltype(part(chunks_.front()))> all;
    reader_.template array<Number>(name, all);
    std::size_t begin = 0;
    for (PairChunk& chunk : chunks_) {
      const std::size_t count = length(chunk);
      if (all.size() - begin < count)
        throw InputError("state", "array " + name + " that ends early", "an entry for each pair or contact");
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin);
      part(chunk).assign(first, first + static_cast<std::ptrdiff_t>(count));
      begin += count;
    }
    if (begin != all.size())
      throw InputError("state", "array " + name + " that goes on", "an entry for each pair or contact");
  }

 private:
  StateReader& reader_;
  std::vector<PairChunk>& chunks_;
};

template <class Fields>
void visit_chunks(Fields& fields, const std::vector<Header>& headers, const World& world, const PairChunk* first) {
  const auto header = [&, first](const PairChunk& chunk) -> const Header& {
    return headers[static_cast<std::size_t>(&chunk - first)];
  };
  const auto pairs = [&](const PairChunk& chunk) { return header(chunk).pairs; };
  const auto slots = [&](const PairChunk& chunk) { return header(chunk).slots; };
  const auto law = [&](const PairChunk& chunk) -> const ContactLaw& {
    return world.setup.interactions[header(chunk).law].law;
  };
  const auto lines = [&](const PairChunk& chunk) { return slots(chunk) / law_lanes * law(chunk).memory_size(); };
  const auto couples = [&](const PairChunk& chunk) { return law(chunk).makes_couples() ? slots(chunk) : 0; };
  fields.template field<std::int32_t>(
      "pairs.bodies", [](PairChunk & c) -> auto& { return c.pairs; }, pairs);
  fields.template field<double>(
      "pairs.quiet_until", [](PairChunk & c) -> auto& { return c.quiet_until; }, pairs);
  fields.template field<std::int32_t>(
      "pairs.slot", [](PairChunk & c) -> auto& { return c.slot; }, pairs);
  fields.template field<std::int32_t>(
      "pairs.cache_state", [](PairChunk & c) -> auto& { return c.caches.states; }, pairs);
  fields.template field<std::int32_t>(
      "slots.owner", [](PairChunk & c) -> auto& { return c.slots.owner; }, slots);
  fields.template field<double>(
      "slots.memory", [](PairChunk & c) -> auto& { return c.slots.memory; }, lines);
  fields.template field<double>(
      "slots.reduced_mass", [](PairChunk & c) -> auto& { return c.slots.reduced_mass; }, slots);
  fields.template field<double>(
      "slots.effective_radius", [](PairChunk & c) -> auto& { return c.slots.effective_radius; }, slots);
  fields.template field<double>(
      "slots.force", [](PairChunk & c) -> auto& { return c.slots.force; }, slots);
  fields.template field<double>(
      "slots.point", [](PairChunk & c) -> auto& { return c.slots.point; }, slots);
  fields.template field<double>(
      "slots.couple", [](PairChunk & c) -> auto& { return c.slots.couple; }, couples);
}

Header header_of(const PairChunk& chunk) {
  return {chunk.pairs.size(),
          chunk.slots.size(),
          static_cast<std::uint64_t>(chunk.group.narrow_phase),
          static_cast<std::uint64_t>(chunk.group.law),
          static_cast<std::uint64_t>(chunk.checked),
          static_cast<std::uint64_t>(chunk.contacts)};
}

PairChunk chunk_of(const Header& header, const Totals& totals, const World& world) {
  if (header.law >= world.setup.interactions.size() || header.kind > 1 || header.slots % law_lanes != 0)
    throw InputError("state", "a pair list of another setup", "the setup that the state was made with");
  PairChunk chunk;
  chunk.group = {static_cast<NarrowPhase>(header.kind), static_cast<std::int32_t>(header.law)};
  chunk.checked = static_cast<std::int32_t>(header.checked);
  chunk.contacts = static_cast<std::int32_t>(header.contacts);
  chunk.viscous_loss = totals.viscous_loss;
  chunk.friction_loss = totals.friction_loss;
  chunk.hysteresis_loss = totals.hysteresis_loss;
  chunk.stored_normal = totals.stored_normal;
  chunk.stored_tangential = totals.stored_tangential;
  chunk.stiffest = totals.stiffest;
  return chunk;
}

void visit_pairs(PairList& list, const World& world, StateWriter& writer) {
  std::vector<Header> headers;
  std::vector<Totals> totals;
  std::vector<Cache> caches;
  for (const PairChunk& chunk : list.chunks) {
    headers.push_back(header_of(chunk));
    totals.push_back({chunk.viscous_loss, chunk.friction_loss, chunk.hysteresis_loss, chunk.stored_normal,
                      chunk.stored_tangential, chunk.stiffest});
    for (std::size_t k = 0; k < chunk.pairs.size(); ++k) {
      Cache& cache = caches.emplace_back();
      for (std::size_t n = 0; n < cache.size(); ++n) cache[n] = chunk.caches.columns[n][k];
    }
  }
  writer.array<std::uint64_t>("chunks.header", headers);
  writer.array<double>("chunks.totals", totals);
  writer.array<double>("pairs.cache", caches);
  ChunkWriter fields(writer, list.chunks);
  visit_chunks(fields, headers, world, list.chunks.data());
}

void visit_pairs(PairList& list, const World& world, StateReader& reader) {
  std::vector<Header> headers;
  std::vector<Totals> totals;
  std::vector<Cache> caches;
  reader.array<std::uint64_t>("chunks.header", headers);
  reader.array<double>("chunks.totals", totals);
  reader.array<double>("pairs.cache", caches);
  if (totals.size() != headers.size())
    throw InputError("state", "chunks.totals of another length", "that of chunks.header");
  list.chunks.clear();
  for (std::size_t c = 0; c < headers.size(); ++c) list.chunks.push_back(chunk_of(headers[c], totals[c], world));
  ChunkReader fields(reader, list.chunks);
  visit_chunks(fields, headers, world, list.chunks.data());
  std::size_t next = 0;
  for (PairChunk& chunk : list.chunks) {
    chunk.caches.resize(chunk.pairs.size());
    for (std::size_t k = 0; k < chunk.pairs.size(); ++k, ++next) {
      if (next == caches.size())
        throw InputError("state", "array pairs.cache that ends early", "an entry for each pair");
      for (std::size_t n = 0; n < caches[next].size(); ++n) chunk.caches.columns[n][k] = caches[next][n];
    }
  }
}

template <class Item>
std::size_t bytes(const std::vector<Item>& items) {
  return items.capacity() * sizeof(Item);
}

}  // namespace

template <class Self, class Visitor>
void Simulation::Engine::visit_state(Self& self, Visitor& visitor) {
  visitor.template array<double>("bodies.position", self.bodies_.position);
  visitor.template array<double>("bodies.orientation", self.bodies_.orientation);  // x, y, z, w
  visitor.template array<double>("bodies.velocity", self.bodies_.velocity);
  visitor.template array<double>("bodies.angular_momentum", self.bodies_.angular_momentum);
  visitor.template array<double>("bodies.force", self.bodies_.force);
  visitor.template array<double>("bodies.torque", self.bodies_.torque);
  visitor.template array<double>("bodies.travel", self.kinematics_.travel);
  visitor.value("extent", self.extent_);
  visitor.value("centre.x", self.centre_.x());
  visitor.value("centre.y", self.centre_.y());
  visitor.value("centre.z", self.centre_.z());
  visitor.value("driven_work", self.driven_work_);
  visitor.value("gravity_wrapped", self.gravity_wrapped_);
  visitor.value("steps", self.steps_);
  visitor.value("rebuilds", self.rebuilds_);
  visitor.value("losses.viscous", self.pairs_.viscous_loss);
  visitor.value("losses.friction", self.pairs_.friction_loss);
  visitor.value("losses.hysteresis", self.pairs_.hysteresis_loss);
  visit_pairs(self.pairs_, self.world_, visitor);
}

Simulation::Engine::Engine(const Setup& setup, const State& state)
    : world_(make_world(setup)), bodies_(make_bodies(world_)), threads_(setup.threads) {
  make_room();
  kinematics_.time_step = setup.time_step;
  StateReader reader(state);
  const std::size_t count = bodies_.size();
  visit_state(*this, reader);
  for (const std::size_t size :
       {bodies_.position.size(), bodies_.orientation.size(), bodies_.velocity.size(), bodies_.angular_momentum.size(),
        bodies_.force.size(), bodies_.torque.size(), kinematics_.travel.size()})
    if (size != count)
      throw InputError("state", std::to_string(size) + " bodies", std::to_string(count) + " as in the setup");
  for (const PairChunk& chunk : pairs_.chunks)
    for (const BodyPair& pair : chunk.pairs)
      if (pair.first < 0 || pair.second < 0 || static_cast<std::size_t>(std::max(pair.first, pair.second)) >= count)
        throw InputError("state", "a pair of bodies that do not exist", "indices below " + std::to_string(count));
  index_bodies(pairs_, count);
}

State Simulation::Engine::state() const {
  State state;
  StateWriter writer(state);
  auto& self = const_cast<Engine&>(*this);  // a writer changes nothing
  visit_state(self, writer);
  return state;
}

std::size_t Simulation::Engine::memory_bytes() const {
  std::size_t sum = bytes(bodies_.shape) + bytes(bodies_.material) + bytes(bodies_.motion) + bytes(bodies_.position) +
                    bytes(bodies_.orientation) + bytes(bodies_.velocity) + bytes(bodies_.angular_momentum) +
                    bytes(bodies_.force) + bytes(bodies_.torque) + bytes(bodies_.mass) + bytes(bodies_.inertia) +
                    bytes(kinematics_.velocity) + bytes(kinematics_.angular_velocity) +
                    bytes(kinematics_.mean_angular_velocity) + bytes(kinematics_.travel) + bytes(step_travel_) +
                    bytes(pairs_.first) + bytes(pairs_.incidences) + bytes(pairs_.chunks);
  for (const PairChunk& chunk : pairs_.chunks) {
    const Slots& slots = chunk.slots;
    sum += bytes(chunk.pairs) + bytes(chunk.quiet_until) + bytes(chunk.slot) + bytes(chunk.caches.states) +
           chunk.caches.size() * sizeof(Cache) + bytes(slots.owner) + bytes(slots.memory) + bytes(slots.reduced_mass) +
           bytes(slots.effective_radius) + bytes(slots.force) + bytes(slots.point) + bytes(slots.couple);
  }
  return sum;
}

}  // namespace osculate
