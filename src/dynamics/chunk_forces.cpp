#include "dynamics/chunk_forces.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "dynamics/contact_edge.hpp"

namespace osculate {
namespace {

using Index = std::size_t;

/// Overlaps beyond this share of the smaller half width are no contact mechanics any more.
constexpr double deepest = 0.25;

/// Most of stiffness over reduced mass times the square of the time step: six steps in half a period.
constexpr double stiffest_step = 0.25;

Index index_of(std::int32_t i) {
  return static_cast<Index>(i);
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void report(PairChunk& chunk, Fault fault, const BodyPair& pair, double overlap) {
  if (chunk.fault != Fault::none) return;
  chunk.fault = fault;
  chunk.fault_pair = pair;
  chunk.fault_overlap = overlap;
}

/// Energy that a contact's normal spring gained since the last step because its coefficient changed: the bodies touch
/// where they are curved otherwise. No force took it from the motion. Only of springs that go with a power of the
/// overlap, from linear to quadratic.
double curvature_gain(NormalSpring& spring, double overlap, double stored, double stiffness) {
  constexpr double hertz = 1.5, same = 1e-9, least = 1.0 - same, most = 2.0;
  const NormalSpring before = spring;
  spring = {0.0, 0.0};
  if (!(overlap > 0.0) || !(stored > 0.0) || !(stiffness > 0.0)) return 0.0;
  const double p = elastic_power(overlap, stored, stiffness);
  if (!(p >= least && p <= most)) return 0.0;
  const auto energy_shape = [p](double depth) {
    return std::fabs(p - hertz) < same ? depth * depth * std::sqrt(depth) : std::pow(depth, p + 1.0);
  };
  spring = {overlap, stored / energy_shape(overlap)};
  if (before.overlap == 0.0) return 0.0;
  return (spring.coefficient - before.coefficient) * energy_shape(0.5 * (before.overlap + overlap));
}

/// One chunk's work in one step.
class ChunkStep {
 public:
  ChunkStep(PairChunk& chunk, const World& world, const Bodies& bodies, const Kinematics& kinematics,
            ChunkScratch& scratch)
      : chunk_(chunk),
        world_(world),
        bodies_(bodies),
        kinematics_(kinematics),
        scratch_(scratch),
        law_(world.setup.interactions[index_of(chunk.group.law)].law),
        reach_(world.reach[index_of(chunk.group.law)]) {}

  /// Those of the far pairs that touch become contacts; the others sleep until they could.
  void watch_far() {
    find_awake();
    chunk_.checked = static_cast<std::int32_t>(scratch_.awake.size() + chunk_.contacts.size());
    if (scratch_.awake.empty()) return;
    scratch_.pairs.clear();
    scratch_.caches.resize(scratch_.awake.size());
    for (Index row = 0; row < scratch_.awake.size(); ++row) {
      const Index k = index_of(scratch_.awake[row]);
      const LocalPair& pair = chunk_.far[k].bodies;
      scratch_.pairs.push_back(pair);
      const bool planes = chunk_.group.narrow_phase == NarrowPhase::superquadrics;
      const auto radius = [&](Index body) { return planes ? shape(body).bounding_radius : 0.0; };
      scratch_.caches.set(row, chunk_.far_caches[k].cache(radius(pair.first), radius(pair.second)));
    }
    solve(scratch_.pairs, scratch_.caches, reach_ > 0.0 ? Gap::resolve : Gap::skip, scratch_.far);
    // From behind, since a pair that leaves is replaced by the last one.
    for (Index row = scratch_.awake.size(); row-- > 0;) sort_out(row);
  }

  void solve_contacts() {
    if (chunk_.contacts.size() > 0) solve(chunk_.contacts.bodies, chunk_.contacts.caches, Gap::skip, scratch_.contacts);
  }

  void apply_law();

  void solve(const std::vector<LocalPair>& pairs, ContactCaches& caches, Gap gap, ChunkScratch::Solved& solved);

 private:
  const BodyRecord& record(Index local) const { return kinematics_.records[index_of(chunk_.bodies[local])]; }
  double travel(const LocalPair& pair) const {
    return kinematics_.travel[index_of(chunk_.bodies[pair.first])] +
           kinematics_.travel[index_of(chunk_.bodies[pair.second])];
  }
  const BodyShape& shape(Index local) const {
    return world_.shapes[index_of(bodies_.shape[index_of(chunk_.bodies[local])])];
  }
  BodyPair global(const LocalPair& pair) const { return {chunk_.bodies[pair.first], chunk_.bodies[pair.second]}; }
  /// The multiple of the periods that brings body 2 next to body 1.
  Vec3 image_shift(const BodyRecord& one, const BodyRecord& two) const {
    const PeriodicBox& box = world_.setup.box;
    if (!box.repeats()) return Vec3::Zero();
    return nearest_image_shift(box, two.position() - one.position());
  }

  void find_awake();
  void sort_out(Index row);
  PairConstants constants_of(const LocalPair& pair) const;
  void describe_motion();
  void call_law();
  void collect_forces();

  PairChunk& chunk_;
  const World& world_;
  const Bodies& bodies_;
  const Kinematics& kinematics_;
  ChunkScratch& scratch_;
  const ContactLaw& law_;
  double reach_;
};

void ChunkStep::find_awake() {
  scratch_.awake.clear();
  scratch_.travel.clear();
  for (const std::int32_t body : chunk_.bodies) scratch_.travel.push_back(kinematics_.travel[index_of(body)]);
  for (Index k = 0; k < chunk_.far.size(); ++k) {
    const FarPair& far = chunk_.far[k];
    if (scratch_.travel[far.bodies.first] + scratch_.travel[far.bodies.second] >= far.quiet_until)
      scratch_.awake.push_back(static_cast<std::int32_t>(k));
  }
}

void ChunkStep::solve(const std::vector<LocalPair>& pairs, ContactCaches& caches, Gap gap,
                      ChunkScratch::Solved& solved) {
  if (chunk_.group.narrow_phase == NarrowPhase::superquadrics) {
    constexpr Index each = SuperquadricPairs::per_body;
    solved.superquadrics.resize(pairs.size());
    double* columns[2 * each];
    for (Index k = 0; k < 2 * each; ++k) columns[k] = solved.superquadrics.columns[k];
    const bool repeats = world_.setup.box.repeats();
    for (Index row = 0; row < pairs.size(); ++row) {
      const BodyRecord &one = record(pairs[row].first), &two = record(pairs[row].second);
      for (Index k = 0; k < each; ++k) columns[k][row] = one.placed[k];
      for (Index k = 0; k < each; ++k) columns[each + k][row] = two.placed[k];
      if (!repeats) continue;
      const Vec3 shift = image_shift(one, two);
      for (Index k = 0; k < 3; ++k) columns[each + 5 + k][row] += shift[static_cast<Eigen::Index>(k)];
    }
    common_normals(solved.superquadrics, caches, solved.geometry, gap);
    return;
  }
  solved.shapes.resize(pairs.size());
  for (Index row = 0; row < pairs.size(); ++row) {
    const BodyRecord &one = record(pairs[row].first), &two = record(pairs[row].second);
    const BodyShape &shape_1 = shape(pairs[row].first), &shape_2 = shape(pairs[row].second);
    Pose second = two.pose();
    second.position += image_shift(one, two);
    solved.shapes.set(row, shape_1.shape, shape_pose(shape_1, one.pose()), shape_2.shape, shape_pose(shape_2, second));
  }
  common_normals(solved.shapes, caches, solved.geometry, gap);
}

PairConstants ChunkStep::constants_of(const LocalPair& pair) const {
  const BodyPair bodies = global(pair);
  const Index one = index_of(bodies.first), two = index_of(bodies.second);
  const auto mass = [&](Index body) {
    return bodies_.is_free(body) ? bodies_.mass[body] : std::numeric_limits<double>::infinity();
  };
  const auto half_harmonic = [](double x, double y) { return 1.0 / (1.0 / x + 1.0 / y); };  // one may be ∞
  const double radius_1 = shape(pair.first).volume_radius, radius_2 = shape(pair.second).volume_radius;
  return {.reduced_mass = half_harmonic(mass(one), mass(two)),
          .effective_radius = half_harmonic(radius_1, radius_2),
          .radius_cap = world_.setup.radius_cap * std::min(radius_1, radius_2)};
}

void ChunkStep::sort_out(Index row) {
  constexpr double safety = 1e-9;  // of the bodies' size: far above the round-off of a gap
  const Index k = index_of(scratch_.awake[row]);
  FarPair& far = chunk_.far[k];
  const double overlap = scratch_.far.geometry.columns[3][row];
  const ContactStatus status = scratch_.far.geometry.statuses[row];
  if (!is_resolved(status) && !(status == ContactStatus::not_converged && overlap < -reach_))
    report(chunk_, status == ContactStatus::degenerate ? Fault::degenerate : Fault::not_converged, global(far.bodies),
           overlap);
  const ContactCache cache = scratch_.caches.get(row);
  if (overlap > -reach_) {
    append_contact(chunk_.contacts, far.bodies, cache, constants_of(far.bodies), law_);
    far = chunk_.far.back();
    chunk_.far.pop_back();
    chunk_.far_caches[k] = chunk_.far_caches.back();
    chunk_.far_caches.pop_back();
    return;
  }
  chunk_.far_caches[k] = FarCache(cache);
  const double size = std::min(shape(far.bodies.first).bounding_radius, shape(far.bodies.second).bounding_radius);
  far.quiet_until = rounded_down(travel(far.bodies) - overlap - reach_ - safety * size);
}

Vec3 column_vector(const ContactColumns& contacts, Index first, Index row) {
  return {contacts.columns[first][row], contacts.columns[first + 1][row], contacts.columns[first + 2][row]};
}

template <Index N>
Vectors<double> vectors(Columns<N>& columns, Index first, Index size) {
  return {{columns[first], size}, {columns[first + 1], size}, {columns[first + 2], size}};
}
template <Index N>
Vectors<const double> const_vectors(const Columns<N>& columns, Index first, Index size) {
  return {{columns[first], size}, {columns[first + 1], size}, {columns[first + 2], size}};
}

void put(double* const* columns, Index i, const Vec3& v) {
  columns[0][i] = v.x();
  columns[1][i] = v.y();
  columns[2][i] = v.z();
}

/// Columns of ContactColumns, of the motion and of the law's answer.
namespace geometry {
enum : Index { normal = 0, overlap = 3, on_1 = 4, on_2 = 7, R_i = 20, R_j = 21, major_axis = 22 };
}
namespace motion {
enum : Index { velocity = 0, angular = 3, mean_angular = 6 };
}
namespace answer {
enum : Index {
  force = 0,
  couple = 3,
  normal_force = 6,
  stiffness,
  stored_normal,
  stored_tangential,
  viscous_loss,
  friction_loss,
  hysteresis_loss
};
}

/// Arms, velocities, capped radii.
void ChunkStep::describe_motion() {
  const Index size = chunk_.contacts.size();
  scratch_.arm_1.resize(size);
  scratch_.arm_2.resize(size);
  scratch_.motion.resize(size);
  double* columns[9];
  for (Index k = 0; k < 9; ++k) columns[k] = scratch_.motion[k];
  ContactColumns& found = scratch_.contacts.geometry;
  const bool repeats = world_.setup.box.repeats();
  const LawNeeds& needs = law_.needs();
  for (Index i = 0; i < size; ++i) {
    const LocalPair& pair = chunk_.contacts.bodies[i];
    const BodyRecord &one = record(pair.first), &two = record(pair.second);
    const double cap = chunk_.contacts.radius_cap[i];
    double &R_i = found.columns[geometry::R_i][i], &R_j = found.columns[geometry::R_j][i];
    const Vec3 n = column_vector(found, geometry::normal, i);
    if (!(R_j > 0.0)) {
      // A gap that was proved but not resolved has neither points nor curvatures.
      R_i = R_j = cap;
      double* axes[] = {found.columns[geometry::major_axis], found.columns[geometry::major_axis + 1],
                        found.columns[geometry::major_axis + 2]};
      put(axes, i, n.unitOrthogonal());
      for (double* column : columns) column[i] = 0.0;
      scratch_.arm_1[i] = scratch_.arm_2[i] = Vec3::Zero();
      continue;
    }
    R_i = std::min(R_i, cap);
    R_j = std::min(R_j, cap);
    const Vec3 point = 0.5 * (column_vector(found, geometry::on_1, i) + column_vector(found, geometry::on_2, i));
    const Vec3 arm_1 = point - one.position();
    Vec3 arm_2 = point - two.position();
    if (repeats) arm_2 -= image_shift(one, two);
    scratch_.arm_1[i] = arm_1;
    scratch_.arm_2[i] = arm_2;
    const Vec3 moved =
        two.velocity + two.mean_angular_velocity.cross(arm_2) - one.velocity - one.mean_angular_velocity.cross(arm_1);
    const Vec3 now = two.last_velocity + two.last_angular_velocity.cross(arm_2) - one.last_velocity -
                     one.last_angular_velocity.cross(arm_1);
    put(columns + motion::velocity, i, moved + n.dot(now - moved) * n);
    if (needs.angular_velocity)
      put(columns + motion::angular, i, two.mean_angular_velocity - one.mean_angular_velocity);
    if (needs.mean_angular_velocity)
      put(columns + motion::mean_angular, i, 0.5 * (two.mean_angular_velocity + one.mean_angular_velocity));
  }
}

void ChunkStep::call_law() {
  Contacts& contacts = chunk_.contacts;
  const Index size = contacts.size();
  const ContactColumns& found = scratch_.contacts.geometry;
  Columns<13>& out = scratch_.answer;
  out.resize(size);
  scratch_.status.resize(size);
  const auto given = [&](Index k) { return std::span(found.columns[k], size); };
  const auto column = [&](Index k) { return std::span(out[k], size); };
  const LawInput input{.R_i = given(geometry::R_i),
                       .R_j = given(geometry::R_j),
                       .overlap = given(geometry::overlap),
                       .normal = const_vectors(found.columns, geometry::normal, size),
                       .major_axis = const_vectors(found.columns, geometry::major_axis, size),
                       .velocity = const_vectors(scratch_.motion, motion::velocity, size),
                       .angular_velocity = const_vectors(scratch_.motion, motion::angular, size),
                       .mean_angular_velocity = const_vectors(scratch_.motion, motion::mean_angular, size),
                       .reduced_mass = contacts.reduced_mass,
                       .effective_radius = contacts.effective_radius,
                       .smallest_radius = {},
                       .time_step = kinematics_.time_step};
  const LawOutput output{.force = vectors(out, answer::force, size),
                         .couple = law_.makes_couples() ? vectors(out, answer::couple, size) : Vectors<double>{},
                         .normal_force = column(answer::normal_force),
                         .status = scratch_.status,
                         .a_c = {},
                         .axis_ratio = {},
                         .stiffness = column(answer::stiffness),
                         .stored_normal = column(answer::stored_normal),
                         .stored_tangential = column(answer::stored_tangential),
                         .viscous_loss = column(answer::viscous_loss),
                         .friction_loss = column(answer::friction_loss),
                         .hysteresis_loss = column(answer::hysteresis_loss)};
  law_.evaluate(input, doubles_of(contacts.memory), output);
}

void ChunkStep::collect_forces() {
  constexpr double safety = 1e-9;
  Contacts& contacts = chunk_.contacts;
  const Index size = contacts.size();
  const ContactColumns& found = scratch_.contacts.geometry;
  const Columns<13>& out = scratch_.answer;
  const double dt = kinematics_.time_step;
  const bool couples = law_.makes_couples();
  const double shallow = deepest * world_.least_half_width;
  double viscous = 0.0, friction = 0.0, hysteresis = 0.0, stored_normal = 0.0, stored_tangential = 0.0, most = 0.0,
         gain = 0.0;
  scratch_.opened.clear();
  for (Index i = 0; i < size; ++i) {
    const LocalPair& pair = contacts.bodies[i];
    const double overlap = found.columns[geometry::overlap][i];
    const ContactStatus geometry_status = found.statuses[i];
    const LawStatus status = scratch_.status[i];
    if (!is_resolved(geometry_status) && !(geometry_status == ContactStatus::not_converged && overlap < -reach_))
      report(chunk_, geometry_status == ContactStatus::degenerate ? Fault::degenerate : Fault::not_converged,
             global(pair), overlap);
    if (status == LawStatus::bad_input || status == LawStatus::not_converged)
      report(chunk_, Fault::law_refused, global(pair), overlap);
    if (overlap > shallow && overlap > deepest * std::min(shape(pair.first).half_width, shape(pair.second).half_width))
      report(chunk_, Fault::too_deep, global(pair), overlap);
    viscous += out[answer::viscous_loss][i];
    friction += out[answer::friction_loss][i];
    hysteresis += out[answer::hysteresis_loss][i];
    if (status == LawStatus::open && overlap <= -reach_) {
      scratch_.opened.push_back(static_cast<std::int32_t>(i));
      continue;
    }
    const double stored = out[answer::stored_normal][i], stiffness = out[answer::stiffness][i];
    stored_normal += stored;
    if (reach_ == 0.0) gain += curvature_gain(contacts.spring[i], overlap, stored, stiffness);
    stored_tangential += out[answer::stored_tangential][i];
    const double stiffest = stiffness / contacts.reduced_mass[i];
    most = std::max(most, stiffest);
    if (stiffest * dt * dt > stiffest_step) report(chunk_, Fault::step_too_long, global(pair), overlap);
    const Vec3 n = column_vector(found, geometry::normal, i);
    const Vec3 v(scratch_.motion[0][i], scratch_.motion[1][i], scratch_.motion[2][i]);
    const double edge = edge_force(overlap, std::fabs(n.dot(v)) * dt, stored, stiffness);
    const Vec3 force = Vec3(out[0][i], out[1][i], out[2][i]) - edge * n;
    contacts.force[i] = force;
    Wrench &on_1 = chunk_.wrenches[pair.first], &on_2 = chunk_.wrenches[pair.second];
    on_1.force += force;
    on_2.force -= force;
    on_1.torque += scratch_.arm_1[i].cross(force);
    on_2.torque -= scratch_.arm_2[i].cross(force);
    if (!couples) continue;
    const Vec3 couple(out[answer::couple][i], out[answer::couple + 1][i], out[answer::couple + 2][i]);
    contacts.couple[i] = couple;
    on_1.torque += couple;
    on_2.torque -= couple;
  }
  chunk_.viscous_loss += viscous;
  chunk_.friction_loss += friction;
  chunk_.hysteresis_loss += hysteresis;
  chunk_.curvature_gain += gain;
  chunk_.stored_normal = stored_normal;
  chunk_.stored_tangential = stored_tangential;
  chunk_.stiffest = most;
  for (Index k = scratch_.opened.size(); k-- > 0;) {
    const Index i = index_of(scratch_.opened[k]);
    const LocalPair pair = contacts.bodies[i];
    const double size_of_pair = std::min(shape(pair.first).bounding_radius, shape(pair.second).bounding_radius);
    const double gap = -found.columns[geometry::overlap][i] - reach_ - safety * size_of_pair;
    chunk_.far.push_back({pair, rounded_down(travel(pair) + gap)});
    chunk_.far_caches.emplace_back(contacts.caches.get(i));
    remove_contact(contacts, i, law_);
  }
}

void ChunkStep::apply_law() {
  chunk_.stored_normal = chunk_.stored_tangential = chunk_.stiffest = 0.0;
  std::fill(chunk_.wrenches.begin(), chunk_.wrenches.end(), Wrench{Vec3::Zero(), Vec3::Zero()});
  if (chunk_.contacts.size() == 0) return;
  describe_motion();
  call_law();
  collect_forces();
}

}  // namespace

void evaluate(PairChunk& chunk, const World& world, const Bodies& bodies, const Kinematics& kinematics,
              ChunkScratch& scratch) {
  const auto begin = std::chrono::steady_clock::now();
  ChunkStep step(chunk, world, bodies, kinematics, scratch);
  step.watch_far();
  step.solve_contacts();
  scratch.narrow_seconds += seconds_since(begin);
  const auto middle = std::chrono::steady_clock::now();
  step.apply_law();
  scratch.law_seconds += seconds_since(middle);
}

ContactColumns geometry_of(const PairChunk& chunk, const World& world, const Bodies& bodies,
                           const Kinematics& kinematics) {
  ChunkScratch scratch;
  PairChunk copy;
  copy.group = chunk.group;
  copy.bodies = chunk.bodies;
  scratch.caches = chunk.contacts.caches;
  ChunkStep(copy, world, bodies, kinematics, scratch)
      .solve(chunk.contacts.bodies, scratch.caches, Gap::resolve, scratch.contacts);
  return scratch.contacts.geometry;
}

std::array<double, 5> superquadric_numbers(const Shape& shape) {
  return std::visit(
      [](const auto& one) -> std::array<double, 5> {
        if constexpr (requires { as_superquadric(one); }) {
          const Superquadric body = as_superquadric(one);
          return {body.half_axes.x(), body.half_axes.y(), body.half_axes.z(), body.exponents.n1, body.exponents.n2};
        } else {
          return {};
        }
      },
      shape);
}

}  // namespace osculate
