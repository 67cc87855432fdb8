#include "dynamics/kick_bodies.hpp"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/kick_bodies.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "core/transpose-inl.hpp"
#include "dynamics/vector_rows-inl.hpp"
#include "dynamics/wrench_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

inline const Wrench& wrench_at(const PairList& pairs, const Incidence& incidence) {
  return pairs.chunks[incidence.chunk].wrenches[incidence.place];
}

/// Forces and torques on a batch of bodies. Lanes beyond the last one hold none.
HWY_INLINE WrenchColumns sum_of_wrenches(const PairList& pairs, std::size_t start, std::size_t count) {
  WrenchRows rows;
  for (std::size_t i = 0; i < count; ++i)
    for (std::uint64_t k = pairs.first[start + i]; k < pairs.first[start + i + 1]; ++k)
      rows.add(i, wrench_at(pairs, pairs.incidences[k]));
  return rows.columns();
}

void kick_all(const Kick& kick, std::size_t begin, std::size_t end, const PairList& pairs, Bodies& bodies) {
  constexpr std::size_t ahead = 24;  // a body's wrenches lie scattered: they are fetched while others are added up
  const Batch zero(0.0), one(1.0), time(kick.time);
  const V3<Batch> gravity{Batch(kick.gravity.x()), Batch(kick.gravity.y()), Batch(kick.gravity.z())};
  for_batches(end - begin, [&](std::size_t row, auto count) HWY_ATTR {
    const std::size_t start = begin + row, soon = std::min(start + ahead, bodies.size());
    for (std::uint64_t k = pairs.first[soon]; k < pairs.first[std::min(soon + count, bodies.size())]; ++k)
      hwy::Prefetch(&wrench_at(pairs, pairs.incidences[k]));
    const auto [force, torque] = sum_of_wrenches(pairs, start, count);
    write(force, &bodies.force[start], count);
    write(torque, &bodies.torque[start], count);

    HWY_ALIGN double freedom[lanes<Batch>()] = {};
    for (std::size_t i = 0; i < count; ++i) freedom[i] = bodies.is_free(start + i) ? 1.0 : 0.0;
    const Mask is_free = load<Batch>(freedom, lanes<Batch>()) > zero;
    const Batch mass = select(is_free, load<Batch>(&bodies.mass[start], count), one);
    const QuatOf<Batch> q = read(&bodies.orientation[start], count);
    const V3<Batch> velocity = read(&bodies.velocity[start], count);
    const V3<Batch> momentum = read(&bodies.angular_momentum[start], count);
    const V3<Batch> kicked = velocity + time * ((one / mass) * force + gravity);
    const V3<Batch> turned = momentum + time * rotation_of(q.w, q.v).apply_inverse(torque);
    write(select(is_free, kicked, velocity), &bodies.velocity[start], count);
    write(select(is_free, turned, momentum), &bodies.angular_momentum[start], count);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(kick_all);

void kick_bodies(const Kick& kick, std::size_t begin, std::size_t end, const PairList& pairs, Bodies& bodies) {
  HWY_DYNAMIC_DISPATCH(kick_all)(kick, begin, end, pairs, bodies);
}

}  // namespace osculate
#endif
