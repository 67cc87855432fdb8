#include "dynamics/chunk_forces.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "geometry/contact_rows.hpp"
#include "geometry/pair_order.hpp"
#include "geometry/superquadric_narrow.hpp"
#include "osculate/geometry/plane_contacts.hpp"

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
    first_new_ = chunk_.contacts.size();
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
    for (Index row = scratch_.awake.size(); row-- > 0;) {
      make_room_for_one(chunk_);
      sort_out(row);
    }
  }

  void solve_contacts() {
    if (chunk_.contacts.size() == 0) return;
    solve(chunk_.contacts.bodies, chunk_.contacts.caches, Gap::skip, scratch_.contacts);
    if (chunk_.group.narrow_phase == NarrowPhase::faces) hand_over();
  }

  void apply_law(ContactForces forces);

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
  PairRecords records(const std::vector<LocalPair>& pairs) const {
    return {pairs, chunk_.bodies.data(), kinematics_.records.data()};
  }
  void find_images(const std::vector<LocalPair>& pairs, ImageShifts& images) const;

  void solve_faces(const std::vector<LocalPair>& pairs, ContactColumns& geometry) const;
  void hand_over();
  void find_awake();
  void sort_out(Index row);
  PairConstants constants_of(const LocalPair& pair) const;
  void spread_constants();
  void call_law();
  void check_contacts();
  void report_extremes(const LawSums& sums);
  void open_contacts();

  PairChunk& chunk_;
  const World& world_;
  const Bodies& bodies_;
  const Kinematics& kinematics_;
  ChunkScratch& scratch_;
  const ContactLaw& law_;
  double reach_;
  Index first_new_ = 0;  ///< of the contacts: those from here on were far pairs before this step
};

void ChunkStep::solve_faces(const std::vector<LocalPair>& pairs, ContactColumns& geometry) const {
  constexpr double beyond = 1e-9;
  geometry.resize(pairs.size());
  for (Index row = 0; row < pairs.size(); ++row) {
    const bool face_first = shape(pairs[row].first).is_face();
    const Index of_particle = face_first ? pairs[row].second : pairs[row].first;
    const BodyShape &particle = shape(of_particle), &face = shape(face_first ? pairs[row].first : pairs[row].second);
    FaceContact found =
        face_contact(particle.shape, shape_pose(particle, record(of_particle).pose()), *face.surface,
                     record(face_first ? pairs[row].first : pairs[row].second).pose(), face.face, reach_);
    // What is not the face's to make is out of the law's reach.
    if (!found.is_active)
      found.contact.overlap =
          std::min(found.contact.overlap, -reach_ * (1.0 + beyond) - std::numeric_limits<double>::min());
    if (face_first) swap_bodies(found.contact);
    set_row(geometry, row, found.contact);
  }
}

/// Where a particle leaves a face and has come onto the next one, the new contact goes on with what the old one knew.
void ChunkStep::hand_over() {
  const Contacts& contacts = chunk_.contacts;
  const auto face_of = [&](const LocalPair& pair) -> const BodyShape& {
    return shape(pair.first).is_face() ? shape(pair.first) : shape(pair.second);
  };
  const auto particle_of = [&](const LocalPair& pair) {
    return shape(pair.first).is_face() ? pair.second : pair.first;
  };
  const double* overlaps = scratch_.contacts.geometry.columns[of_geometry::overlap];
  for (Index to = first_new_; to < contacts.size(); ++to) {
    const BodyShape& face = face_of(contacts.bodies[to]);
    const auto& neighbours = face.surface->faces[static_cast<Index>(face.face)].neighbours;
    for (Index from = 0; from < first_new_; ++from) {
      const BodyShape& old = face_of(contacts.bodies[from]);
      if (overlaps[from] > -reach_ || old.surface != face.surface ||
          particle_of(contacts.bodies[from]) != particle_of(contacts.bodies[to]) ||
          !std::binary_search(neighbours.begin(), neighbours.end(), old.face))
        continue;
      move_memory(chunk_.contacts, from, to, law_);
      break;
    }
  }
}

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

