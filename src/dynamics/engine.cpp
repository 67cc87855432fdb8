#include "dynamics/engine.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <string>

#include "dynamics/driven_travel.hpp"
#include "dynamics/fault_text.hpp"
#include "dynamics/kick_bodies.hpp"
#include "dynamics/move_bodies.hpp"
#include "dynamics/pouring.hpp"

namespace osculate {
namespace {

constexpr std::size_t body_block = 256;

/// Adds the time a stage takes.
class StageClock {
 public:
  explicit StageClock(double& seconds) : seconds_(seconds), begin_(std::chrono::steady_clock::now()) {}
  ~StageClock() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point begin_;
};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

Simulation::Engine::Engine(const Setup& setup)
    : world_(make_world(setup)), bodies_(make_bodies(world_)), threads_(setup.threads) {
  make_room();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BodyRecord& record = kinematics_.records[i];
    record.velocity = record.last_velocity = bodies_.velocity[i];
    record.mean_angular_velocity = record.last_angular_velocity = bodies_.angular_velocity(i);
  }
  for (const Driven& driven : driven_) {
    const BodyStart& start = world_.starts[driven.body];
    const Moving moving = at_time(world_.setup.motions[static_cast<std::size_t>(start.motion)], start.pose, 0.0);
    BodyRecord& record = kinematics_.records[driven.body];
    bodies_.velocity[driven.body] = record.velocity = record.last_velocity = moving.velocity;
    record.mean_angular_velocity = record.last_angular_velocity = moving.angular_velocity;
  }
  rebuild();
  evaluate_pairs(ContactForces::keep);
  image_power_ = image_power();
  kick_bodies({.time = 0.0, .gravity = setup.gravity}, 0, bodies_.size(), pairs_, bodies_);
  kinematics_.time_step = setup.time_step;
}

/// Everything that has one entry a body, with the bodies where they are.
void Simulation::Engine::make_room() {
  poured_.resize(world_.setup.pours.size());
  scratch_.resize(static_cast<std::size_t>(threads_.count()));
  const auto reserve = [&](auto&... items) { (items.reserve(bodies_.size()), ...); };
  reserve(kinematics_.records, kinematics_.travel, kinematics_.skin, step_travel_, listed_at_, radius_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) make_room_for(i);
}

void Simulation::Engine::make_room_for(std::size_t body) {
  const BodyShape& shape = world_.shapes[static_cast<std::size_t>(bodies_.shape[body])];
  BodyRecord& record = kinematics_.records.emplace_back();
  const auto numbers = superquadric_numbers(shape.shape);
  std::copy(numbers.begin(), numbers.end(), record.placed.begin());
  record.place(bodies_.position[body], bodies_.orientation[body]);
  kinematics_.travel.push_back(0.0);
  kinematics_.skin.push_back(world_.least_skin);
  step_travel_.push_back(0.0);
  listed_at_.push_back(bodies_.position[body]);
  radius_.push_back(shape.bounding_radius);
  if (!bodies_.is_free(body)) driven_.push_back({.body = body});
}

bool Simulation::Engine::pour_is_due() const {
  return !poured_.empty() && steps_ % steps_between_pours == 0;
}

/// Particles that are due come in, each further from everything than any force acts.
void Simulation::Engine::pour() {
  const std::size_t before = bodies_.size();
  for (std::size_t p = 0; p < poured_.size(); ++p)
    for (const BodyStart& start : poured_now(world_, bodies_, world_.setup.pours[p], steps_, poured_[p])) {
      const std::size_t body = bodies_.size();
      append_body(world_, start, "body " + std::to_string(body), bodies_);
      make_room_for(body);
      poured_energy_ +=
          bodies_.mass[body] * (0.5 * start.velocity.squaredNorm() - world_.setup.gravity.dot(start.pose.position));
    }
  if (bodies_.size() > before) rebuild();
}

void Simulation::Engine::advance(std::uint64_t steps) {
  // A step ends with a kick of every body and the next one begins with its motion: one pass over the bodies does both.
  bool kick_is_due = false;
  for (std::uint64_t left = steps; left > 0; --left) {
    if (pour_is_due()) {
      if (kick_is_due) end_step();
      kick_is_due = false;
      const StageClock clock(times_.broad);
      pour();
    }
    move(kick_is_due);
    if (list_is_stale_) {
      const StageClock clock(times_.broad);
      rebuild();
    }
    evaluate_pairs(left == 1 ? ContactForces::keep : ContactForces::skip);
    kick_is_due = true;
  }
  if (kick_is_due) end_step();
}

void Simulation::Engine::end_step() {
  {
    const StageClock clock(times_.move);
    const Kick kick = half_kick();
    threads_.for_blocks(bodies_.size(), body_block,
                        [&](std::size_t begin, std::size_t end) { kick_bodies(kick, begin, end, pairs_, bodies_); });
  }
  add_driven_work();
}

/// Of the step whose forces are known now.
void Simulation::Engine::add_driven_work() {
  for (const Driven& driven : driven_)
    driven_work_ -= 0.5 * ((driven.force + bodies_.force[driven.body]).dot(driven.displacement) +
                           (driven.torque + bodies_.torque[driven.body]).dot(driven.turn));
  if (!world_.box.shear) return;
  const double power = image_power();
  driven_work_ += 0.5 * world_.setup.time_step * (image_power_ + power);
  image_power_ = power;
}

/// What the images of a sheared box do: moving, they push as driven bodies do.
double Simulation::Engine::image_power() const {
  double power = 0.0;
  for (const PairChunk& chunk : pairs_.chunks) power += chunk.image_power;
  return power;
}

/// The mean velocity in a sheared box. What bodies and images do beyond it decides how near two of them can come: those
/// that are far apart along the gradient cannot touch, whatever the flow does between them.
Vec3 Simulation::Engine::flow_at(const Vec3& position) const {
  return image_velocity(world_.box, position - world_.box.origin - 0.5 * world_.box.length);
}

/// How far the flow moves two bodies of a pair against each other in a time, at most.
double Simulation::Engine::flow_way(double time) const {
  return world_.box.shear ? std::fabs(world_.box.shear->rate) * flow_reach_ * time : 0.0;
}

/// Skins that make lists and looks at pairs that do not touch cost least together: as many steps to the next list as a
/// typical body's speed makes worth while, and for each body the way it will have gone by then.
void Simulation::Engine::choose_skins() {
  constexpr double listing_cost = 100.0;  // of a body in a new list, over that of a step's look at a far pair
  constexpr double crowding = 14.0;       // far pairs that a skin of a radius adds to a body, in a dense bed
  constexpr double most_steps = 1000.0, spare = 1.25;
  const double dt = world_.setup.time_step;
  const auto speed = [&](std::size_t i) { return (bodies_.velocity[i] - flow_at(bodies_.position[i])).norm(); };
  double sum = 0.0;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_.is_free(i)) sum += dt * speed(i) / radius_[i];
  const double mean = sum / static_cast<double>(bodies_.size() - driven_.size());  // a share of the radius in a step
  const double steps = std::min(most_steps, std::sqrt(listing_cost / (crowding * mean)));
  const double of_flow = 0.5 * flow_way(steps * dt);
  double most = world_.least_skin;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const bool is_free = bodies_.is_free(i);
    const double way = is_free ? dt * speed(i) : step_travel_[i];
    const double cap = is_free ? std::min(radius_[i], world_.most_skin) : world_.most_skin;
    kinematics_.skin[i] = std::max(world_.least_skin, std::min(spare * steps * way + of_flow, cap));
    most = std::max(most, kinematics_.skin[i]);
  }
  flow_reach_ = 2.0 * (world_.largest_radius + most) + world_.largest_reach;
}

