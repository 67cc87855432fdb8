// What a state holds, in order; and how much memory the engine takes.

#include <algorithm>
#include <array>
#include <string>

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
  std::uint64_t bodies, far, contacts, narrow_phase, law, checked;
};
struct Totals {
  double viscous_loss, friction_loss, hysteresis_loss, curvature_gain, stored_normal, stored_tangential, stiffest;
};

/// A contact's cache as numbers: all its vectors. A far pair has floats of its own.
using CacheNumbers = std::array<double, 6 * 3>;
using FarNumbers = std::array<double, std::tuple_size_v<decltype(FarCache::numbers)>>;
CacheNumbers numbers_of(const ContactCache& cache) {
  CacheNumbers numbers{};
  std::size_t k = 0;
  for (const Vec3* vector :
       {&cache.point_1, &cache.normal_1, &cache.point_2, &cache.normal_2, &cache.shape_1, &cache.shape_2})
    for (const double value : *vector) numbers[k++] = value;
  return numbers;
}
FarNumbers numbers_of(const FarCache& cache) {
  FarNumbers numbers{};
  std::copy(cache.numbers.begin(), cache.numbers.end(), numbers.begin());
  return numbers;
}
ContactCache::State state_of(std::int32_t state) {
  if (state < 0 || state > static_cast<std::int32_t>(ContactCache::State::separation))
    throw InputError("state", "cache state " + std::to_string(state), "0, 1 or 2");
  return static_cast<ContactCache::State>(state);
}
ContactCache cache_of(const CacheNumbers& numbers, std::int32_t state) {
  const auto vector = [&](std::size_t k) { return Vec3(numbers[k], numbers[k + 1], numbers[k + 2]); };
  return {state_of(state), vector(0), vector(3), vector(6), vector(9), vector(12), vector(15)};
}
FarCache far_cache_of(const FarNumbers& numbers) {
  FarCache cache;
  std::transform(numbers.begin(), numbers.end(), cache.numbers.begin(),
                 [](double number) { return static_cast<float>(number); });
  return cache;
}

/// A pair's places as numbers of the width that states know.
BodyPair wide(const LocalPair& pair) {
  return {pair.first, pair.second};
}
LocalPair narrow(const BodyPair& pair, const PairChunk& chunk) {
  const auto count = static_cast<std::int32_t>(chunk.bodies.size());
  if (std::min(pair.first, pair.second) < 0 || std::max(pair.first, pair.second) >= count)
    throw InputError("state", "a pair of bodies that its chunk does not have", "places below " + std::to_string(count));
  return {static_cast<std::uint16_t>(pair.first), static_cast<std::uint16_t>(pair.second)};
}

/// What is stored of all pairs, chunk after chunk.
struct FlatPairs {
  std::vector<Header> headers;
  std::vector<Totals> totals;
  std::vector<std::int32_t> bodies;
  std::vector<BodyPair> far;
  std::vector<double> far_quiet;
  std::vector<FarNumbers> far_cache;
  std::vector<BodyPair> contacts;
  std::vector<std::int32_t> contact_state;
  std::vector<CacheNumbers> contact_cache;
  std::vector<MemoryLine> memory;
  std::vector<PairConstants> constants;
  std::vector<NormalSpring> spring;
  std::vector<Vec3> force, couple;

  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor.template array<std::uint64_t>("chunks.header", headers);
    visitor.template array<double>("chunks.totals", totals);
    visitor.template array<std::int32_t>("chunks.bodies", bodies);
    visitor.template array<std::int32_t>("far.bodies", far);
    visitor.template array<double>("far.quiet_until", far_quiet);
    visitor.template array<double>("far.cache", far_cache);
    visitor.template array<std::int32_t>("contacts.bodies", contacts);
    visitor.template array<std::int32_t>("contacts.cache_state", contact_state);
    visitor.template array<double>("contacts.cache", contact_cache);
    visitor.template array<double>("contacts.memory", memory);
    visitor.template array<double>("contacts.constants", constants);
    visitor.template array<double>("contacts.spring", spring);
    visitor.template array<double>("contacts.force", force);
    visitor.template array<double>("contacts.couple", couple);
  }
};

