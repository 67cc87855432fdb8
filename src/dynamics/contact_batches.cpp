#include "dynamics/contact_batches.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/contact_edge.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/contact_batches.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "core/transpose-inl.hpp"
#include "core/vector-inl.hpp"
#include "dynamics/vector_rows-inl.hpp"
#include "dynamics/wrench_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

constexpr std::size_t width = lanes<Batch>();
static_assert(sizeof(BodyRecord) == 24 * sizeof(double));

/// The bodies' records of one batch of pairs, column by column.
struct RecordColumns {
  const double* row[width];

  HWY_INLINE RecordColumns(const PairRecords& of, std::size_t start, std::size_t count,
                           std::uint16_t LocalPair::*body) {
    for (std::size_t i = 0; i < width; ++i) {
      const LocalPair& pair = of.pairs[start + std::min(i, count - 1)];
      row[i] = of.records[static_cast<std::size_t>(of.bodies[pair.*body])].placed.data();
    }
  }
  /// Columns `first` to first + width − 1 of the record.
  HWY_INLINE void read(std::size_t first, Batch* columns) const {
    hn::Vec<Tag> rows[width];
    for (std::size_t i = 0; i < width; ++i) rows[i] = hn::Load(Tag(), row[i] + first);
    transpose(rows);
    for (std::size_t k = 0; k < width; ++k) columns[k] = Batch(rows[k]);
  }
};

HWY_INLINE V3<Batch> vector_at(const Batch* columns) {
  return {columns[0], columns[1], columns[2]};
}
template <std::size_t N>
HWY_INLINE V3<Batch> load_vector(const Columns<N>& columns, std::size_t first, std::size_t start, std::size_t count) {
  return {load<Batch>(columns[first] + start, count), load<Batch>(columns[first + 1] + start, count),
          load<Batch>(columns[first + 2] + start, count)};
}
template <std::size_t N>
HWY_INLINE void store_vector(const V3<Batch>& v, Columns<N>& columns, std::size_t first, std::size_t start,
                             std::size_t count) {
  store(v.x, columns[first] + start, count);
  store(v.y, columns[first + 1] + start, count);
  store(v.z, columns[first + 2] + start, count);
}

void fill(const PairRecords& of, SuperquadricPairs& pairs, ReadAhead& ahead) {
  constexpr std::size_t each = SuperquadricPairs::per_body;
  for_batches(of.pairs.size(), [&](std::size_t start, auto count) HWY_ATTR {
    ahead.proceed(count);
    const auto put = [&](std::uint16_t LocalPair::*body, std::size_t first) HWY_ATTR {
      const RecordColumns record(of, start, count, body);
      Batch columns[each + width];
      for (std::size_t k = 0; k < each; k += width) record.read(k, columns + k);
      for (std::size_t k = 0; k < each; ++k) store(columns[k], pairs.columns[first + k] + start, count);
    };
    put(&LocalPair::first, 0);
    put(&LocalPair::second, each);
  });
}

/// What describe_motion reads of a record.
struct BodyMotion {
  V3<Batch> position, velocity, mean_angular_velocity, last_velocity, last_angular_velocity;

  HWY_INLINE explicit BodyMotion(const RecordColumns& record) {
    Batch columns[24];
    for (std::size_t k = 4 / width * width; k < 24; k += width) record.read(k, columns + k);
    position = vector_at(columns + 5);
    velocity = vector_at(columns + 12);
    mean_angular_velocity = vector_at(columns + 15);
    last_velocity = vector_at(columns + 18);
    last_angular_velocity = vector_at(columns + 21);
  }
};

/// Velocities of the images in a batch of rows.
HWY_INLINE V3<Batch> image_velocity(const ImageShifts& images, std::size_t start, std::size_t count) {
  const Batch zero(0.0);
  if (!images.flow) return {zero, zero, zero};
  const auto [flow, gradient, rate] = *images.flow;
  const Batch speed = Batch(rate) * load<Batch>(images.shift[static_cast<std::size_t>(gradient)] + start, count);
  return {flow == 0 ? speed : zero, flow == 1 ? speed : zero, flow == 2 ? speed : zero};
}