/// Begins a step. If the last one is still to end, bodies get the rest of its kick on the way.
void Simulation::Engine::move(bool kick_is_due) {
  const StageClock clock(times_.move);
  const double dt = world_.setup.time_step;
  const MoveStep step{.time_step = dt, .gravity = world_.setup.gravity};
  const Kick kick = half_kick();
  for (Driven& driven : driven_) driven.position = bodies_.position[driven.body];
  ++steps_;
  if (world_.box.shear) world_.box = at_time(world_.setup.box, time());
  const double most = 0.5 * world_.least_half_width;  // of a way in one step
  const double elapsed = static_cast<double>(steps_ - listed_step_) * dt;
  const double in_flow = 0.5 * flow_way(elapsed), flow_in_step = 0.5 * flow_way(dt);
  const bool is_sheared = world_.box.shear.has_value();
  std::atomic<bool> is_stale = false, is_lost = false;
  const auto look_at = [&](std::size_t i, bool is_free) {
    double& travel = kinematics_.travel[i];
    travel += step_travel_[i];
    Vec3 gone = bodies_.position[i] - listed_at_[i];
    if (is_sheared) {
      const Vec3& velocity = bodies_.velocity[i];
      travel += flow_in_step + dt * ((velocity - flow_at(bodies_.position[i])).norm() - velocity.norm());
      gone -= elapsed * flow_at(listed_at_[i]);
    }
    // Spheres around bodies were listed with their skins. What turns in its sphere does not matter.
    const double room = kinematics_.skin[i] - in_flow;
    if (is_free ? !(room > 0.0) || gone.squaredNorm() > room * room : travel > room)
      is_stale.store(true, std::memory_order_relaxed);
    if (!(step_travel_[i] <= most)) is_lost.store(true, std::memory_order_relaxed);  // NaN too
  };
  threads_.for_blocks(bodies_.size(), body_block, [&](std::size_t begin, std::size_t end) {
    if (kick_is_due) kick_bodies(kick, begin, end, pairs_, bodies_);
    move_bodies(step, begin, end, bodies_, kinematics_, radius_, step_travel_);
    for (std::size_t i = begin; i < end; ++i)
      if (bodies_.is_free(i)) look_at(i, true);
  });
  if (kick_is_due) add_driven_work();
  for (Driven& driven : driven_) {
    move_driven(driven);
    look_at(driven.body, false);
  }
  list_is_stale_ = is_stale;
  if (is_lost) stop_at_lost(most);
}

