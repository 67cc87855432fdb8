#include "lammps/rank_pairs.hpp"

#include <algorithm>
#include <limits>

namespace osculate::lammps {
namespace {

using Index = std::size_t;
using Place = decltype(FarPair::bodies);

/// What packs say of a partner: an atom's tag, or −1 − index of a driven body.
double partner_name(const RankBodies& rank, const int* tags, Index body) {
  if (rank.is_driven(body)) return -1.0 - static_cast<double>(body);
  return static_cast<double>(tags[body - rank.driven]);
}

std::uint64_t key_of(const RankBodies& rank, const int* tags, Index one, Index two) {
  const auto half = [&](Index body) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(
        rank.is_driven(body) ? -1 - static_cast<std::int32_t>(body) : tags[body - rank.driven]));
  };
  return half(one) << 32 | half(two);
}

bool is_superquadric(const Shape& shape) {
  return is_particle(shape) && !std::holds_alternative<PotentialParticle>(shape);
}

double gap_to_driven(const BodyShape& shape, const Pose& pose, const Vec3& point) {
  return std::visit(
      [&](const auto& one) {
        if constexpr (requires { signed_distance(one, point); })
          return signed_distance(one, pose.to_body(point)).value;
        else
          return (point - pose.position).norm() - shape.bounding_radius;
      },
      shape.shape);
}

/// Between the sphere around an atom and a driven body or the sphere around another atom.
double sphere_gap(const RankBodies& rank, Index one, Index two) {
  const Vec3 second = rank.kinematics.records[two].position();
  if (rank.is_driven(one))
    return gap_to_driven(rank.shape(one), rank.kinematics.records[one].pose(), second) - rank.radius[two];
  return (second - rank.kinematics.records[one].position()).norm() - rank.radius[one] - rank.radius[two];
}

/// Everything that a contact remembers, one after another, but state and constants; `visit` sees every double.
template <class Self, class Visit>
void visit_contact(Self& contacts, Index i, Index memory_size, Visit&& visit) {
  for (Index m = 0; m < memory_size; ++m) visit(contacts.memory[i / law_lanes * memory_size + m].lanes[i % law_lanes]);
  for (Index k = 0; k < ContactCaches::width; ++k) visit(contacts.caches.columns[k][i]);
  visit(contacts.spring[i].overlap);
  visit(contacts.spring[i].coefficient);
}

void stow_contact(const Contacts& contacts, Index i, Index memory_size, double partner, StowedContacts& to) {
  to.push_back(partner);
  const Index length_at = to.size();
  to.push_back(0.0);
  to.push_back(static_cast<double>(contacts.caches.states[i]));
  const auto& [reduced_mass, effective_radius, radius_cap] = contacts.constants[contacts.kind[i]];
  for (const double constant : {reduced_mass, effective_radius, radius_cap}) to.push_back(constant);
  visit_contact(contacts, i, memory_size, [&](double value) { to.push_back(value); });
  to[length_at] = static_cast<double>(to.size() - length_at - 1);
}

const double* find_contact(const StowedContacts& stowed, double partner) {
  for (Index at = 0; at < stowed.size(); at += 2 + static_cast<Index>(stowed[at + 1]))
    if (stowed[at] == partner) return &stowed[at + 2];
  return nullptr;
}

/// The contact's bodies get their places later.
void append_stowed(Contacts& contacts, const double* numbers, const ContactLaw& law) {
  ContactCache cache;
  cache.state = static_cast<ContactCache::State>(static_cast<int>(numbers[0]));
  append_contact(contacts, Place{}, cache, {numbers[1], numbers[2], numbers[3]}, law);
  numbers += 4;
  visit_contact(contacts, contacts.size() - 1, law.memory_size(), [&](double& value) { value = *numbers++; });
}

}  // namespace

