#include "dynamics/move_bodies.hpp"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/move_bodies.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "core/transpose-inl.hpp"
#include "dynamics/vector_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

constexpr std::size_t width = lanes<Batch>();

/// What a record takes from a step beside the position, in its order.
struct MovedColumns {
  QuatOf<Batch> orientation;
  V3<Batch> velocity, mean_angular_velocity, last_velocity, last_angular_velocity;
};

HWY_INLINE void write_records(const MovedColumns& from, const Vec3* positions, std::size_t count, BodyRecord* to) {
  constexpr std::size_t first = 8, columns = 16;  // of the record: from the orientation to its end
  static_assert(sizeof(BodyRecord) == (first + columns) * sizeof(double) && columns % width == 0);
  const auto& [q, v, mean, last_v, last] = from;
  const Batch all[columns] = {q.w,    q.v.x,  q.v.y,    q.v.z,    v.x,      v.y,    v.z,    mean.x,
                              mean.y, mean.z, last_v.x, last_v.y, last_v.z, last.x, last.y, last.z};
  for (std::size_t k = 0; k < columns; k += width) {
    hn::Vec<Tag> rows[width];
    for (std::size_t i = 0; i < width; ++i) rows[i] = all[k + i].v;
    transpose(rows);
    for (std::size_t i = 0; i < count; ++i) hn::Store(rows[i], Tag(), to[i].placed.data() + first + k);
  }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) to[i].placed[5 + k] = positions[i][static_cast<Eigen::Index>(k)];
}

/// Records are written whole: their lines are fetched while others are worked on.
HWY_INLINE void fetch_records(const std::vector<BodyRecord>& records, std::size_t first) {
  constexpr std::size_t line = alignof(BodyRecord), lines = width * sizeof(BodyRecord) / line;
  if (first + width > records.size()) return;
  const auto* at = reinterpret_cast<const char*>(&records[first]);
  for (std::size_t k = 0; k < lines; ++k) hwy::Prefetch(at + k * line);
}

void move(const MoveStep& step, std::size_t begin, std::size_t end, Bodies& bodies, Kinematics& kinematics,
          const double* radius, double* way_of) {
  constexpr std::size_t ahead = 24;  // bodies
  const Batch dt(step.time_step), half(0.5 * step.time_step);
  const V3<Batch> gravity{Batch(step.gravity.x()), Batch(step.gravity.y()), Batch(step.gravity.z())};
  for_batches(end - begin, [&](std::size_t row, auto count) HWY_ATTR {
    const std::size_t start = begin + row;
    fetch_records(kinematics.records, start + ahead);
    const QuatOf<Batch> before = read(&bodies.orientation[start], count);
    const Batch inverse_mass = Batch(1.0) / load<Batch>(&bodies.mass[start], count);
    const V3<Batch> inverse_inertia = inverse(read(&bodies.inertia[start], count));
    const V3<Batch> kick = half * (inverse_mass * read(&bodies.force[start], count) + gravity);
    const V3<Batch> torque_kick =
        half * rotation_of(before.w, before.v).apply_inverse(read(&bodies.torque[start], count));
    const V3<Batch> velocity = read(&bodies.velocity[start], count) + kick;
    const V3<Batch> way = dt * velocity;
    const V3<Batch> position = read(&bodies.position[start], count) + way;
    const TurnOf<Batch> turn =
        turned(before, read(&bodies.angular_momentum[start], count) + torque_kick, inverse_inertia, dt);
    const QuatOf<Batch>& now = turn.orientation;
    const V3<Batch> last = rotation_of(now.w, now.v).apply(times(turn.momentum + torque_kick, inverse_inertia));
    store(fma(dt * norm(turn.mean_velocity), load<Batch>(radius + start, count), norm(way)), way_of + start, count);

    write(position, &bodies.position[start], count);
    write(now, &bodies.orientation[start], count);
    write(velocity, &bodies.velocity[start], count);
    write(turn.momentum, &bodies.angular_momentum[start], count);
    write_records({now, velocity, turn.mean_velocity, velocity + kick, last}, &bodies.position[start], count,
                  &kinematics.records[start]);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(move);

void move_bodies(const MoveStep& step, std::size_t begin, std::size_t end, Bodies& bodies, Kinematics& kinematics,
                 const std::vector<double>& radius, std::vector<double>& way) {
  HWY_DYNAMIC_DISPATCH(move)(step, begin, end, bodies, kinematics, radius.data(), way.data());
}

}  // namespace osculate
#endif