/// A body went further in a step than it may, or nowhere.
void Simulation::Engine::stop_at_lost(double most) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const double way = step_travel_[i];
    if (way <= most) continue;  // false for NaN too
    throw StepError(when() + "body " + std::to_string(i) +
                    (std::isfinite(way)
                         ? " moved " + number(way) + " m in one step, more than half of the least half width " +
                               number(world_.least_half_width) + " m of all particles"
                         : " has a position or velocity that is not finite"));
  }
}

void Simulation::Engine::move_driven(Driven& driven) {
  const std::size_t i = driven.body;
  const double dt = world_.setup.time_step;
  const BodyStart& start = world_.starts[i];
  const Moving moving = at_time(world_.setup.motions[static_cast<std::size_t>(start.motion)], start.pose, time());
  driven.displacement = moving.pose.position - driven.position;
  driven.turn = dt * moving.angular_velocity;
  driven.force = bodies_.force[i];
  driven.torque = bodies_.torque[i];
  bodies_.position[i] = moving.pose.position;
  bodies_.orientation[i] = moving.pose.orientation;
  bodies_.velocity[i] = driven.displacement / dt;
  bodies_.angular_momentum[i].setZero();
  BodyRecord& record = kinematics_.records[i];
  record.place(moving.pose.position, moving.pose.orientation);
  record.velocity = bodies_.velocity[i];
  record.last_velocity = moving.velocity;
  record.mean_angular_velocity = record.last_angular_velocity = moving.angular_velocity;
  step_travel_[i] = driven_travel(world_.shapes[static_cast<std::size_t>(bodies_.shape[i])], bodies_.pose(i),
                                  {driven.displacement, driven.turn}, {centre_, extent_});
}

/// The body's image inside the box takes its place.
void Simulation::Engine::wrap(std::size_t body) {
  const Vec3 shift = shift_inside(world_.box, bodies_.position[body]);
  if (shift.isZero(0.0)) return;
  const Vec3 inside = wrapped(world_.box, bodies_.position[body]);
  const double mass = bodies_.mass[body];
  gravity_wrapped_ += mass * world_.setup.gravity.dot(inside - bodies_.position[body]);
  bodies_.position[body] = inside;
  BodyRecord& record = kinematics_.records[body];
  record.place(inside, bodies_.orientation[body]);
  const Vec3 change = image_velocity(world_.box, shift);
  driven_work_ += mass * change.dot(bodies_.velocity[body] + 0.5 * change);
  bodies_.velocity[body] += change;
  record.velocity += change;
  record.last_velocity += change;
}

void Simulation::Engine::rebuild() {
  ++rebuilds_;
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_.is_free(i)) continue;
    if (world_.box.repeats()) wrap(i);
    lower = lower.cwiseMin(bodies_.position[i]);
    upper = upper.cwiseMax(bodies_.position[i]);
  }
  if (!(lower.x() <= upper.x())) lower = upper = Vec3::Zero();  // nothing has come in yet
  centre_ = 0.5 * (lower + upper);
  choose_skins();
  extent_ = 0.5 * (upper - lower).norm() + world_.largest_radius +
            *std::max_element(kinematics_.skin.begin(), kinematics_.skin.end());
  pairs_ = make_pair_list(std::move(pairs_), world_, bodies_, kinematics_, threads_);
  listed_at_ = bodies_.position;
  std::fill(kinematics_.travel.begin(), kinematics_.travel.end(), 0.0);
  listed_step_ = steps_;
}

