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

/// A pair in the old list: a far one, or a contact.
struct Place {
  Candidate candidate;
  const PairChunk* chunk;
  std::int32_t far;      ///< index, or −1
  std::int32_t contact;  ///< index, or −1
};

std::vector<Place> places_of(const PairList& list) {
  std::vector<Place> places;
  for (const PairChunk& chunk : list.chunks) {
    const auto global = [&](const BodyPair& pair) {
      return BodyPair{chunk.bodies[index_of(pair.first)], chunk.bodies[index_of(pair.second)]};
    };
    for (Index k = 0; k < chunk.far.size(); ++k)
      places.push_back({{chunk.group, global(chunk.far[k].bodies)}, &chunk, static_cast<std::int32_t>(k), -1});
    for (Index k = 0; k < chunk.contacts.size(); ++k)
      places.push_back({{chunk.group, global(chunk.contacts.bodies[k])}, &chunk, -1, static_cast<std::int32_t>(k)});
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.candidate < b.candidate; });
  return places;
}

/// Gives the chunk's bodies their places in it; its pairs named bodies by their numbers so far.
void number_bodies(PairChunk& chunk, std::vector<std::int32_t>& place) {
  const auto number = [&](std::int32_t& body) {
    std::int32_t& at = place[index_of(body)];
    if (at < 0) {
      at = static_cast<std::int32_t>(chunk.bodies.size());
      chunk.bodies.push_back(body);
    }
    body = at;
  };
  const auto number_pair = [&](BodyPair& pair) {
    number(pair.first);
    number(pair.second);
  };
  for (FarPair& far : chunk.far) number_pair(far.bodies);
  for (BodyPair& pair : chunk.contacts.bodies) number_pair(pair);
  for (const std::int32_t body : chunk.bodies) place[index_of(body)] = -1;
  chunk.wrenches.assign(chunk.bodies.size(), {Vec3::Zero(), Vec3::Zero()});
}

}  // namespace

void index_bodies(PairList& list, std::size_t bodies) {
  list.first.assign(bodies + 1, 0);
  for (const PairChunk& chunk : list.chunks)
    for (const std::int32_t body : chunk.bodies) ++list.first[index_of(body) + 1];
  for (Index i = 0; i < bodies; ++i) list.first[i + 1] += list.first[i];
  list.incidences.resize(list.first.back());
  std::vector<std::uint64_t> next(list.first.begin(), list.first.end() - 1);
  for (Index c = 0; c < list.chunks.size(); ++c)
    for (Index k = 0; k < list.chunks[c].bodies.size(); ++k)
      list.incidences[next[index_of(list.chunks[c].bodies[k])]++] = {static_cast<std::uint32_t>(c),
                                                                     static_cast<std::uint32_t>(k)};
}

PairList make_pair_list(PairList&& before, const World& world, const Bodies& bodies, const Kinematics& kinematics) {
  PairList list;
  list.viscous_loss = before.viscous_loss;
  list.friction_loss = before.friction_loss;
  list.hysteresis_loss = before.hysteresis_loss;
  list.curvature_gain = before.curvature_gain;
  for (const PairChunk& chunk : before.chunks) {
    list.viscous_loss += chunk.viscous_loss;
    list.friction_loss += chunk.friction_loss;
    list.hysteresis_loss += chunk.hysteresis_loss;
    list.curvature_gain += chunk.curvature_gain;
  }
  const std::vector<Place> old = places_of(before);
  auto known = old.begin();
  for (const Candidate& candidate : candidates(world, bodies)) {
    const auto pairs_in = [](const PairChunk& chunk) { return chunk.far.size() + chunk.contacts.size(); };
    if (list.chunks.empty() || list.chunks.back().group != candidate.group ||
        pairs_in(list.chunks.back()) == PairChunk::most_pairs)
      list.chunks.emplace_back().group = candidate.group;
    PairChunk& chunk = list.chunks.back();
    while (known != old.end() && known->candidate < candidate) ++known;
    const bool is_known = known != old.end() && known->candidate == candidate;
    if (is_known && known->contact >= 0) {
      const ContactLaw& law = world.setup.interactions[index_of(candidate.group.law)].law;
      append_contact(chunk.contacts, known->chunk->contacts, index_of(known->contact), law);
      chunk.contacts.bodies.back() = candidate.pair;
      continue;
    }
    const Index one = index_of(candidate.pair.first), two = index_of(candidate.pair.second);
    const double reach = world.reach[index_of(candidate.group.law)];
    FarPair far{candidate.pair, sphere_gap(world, bodies, one, two) - reach};
    FarCache cache;
    if (is_known) {
      const FarPair& was = known->chunk->far[index_of(known->far)];
      cache = known->chunk->far_caches[index_of(known->far)];
      far.quiet_until = std::max(far.quiet_until, was.quiet_until - kinematics.travel[one] - kinematics.travel[two]);
    }
    chunk.far.push_back(far);
    chunk.far_caches.push_back(cache);
  }
  std::vector<std::int32_t> place(bodies.size(), -1);
  for (PairChunk& chunk : list.chunks) {
    number_bodies(chunk, place);
    drop_spare_room(chunk);
  }
  index_bodies(list, bodies.size());
  return list;
}

}  // namespace osculate