template <class Item>
void append(std::vector<Item>& all, const std::vector<Item>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

FlatPairs flat(const PairList& list) {
  FlatPairs all;
  for (const PairChunk& chunk : list.chunks) {
    const Contacts& contacts = chunk.contacts;
    all.headers.push_back({chunk.bodies.size(), chunk.far.size(), contacts.size(),
                           static_cast<std::uint64_t>(chunk.group.narrow_phase),
                           static_cast<std::uint64_t>(chunk.group.law), static_cast<std::uint64_t>(chunk.checked)});
    all.totals.push_back({chunk.viscous_loss, chunk.friction_loss, chunk.hysteresis_loss, chunk.curvature_gain,
                          chunk.stored_normal, chunk.stored_tangential, chunk.stiffest});
    append(all.bodies, chunk.bodies);
    for (std::size_t i = 0; i < chunk.far.size(); ++i) {
      all.far.push_back(wide(chunk.far[i].bodies));
      all.far_quiet.push_back(chunk.far[i].quiet_until);
      all.far_cache.push_back(numbers_of(chunk.far_caches[i]));
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      all.contacts.push_back(wide(contacts.bodies[i]));
      all.contact_state.push_back(static_cast<std::int32_t>(contacts.caches.states[i]));
      all.contact_cache.push_back(numbers_of(contacts.caches.get(i)));
      all.constants.push_back(contacts.constants[contacts.kind[i]]);
    }
    append(all.memory, contacts.memory);
    append(all.spring, contacts.spring);
    append(all.force, contacts.force);
    append(all.couple, contacts.couple);
  }
  return all;
}

/// Hands out one item after another.
template <class Item>
class Next {
 public:
  Next(const char* name, const std::vector<Item>& items) : name_(name), items_(items) {}

  const Item& operator()() {
    if (next_ == items_.size())
      throw InputError("state", std::string("array ") + name_ + " that ends early", "an entry for each pair");
    return items_[next_++];
  }
  void finish() const {
    if (next_ != items_.size())
      throw InputError("state", std::string("array ") + name_ + " that goes on", "an entry for each pair");
  }

 private:
  const char* name_;
  const std::vector<Item>& items_;
  std::size_t next_ = 0;
};

void restore(const FlatPairs& all, const World& world, std::size_t body_count, PairList& list) {
  Next bodies("chunks.bodies", all.bodies);
  Next far("far.bodies", all.far);
  Next far_quiet("far.quiet_until", all.far_quiet);
  Next far_cache("far.cache", all.far_cache);
  Next contact("contacts.bodies", all.contacts);
  Next contact_state("contacts.cache_state", all.contact_state);
  Next contact_cache("contacts.cache", all.contact_cache);
  Next memory("contacts.memory", all.memory);
  Next constants("contacts.constants", all.constants);
  Next spring("contacts.spring", all.spring);
  Next force("contacts.force", all.force);
  Next couple("contacts.couple", all.couple);
  Next totals("chunks.totals", all.totals);
  list.chunks.clear();
  for (const Header& header : all.headers) {
    if (header.law >= world.setup.interactions.size() || header.narrow_phase >= narrow_phases)
      throw InputError("state", "pairs of another setup", "the setup that the state was made with");
    const ContactLaw& law = world.setup.interactions[header.law].law;
    PairChunk& chunk = list.chunks.emplace_back();
    chunk.group = {static_cast<NarrowPhase>(header.narrow_phase), static_cast<std::int32_t>(header.law)};
    chunk.checked = static_cast<std::int32_t>(header.checked);
    const Totals& sums = totals();
    chunk.viscous_loss = sums.viscous_loss;
    chunk.friction_loss = sums.friction_loss;
    chunk.hysteresis_loss = sums.hysteresis_loss;
    chunk.curvature_gain = sums.curvature_gain;
    chunk.stored_normal = sums.stored_normal;
    chunk.stored_tangential = sums.stored_tangential;
    chunk.stiffest = sums.stiffest;
    if (header.bodies > 2 * PairChunk::most_pairs)
      throw InputError("state", std::to_string(header.bodies) + " bodies in a chunk",
                       "at most " + std::to_string(2 * PairChunk::most_pairs));
    for (std::uint64_t i = 0; i < header.bodies; ++i) {
      const std::int32_t body = bodies();
      if (body < 0 || static_cast<std::size_t>(body) >= body_count)
        throw InputError("state", "body " + std::to_string(body), "indices below " + std::to_string(body_count));
      chunk.bodies.push_back(body);
    }
    chunk.wrenches.assign(chunk.bodies.size(), Wrench());
    for (std::uint64_t i = 0; i < header.far; ++i) {
      chunk.far.push_back({narrow(far(), chunk), static_cast<float>(far_quiet())});
      chunk.far_caches.push_back(far_cache_of(far_cache()));
    }
    for (std::uint64_t i = 0; i < header.contacts; ++i) {
      append_contact(chunk.contacts, narrow(contact(), chunk), cache_of(contact_cache(), contact_state()), constants(),
                     law);
      chunk.contacts.spring.back() = spring();
      chunk.contacts.force.back() = force();
      if (law.makes_couples()) chunk.contacts.couple.back() = couple();
    }
    for (MemoryLine& line : chunk.contacts.memory) line = memory();
    fit_room(chunk);
  }
  bodies.finish(), far.finish(), contact.finish(), memory.finish(), force.finish(), couple.finish();
}

void visit_pairs(PairList& list, const World&, std::size_t, StateWriter& writer) {
  flat(list).visit(writer);
}

void visit_pairs(PairList& list, const World& world, std::size_t body_count, StateReader& reader) {
  FlatPairs all;
  all.visit(reader);
  restore(all, world, body_count, list);
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
  visitor.template array<double>("bodies.skin", self.kinematics_.skin);
  visitor.value("extent", self.extent_);
  visitor.value("flow_reach", self.flow_reach_);
  visitor.value("centre.x", self.centre_.x());
  visitor.value("centre.y", self.centre_.y());
  visitor.value("centre.z", self.centre_.z());
  visitor.value("driven_work", self.driven_work_);
  visitor.value("poured_energy", self.poured_energy_);
  visitor.value("gravity_wrapped", self.gravity_wrapped_);
  visitor.value("image_power", self.image_power_);
  visitor.value("listed_step", self.listed_step_);
  visitor.value("steps", self.steps_);
  visitor.value("rebuilds", self.rebuilds_);
  visitor.value("losses.viscous", self.pairs_.viscous_loss);
  visitor.value("losses.friction", self.pairs_.friction_loss);
  visitor.value("losses.hysteresis", self.pairs_.hysteresis_loss);
  visitor.value("gains.curvature", self.pairs_.curvature_gain);
  visitor.template array<double>("bodies.listed_at", self.listed_at_);
  visit_pairs(self.pairs_, self.world_, self.bodies_.size(), visitor);
}

/// Bodies that came in since the start have the setup's kinds, and no entry of their own in it.
struct PouredBodies {
  std::vector<std::int32_t> shape, material;
  std::vector<std::uint64_t> particles;  ///< of each pour
  std::vector<double> mass;              ///< [kg]

  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor.template array<std::int32_t>("poured.shape", shape);
    visitor.template array<std::int32_t>("poured.material", material);
    visitor.template array<std::uint64_t>("poured.particles", particles);
    visitor.template array<double>("poured.mass", mass);
  }
};

