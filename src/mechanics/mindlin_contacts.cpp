#include "osculate/mechanics/mindlin_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "osculate/core/error.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/mindlin_contacts.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "mechanics/hertz-inl.hpp"

#ifndef OSCULATE_MECHANICS_MINDLIN_CONTACTS_CHUNK
#define OSCULATE_MECHANICS_MINDLIN_CONTACTS_CHUNK
namespace osculate::mindlin {

/// A few contacts as columns: what the vector part and the memory part hand to each other.
struct Chunk {
  static constexpr std::size_t size = 64;
  using Column = std::array<double, size>;
  Column R_i, R_j, overlap;
  Column coefficient, stiffness, a_c, axis_ratio, major, minor;
};

}  // namespace osculate::mindlin
#endif

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

void mindlin_normal(mindlin::Chunk& chunk, std::size_t used, double modulus, double coupling) {
  const Batch one(1.0), c(coupling);
  for (std::size_t start = 0; start < used; start += lanes<Batch>()) {
    const std::size_t count = std::min(lanes<Batch>(), used - start);
    const Batch R_j = load<Batch>(&chunk.R_j[start], count);
    const Batch R_i = limited(load<Batch>(&chunk.R_i[start], count), R_j);
    const Batch overlap = load<Batch>(&chunk.overlap[start], count);
    const auto ellipse = ellipse_of(R_i, R_j);
    const auto state = hertz_state(ellipse, Batch(modulus), overlap);
    // D/K from the ellipse's own equation R_j/R_i = m1 D/B with K = B + D.
    const Batch ratio = R_j / R_i, m1 = ellipse.axis_ratio * ellipse.axis_ratio;
    const Batch share = ratio / (ratio + m1);
    store(Batch(2.0 / 3.0) * state.stiffness / sqrt(overlap), &chunk.coefficient[start], count);
    store(state.stiffness, &chunk.stiffness[start], count);
    store(state.a_c, &chunk.a_c[start], count);
    store(ellipse.axis_ratio, &chunk.axis_ratio[start], count);
    store(one + c * share, &chunk.major[start], count);
    store(one + c * (one - share), &chunk.minor[start], count);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(mindlin_normal);

namespace mindlin {
namespace {

bool is_good(const ContactInput& in) {
  double sum = in.R_j + in.overlap + in.overlap_rate + in.spin;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    sum += in.normal[k] + in.major_axis[k] + in.displacement[k];
  }
  return std::isfinite(sum) && in.R_j > 0.0 && in.R_i >= in.R_j;
}

Vec3 vector(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

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

void contacts(const Pair& pair, std::span<const ContactInput> input, std::span<Memory> memory,
              std::span<ContactOutput> output) {
  if (memory.size() != input.size() || output.size() != input.size())
    throw InputError("mindlin::contacts",
                     std::to_string(memory.size()) + " memories and " + std::to_string(output.size()) + " outputs",
                     std::to_string(input.size()) + " of each, as many as contacts");
  Chunk chunk;
  std::array<std::size_t, Chunk::size> index{};
  for (std::size_t start = 0; start < input.size(); start += Chunk::size) {
    const std::size_t stop = std::min(start + Chunk::size, input.size());
    std::size_t used = 0;
    for (std::size_t i = start; i < stop; ++i) {
      const ContactInput& in = input[i];
      const bool good = is_good(in);
      if (good && in.overlap > 0.0) {
        index[used] = i;
        chunk.R_i[used] = in.R_i, chunk.R_j[used] = in.R_j, chunk.overlap[used] = in.overlap;
        ++used;
        continue;
      }
      output[i] = {.force = {0.0, 0.0, 0.0},
                   .normal_force = 0.0,
                   .a_c = 0.0,
                   .axis_ratio = 0.0,
                   .status = good ? BatchStatus::open : BatchStatus::bad_input};
      if (good) memory[i] = Memory{};
    }
    if (used == 0) continue;
    HWY_DYNAMIC_DISPATCH(mindlin_normal)(chunk, used, pair.modulus, pair.coupling);
    for (std::size_t j = 0; j < used; ++j) {
      const ContactInput& in = input[index[j]];
      const Vec3 normal = vector(in.normal);
      const Law law{.coefficient = chunk.coefficient[j],
                    .compliance_ratio = {.major = chunk.major[j], .minor = chunk.minor[j]},
                    .friction = pair.friction};
      const Vec3 tangential = advance(memory[index[j]], law,
                                      {.normal = normal,
                                       .major_axis = vector(in.major_axis),
                                       .overlap = in.overlap,
                                       .displacement = vector(in.displacement),
                                       .spin = in.spin});
      const double elastic = 2.0 / 3.0 * chunk.stiffness[j] * in.overlap;
      const double total = std::fmax(elastic + pair.damping_time * chunk.stiffness[j] * in.overlap_rate, 0.0);
      const Vec3 force = tangential - total * normal;
      output[index[j]] = {.force = {force.x(), force.y(), force.z()},
                          .normal_force = total,
                          .a_c = chunk.a_c[j],
                          .axis_ratio = chunk.axis_ratio[j],
                          .status = BatchStatus::pressed};
    }
  }
}

}  // namespace mindlin
}  // namespace osculate
#endif
