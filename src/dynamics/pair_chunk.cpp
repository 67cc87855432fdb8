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

void put(std::array<float, 12>& numbers, std::size_t first, const Vec3& v) {
  for (std::size_t k = 0; k < 3; ++k) numbers[first + k] = static_cast<float>(v[static_cast<Eigen::Index>(k)]);
}
Vec3 vector_at(const std::array<float, 12>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

}  // namespace

float rounded_down(double x) {
  const auto near = static_cast<float>(x);
  return near > x ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

FarCache::FarCache(const ContactCache& cache) : state(cache.state) {
  put(numbers, 0, cache.point_1), put(numbers, 3, cache.normal_1);
  put(numbers, 6, cache.point_2), put(numbers, 9, cache.normal_2);
}

ContactCache FarCache::cache(double radius_1, double radius_2) const {
  // A vector rounded to floats is off by 2^-24 of its length, a unit vector by as much again once it has length 1; the
  // support in it, and the point's height along it, by a radius times that each.
  constexpr double slack = 4.0 * 0x1p-24;
  if (state == ContactCache::State::empty) return {};
  const Vec3 normal_1 = vector_at(numbers, 3).normalized(), normal_2 = vector_at(numbers, 9).normalized();
  return {state, vector_at(numbers, 0) + slack * radius_1 * normal_1, normal_1,
          vector_at(numbers, 6) + slack * radius_2 * normal_2, normal_2};
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
  contacts.reduced_mass.push_back(constants.reduced_mass);
  contacts.effective_radius.push_back(constants.effective_radius);
  contacts.radius_cap.push_back(constants.radius_cap);
  contacts.spring.push_back({0.0, 0.0});
  contacts.force.push_back(Vec3::Zero());
  if (law.makes_couples()) contacts.couple.push_back(Vec3::Zero());
}

void append_contact(Contacts& contacts, const Contacts& from, std::size_t i, const ContactLaw& law) {
  const std::size_t end = contacts.size();
  append_contact(contacts, from.bodies[i], from.caches.get(i),
                 {from.reduced_mass[i], from.effective_radius[i], from.radius_cap[i]}, law);
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
  fill_gap(contacts.reduced_mass);
  fill_gap(contacts.effective_radius);
  fill_gap(contacts.radius_cap);
  fill_gap(contacts.spring);
  fill_gap(contacts.force);
  if (law.makes_couples()) fill_gap(contacts.couple);
}

void drop_spare_room(PairChunk& chunk) {
  Contacts& contacts = chunk.contacts;
  const std::size_t size = contacts.size(), room = size + size / law_lanes + 1;
  const auto fit = [](auto& items, std::size_t count) {
    auto fitting = items;  // a copy is as long as what it copies
    fitting.reserve(count);
    items.swap(fitting);
  };
  fit(chunk.far, chunk.far.size());
  fit(chunk.far_caches, chunk.far.size());
  fit(chunk.bodies, chunk.bodies.size());
  ContactCaches caches;
  caches.resize(room);
  for (std::size_t i = 0; i < size; ++i) caches.set(i, contacts.caches.get(i));
  caches.resize(size);
  contacts.caches = std::move(caches);
  fit(contacts.bodies, room);
  fit(contacts.memory, contacts.memory.size() * room / std::max<std::size_t>(size, 1));
  fit(contacts.reduced_mass, room);
  fit(contacts.effective_radius, room);
  fit(contacts.radius_cap, room);
  fit(contacts.spring, room);
  fit(contacts.force, room);
  if (!contacts.couple.empty()) fit(contacts.couple, room);
}

}  // namespace osculate
