#include "mechanics/spring_contacts.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "mechanics/laws/spring.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/spring_contacts.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "core/vector-inl.hpp"
#include "mechanics/hertz-inl.hpp"
#include "mechanics/turn-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

HWY_INLINE V3<Batch> load(const Vectors<const double>& from, std::size_t start, std::size_t count) {
  return {load<Batch>(&from.x[start], count), load<Batch>(&from.y[start], count), load<Batch>(&from.z[start], count)};
}

HWY_INLINE Batch size_of(const V3<Batch>& a) {
  return abs(a.x) + abs(a.y) + abs(a.z);
}

/// The vector, shortened to `longest` ≥ 0 if it is longer.
HWY_INLINE V3<Batch> shortened(const V3<Batch>& a, const Batch& longest) {
  const Batch one(1.0), square_length = dot(a, a);
  const Mask longer = square_length > longest * longest;
  return select(longer, longest / sqrt(select(longer, square_length, one)), one) * a;
}

/// What a spring remembers, see laws/spring.hpp.
struct SpringMemory {
  V3<Batch> stretch, normal;
  Batch stiffness;

  static HWY_INLINE SpringMemory read(const double* block) {
    const auto entry = [&](std::size_t k) HWY_ATTR { return load<Batch>(block + k * law_lanes, lanes<Batch>()); };
    return {{entry(0), entry(1), entry(2)}, {entry(3), entry(4), entry(5)}, entry(6)};
  }
  HWY_INLINE void write(double* block) const {
    std::size_t k = 0;
    for (const Batch& value : {stretch.x, stretch.y, stretch.z, normal.x, normal.y, normal.z, stiffness})
      store(value, block + k++ * law_lanes, lanes<Batch>());
  }
};
HWY_INLINE SpringMemory select(const Mask& condition, const SpringMemory& yes, const SpringMemory& no) {
  return {select(condition, yes.stretch, no.stretch), select(condition, yes.normal, no.normal),
          select(condition, yes.stiffness, no.stiffness)};
}

struct SpringMotion {
  V3<Batch> normal, slide;  ///< slide: relative velocity in the plane
  Batch spin, time_step;
};
struct SpringAnswer {
  V3<Batch> force, dashpot;
  Batch stored, stored_before, work;  ///< work of the spring's force in the step
  SpringMemory memory;
};

/// One step of spring, dashpot and slider.
HWY_INLINE SpringAnswer rub(const SpringMemory& before, const SpringMotion& motion, const Batch& stiffness,
                            const Batch& damping, const Batch& limit) {
  const Batch one(1.0), half(0.5);
  const V3<Batch>& normal = motion.normal;
  // Carried along the turn of the normal by the shortest way, then by the spin.
  const Batch share = dot(before.stretch, normal) / max(one + dot(before.normal, normal), Batch(1e-30));
  const V3<Batch> moved = before.stretch - share * (before.normal + normal);
  const auto [sine, cosine] = turn_of(motion.spin);
  const V3<Batch> turned = cosine * moved + sine * cross(normal, moved);
  const V3<Batch> stretch = turned - dot(turned, normal) * normal;  // rounding must not add up

  const V3<Batch> step = motion.time_step * motion.slide, viscous = damping * motion.slide;
  const V3<Batch> tried = stretch + step, trial = stiffness * tried + viscous;
  const Mask slips = dot(trial, trial) > limit * limit;
  V3<Batch> force = trial, now = tried;
  if (any(slips)) {
    force = select(slips, shortened(trial, limit), trial);
    // In sliding the spring holds what the dashpot leaves over, and no more than the limit.
    const Batch yielding = one / stiffness;
    now = select(slips, shortened(yielding * (force - viscous), limit * yielding), tried);
  }
  const V3<Batch> elastic = stiffness * now;
  return {force,
          force - elastic,
          half * stiffness * dot(now, now),
          half * before.stiffness * dot(before.stretch, before.stretch),
          half * dot(before.stiffness * stretch + elastic, step),
          {now, normal, stiffness}};
}