void append_poured(const World& world, const PouredBodies& poured, Bodies& bodies) {
  const std::set<BodyKind> kinds = body_kinds(world);
  if (poured.material.size() != poured.shape.size())
    throw InputError("state", "poured bodies without a material", "a shape and a material of each");
  for (std::size_t k = 0; k < poured.shape.size(); ++k) {
    const std::string where = "body " + std::to_string(bodies.size()) + " of the state";
    if (!kinds.contains({poured.shape[k], poured.material[k], true}))
      throw InputError(where, "a kind that no pour has", "one of the setup that the state was made with");
    append_body(world, {.shape = poured.shape[k], .material = poured.material[k], .pose = {}}, where, bodies);
  }
}

Simulation::Engine::Engine(const Setup& setup, const State& state)
    : world_(make_world(setup)), bodies_(make_bodies(world_)), threads_(setup.threads) {
  StateReader reader(state);
  PouredBodies poured;
  poured.visit(reader);
  if (poured.particles.size() != setup.pours.size() || poured.mass.size() != setup.pours.size())
    throw InputError("state", std::to_string(poured.particles.size()) + " pours",
                     std::to_string(setup.pours.size()) + " as in the setup");
  append_poured(world_, poured, bodies_);
  make_room();
  for (std::size_t p = 0; p < poured_.size(); ++p) poured_[p] = {poured.particles[p], poured.mass[p]};
  kinematics_.time_step = setup.time_step;
  const std::size_t count = bodies_.size();
  visit_state(*this, reader);
  world_.box = at_time(setup.box, time());
  for (const std::size_t size : {bodies_.position.size(), bodies_.orientation.size(), bodies_.velocity.size(),
                                 bodies_.angular_momentum.size(), bodies_.force.size(), bodies_.torque.size(),
                                 kinematics_.travel.size(), kinematics_.skin.size(), listed_at_.size()})
    if (size != count)
      throw InputError("state", std::to_string(size) + " bodies", std::to_string(count) + " as in the setup");
  for (std::size_t i = 0; i < count; ++i) kinematics_.records[i].place(bodies_.position[i], bodies_.orientation[i]);
  index_bodies(pairs_, count);
}