void describe(const PairRecords& of, const ImageShifts& images, const std::vector<double>& radius_cap,
              const LawNeeds& needs, ContactColumns& found, Columns<of_arms::columns>& arms,
              Columns<of_motion::columns>& motion, ReadAhead& ahead) {
  const Batch zero(0.0), half(0.5);
  auto& columns = found.columns;
  for_batches(of.pairs.size(), [&](std::size_t start, auto count) HWY_ATTR {
    ahead.proceed(count);
    const BodyMotion one(RecordColumns(of, start, count, &LocalPair::first));
    const BodyMotion two(RecordColumns(of, start, count, &LocalPair::second));
    const Batch cap = load<Batch>(&radius_cap[start], count);
    const Batch R_i = load<Batch>(columns[of_geometry::R_i] + start, count);
    const Batch R_j = load<Batch>(columns[of_geometry::R_j] + start, count);
    const V3<Batch> n = load_vector(columns, of_geometry::normal, start, count);
    const Mask resolved = R_j > zero;
    const V3<Batch> none{zero, zero, zero};
    const V3<Batch> point = half * (load_vector(columns, of_geometry::on_1, start, count) +
                                    load_vector(columns, of_geometry::on_2, start, count));
    const V3<Batch> arm_1 = point - one.position;
    V3<Batch> arm_2 = point - two.position;
    if (images.shift.size() > 0) arm_2 = arm_2 - load_vector(images.shift, 0, start, count);
    const V3<Batch> of_image = image_velocity(images, start, count);
    const V3<Batch> moved = two.velocity + of_image + cross(two.mean_angular_velocity, arm_2) - one.velocity -
                            cross(one.mean_angular_velocity, arm_1);
    const V3<Batch> now = two.last_velocity + of_image + cross(two.last_angular_velocity, arm_2) - one.last_velocity -
                          cross(one.last_angular_velocity, arm_1);
    store(select(resolved, min(R_i, cap), cap), columns[of_geometry::R_i] + start, count);
    store(select(resolved, min(R_j, cap), cap), columns[of_geometry::R_j] + start, count);
    if (!all(resolved)) {
      const V3<Batch> axis = load_vector(columns, of_geometry::major_axis, start, count);
      store_vector(select(resolved, axis, tangent_basis(n).e1), columns, of_geometry::major_axis, start, count);
    }
    store_vector(select(resolved, arm_1, none), arms, of_arms::arm_1, start, count);
    store_vector(select(resolved, arm_2, none), arms, of_arms::arm_2, start, count);
    const auto put = [&](const V3<Batch>& v, std::size_t first)
                         HWY_ATTR { store_vector(select(resolved, v, none), motion, first, start, count); };
    put(moved + dot(n, now - moved) * n, of_motion::velocity);
    if (needs.angular_velocity) put(two.mean_angular_velocity - one.mean_angular_velocity, of_motion::angular);
    if (needs.mean_angular_velocity)
      put(half * (two.mean_angular_velocity + one.mean_angular_velocity), of_motion::mean_angular);
  });
}

/// Springs of one batch. Lanes beyond the last one repeat it.
struct SpringLanes {
  Batch overlap, coefficient;

  static HWY_INLINE SpringLanes read(const NormalSpring* from, std::size_t count) {
    NormalSpring padded[width];
    if (count < width) {
      for (std::size_t i = 0; i < width; ++i) padded[i] = from[std::min(i, count - 1)];
      from = padded;
    }
    SpringLanes springs;
    hn::LoadInterleaved2(Tag(), &from->overlap, springs.overlap.v, springs.coefficient.v);
    return springs;
  }
  HWY_INLINE void write(NormalSpring* to, std::size_t count) const {
    if (count == width) return hn::StoreInterleaved2(overlap.v, coefficient.v, Tag(), &to->overlap);
    NormalSpring padded[width];
    hn::StoreInterleaved2(overlap.v, coefficient.v, Tag(), &padded->overlap);
    std::copy_n(padded, count, to);
  }
};

/// What the springs gained, and what they are like now.
HWY_INLINE Batch curvature_gain(SpringLanes& spring, Batch overlap, Batch stored, Batch stiffness) {
  constexpr double same = 1e-9;
  const Batch zero(0.0), one(1.0), hertz(1.5), four(4.0);
  const SpringLanes before = spring;
  Mask usable = (overlap > zero) & (stored > zero) & (stiffness > zero);
  const Batch depth = select(usable, overlap, one);
  const Batch ratio = select(usable, stiffness * depth * depth / select(usable, stored, one), one);
  const Batch p = Batch(0.5) * (sqrt(one + four * ratio) - one);  // elastic_power
  usable = usable & (p >= Batch(1.0 - same)) & (p <= Batch(2.0));
  const Mask hertzian = abs(p - hertz) < Batch(same);
  const bool all_hertzian = all(hertzian | !usable);
  const auto energy_shape = [&](Batch at) HWY_ATTR {
    const Batch by_root = at * at * sqrt(at);
    return all_hertzian ? by_root : select(hertzian, by_root, power(at, p + one));
  };
  spring.overlap = select(usable, depth, zero);
  spring.coefficient = select(usable, stored / energy_shape(depth), zero);
  const Batch middle = Batch(0.5) * (before.overlap + depth);
  return select(usable & (before.overlap > zero), (spring.coefficient - before.coefficient) * energy_shape(middle),
                zero);
}

HWY_INLINE double sum_of(Batch a) {
  HWY_ALIGN double values[width];
  store(a, values, width);
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}
HWY_INLINE double most_of(Batch a) {
  HWY_ALIGN double values[width];
  store(a, values, width);
  return *std::max_element(values, values + width);
}

