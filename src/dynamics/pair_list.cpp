#include "dynamics/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "dynamics/neighbours.hpp"

namespace osculate {
namespace {

using Index = std::size_t;

struct Candidate {
  PairGroup group;
  BodyPair pair;
  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

Index index_of(std::int32_t i) {
  return static_cast<Index>(i);
}

const BodyShape& shape_of(const World& world, const Bodies& bodies, Index body) {
  return world.shapes[index_of(bodies.shape[body])];
}

double gap_to_wall(const Shape& wall, const Pose& pose, const Vec3& point) {
  return std::visit(
      [&](const auto& shape) {
        if constexpr (requires { signed_distance(shape, point); })
          return signed_distance(shape, pose.to_body(point)).value;
        else
          return 0.0;
      },
      wall);
}

/// How far apart the spheres around two bodies are; for a wall and a particle, the wall and the sphere.
double sphere_gap(const World& world, const Bodies& bodies, Index one, Index two) {
  const BodyShape &shape_1 = shape_of(world, bodies, one), &shape_2 = shape_of(world, bodies, two);
  if (!is_particle(shape_1.shape))
    return gap_to_wall(shape_1.shape, bodies.pose(one), bodies.position[two]) - shape_2.bounding_radius;
  if (!is_particle(shape_2.shape))
    return gap_to_wall(shape_2.shape, bodies.pose(two), bodies.position[one]) - shape_1.bounding_radius;
  Vec3 apart = bodies.position[two] - bodies.position[one];
  if (world.setup.box.repeats()) apart += nearest_image_shift(world.setup.box, apart);
  return apart.norm() - shape_1.bounding_radius - shape_2.bounding_radius;
}

bool is_superquadric(const Shape& shape) {
  return is_particle(shape) && !std::holds_alternative<PotentialParticle>(shape);
}

std::vector<Candidate> candidates(const World& world, const Bodies& bodies) {
  const double reach = world.reach.empty() ? 0.0 : *std::max_element(world.reach.begin(), world.reach.end());
  std::vector<Ball> balls;
  std::vector<std::int32_t> ball_of, walls;
  for (Index i = 0; i < bodies.size(); ++i) {
    const double radius = shape_of(world, bodies, i).bounding_radius;
    if (std::isfinite(radius)) {
      balls.push_back({bodies.position[i], radius + 0.5 * (world.skin + reach)});
      ball_of.push_back(static_cast<std::int32_t>(i));
    } else {
      walls.push_back(static_cast<std::int32_t>(i));
    }
  }
  std::vector<BodyPair> pairs = touching_balls(balls, world.setup.box);
  for (BodyPair& pair : pairs) pair = {ball_of[index_of(pair.first)], ball_of[index_of(pair.second)]};
  for (const std::int32_t wall : walls)
    for (const std::int32_t body : ball_of)
      if (sphere_gap(world, bodies, index_of(wall), index_of(body)) <= world.skin + reach)
        pairs.push_back({std::min(wall, body), std::max(wall, body)});

  std::vector<Candidate> found;
  found.reserve(pairs.size());
  for (const BodyPair& pair : pairs) {
    const Index one = index_of(pair.first), two = index_of(pair.second);
    if (!bodies.is_free(one) && !bodies.is_free(two)) continue;
    const bool fast =
        is_superquadric(shape_of(world, bodies, one).shape) && is_superquadric(shape_of(world, bodies, two).shape);
    found.push_back({{fast ? NarrowPhase::superquadrics : NarrowPhase::any_shapes,
                      world.law_between(bodies.material[one], bodies.material[two])},
                     pair});
  }
  std::sort(found.begin(), found.end());
  return found;
}

void append(PairChunk& chunk, const BodyPair& pair, double quiet_until) {
  chunk.pairs.push_back(pair);
  chunk.quiet_until.push_back(quiet_until);
  chunk.slot.push_back(Slots::unused);
}

/// A pair's place in the old list.
struct Place {
  const PairChunk* chunk;
  Index pair;
};

void carry_over(const Place& old, const World& world, PairChunk& chunk, Index k, std::vector<double>& memory) {
  chunk.caches.set(k, old.chunk->caches.get(old.pair));
  const std::int32_t slot = old.chunk->slot[old.pair];
  if (slot == Slots::unused) return;
  const ContactLaw& law = world.setup.interactions[index_of(chunk.group.law)].law;
  const Slots& from = old.chunk->slots;
  const Index source = index_of(slot), target = take_slot(chunk, k, law);
  chunk.slots.reduced_mass[target] = from.reduced_mass[source];
  chunk.slots.effective_radius[target] = from.effective_radius[source];
  chunk.slots.force[target] = from.force[source];
  chunk.slots.point[target] = from.point[source];
  if (law.makes_couples()) chunk.slots.couple[target] = from.couple[source];
  memory.resize(law.memory_size());
  write_memory(chunk.slots, target, read_memory(from, source, memory));
}

}  // namespace

void index_bodies(PairList& list, std::size_t bodies) {
  list.first.assign(bodies + 1, 0);
  for (const PairChunk& chunk : list.chunks)
    for (const BodyPair& pair : chunk.pairs) {
      ++list.first[index_of(pair.first) + 1];
      ++list.first[index_of(pair.second) + 1];
    }
  for (Index i = 0; i < bodies; ++i) list.first[i + 1] += list.first[i];
  list.incidences.resize(list.first.back());
  std::vector<std::uint64_t> next(list.first.begin(), list.first.end() - 1);
  for (Index c = 0; c < list.chunks.size(); ++c) {
    const std::vector<BodyPair>& pairs = list.chunks[c].pairs;
    for (Index k = 0; k < pairs.size(); ++k) {
      const auto entry = [&](std::uint32_t side) {
        return Incidence{static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(2 * k) + side};
      };
      list.incidences[next[index_of(pairs[k].first)]++] = entry(0);
      list.incidences[next[index_of(pairs[k].second)]++] = entry(1);
    }
  }
}

PairList make_pair_list(PairList&& before, const World& world, const Kinematics& kinematics) {
  const Bodies& bodies = *kinematics.bodies;
  PairList list;
  list.viscous_loss = before.viscous_loss;
  list.friction_loss = before.friction_loss;
  list.hysteresis_loss = before.hysteresis_loss;
  std::vector<Place> old;
  for (const PairChunk& chunk : before.chunks) {
    list.viscous_loss += chunk.viscous_loss;
    list.friction_loss += chunk.friction_loss;
    list.hysteresis_loss += chunk.hysteresis_loss;
    for (Index k = 0; k < chunk.pairs.size(); ++k) old.push_back({&chunk, k});
  }
  const auto candidate_of = [](const Place& place) {
    return Candidate{place.chunk->group, place.chunk->pairs[place.pair]};
  };

  std::vector<double> memory;
  auto known = old.begin();
  for (const Candidate& candidate : candidates(world, bodies)) {
    if (list.chunks.empty() || list.chunks.back().group != candidate.group ||
        list.chunks.back().pairs.size() == PairChunk::most_pairs)
      list.chunks.emplace_back().group = candidate.group;
    PairChunk& chunk = list.chunks.back();
    const Index k = chunk.pairs.size(), one = index_of(candidate.pair.first), two = index_of(candidate.pair.second);
    const double reach = world.reach[index_of(candidate.group.law)];
    double quiet_until = sphere_gap(world, bodies, one, two) - reach;
    while (known != old.end() && candidate_of(*known) < candidate) ++known;
    const bool is_known = known != old.end() && candidate_of(*known) == candidate;
    if (is_known) {
      const double was = known->chunk->quiet_until[known->pair];
      quiet_until =
          was == PairChunk::awake ? was : std::max(quiet_until, was - kinematics.travel[one] - kinematics.travel[two]);
    }
    append(chunk, candidate.pair, quiet_until);
    chunk.caches.resize(k + 1);
    if (is_known) carry_over(*known, world, chunk, k, memory);
  }
  index_bodies(list, bodies.size());
  return list;
}

}  // namespace osculate
