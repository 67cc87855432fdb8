#include "dynamics/move_bodies.hpp"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/move_bodies.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "dynamics/rigid_rotation-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// The columns of up to one batch of Vec3.
HWY_INLINE V3<Batch> read_vectors(const Vec3* from, std::size_t count) {
  constexpr std::size_t width = lanes<Batch>();
  HWY_ALIGN double x[width], y[width], z[width];
  for (std::size_t i = 0; i < width; ++i) {
    const Vec3& v = from[std::min(i, count - 1)];
    x[i] = v.x(), y[i] = v.y(), z[i] = v.z();
  }
  return {load<Batch>(x, width), load<Batch>(y, width), load<Batch>(z, width)};
}
HWY_INLINE QuatOf<Batch> read_quaternions(const Quat* from, std::size_t count) {
  constexpr std::size_t width = lanes<Batch>();
  HWY_ALIGN double w[width], x[width], y[width], z[width];
  for (std::size_t i = 0; i < width; ++i) {
    const Quat& q = from[std::min(i, count - 1)];
    w[i] = q.w(), x[i] = q.x(), y[i] = q.y(), z[i] = q.z();
  }
  return {load<Batch>(w, width), {load<Batch>(x, width), load<Batch>(y, width), load<Batch>(z, width)}};
}

/// Vectors of a batch, to be read lane by lane.
struct VectorLanes {
  HWY_ALIGN double x[lanes<Batch>()], y[lanes<Batch>()], z[lanes<Batch>()];

  explicit VectorLanes(const V3<Batch>& v) {
    store(v.x, x, lanes<Batch>()), store(v.y, y, lanes<Batch>()), store(v.z, z, lanes<Batch>());
  }
  Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
};

void move(const MoveStep& step, std::size_t begin, std::size_t end, Bodies& bodies, Kinematics& kinematics,
          const double* radius, double* way_of) {
  const Batch dt(step.time_step), half(0.5 * step.time_step);
  const V3<Batch> gravity{Batch(step.gravity.x()), Batch(step.gravity.y()), Batch(step.gravity.z())};
  for (std::size_t start = begin; start < end; start += lanes<Batch>()) {
    const std::size_t count = std::min(lanes<Batch>(), end - start);
    const QuatOf<Batch> before = read_quaternions(&bodies.orientation[start], count);
    const Batch inverse_mass = Batch(1.0) / load<Batch>(&bodies.mass[start], count);
    const V3<Batch> inverse_inertia = inverse(read_vectors(&bodies.inertia[start], count));
    const V3<Batch> kick = half * (inverse_mass * read_vectors(&bodies.force[start], count) + gravity);
    const V3<Batch> torque_kick =
        half * rotation_of(before.w, before.v).apply_inverse(read_vectors(&bodies.torque[start], count));
    const V3<Batch> velocity = read_vectors(&bodies.velocity[start], count) + kick;
    const V3<Batch> way = dt * velocity;
    const V3<Batch> position = read_vectors(&bodies.position[start], count) + way;
    const TurnOf<Batch> turn =
        turned(before, read_vectors(&bodies.angular_momentum[start], count) + torque_kick, inverse_inertia, dt);
    const QuatOf<Batch>& now = turn.orientation;
    const V3<Batch> last = rotation_of(now.w, now.v).apply(times(turn.momentum + torque_kick, inverse_inertia));
    store(fma(dt * norm(turn.mean_velocity), load<Batch>(radius + start, count), norm(way)), way_of + start, count);

    const VectorLanes x(position), v(velocity), v_last(velocity + kick), L(turn.momentum), mean(turn.mean_velocity),
        omega_last(last), q(now.v);
    HWY_ALIGN double w[lanes<Batch>()];
    store(now.w, w, lanes<Batch>());
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t body = start + i;
      const Quat orientation(w[i], q.x[i], q.y[i], q.z[i]);
      bodies.position[body] = x[i];
      bodies.orientation[body] = orientation;
      bodies.velocity[body] = v[i];
      bodies.angular_momentum[body] = L[i];
      BodyRecord& record = kinematics.records[body];
      record.place(x[i], orientation);
      record.velocity = v[i];
      record.mean_angular_velocity = mean[i];
      record.last_velocity = v_last[i];
      record.last_angular_velocity = omega_last[i];
    }
  }
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