/// Takes from the force, row by row, what the edge of the contact asks for.
void correct_edges(const LawAnswer& law, std::size_t start, std::uint64_t rows) {
  const auto& found = law.geometry.columns;
  auto& out = law.answer;
  for (std::size_t i = start; rows != 0; rows >>= 1U, ++i) {
    if ((rows & 1U) == 0) continue;
    double rate = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      rate += found[of_geometry::normal + k][i] * law.motion[of_motion::velocity + k][i];
    const double edge = edge_force(found[of_geometry::overlap][i], std::fabs(rate) * law.time_step,
                                   out[of_answer::stored_normal][i], out[of_answer::stiffness][i]);
    for (std::size_t k = 0; k < 3; ++k) out[of_answer::force + k][i] -= edge * found[of_geometry::normal + k][i];
  }
}

LawSums collect_all(const LawAnswer& law, const std::vector<double>& reduced_mass, const LawEffects& effects,
                    ReadAhead& ahead) {
  const Batch zero(0.0), dt(law.time_step);
  const auto& found = law.geometry.columns;
  auto& out = law.answer;
  Batch viscous(0.0), friction(0.0), hysteresis(0.0), normal(0.0), tangential(0.0), gain(0.0), stiffest(0.0),
      deepest(0.0);
  for_batches(out.size(), [&](std::size_t start, auto count) HWY_ATTR {
    ahead.proceed(count);
    const Mask real{hn::FirstN(Tag(), count)};
    const auto column = [&](std::size_t k) HWY_ATTR { return load<Batch>(out[k] + start, count); };
    const auto add = [&](Batch& sum, Batch value) HWY_ATTR { sum += select(real, value, zero); };
    const Batch overlap = load<Batch>(found[of_geometry::overlap] + start, count);
    const Batch stiffness = column(of_answer::stiffness), stored = column(of_answer::stored_normal);
    const V3<Batch> n = load_vector(found, of_geometry::normal, start, count);
    const V3<Batch> velocity = load_vector(law.motion, of_motion::velocity, start, count);
    const Mask edge = real & (overlap > zero) & (overlap < abs(dot(n, velocity)) * dt);
    if (any(edge)) correct_edges(law, start, bits(edge));

    const V3<Batch> force = load_vector(out, of_answer::force, start, count);
    V3<Batch> on_1 = cross(load_vector(law.arms, of_arms::arm_1, start, count), force);
    V3<Batch> on_2 = -cross(load_vector(law.arms, of_arms::arm_2, start, count), force);
    if (law.has_couples) {
      const V3<Batch> couple = load_vector(out, of_answer::couple, start, count);
      on_1 = on_1 + couple;
      on_2 = on_2 - couple;
      if (!effects.couple.empty()) write(couple, &effects.couple[start], count);
    }
    if (!effects.force.empty()) write(force, &effects.force[start], count);
    const WrenchRows first({force, on_1}), second({-force, on_2});
    for (std::size_t i = 0; i < count; ++i) {
      const LocalPair& pair = effects.pairs[start + i];
      first.add_to(effects.wrenches[pair.first], i);
      second.add_to(effects.wrenches[pair.second], i);
    }

    add(viscous, column(of_answer::viscous_loss));
    add(friction, column(of_answer::friction_loss));
    add(hysteresis, column(of_answer::hysteresis_loss));
    add(normal, stored);
    add(tangential, column(of_answer::stored_tangential));
    stiffest = max(stiffest, stiffness / load<Batch>(&reduced_mass[start], count));
    deepest = max(deepest, overlap);
    if (!law.has_springs) return;
    SpringLanes spring = SpringLanes::read(&effects.springs[start], count);
    add(gain, curvature_gain(spring, overlap, stored, stiffness));
    spring.write(&effects.springs[start], count);
  });
  return {.viscous_loss = sum_of(viscous),
          .friction_loss = sum_of(friction),
          .hysteresis_loss = sum_of(hysteresis),
          .stored_normal = sum_of(normal),
          .stored_tangential = sum_of(tangential),
          .curvature_gain = sum_of(gain),
          .stiffest = most_of(stiffest),
          .deepest = most_of(deepest)};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(fill);
HWY_EXPORT(describe);
HWY_EXPORT(collect_all);

void fill_pairs(const PairRecords& of, SuperquadricPairs& pairs, ReadAhead& ahead) {
  pairs.resize(of.pairs.size());
  HWY_DYNAMIC_DISPATCH(fill)(of, pairs, ahead);
}

void describe_motion(const PairRecords& of, const ImageShifts& images, const std::vector<double>& radius_cap,
                     const LawNeeds& needs, ContactColumns& geometry, Columns<of_arms::columns>& arms,
                     Columns<of_motion::columns>& motion, ReadAhead& ahead) {
  arms.resize(of.pairs.size());
  motion.resize(of.pairs.size());
  HWY_DYNAMIC_DISPATCH(describe)(of, images, radius_cap, needs, geometry, arms, motion, ahead);
}

LawSums collect(const LawAnswer& law, const std::vector<double>& reduced_mass, const LawEffects& effects,
                ReadAhead& ahead) {
  return HWY_DYNAMIC_DISPATCH(collect_all)(law, reduced_mass, effects, ahead);
}

}  // namespace osculate
#endif