void PairSums::add(const PairChunk& chunk, double weight) {
  stored_normal += weight * chunk.stored_normal;
  stored_tangential += weight * chunk.stored_tangential;
  viscous_loss += weight * chunk.viscous_loss;
  friction_loss += weight * chunk.friction_loss;
  hysteresis_loss += weight * chunk.hysteresis_loss;
  curvature_gain += weight * chunk.curvature_gain;
  contacts += weight * static_cast<double>(chunk.contacts.size());
  candidates += weight * static_cast<double>(chunk.contacts.size() + chunk.far.size());
}

void RankPairs::stow(const RankBodies& rank, const int* tags, std::vector<StowedContacts>& atoms) {
  for (StowedContacts& atom : atoms) atom.clear();
  sleepers_.clear();
  for (Index c = 0; c < chunks_.size(); ++c) {
    const PairChunk& chunk = chunks_[c];
    const Index memory_size = rank.world.setup.interactions[static_cast<Index>(chunk.group.law)].law.memory_size();
    const auto body = [&](auto place) { return static_cast<Index>(chunk.bodies[static_cast<Index>(place)]); };
    for (Index i = 0; i < chunk.contacts.size(); ++i) {
      const Index one = body(chunk.contacts.bodies[i].first), two = body(chunk.contacts.bodies[i].second);
      const auto give = [&](Index owner, Index partner) {
        if (rank.is_owned(owner))
          stow_contact(chunk.contacts, i, memory_size, partner_name(rank, tags, partner), atoms[owner - rank.driven]);
      };
      give(one, two);
      give(two, one);
    }
    for (Index k = 0; k < chunk.far.size(); ++k) {
      const Index one = body(chunk.far[k].bodies.first), two = body(chunk.far[k].bodies.second);
      // A ghost's last step has not been heard of yet.
      const bool known = c < shared_;
      const double travel = rank.kinematics.travel[one] + rank.kinematics.travel[two];
      const double quiet = known ? static_cast<double>(chunk.far[k].quiet_until) - travel : 0.0;
      sleepers_.push_back({key_of(rank, tags, one, two), chunk.far_caches[k], quiet});
    }
  }
  std::sort(sleepers_.begin(), sleepers_.end(), [](const Sleeper& a, const Sleeper& b) { return a.key < b.key; });
}

RankPairs::Draft& RankPairs::open_draft(const PairGroup& group, Index from) {
  for (Index c = drafts_.size(); c-- > from;) {
    const PairChunk& chunk = drafts_[c].chunk;
    if (chunk.group == group && chunk.far.size() + chunk.contacts.size() < PairChunk::most_pairs) return drafts_[c];
  }
  Draft& draft = drafts_.emplace_back();
  draft.chunk.group = group;
  return draft;
}

void RankPairs::finish(Draft& draft) {
  PairChunk& chunk = draft.chunk;
  const auto place_of = [&](std::int32_t body) {
    std::int32_t& at = place_[static_cast<Index>(body)];
    if (at < 0) {
      at = static_cast<std::int32_t>(chunk.bodies.size());
      chunk.bodies.push_back(body);
    }
    return static_cast<decltype(Place::first)>(at);
  };
  const auto places_of = [&](const BodyPair& pair) { return Place{place_of(pair.first), place_of(pair.second)}; };
  for (Index k = 0; k < chunk.far.size(); ++k) chunk.far[k].bodies = places_of(draft.far[k]);
  for (Index k = 0; k < chunk.contacts.size(); ++k) chunk.contacts.bodies[k] = places_of(draft.contacts[k]);
  for (const std::int32_t body : chunk.bodies) place_[static_cast<Index>(body)] = -1;
  chunk.wrenches.assign(chunk.bodies.size(), Wrench());
  fit_room(chunk);
  chunks_.push_back(std::move(chunk));
}

