#include "dynamics/pair_chunk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace osculate {
namespace {

void copy_memory(const std::vector<MemoryLine>& from, std::size_t source, std::vector<MemoryLine>& to,
                 std::size_t target, std::size_t size) {
  for (std::size_t m = 0; m < size; ++m)
    to[target / law_lanes * size + m].lanes[target % law_lanes] =
        from[source / law_lanes * size + m].lanes[source % law_lanes];
}

/// Pairs of a chunk are few, and so are their constants: a contact that comes back finds its own.
std::uint16_t kind_of(const PairConstants& constants, std::vector<PairConstants>& known) {
  const auto place = std::find(known.begin(), known.end(), constants) - known.begin();
  if (place == std::ssize(known)) known.push_back(constants);
  return static_cast<std::uint16_t>(place);
}

}  // namespace

float rounded_down(double x) {
  const auto near = static_cast<float>(x);
  return near > x ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

FarCache::FarCache(const ContactCache& cache) {
  if (cache.state == ContactCache::State::empty) return;
  const auto put = [&](std::size_t first, const Vec3& v) {
    for (std::size_t k = 0; k < 3; ++k) numbers[first + k] = static_cast<float>(v[static_cast<Eigen::Index>(k)]);
  };
  put(0, cache.normal_1), put(3, cache.normal_2);
  numbers[6] = static_cast<float>(cache.point_1.dot(cache.normal_1));
  numbers[7] = static_cast<float>(cache.point_2.dot(cache.normal_2));
}

ContactCache FarCache::cache(double radius_1, double radius_2) const {
  // A vector rounded to floats is off by 2^-24 of its length, a unit vector by as much again once it has length 1; the
  // support in it is by a radius times that, and its height by as much.
  constexpr double slack = 4.0 * 0x1p-24;
  const auto normal = [&](std::size_t first) {
    return Vec3(numbers[first], numbers[first + 1], numbers[first + 2]).normalized();
  };
  ContactCache cache;
  if (numbers == FarCache().numbers) return cache;
  cache.state = ContactCache::State::separation;
  cache.normal_1 = normal(0), cache.normal_2 = normal(3);
  cache.point_1 = (numbers[6] + slack * radius_1) * cache.normal_1;
  cache.point_2 = (numbers[7] + slack * radius_2) * cache.normal_2;
  return cache;
}

void append_contact(Contacts& contacts, const LocalPair& bodies, const ContactCache& cache,
                    const PairConstants& constants, const ContactLaw& law) {
  const std::size_t i = contacts.size();
  contacts.bodies.push_back(bodies);
  contacts.caches.resize(i + 1);
  contacts.caches.set(i, cache);
  contacts.memory.resize(law.memory_length(i + 1) / law_lanes, MemoryLine{});
  // A law may leave anything in the lanes behind the last contact.
  for (std::size_t m = 0; m < law.memory_size(); ++m)
    contacts.memory[i / law_lanes * law.memory_size() + m].lanes[i % law_lanes] = 0.0;
  contacts.kind.push_back(kind_of(constants, contacts.constants));
  contacts.spring.push_back({0.0, 0.0});
  contacts.force.push_back(Vec3::Zero());
  if (law.makes_couples()) contacts.couple.push_back(Vec3::Zero());
}

void append_contact(Contacts& contacts, const Contacts& from, std::size_t i, const ContactLaw& law) {
  const std::size_t end = contacts.size();
  append_contact(contacts, from.bodies[i], from.caches.get(i), from.constants[from.kind[i]], law);
  copy_memory(from.memory, i, contacts.memory, end, law.memory_size());
  contacts.spring[end] = from.spring[i];
  contacts.force[end] = from.force[i];
  if (law.makes_couples()) contacts.couple[end] = from.couple[i];
}

void move_memory(Contacts& contacts, std::size_t from, std::size_t to, const ContactLaw& law) {
  copy_memory(contacts.memory, from, contacts.memory, to, law.memory_size());
  for (std::size_t m = 0; m < law.memory_size(); ++m)
    contacts.memory[from / law_lanes * law.memory_size() + m].lanes[from % law_lanes] = 0.0;
  contacts.spring[to] = std::exchange(contacts.spring[from], {0.0, 0.0});
}

void remove_contact(Contacts& contacts, std::size_t i, const ContactLaw& law) {
  const std::size_t last = contacts.size() - 1;
  const auto fill_gap = [&](auto& items) {
    items[i] = items[last];
    items.pop_back();
  };
  copy_memory(contacts.memory, last, contacts.memory, i, law.memory_size());
  contacts.memory.resize(law.memory_length(last) / law_lanes);
  contacts.caches.set(i, contacts.caches.get(last));
  contacts.caches.resize(last);
  fill_gap(contacts.bodies);
  fill_gap(contacts.kind);
  fill_gap(contacts.spring);
  fill_gap(contacts.force);
  if (law.makes_couples()) fill_gap(contacts.couple);
}

void fit_room(PairChunk& chunk) {
  Contacts& contacts = chunk.contacts;
  const auto room_for = [](std::size_t count) { return count + count / 16 + 1; };
  const std::size_t size = contacts.size(), room = room_for(size), far_room = room_for(chunk.far.size());
  const auto fit = [](auto& items, std::size_t count) {
    auto fitting = items;  // a copy is as long as what it copies
    fitting.reserve(count);
    items.swap(fitting);
  };
  fit(chunk.far, far_room);
  fit(chunk.far_caches, far_room);
  fit(chunk.bodies, chunk.bodies.size());
  ContactCaches caches;
  caches.resize(room);
  for (std::size_t i = 0; i < size; ++i) caches.set(i, contacts.caches.get(i));
  caches.resize(size);
  contacts.caches = std::move(caches);
  fit(contacts.bodies, room);
  const auto blocks = [](std::size_t count) { return (count + law_lanes - 1) / law_lanes; };
  fit(contacts.memory, contacts.memory.size() / std::max<std::size_t>(blocks(size), 1) * blocks(room));
  fit(contacts.kind, room);
  fit(contacts.constants, contacts.constants.size());
  fit(contacts.spring, room);
  fit(contacts.force, room);
  if (!contacts.couple.empty()) fit(contacts.couple, room);
}

}  // namespace osculate
