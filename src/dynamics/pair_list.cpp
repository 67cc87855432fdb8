#include "dynamics/pair_list.hpp"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "dynamics/neighbours.hpp"

namespace osculate {
namespace {

using Index = std::size_t;

/// Pairs stand in the order of their bodies along a curve through space, so that a chunk's bodies lie together.
struct Candidate {
  PairGroup group;
  std::uint32_t earlier, later;  ///< the bodies' ranks along the curve; walls come last
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

double gap_to_face(const BodyShape& shape, const Pose& pose, const Vec3& point) {
  return distance_to(shape.surface->faces[static_cast<Index>(shape.face)], pose.to_body(point));
}

/// How far apart the spheres around two bodies are; for a wall and a particle, the wall and the sphere.
double sphere_gap(const World& world, const Bodies& bodies, Index one, Index two) {
  const BodyShape &shape_1 = shape_of(world, bodies, one), &shape_2 = shape_of(world, bodies, two);
  if (shape_1.is_face()) return gap_to_face(shape_1, bodies.pose(one), bodies.position[two]) - shape_2.bounding_radius;
  if (shape_2.is_face()) return gap_to_face(shape_2, bodies.pose(two), bodies.position[one]) - shape_1.bounding_radius;
  if (!is_particle(shape_1.shape))
    return gap_to_wall(shape_1.shape, bodies.pose(one), bodies.position[two]) - shape_2.bounding_radius;
  if (!is_particle(shape_2.shape))
    return gap_to_wall(shape_2.shape, bodies.pose(two), bodies.position[one]) - shape_1.bounding_radius;
  Vec3 apart = bodies.position[two] - bodies.position[one];
  if (world.box.repeats()) apart += nearest_image_shift(world.box, apart);
  return apart.norm() - shape_1.bounding_radius - shape_2.bounding_radius;
}

bool is_superquadric(const Shape& shape) {
  return is_particle(shape) && !std::holds_alternative<PotentialParticle>(shape);
}

/// Every third bit: the lowest 21 bits of a number.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1F00000000FFFF;
  x = (x | x << 16) & 0x1F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Each body's place along Morton's curve through the particles; walls come last.
std::vector<std::uint32_t> ranks(const World& world, const Bodies& bodies) {
  constexpr double cells = 1 << 21;
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  const auto is_bounded = [&](Index i) { return is_particle(shape_of(world, bodies, i).shape); };
  for (Index i = 0; i < bodies.size(); ++i) {
    if (!is_bounded(i)) continue;
    lower = lower.cwiseMin(bodies.position[i]);
    upper = upper.cwiseMax(bodies.position[i]);
  }
  const double length = (upper - lower).maxCoeff(), scale = length > 0.0 ? (cells - 1.0) / length : 0.0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(bodies.size());
  for (Index i = 0; i < bodies.size(); ++i) {
    std::uint64_t place = std::numeric_limits<std::uint64_t>::max();
    if (is_bounded(i)) {
      const Vec3 cell = scale * (bodies.position[i] - lower);
      place = 0;
      for (int k = 0; k < 3; ++k) place |= spread(static_cast<std::uint64_t>(cell[k])) << k;
    }
    order[i] = {place, static_cast<std::uint32_t>(i)};
  }
  oneapi::tbb::parallel_sort(order);
  std::vector<std::uint32_t> rank(bodies.size());
  for (Index k = 0; k < order.size(); ++k) rank[order[k].second] = static_cast<std::uint32_t>(k);
  return rank;
}

Candidate make_candidate(const PairGroup& group, const BodyPair& pair, const std::vector<std::uint32_t>& rank) {
  const auto [earlier, later] = std::minmax(rank[index_of(pair.first)], rank[index_of(pair.second)]);
  return {group, earlier, later, pair};
}

NarrowPhase narrow_phase_of(const BodyShape& one, const BodyShape& two) {
  if (one.is_face() || two.is_face()) return NarrowPhase::faces;
  const auto is_plane = [](const BodyShape& shape) { return std::holds_alternative<HalfSpace>(shape.shape); };
  const bool first = is_superquadric(one.shape), second = is_superquadric(two.shape);
  if (first && second) return NarrowPhase::superquadrics;
  return (first && is_plane(two)) || (is_plane(one) && second) ? NarrowPhase::planes : NarrowPhase::any_shapes;
}

std::vector<Candidate> candidates(const World& world, const Bodies& bodies, const std::vector<double>& skin,
                                  const std::vector<std::uint32_t>& rank) {
  const double reach = world.largest_reach;
  std::vector<Ball> balls;
  std::vector<std::int32_t> ball_of, walls;
  for (Index i = 0; i < bodies.size(); ++i) {
    const BodyShape& shape = shape_of(world, bodies, i);
    const double radius = shape.bounding_radius;
    if (std::isfinite(radius)) {
      balls.push_back({shape.is_face() ? bodies.pose(i).to_world(shape.centre) : bodies.position[i],
                       radius + skin[i] + 0.5 * reach});
      ball_of.push_back(static_cast<std::int32_t>(i));
    } else {
      walls.push_back(static_cast<std::int32_t>(i));
    }
  }
  std::vector<BodyPair> pairs = touching_balls(balls, world.box);
  for (BodyPair& pair : pairs) pair = {ball_of[index_of(pair.first)], ball_of[index_of(pair.second)]};
  const auto is_near = [&](std::int32_t one, std::int32_t two) {
    const Index i = index_of(one), j = index_of(two);
    return sphere_gap(world, bodies, i, j) <= skin[i] + skin[j] + reach;
  };
  const auto is_face = [&](std::int32_t body) { return shape_of(world, bodies, index_of(body)).is_face(); };
  std::erase_if(pairs, [&](const BodyPair& pair) {
    const bool one = is_face(pair.first), two = is_face(pair.second);
    return (one && two) || ((one || two) && !is_near(pair.first, pair.second));
  });
  for (const std::int32_t wall : walls)
    for (const std::int32_t body : ball_of)
      if (!is_face(body) && is_near(wall, body)) pairs.push_back({std::min(wall, body), std::max(wall, body)});

  std::vector<Candidate> found;
  found.reserve(pairs.size());
  for (const BodyPair& pair : pairs) {
    const Index one = index_of(pair.first), two = index_of(pair.second);
    if (!bodies.is_free(one) && !bodies.is_free(two)) continue;
    const PairGroup group{narrow_phase_of(shape_of(world, bodies, one), shape_of(world, bodies, two)),
                          world.law_between(bodies.material[one], bodies.material[two])};
    found.push_back(make_candidate(group, pair, rank));
  }
  oneapi::tbb::parallel_sort(found);
  return found;
}

/// A pair in the old list: a far one, or a contact.
struct Place {
  Candidate candidate;
  const PairChunk* chunk;
  std::int32_t far;      ///< index, or −1
  std::int32_t contact;  ///< index, or −1
  friend bool operator<(const Place& a, const Place& b) { return a.candidate < b.candidate; }
};

std::vector<Place> places_of(const PairList& list, const std::vector<std::uint32_t>& rank) {
  std::vector<Place> places;
  for (const PairChunk& chunk : list.chunks) {
    const auto candidate = [&](const LocalPair& pair) {
      return make_candidate(chunk.group, {chunk.bodies[pair.first], chunk.bodies[pair.second]}, rank);
    };
    for (Index k = 0; k < chunk.far.size(); ++k)
      places.push_back({candidate(chunk.far[k].bodies), &chunk, static_cast<std::int32_t>(k), -1});
    for (Index k = 0; k < chunk.contacts.size(); ++k)
      places.push_back({candidate(chunk.contacts.bodies[k]), &chunk, -1, static_cast<std::int32_t>(k)});
  }
  oneapi::tbb::parallel_sort(places);
  return places;
}

/// Hands out places in a chunk to bodies.
class Numbering {
 public:
  Numbering(std::vector<std::int32_t>& bodies, std::vector<std::int32_t>& place) : bodies_(bodies), place_(place) {}
  ~Numbering() {
    for (const std::int32_t body : bodies_) place_[index_of(body)] = -1;
  }
  Numbering(const Numbering&) = delete;
  Numbering& operator=(const Numbering&) = delete;