void RankPairs::add(const RankBodies& rank, BodyPair pair, const int* tags, const StowedContacts& stowed, Index from) {
  const auto one = static_cast<Index>(pair.first), two = static_cast<Index>(pair.second);
  const bool fast = is_superquadric(rank.shape(one).shape) && is_superquadric(rank.shape(two).shape);
  const std::int32_t law = rank.world.law_between(rank.bodies.material[one], rank.bodies.material[two]);
  Draft& draft = open_draft({fast ? NarrowPhase::superquadrics : NarrowPhase::any_shapes, law}, from);
  // The stowed contacts are those of the pair's owned atom, whichever it is.
  const Index owner = rank.is_owned(two) ? two : one;
  const double* contact = find_contact(stowed, partner_name(rank, tags, owner == two ? one : two));
  if (contact != nullptr) {
    append_stowed(draft.chunk.contacts, contact, rank.world.setup.interactions[static_cast<Index>(law)].law);
    draft.contacts.push_back(pair);
    return;
  }
  double quiet = sphere_gap(rank, one, two) - rank.world.reach[static_cast<Index>(law)];
  FarCache cache;
  const std::uint64_t key = key_of(rank, tags, one, two);
  const auto sleeper = std::lower_bound(sleepers_.begin(), sleepers_.end(), key,
                                        [](const Sleeper& a, std::uint64_t b) { return a.key < b; });
  if (sleeper != sleepers_.end() && sleeper->key == key) {
    cache = sleeper->cache;
    quiet = std::max(quiet, sleeper->quiet);
  }
  FarPair far{};
  far.quiet_until = static_cast<decltype(far.quiet_until)>(quiet);
  draft.chunk.far.push_back(far);
  draft.chunk.far_caches.push_back(cache);
  draft.far.push_back(pair);
}

void RankPairs::list(const RankBodies& rank, const int* tags, std::span<const AtomPair> found, double skin,
                     const std::vector<StowedContacts>& atoms) {
  const PairSums all = sums();
  gone_ = {.viscous_loss = all.viscous_loss,
           .friction_loss = all.friction_loss,
           .hysteresis_loss = all.hysteresis_loss,
           .curvature_gain = all.curvature_gain};
  chunks_.clear();
  const auto add_atoms = [&](const AtomPair& pair, Index from) {
    const bool in_order = tags[pair.first] < tags[pair.second];
    const auto first = static_cast<std::int32_t>(rank.index(pair.first));
    const auto second = static_cast<std::int32_t>(rank.index(pair.second));
    const BodyPair bodies = in_order ? BodyPair{first, second} : BodyPair{second, first};
    const bool second_owns = rank.is_owned(static_cast<Index>(bodies.second));
    const int owner = static_cast<int>(static_cast<Index>(second_owns ? bodies.second : bodies.first) - rank.driven);
    add(rank, bodies, tags, atoms[static_cast<Index>(owner)], from);
  };
  const auto is_ghost = [&](int atom) { return static_cast<Index>(atom) >= rank.owned; };
  for (const AtomPair& pair : found)
    if (!is_ghost(pair.second)) add_atoms(pair, 0);
  const double reach = *std::max_element(rank.world.reach.begin(), rank.world.reach.end());
  for (Index wall = 0; rank.driven_act && wall < rank.driven; ++wall)
    for (Index atom = 0; atom < rank.owned; ++atom)
      if (sphere_gap(rank, wall, rank.driven + atom) <= skin + reach)
        add(rank, {static_cast<std::int32_t>(wall), static_cast<std::int32_t>(rank.driven + atom)}, tags, atoms[atom],
            0);
  shared_ = drafts_.size();
  for (const AtomPair& pair : found)
    if (is_ghost(pair.second)) add_atoms(pair, shared_);
  place_.assign(rank.bodies.size(), -1);
  for (Draft& draft : drafts_) finish(draft);
  drafts_.clear();
}

const PairChunk* RankPairs::evaluate(const RankBodies& rank) {
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    PairChunk& chunk = chunks_[c];
    const PairChunk* next = c + 1 < chunks_.size() ? &chunks_[c + 1] : nullptr;
    osculate::evaluate(chunk, next, rank.world, rank.bodies, rank.kinematics, osculate::ContactForces::keep, scratch_);
    if (chunk.fault != Fault::none) return &chunk;
  }
  return nullptr;
}

PairSums RankPairs::sums() const {
  PairSums all = gone_;
  for (Index c = 0; c < chunks_.size(); ++c) all.add(chunks_[c], weight(c));
  return all;
}

}  // namespace osculate::lammps