void Simulation::Engine::evaluate_pairs(ContactForces forces) {
  constexpr std::size_t most = 16, blocks_of_thread = 8;
  const auto threads = static_cast<std::size_t>(threads_.count());
  const std::size_t size = pairs_.chunks.size(), share = size / (blocks_of_thread * threads);
  const std::size_t block = threads == 1 ? std::max<std::size_t>(size, 1) : std::clamp<std::size_t>(share, 1, most);
  threads_.for_blocks(size, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      // Only within the block: another thread may be at work on any other chunk.
      const PairChunk* next = c + 1 < end ? &pairs_.chunks[c + 1] : nullptr;
      evaluate(pairs_.chunks[c], next, world_, bodies_, kinematics_, forces, scratch_[Threads::current()]);
    }
  });
  for (const PairChunk& chunk : pairs_.chunks)
    if (chunk.fault != Fault::none) stop_at(chunk);
}

std::string Simulation::Engine::when() const {
  return "step " + std::to_string(steps_) + ", t = " + number(time()) + " s: ";
}

void Simulation::Engine::stop_at(const PairChunk& chunk) const {
  const BodyPair& pair = chunk.fault_pair;
  throw StepError(when() +
                  fault_text(chunk, "bodies " + std::to_string(pair.first) + " and " + std::to_string(pair.second)));
}

EnergyLedger Simulation::Engine::energy() const {
  EnergyLedger energy{};
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_.is_free(i)) continue;
    energy.kinetic += 0.5 * bodies_.mass[i] * bodies_.velocity[i].squaredNorm();
    energy.rotational +=
        0.5 * bodies_.angular_momentum[i].dot(bodies_.angular_momentum[i].cwiseQuotient(bodies_.inertia[i]));
    energy.gravity -= bodies_.mass[i] * world_.setup.gravity.dot(bodies_.position[i]);
  }
  energy.gravity += gravity_wrapped_;
  energy.viscous_loss = pairs_.viscous_loss;
  energy.friction_loss = pairs_.friction_loss;
  energy.hysteresis_loss = pairs_.hysteresis_loss;
  energy.curvature_gain = pairs_.curvature_gain;
  for (const PairChunk& chunk : pairs_.chunks) {
    energy.stored_normal += chunk.stored_normal;
    energy.stored_tangential += chunk.stored_tangential;
    energy.viscous_loss += chunk.viscous_loss;
    energy.friction_loss += chunk.friction_loss;
    energy.hysteresis_loss += chunk.hysteresis_loss;
    energy.curvature_gain += chunk.curvature_gain;
  }
  energy.driven_work = driven_work_;
  energy.poured = poured_energy_;
  return energy;
}

StepCounts Simulation::Engine::counts() const {
  StepCounts counts{};
  for (const PairChunk& chunk : pairs_.chunks) {
    counts.candidates += chunk.far.size() + chunk.contacts.size();
    counts.checked += static_cast<std::uint64_t>(chunk.checked);
    counts.contacts += chunk.contacts.size();
  }
  counts.rebuilds = rebuilds_;
  return counts;
}

StageTimes Simulation::Engine::times() const {
  StageTimes times = times_;
  for (const ChunkScratch& scratch : scratch_) {
    times.narrow += scratch.narrow_seconds;
    times.law += scratch.law_seconds;
  }
  return times;
}

std::vector<Contact> Simulation::Engine::contacts() const {
  std::vector<Contact> contacts;
  for (const PairChunk& chunk : pairs_.chunks) {
    const Contacts& pairs = chunk.contacts;
    if (pairs.size() == 0) continue;
    const ContactColumns geometry = geometry_of(chunk, world_, bodies_, kinematics_);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const std::int32_t one = chunk.bodies[pairs.bodies[i].first];
      const std::int32_t two = chunk.bodies[pairs.bodies[i].second];
      const ContactGeometry found = geometry.get(i);
      const Vec3 difference =
          bodies_.position[static_cast<std::size_t>(two)] - bodies_.position[static_cast<std::size_t>(one)];
      const PeriodicBox& box = world_.box;
      const Vec3 shift = box.repeats() ? nearest_image_shift(box, difference) : Vec3::Zero();
      contacts.push_back({.body_1 = one,
                          .body_2 = two,
                          .point = found.point(),
                          .normal = found.normal,
                          .overlap = found.overlap,
                          .force = pairs.force[i],
                          .couple = pairs.couple.empty() ? Vec3::Zero() : pairs.couple[i],
                          .branch = difference + shift});
    }
  }
  return contacts;
}

}  // namespace osculate