  LocalPair local(const BodyPair& pair) { return {number(pair.first), number(pair.second)}; }

 private:
  std::uint16_t number(std::int32_t body) {
    std::int32_t& at = place_[index_of(body)];
    if (at < 0) {
      at = static_cast<std::int32_t>(bodies_.size());
      bodies_.push_back(body);
    }
    return static_cast<std::uint16_t>(at);
  }

  std::vector<std::int32_t>& bodies_;
  std::vector<std::int32_t>& place_;  ///< of every body, −1 where it has none
};

/// The pairs of a chunk: consecutive candidates of one group, with what the old list knows of them.
PairChunk make_chunk(std::span<const Candidate> pairs, const std::vector<Place>& old, const World& world,
                     const Bodies& bodies, const Kinematics& kinematics, std::vector<std::int32_t>& place) {
  PairChunk chunk;
  chunk.group = pairs.front().group;
  const ContactLaw& law = world.setup.interactions[index_of(chunk.group.law)].law;
  const double reach = world.reach[index_of(chunk.group.law)];
  auto known = std::lower_bound(old.begin(), old.end(), pairs.front(),
                                [](const Place& one, const Candidate& pair) { return one.candidate < pair; });
  {
    Numbering numbering(chunk.bodies, place);
    for (const Candidate& candidate : pairs) {
      while (known != old.end() && known->candidate < candidate) ++known;
      const bool is_known = known != old.end() && known->candidate == candidate;
      const LocalPair local = numbering.local(candidate.pair);
      if (is_known && known->contact >= 0) {
        append_contact(chunk.contacts, known->chunk->contacts, index_of(known->contact), law);
        chunk.contacts.bodies.back() = local;
        continue;
      }
      const Index one = index_of(candidate.pair.first), two = index_of(candidate.pair.second);
      FarPair far{local, rounded_down(sphere_gap(world, bodies, one, two) - reach)};
      FarCache cache;
      if (is_known) {
        const double was = known->chunk->far[index_of(known->far)].quiet_until;
        cache = known->chunk->far_caches[index_of(known->far)];
        far.quiet_until =
            std::max(far.quiet_until, rounded_down(was - kinematics.travel[one] - kinematics.travel[two]));
      }
      chunk.far.push_back(far);
      chunk.far_caches.push_back(cache);
    }
  }
  chunk.wrenches.assign(chunk.bodies.size(), Wrench());
  fit_room(chunk);
  return chunk;
}

/// Where each chunk's candidates begin, and where the last one's end. A particle's faces stay together: memory goes
/// from one to the next.
std::vector<Index> chunk_bounds(const std::vector<Candidate>& found) {
  constexpr Index most_faces = PairChunk::most_pairs / 4;
  std::vector<Index> bounds{0};
  for (Index i = 1; i < found.size(); ++i) {
    const Index size = i - bounds.back();
    const bool is_next_particle = found[i].group.narrow_phase == NarrowPhase::faces &&
                                  found[i].earlier != found[i - 1].earlier &&
                                  size >= PairChunk::most_pairs - most_faces;
    if (found[i].group != found[i - 1].group || size == PairChunk::most_pairs || is_next_particle) bounds.push_back(i);
  }
  if (!found.empty()) bounds.push_back(found.size());
  return bounds;
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

PairList make_pair_list(PairList&& before, const World& world, const Bodies& bodies, const Kinematics& kinematics,
                        Threads& threads) {
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
  threads.run([&] {
    const std::vector<std::uint32_t> rank = ranks(world, bodies);
    const std::vector<Place> old = places_of(before, rank);
    const std::vector<Candidate> found = candidates(world, bodies, kinematics.skin, rank);
    const std::vector<Index> bounds = chunk_bounds(found);
    list.chunks.resize(bounds.size() - 1);
    std::vector<std::vector<std::int32_t>> places(static_cast<Index>(threads.count()));
    threads.for_blocks(list.chunks.size(), 1, [&](Index c, Index) {
      std::vector<std::int32_t>& place = places[Threads::current()];
      place.resize(bodies.size(), -1);
      list.chunks[c] = make_chunk(std::span(found).subspan(bounds[c], bounds[c + 1] - bounds[c]), old, world, bodies,
                                  kinematics, place);
    });
  });
  index_bodies(list, bodies.size());
  return list;
}

}  // namespace osculate
