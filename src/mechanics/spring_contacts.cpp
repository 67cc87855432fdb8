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

void spring_contacts(const spring_contacts::Pair& pair, const LawInput& input, double* memory,
                     const LawOutput& output) {
  const Batch zero(0.0), one(1.0), infinity(std::numeric_limits<double>::infinity());
  const Batch time_step(input.time_step), friction(pair.friction), damping(pair.tangential_damping);
  const bool energies = !output.stored_tangential.empty() || !output.friction_loss.empty();
  const std::size_t size = input.R_i.size();
  for (std::size_t start = 0; start < size; start += lanes<Batch>()) {
    const std::size_t count = std::min(lanes<Batch>(), size - start);
    const Batch R_i = load<Batch>(&input.R_i[start], count), R_j = load<Batch>(&input.R_j[start], count);
    const Batch depth = load<Batch>(&input.overlap[start], count);
    const V3<Batch> normal = load(input.normal, start, count), major = load(input.major_axis, start, count);
    const V3<Batch> velocity = load(input.velocity, start, count);
    const V3<Batch> turning = load(input.mean_angular_velocity, start, count);
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

    // The spring as it was, carried along the turn of the normal by the shortest way, then by the spin.
    double* block = memory + start / law_lanes * law_lanes * laws::spring_memory + start % law_lanes;
    const auto remembered = [&](std::size_t entry)
                                HWY_ATTR { return load<Batch>(block + entry * law_lanes, lanes<Batch>()); };
    const V3<Batch> old_stretch{remembered(0), remembered(1), remembered(2)};
    const V3<Batch> old_normal{remembered(3), remembered(4), remembered(5)};
    const Batch old_stiffness = remembered(6);
    const Batch spin = dot(turning, normal) * time_step;
    const Batch share = dot(old_stretch, normal) / max(one + dot(old_normal, normal), Batch(1e-30));
    const V3<Batch> moved = old_stretch - share * (old_normal + normal);
    const auto [sin_spin, cos_spin] = turn_of(spin);
    V3<Batch> stretch = cos_spin * moved + sin_spin * cross(normal, moved);
    stretch = stretch - dot(stretch, normal) * normal;  // rounding must not add up

    const V3<Batch> slide = velocity + rate * normal, step = time_step * slide;
    const Batch stiffness = fma(Batch(pair.stiffness_ratio), state.stiffness, Batch(pair.tangential_stiffness));
    const Batch limit = friction * normal_force;
    const V3<Batch> viscous = damping * slide;
    const V3<Batch> tried = stretch + step, trial = stiffness * tried + viscous;
    const Mask slips = dot(trial, trial) > limit * limit;
    const V3<Batch> tangential = select(slips, shortened(trial, limit), trial);
    // In sliding the spring holds what the dashpot leaves over, and no more than the limit.
    const Batch yielding = one / stiffness;
    const V3<Batch> now = select(slips, shortened(yielding * (tangential - viscous), limit * yielding), tried);

    const auto say = [&](const Batch& value, std::span<double> to) HWY_ATTR {
      if (!to.empty()) store(select(pressed, value, zero), &to[start], count);
    };
    const V3<Batch> force = tangential - normal_force * normal;
    say(force.x, output.force.x), say(force.y, output.force.y), say(force.z, output.force.z);
    say(normal_force, output.normal_force);
    say(state.a_c, output.a_c);
    say(ellipse.axis_ratio, output.axis_ratio);
    say(state.stiffness, output.stiffness);
    say(state.strain_energy, output.stored_normal);
    const V3<Batch> rest = tangential - stiffness * now;
    say(fma(normal_force - state.force, rate, dot(rest, slide)) * time_step, output.viscous_loss);
    if (energies) {
      const Batch half(0.5);
      const Batch stored = half * stiffness * dot(now, now);
      const Batch before = half * old_stiffness * dot(old_stretch, old_stretch);
      say(stored, output.stored_tangential);
      if (!output.friction_loss.empty()) {
        const Batch work = half * dot(old_stiffness * stretch + stiffness * now, step);
        store(select(pressed, work + before - stored, select(good, before, zero)), &output.friction_loss[start], count);
      }
    }
    if (!output.hysteresis_loss.empty()) store(zero, &output.hysteresis_loss[start], count);

    // Bad numbers leave the memory as it was, an open contact none.
    const auto remember = [&](const Batch& value, std::size_t entry) HWY_ATTR {
      store(select(pressed, value, select(good, zero, remembered(entry))), block + entry * law_lanes, lanes<Batch>());
    };
    remember(now.x, 0), remember(now.y, 1), remember(now.z, 2);
    remember(normal.x, 3), remember(normal.y, 4), remember(normal.z, 5);
    remember(stiffness, 6);

    const Mask large = input.smallest_radius.empty()
                           ? zero > one
                           : !(state.a_c < Batch(0.5) * load<Batch>(&input.smallest_radius[start], count));
    const std::uint64_t in_contact = bits(pressed), sound = bits(good), oversized = bits(large);
    for (std::size_t i = 0; i < count; ++i)
      output.status[start + i] = (sound >> i & 1) == 0        ? LawStatus::bad_input
                                 : (in_contact >> i & 1) == 0 ? LawStatus::open
                                 : (oversized >> i & 1) != 0  ? LawStatus::large_contact
                                                              : LawStatus::closed;
  }
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