void spring_contacts(const spring_contacts::Pair& pair, const LawInput& input, double* memory,
                     const LawOutput& output) {
  const Batch zero(0.0), one(1.0), infinity(std::numeric_limits<double>::infinity());
  const Batch time_step(input.time_step);
  const V3<Batch> none{zero, zero, zero};
  for_batches(input.R_i.size(), [&](std::size_t start, auto count) HWY_ATTR {
    const Batch R_i = load<Batch>(&input.R_i[start], count), R_j = load<Batch>(&input.R_j[start], count);
    const Batch depth = load<Batch>(&input.overlap[start], count);
    const V3<Batch> normal = load(input.normal, start, count), major = load(input.major_axis, start, count);
    const V3<Batch> velocity = load(input.velocity, start, count);
    V3<Batch> turning = none;
    if (!input.mean_angular_velocity.x.empty()) turning = load(input.mean_angular_velocity, start, count);
    const Batch mass = pair.damping_factor > 0.0 ? load<Batch>(&input.reduced_mass[start], count) : one;
    const Batch all = abs(depth) + size_of(normal) + size_of(major) + size_of(velocity) + size_of(turning);
    const Mask good =
        (R_j > zero) & (R_j < infinity) & (R_i >= R_j) & (all < infinity) & (mass > zero) & (mass < infinity);
    const Mask pressed = good & (depth > zero);

    const Batch minor_radius = select(good, R_j, one), major_radius = select(good, limited(R_i, R_j), one);
    const Batch overlap = select(pressed, depth, minor_radius);  // any, where nothing comes of it
    const auto ellipse = ellipse_of(major_radius, minor_radius);
    const auto state = hertz_state(ellipse, Batch(pair.modulus), overlap);
    const Batch rate = -dot(velocity, normal);
    Batch dashpot = Batch(pair.damping_time) * state.stiffness;
    if (pair.damping_factor > 0.0)
      dashpot += Batch(pair.damping_factor) * sqrt(Batch(2.0 / 3.0) * mass * state.stiffness);
    const Batch normal_force = max(fma(dashpot, rate, state.force), zero);

    const V3<Batch> slide = velocity + rate * normal;
    double* block = memory + start / law_lanes * law_lanes * laws::spring_memory + start % law_lanes;
    SpringAnswer spring{none, none, zero, zero, zero, {none, none, zero}};
    if (pair.kind == spring_contacts::Friction::spring) {
      const SpringMemory before = SpringMemory::read(block);
      const Batch stiffness = fma(Batch(pair.stiffness_ratio), state.stiffness, Batch(pair.tangential_stiffness));
      spring = rub(before, {normal, slide, dot(turning, normal) * time_step, time_step}, stiffness,
                   Batch(pair.tangential_damping), Batch(pair.friction) * normal_force);
      // Bad numbers leave the memory as it was, an open contact none.
      const SpringMemory nothing{none, none, zero};
      select(pressed, spring.memory, select(good, nothing, before)).write(block);
    }

    const auto say = [&](const Batch& value, std::span<double> to) HWY_ATTR {
      if (!to.empty()) store(select(pressed, value, zero), &to[start], count);
    };
    const V3<Batch> force = spring.force - normal_force * normal;
    say(force.x, output.force.x), say(force.y, output.force.y), say(force.z, output.force.z);
    say(normal_force, output.normal_force);
    say(state.a_c, output.a_c);
    say(ellipse.axis_ratio, output.axis_ratio);
    say(state.stiffness, output.stiffness);
    say(state.strain_energy, output.stored_normal);
    say(fma(normal_force - state.force, rate, dot(spring.dashpot, slide)) * time_step, output.viscous_loss);
    say(spring.stored, output.stored_tangential);
    if (!output.friction_loss.empty())
      store(
          select(pressed, spring.work + spring.stored_before - spring.stored, select(good, spring.stored_before, zero)),
          &output.friction_loss[start], count);
    if (!output.hysteresis_loss.empty()) store(zero, &output.hysteresis_loss[start], count);

    const Mask large = input.smallest_radius.empty()
                           ? zero > one
                           : !(state.a_c < Batch(0.5) * load<Batch>(&input.smallest_radius[start], count));
    const std::uint64_t in_contact = bits(pressed), sound = bits(good), oversized = bits(large);
    for (std::size_t i = 0; i < count; ++i)
      output.status[start + i] = (sound >> i & 1) == 0        ? LawStatus::bad_input
                                 : (in_contact >> i & 1) == 0 ? LawStatus::open
                                 : (oversized >> i & 1) != 0  ? LawStatus::large_contact
                                                              : LawStatus::closed;
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(spring_contacts);

namespace spring_contacts {

void evaluate(const Pair& pair, const LawInput& input, double* memory, const LawOutput& output) {
  HWY_DYNAMIC_DISPATCH(spring_contacts)(pair, input, memory, output);
}

}  // namespace spring_contacts
}  // namespace osculate
#endif
