#include "osculate/mechanics/mindlin_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>

#include "mechanics/require.hpp"
#include "osculate/core/error.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/mindlin_contacts.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "mechanics/hertz-inl.hpp"
#include "mechanics/mindlin_memory-inl.hpp"
#include "mechanics/turn-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

HWY_INLINE V3<Batch> load(const Vectors<const double>& from, std::size_t start, std::size_t count) {
  return {load<Batch>(&from.x[start], count), load<Batch>(&from.y[start], count), load<Batch>(&from.z[start], count)};
}
HWY_INLINE void store(const V3<Batch>& value, const Vectors<double>& to, std::size_t start, std::size_t count) {
  store(value.x, &to.x[start], count);
  store(value.y, &to.y[start], count);
  store(value.z, &to.z[start], count);
}

void mindlin_contacts(const mindlin::Pair& pair, const mindlin::BatchInput& input, mindlin::MemoryBlock* memory,
                      const mindlin::BatchOutput& output) {
  using mindlin::BatchStatus;
  const Batch zero(0.0), one(1.0), infinity(std::numeric_limits<double>::infinity());
  const std::size_t size = input.R_i.size();
  for (std::size_t start = 0; start < size; start += lanes<Batch>()) {
    const std::size_t count = std::min(lanes<Batch>(), size - start);
    const Batch R_i = load<Batch>(&input.R_i[start], count), R_j = load<Batch>(&input.R_j[start], count);
    const Batch depth = load<Batch>(&input.overlap[start], count);
    const Batch rate = load<Batch>(&input.overlap_rate[start], count), spin = load<Batch>(&input.spin[start], count);
    const V3<Batch> normal = load(input.normal, start, count), major = load(input.major_axis, start, count);
    const V3<Batch> moved = load(input.displacement, start, count);
    const Batch all = abs(depth) + abs(rate) + abs(spin) + abs(normal.x) + abs(normal.y) + abs(normal.z) +
                      abs(major.x) + abs(major.y) + abs(major.z) + abs(moved.x) + abs(moved.y) + abs(moved.z);
    const Mask good = (R_j > zero) & (R_j < infinity) & (R_i >= R_j) & (all < infinity);
    const Mask pressed = good & (depth > zero);

    const Batch minor_radius = select(good, R_j, one), major_radius = select(good, limited(R_i, R_j), one);
    const Batch overlap = select(pressed, depth, minor_radius);  // any, where nothing comes of it
    const auto ellipse = ellipse_of(major_radius, minor_radius);
    const auto state = hertz_state(ellipse, Batch(pair.modulus), overlap);
    // D/K from the ellipse's own equation R_j/R_i = m1 D/B with K = B + D.
    const Batch ratio = minor_radius / major_radius;
    const Batch share = ratio * reciprocal(fma(ellipse.axis_ratio, ellipse.axis_ratio, ratio));
    const Batch kappa_major = fma(Batch(pair.coupling), share, one);
    const Batch kappa_minor = fma(Batch(pair.coupling), one - share, one);

    mindlin::MemoryBlock& block = memory[start / mindlin::MemoryBlock::width];
    const std::size_t lane = start % mindlin::MemoryBlock::width;
    const auto remembered = [&](const mindlin::MemoryBlock::Lanes& from)
                                HWY_ATTR { return load<Batch>(&from[lane], lanes<Batch>()); };
    const V3<Batch> old_normal{remembered(block.normal[0]), remembered(block.normal[1]), remembered(block.normal[2])};
    const V3<Batch> old_axis{remembered(block.axis[0]), remembered(block.axis[1]), remembered(block.axis[2])};
    const V3<Batch> minor = cross(normal, major);
    const auto [sin_spin, cos_spin] = turn_of(spin);
    const auto turned = carried(old_normal, old_axis, normal, major, minor, sin_spin, cos_spin);
    SpringsOf<Batch> line;
    line.count = remembered(block.count);
    line.rim_root = sqrt(remembered(block.overlap));
    line.most = std::max(largest(line.count), 1);
    for (int i = 0; i < line.most; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const LayerOf<Batch> layer{remembered(block.root[k]), remembered(block.x[k]), remembered(block.y[k])};
      line.at[i] = select(Batch(static_cast<double>(i)) < line.count, turned(layer), line.rim());
    }
    line.at[line.most] = line.rim();

    const bool energies = !output.stored_tangential.empty() || !output.friction_loss.empty();
    const Batch coefficient = Batch(2.0 / 3.0) * state.stiffness / sqrt(overlap);
    const auto stored = [&](const SumsOf<Batch>& sum) HWY_ATTR {
      return Batch(0.375) * coefficient * fma(kappa_major, sum.squared.x, kappa_minor * sum.squared.y);
    };

    const Batch along = dot(moved, major), across = dot(moved, minor);
    PlanarOf<Batch> sheared_before{zero, zero};
    Batch stored_before = zero;
    if (energies) {
      const Mask held = line.count > zero;
      const SumsOf<Batch> before = sums(line);
      stored_before = select(held & (line.rim_root > zero), stored(before), zero);
      sheared_before = {select(held, before.traction.x, zero), select(held, before.traction.y, zero)};
    }
    Batch dashpot = Batch(pair.damping_time) * state.stiffness;
    if (pair.damping_factor > 0.0)
      dashpot += Batch(pair.damping_factor) *
                 sqrt(Batch(2.0 / 3.0) * load<Batch>(&input.reduced_mass[start], count) * state.stiffness);
    const Batch normal_force = max(fma(dashpot, rate, state.force), zero);
    // Every spring slides at the same share of its limit as the load is of the elastic one; held finite for δ → 0.
    const Batch unlimited(1e30), smallest(smallest_normal);
    const Batch load = min(max(fma(dashpot * rate, reciprocal(max(state.force, smallest)), one), zero), unlimited);
    const SumsOf<Batch> after =
        advance(line, overlap, {along * reciprocal(kappa_major), across * reciprocal(kappa_minor)},
                Batch(pair.friction) * load);
    const PlanarOf<Batch>& sheared = after.traction;

    const V3<Batch> force =
        (coefficient * sheared.x) * major + (coefficient * sheared.y) * minor - normal_force * normal;
    const V3<Batch> none{zero, zero, zero};
    store(select(pressed, force, none), output.force, start, count);
    store(select(pressed, normal_force, zero), &output.normal_force[start], count);
    const auto say = [&](const Batch& value, std::span<double> to) HWY_ATTR {
      if (!to.empty()) store(select(pressed, value, zero), &to[start], count);
    };
    say(state.a_c, output.a_c);
    say(ellipse.axis_ratio, output.axis_ratio);

    say(state.stiffness, output.stiffness);
    say(state.strain_energy, output.stored_normal);
    say((normal_force - state.force) * rate, output.viscous_power);
    if (energies) {
      const Batch stored_now = stored(after);
      say(stored_now, output.stored_tangential);
      if (!output.friction_loss.empty()) {
        const Batch work = Batch(0.5) * coefficient *
                           fma(sheared_before.x + sheared.x, along, (sheared_before.y + sheared.y) * across);
        // An open contact's springs are those of the last overlap; no other is known.
        store(select(pressed, work - stored_now + stored_before, select(good, stored_before, zero)),
              &output.friction_loss[start], count);
      }
    }

    // Bad numbers leave the memory as it was, an open contact none.
    const bool none_else = !any(!pressed);
    const auto remember = [&](const Batch& value, mindlin::MemoryBlock::Lanes& to) HWY_ATTR {
      store(none_else ? value : select(pressed, value, select(good, zero, remembered(to))), &to[lane], lanes<Batch>());
    };
    for (int i = 0; i < line.most; ++i) {
      const auto k = static_cast<std::size_t>(i);
      remember(line.at[i].root, block.root[k]);
      remember(line.at[i].x, block.x[k]);
      remember(line.at[i].y, block.y[k]);
    }
    const Mask opened = good & !pressed & (remembered(block.count) > zero);
    if (any(opened)) {
      for (auto* lanes_of : {&block.root, &block.x, &block.y})
        for (auto& layer : *lanes_of) store(select(opened, zero, remembered(layer)), &layer[lane], lanes<Batch>());
    }
    remember(line.count, block.count);
    remember(overlap, block.overlap);
    remember(normal.x, block.normal[0]), remember(normal.y, block.normal[1]), remember(normal.z, block.normal[2]);
    remember(major.x, block.axis[0]), remember(major.y, block.axis[1]), remember(major.z, block.axis[2]);
    const std::uint64_t in_contact = bits(pressed), sound = bits(good);
    for (std::size_t i = 0; i < count; ++i)
      output.status[start + i] = (in_contact >> i & 1) != 0 ? BatchStatus::pressed
                                 : (sound >> i & 1) != 0    ? BatchStatus::open
                                                            : BatchStatus::bad_input;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(mindlin_contacts);

namespace mindlin {

static_assert(std::is_trivially_copyable_v<MemoryBlock>);

Memory MemoryBlock::get(std::size_t lane) const {
  Memory memory;
  memory.springs.overlap = overlap[lane];
  memory.springs.count = static_cast<std::int64_t>(count[lane]);
  for (std::size_t i = 0; i < 3; ++i) memory.normal[i] = normal[i][lane], memory.axis[i] = axis[i][lane];
  for (std::size_t i = 0; i < layers; ++i)
    memory.springs.at[i] = {root[i][lane] * root[i][lane], x[i][lane], y[i][lane]};
  return memory;
}

void MemoryBlock::set(std::size_t lane, const Memory& memory) {
  overlap[lane] = memory.springs.overlap;
  count[lane] = static_cast<double>(memory.springs.count);
  for (std::size_t i = 0; i < 3; ++i) normal[i][lane] = memory.normal[i], axis[i][lane] = memory.axis[i];
  for (std::size_t i = 0; i < layers; ++i) {
    const Layer& layer = memory.springs.at[i];
    root[i][lane] = std::sqrt(layer.depth), x[i][lane] = layer.x, y[i][lane] = layer.y;
  }
}

Pair pair(const ElasticMaterial& material_1, const ElasticMaterial& material_2, double friction, double damping_time) {
  const auto require = [](const char* name, double value) {
    if (!(value >= 0.0) || !std::isfinite(value))
      throw InputError("mindlin::pair", std::string(name) + " " + std::to_string(value), "a finite value >= 0");
  };
  require("friction coefficient", friction);
  require("damping time", damping_time);
  return {.modulus = effective_modulus(material_1, material_2),
          .coupling = shear_coupling(material_1, material_2),
          .friction = friction,
          .damping_time = damping_time};
}

void contacts(const Pair& pair, const BatchInput& input, std::span<MemoryBlock> memory, const BatchOutput& output) {
  const std::size_t size = input.R_i.size();
  require_columns("mindlin::contacts", size,
                  {input.R_j.size(), input.overlap.size(), input.overlap_rate.size(), input.normal.x.size(),
                   input.normal.y.size(), input.normal.z.size(), input.major_axis.x.size(), input.major_axis.y.size(),
                   input.major_axis.z.size(), input.displacement.x.size(), input.displacement.y.size(),
                   input.displacement.z.size(), input.spin.size(), output.force.x.size(), output.force.y.size(),
                   output.force.z.size(), output.normal_force.size(), output.status.size()});
  for (const std::size_t other : {input.reduced_mass.size(), output.a_c.size(), output.axis_ratio.size(),
                                  output.stiffness.size(), output.stored_normal.size(), output.stored_tangential.size(),
                                  output.viscous_power.size(), output.friction_loss.size()})
    if (other != size && other != 0)
      throw InputError("mindlin::contacts", "a column of " + std::to_string(other) + " values",
                       std::to_string(size) + " as in R_i");
  if (pair.damping_factor > 0.0 && input.reduced_mass.empty())
    throw InputError("mindlin::contacts", "no column of reduced masses", "one, for a damping factor above zero");
  const std::size_t blocks = (size + MemoryBlock::width - 1) / MemoryBlock::width;
  if (memory.size() != blocks)
    throw InputError("mindlin::contacts", std::to_string(memory.size()) + " blocks of memory", std::to_string(blocks));
  HWY_DYNAMIC_DISPATCH(mindlin_contacts)(pair, input, memory.data(), output);
}

}  // namespace mindlin
}  // namespace osculate
#endif
