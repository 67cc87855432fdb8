#include "dynamics/chunk_forces.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "dynamics/contact_edge.hpp"
#include "geometry/pair_order.hpp"

namespace osculate {
namespace {

using Index = std::size_t;

/// Overlaps beyond this share of the smaller half width are no contact mechanics any more.
constexpr double deepest = 0.25;

Index index_of(std::int32_t i) {
  return static_cast<Index>(i);
}

const BodyShape& shape_of(const World& world, const Bodies& bodies, Index body) {
  return world.shapes[index_of(bodies.shape[body])];
}

/// The multiple of the periods that brings body 2 next to body 1.
Vec3 image_shift(const World& world, const Bodies& bodies, Index one, Index two) {
  const PeriodicBox& box = world.setup.box;
  if (!box.repeats()) return Vec3::Zero();
  return nearest_image_shift(box, bodies.position[two] - bodies.position[one]);
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void find_awake(const PairChunk& chunk, const Kinematics& kinematics, std::vector<std::int32_t>& awake) {
  awake.clear();
  for (Index k = 0; k < chunk.pairs.size(); ++k) {
    const BodyPair& pair = chunk.pairs[k];
    const double travel = kinematics.travel[index_of(pair.first)] + kinematics.travel[index_of(pair.second)];
    if (travel >= chunk.quiet_until[k]) awake.push_back(static_cast<std::int32_t>(k));
  }
}

void fill_superquadrics(const PairChunk& chunk, const World& world, const Bodies& bodies,
                        const std::vector<std::int32_t>& rows, SuperquadricPairs& pairs) {
  pairs.resize(rows.size());
  for (Index row = 0; row < rows.size(); ++row) {
    const BodyPair& pair = chunk.pairs[index_of(rows[row])];
    const Index one = index_of(pair.first), two = index_of(pair.second);
    Pose second = bodies.pose(two);
    second.position += image_shift(world, bodies, one, two);
    pairs.set(row, superquadric_of(shape_of(world, bodies, one).shape), bodies.pose(one),
              superquadric_of(shape_of(world, bodies, two).shape), second);
  }
}

void fill_shapes(const PairChunk& chunk, const World& world, const Bodies& bodies,
                 const std::vector<std::int32_t>& rows, ShapePairs& pairs) {
  pairs.resize(rows.size());
  for (Index row = 0; row < rows.size(); ++row) {
    const BodyPair& pair = chunk.pairs[index_of(rows[row])];
    const Index one = index_of(pair.first), two = index_of(pair.second);
    const BodyShape &shape_1 = shape_of(world, bodies, one), &shape_2 = shape_of(world, bodies, two);
    Pose second = bodies.pose(two);
    second.position += image_shift(world, bodies, one, two);
    pairs.set(row, shape_1.shape, shape_pose(shape_1, bodies.pose(one)), shape_2.shape, shape_pose(shape_2, second));
  }
}

void copy_caches(const ContactCaches& from, ContactCaches& to, const std::vector<std::int32_t>& rows) {
  to.resize(rows.size());
  for (Index row = 0; row < rows.size(); ++row) to.states[row] = from.states[index_of(rows[row])];
  for (Index k = 0; k < ContactCaches::width; ++k) {
    const double* source = from.columns[k];
    double* target = to.columns[k];
    for (Index row = 0; row < rows.size(); ++row) target[row] = source[index_of(rows[row])];
  }
}

void return_caches(const ContactCaches& from, ContactCaches& to, const std::vector<std::int32_t>& rows) {
  for (Index row = 0; row < rows.size(); ++row) to.states[index_of(rows[row])] = from.states[row];
  for (Index k = 0; k < ContactCaches::width; ++k) {
    const double* source = from.columns[k];
    double* target = to.columns[k];
    for (Index row = 0; row < rows.size(); ++row) target[index_of(rows[row])] = source[row];
  }
}

/// The geometry of some pairs of a chunk, with the caches in scratch.
void solve(const PairChunk& chunk, const World& world, const Bodies& bodies, const std::vector<std::int32_t>& rows,
           ChunkScratch& scratch, Gap gap) {
  copy_caches(chunk.caches, scratch.caches, rows);
  if (chunk.group.narrow_phase == NarrowPhase::superquadrics) {
    fill_superquadrics(chunk, world, bodies, rows, scratch.superquadrics);
    common_normals(scratch.superquadrics, scratch.caches, scratch.contacts, gap);
  } else {
    fill_shapes(chunk, world, bodies, rows, scratch.shapes);
    common_normals(scratch.shapes, scratch.caches, scratch.contacts, gap);
  }
}

void report(PairChunk& chunk, Fault fault, const BodyPair& pair, double overlap) {
  if (chunk.fault != Fault::none) return;
  chunk.fault = fault;
  chunk.fault_pair = pair;
  chunk.fault_overlap = overlap;
}

/// Which pairs touch: gives them slots, and lets the others sleep until they could.
void sort_out(PairChunk& chunk, const World& world, const Kinematics& kinematics, ChunkScratch& scratch) {
  constexpr double safety = 1e-9;  // of the bodies' size: far above the round-off of a gap
  const Bodies& bodies = *kinematics.bodies;
  const double reach = world.reach[index_of(chunk.group.law)];
  for (Index row = 0; row < scratch.awake.size(); ++row) {
    const Index k = index_of(scratch.awake[row]);
    const BodyPair& pair = chunk.pairs[k];
    const Index one = index_of(pair.first), two = index_of(pair.second);
    const double overlap = scratch.contacts.columns[3][row];
    const ContactStatus status = scratch.contacts.statuses[row];
    const BodyShape &shape_1 = shape_of(world, bodies, one), &shape_2 = shape_of(world, bodies, two);
    if (!is_resolved(status) && !(status == ContactStatus::not_converged && overlap < -reach))
      report(chunk, status == ContactStatus::degenerate ? Fault::degenerate : Fault::not_converged, pair, overlap);
    if (overlap > deepest * std::min(shape_1.half_width, shape_2.half_width))
      report(chunk, Fault::too_deep, pair, overlap);
    if (overlap > -reach) {
      chunk.quiet_until[k] = PairChunk::awake;
      if (chunk.slot[k] == Slots::unused) {
        const Index slot = take_slot(chunk, k, world.setup.interactions[index_of(chunk.group.law)].law);
        const double mass_1 = bodies.mass[one], mass_2 = bodies.mass[two];
        const auto reduced = [](double x, double y) { return x / (x / y + 1.0); };  // y may be ∞
        const double infinity = std::numeric_limits<double>::infinity();
        chunk.slots.reduced_mass[slot] =
            bodies.is_free(one) ? reduced(mass_1, bodies.is_free(two) ? mass_2 : infinity) : mass_2;
        chunk.slots.effective_radius[slot] = std::isfinite(shape_1.volume_radius)
                                                 ? reduced(shape_1.volume_radius, shape_2.volume_radius)
                                                 : shape_2.volume_radius;
      }
    } else {
      const double size = std::min(shape_1.bounding_radius, shape_2.bounding_radius);
      chunk.quiet_until[k] = kinematics.travel[one] + kinematics.travel[two] - overlap - reach - safety * size;
    }
  }
}

Vec3 column_vector(const ContactColumns& contacts, Index first, Index row) {
  return {contacts.columns[first][row], contacts.columns[first + 1][row], contacts.columns[first + 2][row]};
}

template <Index N>
Vectors<double> vectors(Columns<N>& columns, Index first, Index size) {
  return {{columns[first], size}, {columns[first + 1], size}, {columns[first + 2], size}};
}
template <Index N>
Vectors<const double> vectors(const Columns<N>& columns, Index first, Index size) {
  return {{columns[first], size}, {columns[first + 1], size}, {columns[first + 2], size}};
}

void put(double* const* columns, Index first, Index i, const Vec3& v) {
  columns[first][i] = v.x();
  columns[first + 1][i] = v.y();
  columns[first + 2][i] = v.z();
}

/// Columns of LawInput, slot by slot.
enum In : Index { R_i, R_j, overlap, smallest_radius, normal, major_axis = 7, velocity = 10, angular = 13, mean = 16 };

void fill_law_input(PairChunk& chunk, const World& world, const Kinematics& kinematics, ChunkScratch& scratch) {
  const Index size = chunk.slots.size();
  const Bodies& bodies = *kinematics.bodies;
  const double reach = world.reach[index_of(chunk.group.law)];
  scratch.law_in.resize(size);
  double* in[19];
  for (Index k = 0; k < 19; ++k) in[k] = scratch.law_in[k];
  const ContactColumns& contacts = scratch.contacts;
  for (Index slot = 0; slot < size; ++slot) {
    const bool in_reach = scratch.row[slot] >= 0 && contacts.columns[3][index_of(scratch.row[slot])] > -reach;
    if (!in_reach) {
      // A gap that was proved but not resolved has neither points nor curvatures, an unused slot nothing at all.
      for (double* column : in) column[slot] = 0.0;
      in[R_i][slot] = in[R_j][slot] = in[smallest_radius][slot] = in[normal][slot] = in[major_axis + 1][slot] = 1.0;
      in[overlap][slot] = -1.0;
      continue;
    }
    const Index row = index_of(scratch.row[slot]);
    const BodyPair& pair = chunk.pairs[index_of(chunk.slots.owner[slot])];
    const Index one = index_of(pair.first), two = index_of(pair.second);
    const double cap = world.setup.radius_cap *
                       std::min(shape_of(world, bodies, one).volume_radius, shape_of(world, bodies, two).volume_radius);
    const Vec3 n = column_vector(contacts, 0, row);
    const Vec3 point = 0.5 * (column_vector(contacts, 4, row) + column_vector(contacts, 7, row));
    const Vec3 arm_1 = point - bodies.position[one];
    const Vec3 arm_2 = point - bodies.position[two] - image_shift(world, bodies, one, two);
    const Vec3 &omega_1 = kinematics.mean_angular_velocity[one], &omega_2 = kinematics.mean_angular_velocity[two];
    const Vec3 moved = bodies.velocity[two] + omega_2.cross(arm_2) - bodies.velocity[one] - omega_1.cross(arm_1);
    const Vec3 now = kinematics.velocity[two] + kinematics.angular_velocity[two].cross(arm_2) -
                     kinematics.velocity[one] - kinematics.angular_velocity[one].cross(arm_1);
    in[R_i][slot] = std::min(contacts.columns[20][row], cap);
    in[R_j][slot] = std::min(contacts.columns[21][row], cap);
    in[overlap][slot] = contacts.columns[3][row];
    const double curvature = std::max(contacts.columns[10][row], contacts.columns[15][row]);
    in[smallest_radius][slot] = curvature * cap > 1.0 ? 1.0 / curvature : cap;
    put(in, normal, slot, n);
    put(in, major_axis, slot, column_vector(contacts, 22, row));
    put(in, velocity, slot, moved + n.dot(now - moved) * n);
    put(in, angular, slot, omega_2 - omega_1);
    put(in, mean, slot, 0.5 * (omega_1 + omega_2));
    chunk.slots.point[slot] = point;
  }
}

/// Columns of LawOutput, slot by slot.
enum Out : Index {
  force,
  couple = 3,
  normal_force = 6,
  stiffness,
  stored_normal,
  stored_tangential,
  viscous,
  friction,
  hysteresis
};

void apply_law(PairChunk& chunk, const World& world, const Kinematics& kinematics, ChunkScratch& scratch) {
  const ContactLaw& law = world.setup.interactions[index_of(chunk.group.law)].law;
  Slots& slots = chunk.slots;
  const Index size = slots.size();
  const Columns<22>& in = scratch.law_in;
  Columns<13>& out = scratch.law_out;
  out.resize(size);
  scratch.status.resize(size);
  const auto one = [&](const auto& columns, Index k) { return std::span(columns[k], size); };
  const LawInput input{.R_i = one(in, R_i),
                       .R_j = one(in, R_j),
                       .overlap = one(in, overlap),
                       .normal = vectors(in, normal, size),
                       .major_axis = vectors(in, major_axis, size),
                       .velocity = vectors(in, velocity, size),
                       .angular_velocity = vectors(in, angular, size),
                       .mean_angular_velocity = vectors(in, mean, size),
                       .reduced_mass = slots.reduced_mass,
                       .effective_radius = slots.effective_radius,
                       .smallest_radius = one(in, smallest_radius),
                       .time_step = kinematics.time_step};
  const auto column = [&](Index k) { return std::span<double>(out[k], size); };
  const LawOutput output{.force = vectors(out, force, size),
                         .couple = law.makes_couples() ? vectors(out, couple, size) : Vectors<double>{},
                         .normal_force = column(normal_force),
                         .status = scratch.status,
                         .a_c = {},
                         .axis_ratio = {},
                         .stiffness = column(stiffness),
                         .stored_normal = column(stored_normal),
                         .stored_tangential = column(stored_tangential),
                         .viscous_loss = column(viscous),
                         .friction_loss = column(friction),
                         .hysteresis_loss = column(hysteresis)};
  law.evaluate(input, doubles_of(slots.memory), output);

  chunk.contacts = 0;
  chunk.stored_normal = chunk.stored_tangential = chunk.stiffest = 0.0;
  for (Index slot = 0; slot < size; ++slot) {
    if (slots.owner[slot] == Slots::unused) continue;
    const Index k = index_of(slots.owner[slot]);
    chunk.viscous_loss += out[viscous][slot];
    chunk.friction_loss += out[friction][slot];
    chunk.hysteresis_loss += out[hysteresis][slot];
    const LawStatus status = scratch.status[slot];
    if (status == LawStatus::bad_input || status == LawStatus::not_converged)
      report(chunk, Fault::law_refused, chunk.pairs[k], in[overlap][slot]);
    if (status == LawStatus::open && in[overlap][slot] <= 0.0) {
      // Within an adhesive law's reach the pair stays awake: its memory is zero, and the slot comes again.
      slots.owner[slot] = Slots::unused;
      chunk.slot[k] = Slots::unused;
      slots.force[slot] = Vec3::Zero();
      continue;
    }
    ++chunk.contacts;
    chunk.stored_normal += out[stored_normal][slot];
    chunk.stored_tangential += out[stored_tangential][slot];
    chunk.stiffest = std::max(chunk.stiffest, out[stiffness][slot] / slots.reduced_mass[slot]);
    const Vec3 n(in[normal][slot], in[normal + 1][slot], in[normal + 2][slot]);
    const Vec3 v(in[velocity][slot], in[velocity + 1][slot], in[velocity + 2][slot]);
    const double edge = edge_force(in[overlap][slot], std::fabs(n.dot(v)) * kinematics.time_step,
                                   out[stored_normal][slot], out[stiffness][slot]);
    slots.force[slot] = Vec3(out[force][slot], out[force + 1][slot], out[force + 2][slot]) - edge * n;
    if (!slots.couple.empty()) slots.couple[slot] = {out[couple][slot], out[couple + 1][slot], out[couple + 2][slot]};
  }
}

}  // namespace

void evaluate(PairChunk& chunk, const World& world, const Kinematics& kinematics, ChunkScratch& scratch) {
  const auto begin = std::chrono::steady_clock::now();
  find_awake(chunk, kinematics, scratch.awake);
  chunk.checked = static_cast<std::int32_t>(scratch.awake.size());
  if (scratch.awake.empty()) return;
  const bool resolve = world.reach[index_of(chunk.group.law)] > 0.0;
  solve(chunk, world, *kinematics.bodies, scratch.awake, scratch, resolve ? Gap::resolve : Gap::skip);
  return_caches(scratch.caches, chunk.caches, scratch.awake);
  sort_out(chunk, world, kinematics, scratch);
  scratch.narrow_seconds += seconds_since(begin);
  if (chunk.fault != Fault::none || chunk.slots.size() == 0) return;

  const auto middle = std::chrono::steady_clock::now();
  scratch.row.assign(chunk.slots.size(), -1);
  for (Index row = 0; row < scratch.awake.size(); ++row) {
    const std::int32_t slot = chunk.slot[index_of(scratch.awake[row])];
    if (slot != Slots::unused) scratch.row[index_of(slot)] = static_cast<std::int32_t>(row);
  }
  fill_law_input(chunk, world, kinematics, scratch);
  apply_law(chunk, world, kinematics, scratch);
  scratch.law_seconds += seconds_since(middle);
}

ContactColumns slot_geometry(const PairChunk& chunk, const World& world, const Bodies& bodies,
                             std::vector<std::int32_t>& slots) {
  ChunkScratch scratch;
  slots.clear();
  for (Index slot = 0; slot < chunk.slots.size(); ++slot) {
    if (chunk.slots.owner[slot] == Slots::unused) continue;
    slots.push_back(static_cast<std::int32_t>(slot));
    scratch.awake.push_back(chunk.slots.owner[slot]);
  }
  solve(chunk, world, bodies, scratch.awake, scratch, Gap::resolve);
  return scratch.contacts;
}

}  // namespace osculate