State Simulation::Engine::state() const {
  State state;
  StateWriter writer(state);
  const auto first = static_cast<std::ptrdiff_t>(world_.starts.size());
  PouredBodies poured{.shape = {bodies_.shape.begin() + first, bodies_.shape.end()},
                      .material = {bodies_.material.begin() + first, bodies_.material.end()},
                      .particles = {},
                      .mass = {}};
  for (const Poured& one : poured_) {
    poured.particles.push_back(one.particles);
    poured.mass.push_back(one.mass);
  }
  poured.visit(writer);
  auto& self = const_cast<Engine&>(*this);  // a writer changes nothing
  visit_state(self, writer);
  return state;
}

std::size_t Simulation::Engine::memory_bytes() const {
  std::size_t sum = contact_bytes() + bytes(bodies_.shape) + bytes(bodies_.material) + bytes(bodies_.motion) +
                    bytes(bodies_.position) + bytes(bodies_.orientation) + bytes(bodies_.velocity) +
                    bytes(bodies_.angular_momentum) + bytes(bodies_.force) + bytes(bodies_.torque) +
                    bytes(bodies_.mass) + bytes(bodies_.inertia) + bytes(kinematics_.records) +
                    bytes(kinematics_.travel) + bytes(kinematics_.skin) + bytes(radius_) + bytes(step_travel_) +
                    bytes(listed_at_) + bytes(pairs_.first) + bytes(pairs_.incidences) + bytes(pairs_.chunks);
  for (const PairChunk& chunk : pairs_.chunks)
    sum += bytes(chunk.far) + bytes(chunk.far_caches) + bytes(chunk.bodies) + bytes(chunk.wrenches);
  return sum;
}

std::size_t Simulation::Engine::contact_bytes() const {
  std::size_t sum = 0;
  for (const PairChunk& chunk : pairs_.chunks) {
    const Contacts& contacts = chunk.contacts;
    sum += bytes(contacts.bodies) + bytes(contacts.caches.states) +
           contacts.caches.states.capacity() * ContactCaches::width * sizeof(double) + bytes(contacts.memory) +
           bytes(contacts.kind) + bytes(contacts.constants) + bytes(contacts.spring) + bytes(contacts.force) +
           bytes(contacts.couple);
  }
  return sum;
}

}  // namespace osculate