void ChunkStep::find_images(const std::vector<LocalPair>& pairs, ImageShifts& images) const {
  const PeriodicBox& box = world_.box;
  if (!box.repeats()) return;
  images.shift.resize(pairs.size());
  if (box.shear) images.flow = ImageFlow{box.shear->flow, box.shear->gradient, box.shear->rate};
  for (Index row = 0; row < pairs.size(); ++row) {
    const Vec3 apart = record(pairs[row].second).position() - record(pairs[row].first).position();
    const Vec3 nearer = nearest_image_shift(box, apart);
    for (Index k = 0; k < 3; ++k) images.shift[k][row] = nearer[static_cast<Eigen::Index>(k)];
  }
}

void ChunkStep::solve(const std::vector<LocalPair>& pairs, ContactCaches& caches, Gap gap,
                      ChunkScratch::Solved& solved) {
  if (chunk_.group.narrow_phase == NarrowPhase::faces) return solve_faces(pairs, solved.geometry);
  find_images(pairs, solved.images);
  const Columns<3>& shift = solved.images.shift;
  const bool on_planes = chunk_.group.narrow_phase == NarrowPhase::planes;
  if (on_planes || chunk_.group.narrow_phase == NarrowPhase::superquadrics) {
    fill_pairs(records(pairs), solved.superquadrics, scratch_.ahead);
    for (Index k = 0; k < 3; ++k) {
      double* x = solved.superquadrics.columns[SuperquadricPairs::per_body + 5 + k];
      for (Index row = 0; row < shift.size(); ++row) x[row] += shift[k][row];
    }
    if (on_planes) return plane_contacts(solved.superquadrics, solved.geometry);
    return common_normals(solved.superquadrics, caches, solved.geometry, gap, Curvatures::relative, scratch_.ahead);
  }
  solved.shapes.resize(pairs.size());
  for (Index row = 0; row < pairs.size(); ++row) {
    const BodyRecord &one = record(pairs[row].first), &two = record(pairs[row].second);
    const BodyShape &shape_1 = shape(pairs[row].first), &shape_2 = shape(pairs[row].second);
    Pose second = two.pose();
    if (shift.size() > 0) second.position += Vec3(shift[0][row], shift[1][row], shift[2][row]);
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

void ChunkStep::spread_constants() {
  const Contacts& contacts = chunk_.contacts;
  const Index size = contacts.size();
  auto& [reduced_mass, effective_radius, radius_cap] = scratch_.constants;
  reduced_mass.resize(size), effective_radius.resize(size), radius_cap.resize(size);
  for (Index i = 0; i < size; ++i) {
    const PairConstants& constants = contacts.constants[contacts.kind[i]];
    reduced_mass[i] = constants.reduced_mass;
    effective_radius[i] = constants.effective_radius;
    radius_cap[i] = constants.radius_cap;
  }
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

template <Index N>
Vectors<double> vectors(Columns<N>& columns, Index first, Index size) {
  return {{columns[first], size}, {columns[first + 1], size}, {columns[first + 2], size}};
}
template <Index N>
Vectors<const double> const_vectors(const Columns<N>& columns, Index first, Index size) {
  return {{columns[first], size}, {columns[first + 1], size}, {columns[first + 2], size}};
}

void ChunkStep::call_law() {
  Contacts& contacts = chunk_.contacts;
  const Index size = contacts.size();
  const ContactColumns& found = scratch_.contacts.geometry;
  Columns<of_answer::columns>& out = scratch_.answer;
  out.resize(size);
  scratch_.status.resize(size);
  const auto given = [&](Index k) { return std::span(found.columns[k], size); };
  const auto column = [&](Index k) { return std::span(out[k], size); };
  const LawInput input{.R_i = given(of_geometry::R_i),
                       .R_j = given(of_geometry::R_j),
                       .overlap = given(of_geometry::overlap),
                       .normal = const_vectors(found.columns, of_geometry::normal, size),
                       .major_axis = const_vectors(found.columns, of_geometry::major_axis, size),
                       .velocity = const_vectors(scratch_.motion, of_motion::velocity, size),
                       .angular_velocity = const_vectors(scratch_.motion, of_motion::angular, size),
                       .mean_angular_velocity = const_vectors(scratch_.motion, of_motion::mean_angular, size),
                       .reduced_mass = scratch_.constants.reduced_mass,
                       .effective_radius = scratch_.constants.effective_radius,
                       .smallest_radius = {},
                       .time_step = kinematics_.time_step};
  const LawOutput output{.force = vectors(out, of_answer::force, size),
                         .couple = law_.makes_couples() ? vectors(out, of_answer::couple, size) : Vectors<double>{},
                         .normal_force = column(of_answer::normal_force),
                         .status = scratch_.status,
                         .a_c = {},
                         .axis_ratio = {},
                         .stiffness = column(of_answer::stiffness),
                         .stored_normal = column(of_answer::stored_normal),
                         .stored_tangential = column(of_answer::stored_tangential),
                         .viscous_loss = column(of_answer::viscous_loss),
                         .friction_loss = column(of_answer::friction_loss),
                         .hysteresis_loss = column(of_answer::hysteresis_loss)};
  law_.evaluate(input, doubles_of(contacts.memory), output);
}

/// Finds the contacts that have opened, and those without an answer.
void ChunkStep::check_contacts() {
  const ContactColumns& found = scratch_.contacts.geometry;
  scratch_.opened.clear();
  for (Index i = 0; i < chunk_.contacts.size(); ++i) {
    const ContactStatus geometry_status = found.statuses[i];
    const LawStatus status = scratch_.status[i];
    if (is_resolved(geometry_status) && status == LawStatus::closed) continue;
    const double overlap = found.columns[of_geometry::overlap][i];
    const BodyPair pair = global(chunk_.contacts.bodies[i]);
    if (!is_resolved(geometry_status) && !(geometry_status == ContactStatus::not_converged && overlap < -reach_))
      report(chunk_, geometry_status == ContactStatus::degenerate ? Fault::degenerate : Fault::not_converged, pair,
             overlap);
    if (status == LawStatus::bad_input || status == LawStatus::not_converged)
      report(chunk_, Fault::law_refused, pair, overlap);
    if (status == LawStatus::open && overlap <= -reach_) scratch_.opened.push_back(static_cast<std::int32_t>(i));
  }
}

/// Overlaps that are too deep, and contacts too short for the time step.
void ChunkStep::report_extremes(const LawSums& sums) {
  const double dt = kinematics_.time_step;
  const bool deep = sums.deepest > deepest * world_.least_half_width, stiff = sums.stiffest * dt * dt > stiffest_step;
  if (!deep && !stiff) return;
  const double* overlaps = scratch_.contacts.geometry.columns[of_geometry::overlap];
  const double* stiffness = scratch_.answer[of_answer::stiffness];
  for (Index i = 0; i < chunk_.contacts.size(); ++i) {
    const LocalPair& pair = chunk_.contacts.bodies[i];
    if (overlaps[i] > deepest * std::min(shape(pair.first).half_width, shape(pair.second).half_width))
      report(chunk_, Fault::too_deep, global(pair), overlaps[i]);
    if (stiffness[i] / scratch_.constants.reduced_mass[i] * dt * dt > stiffest_step)
      report(chunk_, Fault::step_too_long, global(pair), overlaps[i]);
  }
}

void ChunkStep::open_contacts() {
  constexpr double safety = 1e-9;
  Contacts& contacts = chunk_.contacts;
  for (Index k = scratch_.opened.size(); k-- > 0;) {
    const Index i = index_of(scratch_.opened[k]);
    const LocalPair pair = contacts.bodies[i];
    const double size_of_pair = std::min(shape(pair.first).bounding_radius, shape(pair.second).bounding_radius);
    const double overlap = scratch_.contacts.geometry.columns[of_geometry::overlap][i];
    make_room_for_one(chunk_);
    chunk_.far.push_back({pair, rounded_down(travel(pair) - overlap - reach_ - safety * size_of_pair)});
    chunk_.far_caches.emplace_back(contacts.caches.get(i));
    remove_contact(contacts, i, law_);
  }
}

void ChunkStep::apply_law(ContactForces forces) {
  chunk_.stored_normal = chunk_.stored_tangential = chunk_.stiffest = chunk_.image_power = 0.0;
  std::fill(chunk_.wrenches.begin(), chunk_.wrenches.end(), Wrench());
  Contacts& contacts = chunk_.contacts;
  if (contacts.size() == 0) return;
  spread_constants();
  describe_motion(records(contacts.bodies), scratch_.contacts.images, scratch_.constants.radius_cap, law_.needs(),
                  scratch_.contacts.geometry, scratch_.arms, scratch_.motion, scratch_.ahead);
  call_law();
  check_contacts();
  const bool keep = forces == ContactForces::keep;
  const auto kept = [&](std::vector<Vec3>& vectors) { return keep ? std::span(vectors) : std::span<Vec3>(); };
  const LawSums sums = collect({.geometry = scratch_.contacts.geometry,
                                .arms = scratch_.arms,
                                .motion = scratch_.motion,
                                .answer = scratch_.answer,
                                .time_step = kinematics_.time_step,
                                .has_couples = law_.makes_couples(),
                                .has_springs = reach_ == 0.0},
                               scratch_.constants.reduced_mass,
                               {.springs = contacts.spring,
                                .force = kept(contacts.force),
                                .couple = kept(contacts.couple),
                                .pairs = contacts.bodies,
                                .wrenches = chunk_.wrenches},
                               scratch_.ahead);
  report_extremes(sums);
  chunk_.viscous_loss += sums.viscous_loss;
  chunk_.friction_loss += sums.friction_loss;
  chunk_.hysteresis_loss += sums.hysteresis_loss;
  chunk_.curvature_gain += sums.curvature_gain;
  chunk_.stored_normal = sums.stored_normal;
  chunk_.stored_tangential = sums.stored_tangential;
  chunk_.stiffest = sums.stiffest;
  if (const ImageShifts& images = scratch_.contacts.images; images.flow)
    for (Index i = 0; i < contacts.size(); ++i) {
      const Vec3 force(scratch_.answer[of_answer::force][i], scratch_.answer[of_answer::force + 1][i],
                       scratch_.answer[of_answer::force + 2][i]);
      chunk_.image_power += force.dot(images.velocity(i));
    }
  open_contacts();
}

/// What a step reads and writes of a chunk.
void list_for(ReadAhead& ahead, const PairChunk& chunk, const Kinematics& kinematics, ContactForces forces) {
  const Contacts& contacts = chunk.contacts;
  ahead.add(contacts.caches.states);
  for (Index k = 0; k < ContactCaches::width; ++k) ahead.add(contacts.caches.columns[k], contacts.size());
  for (const std::int32_t body : chunk.bodies) ahead.add(&kinematics.records[index_of(body)], 1);
  ahead.add(contacts.bodies);
  ahead.add(contacts.memory);
  ahead.add(contacts.kind);
  ahead.add(contacts.spring);
  if (forces == ContactForces::keep) ahead.add(contacts.force);
  ahead.add(chunk.far);
  ahead.add(chunk.wrenches);
}

}  // namespace

void evaluate(PairChunk& chunk, const PairChunk* next, const World& world, const Bodies& bodies,
              const Kinematics& kinematics, ContactForces forces, ChunkScratch& scratch) {
  scratch.ahead.clear();
  if (next != nullptr) list_for(scratch.ahead, *next, kinematics, forces);
  // Over the contacts go fill_pairs, describe_motion, collect and, where it reads ahead, the narrow phase.
  const Index passes = 3 + (chunk.group.narrow_phase == NarrowPhase::superquadrics ? passes_of_a_contact : 0);
  scratch.ahead.spread_over(passes * chunk.contacts.size());
  const auto begin = std::chrono::steady_clock::now();
  ChunkStep step(chunk, world, bodies, kinematics, scratch);
  step.watch_far();
  step.solve_contacts();
  scratch.narrow_seconds += seconds_since(begin);
  const auto middle = std::chrono::steady_clock::now();
  step.apply_law(forces);
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
