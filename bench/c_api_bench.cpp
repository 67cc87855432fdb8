// What the way through the C API costs: warm contacts of superquadrics and forces, by the C++ batches and by the C
// functions, which gather bodies and unpack bytes besides. The ratio is the C column over its C++ neighbour.

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "osculate/core/aligned_allocator.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"
#include "osculate/mechanics/law_registry.hpp"
#include "osculate/osculate.h"

namespace {

using namespace osculate;

/// Pairs of blocky grains that overlap by about a hundredth, and the same after a small motion: contacts are warm, and
/// not where they were.
struct Grains {
  explicit Grains(std::size_t pairs) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return Vec3(normal(random), normal(random), normal(random)).normalized(); };
    std::vector<Pose> first;
    for (std::size_t i = 0; i < pairs; ++i) {
      Pose one{.position = direction(), .orientation = Quat(1.0, 0.3 * normal(random), 0.3 * normal(random), 0.0)},
          two{.position = one.position + 1.9 * direction(), .orientation = Quat(1.0, 0.0, normal(random), 0.5)};
      one.orientation.normalize(), two.orientation.normalize();
      const ContactGeometry contact = common_normal(shape, one, shape, two);
      two.position += (contact.overlap - 0.01) * contact.normal;
      first.push_back(one), first.push_back(two);
      body_1.push_back(static_cast<std::int32_t>(2 * i)), body_2.push_back(static_cast<std::int32_t>(2 * i + 1));
    }
    for (std::size_t motion = 0; motion < 2; ++motion) {
      for (auto& column : columns[motion]) column.clear();
      for (Pose& pose : first) {
        pose.position += 1e-4 * static_cast<double>(motion) * direction();
        const Quat& q = pose.orientation;
        const double values[] = {pose.position.x(), pose.position.y(), pose.position.z(), q.w(), q.x(), q.y(), q.z()};
        for (std::size_t k = 0; k < 7; ++k) columns[motion][k].push_back(values[k]);
      }
    }
  }
  std::size_t pairs() const { return body_1.size(); }
  Pose pose(std::size_t motion, std::size_t body) const {
    const auto& c = columns[motion];
    return {.position = Vec3(c[0][body], c[1][body], c[2][body]),
            .orientation = Quat(c[3][body], c[4][body], c[5][body], c[6][body])};
  }

  Superquadric shape{Vec3(1.0, 1.2, 0.8), {4.0, 4.0}};
  std::array<std::array<std::vector<double>, 7>, 2> columns;  // x, y, z, orientation w, x, y, z
  std::vector<std::int32_t> body_1, body_2;
};

void per_contact(benchmark::State& state, std::size_t contacts) {
  state.counters["per_contact"] = benchmark::Counter(
      static_cast<double>(contacts), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void contacts_cpp(benchmark::State& state) {
  const Grains grains(static_cast<std::size_t>(state.range(0)));
  SuperquadricPairs pairs;
  ContactCaches caches;
  ContactColumns contacts;
  pairs.resize(grains.pairs());
  std::size_t motion = 0;
  for ([[maybe_unused]] auto _ : state) {
    motion = 1 - motion;
    for (std::size_t i = 0; i < grains.pairs(); ++i)
      pairs.set(i, grains.shape, grains.pose(motion, 2 * i), grains.shape, grains.pose(motion, 2 * i + 1));
    common_normals(pairs, caches, contacts, Gap::skip);
    benchmark::ClobberMemory();
  }
  per_contact(state, grains.pairs());
}

void contacts_c(benchmark::State& state) {
  const Grains grains(static_cast<std::size_t>(state.range(0)));
  osculate_shape* shape = nullptr;
  osculate_new_superquadric(grains.shape.half_axes.data(), 4.0, 4.0, &shape);
  const std::vector<const osculate_shape*> shapes(2 * grains.pairs(), shape);
  std::vector<unsigned char> caches(grains.pairs() * osculate_cache_size());
  std::vector<std::int32_t> status(grains.pairs());
  std::vector<std::vector<double>> out(25, std::vector<double>(grains.pairs()));
  const auto at = [&](std::size_t k) { return out[k].data(); };
  const osculate_contact_columns contacts{.status = status.data(),
                                          .normal = {at(0), at(1), at(2)},
                                          .overlap = at(3),
                                          .on_1 = {at(4), at(5), at(6)},
                                          .on_2 = {at(7), at(8), at(9)},
                                          .curvature_1 = {at(10), at(11)},
                                          .direction_1 = {at(12), at(13), at(14)},
                                          .curvature_2 = {at(15), at(16)},
                                          .direction_2 = {at(17), at(18), at(19)},
                                          .R_i = at(20),
                                          .R_j = at(21),
                                          .major_axis = {at(22), at(23), at(24)}};
  std::size_t motion = 0;
  for ([[maybe_unused]] auto _ : state) {
    motion = 1 - motion;
    const auto& c = grains.columns[motion];
    const osculate_bodies bodies{.size = shapes.size(),
                                 .shape = shapes.data(),
                                 .position = {c[0].data(), c[1].data(), c[2].data()},
                                 .orientation = {c[3].data(), c[4].data(), c[5].data(), c[6].data()}};
    if (osculate_find_contacts(&bodies, grains.pairs(), grains.body_1.data(), grains.body_2.data(), OSCULATE_GAP_SKIP,
                               caches.data(), &contacts) != OSCULATE_OK)
      state.SkipWithError(osculate_error_message());
    benchmark::ClobberMemory();
  }
  per_contact(state, grains.pairs());
  osculate_free_shape(shape);
}

/// Sticking and slipping contacts of glass.
struct Approaches {
  explicit Approaches(std::size_t size) : columns(14, std::vector<double>(size)) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (std::size_t i = 0; i < size; ++i) {
      const double values[] = {3e-3,
                               1e-3,
                               1e-6 * uniform(random),
                               0.0,
                               0.0,
                               1.0,
                               1.0,
                               0.0,
                               0.0,
                               0.01 * uniform(random),
                               0.01 * uniform(random),
                               0.0,
                               0.0,
                               1e-5};
      for (std::size_t k = 0; k < columns.size(); ++k) columns[k][i] = values[k];
    }
  }
  std::vector<std::vector<double>> columns;  // R_i, R_j, overlap, normal, major axis, velocity, spin, mass
};

void forces_cpp(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(0));
  const Approaches approach(size);
  const auto& c = approach.columns;
  const ElasticMaterial glass{71e9, 0.22};
  const ContactLaw law = make_contact_law(
      {{"hertz", {}}, {"tsuji", {{"restitution", 0.8}}}, {"mindlin", {{"friction", 0.4}}}}, glass, glass);
  std::vector<double, AlignedAllocator<double>> memory(law.memory_length(size));
  std::vector<std::vector<double>> out(4, std::vector<double>(size));
  std::vector<LawStatus> status(size);
  for ([[maybe_unused]] auto _ : state) {
    law.evaluate({.R_i = c[0],
                  .R_j = c[1],
                  .overlap = c[2],
                  .normal = {c[3], c[4], c[5]},
                  .major_axis = {c[6], c[7], c[8]},
                  .velocity = {c[9], c[10], c[11]},
                  .mean_angular_velocity = {c[12], c[12], c[12]},
                  .reduced_mass = c[13],
                  .time_step = 1e-6},
                 memory, {.force = {out[0], out[1], out[2]}, .normal_force = out[3], .status = status});
    benchmark::ClobberMemory();
  }
  per_contact(state, size);
}

void forces_c(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(0));
  const Approaches approach(size);
  const auto at = [&](std::size_t k) { return approach.columns[k].data(); };
  const osculate_material glass{71e9, 0.22};
  const osculate_law_setting settings[] = {
      {"hertz", nullptr, 0.0}, {"tsuji", "restitution", 0.8}, {"mindlin", "friction", 0.4}};
  osculate_law* law = nullptr;
  osculate_new_law(3, settings, &glass, &glass, &law);
  std::vector<unsigned char> memory(size * osculate_memory_size(law));
  std::vector<std::vector<double>> out(4, std::vector<double>(size));
  std::vector<std::int32_t> status(size);
  osculate_force_columns forces{};
  forces.status = status.data();
  for (std::size_t k = 0; k < 3; ++k) forces.force[k] = out[k].data();
  forces.normal_force = out[3].data();
  osculate_approach_columns in{};
  in.size = size, in.R_i = at(0), in.R_j = at(1), in.overlap = at(2), in.reduced_mass = at(13), in.time_step = 1e-6;
  for (std::size_t k = 0; k < 3; ++k) {
    in.normal[k] = at(3 + k), in.major_axis[k] = at(6 + k), in.velocity[k] = at(9 + k);
    in.mean_angular_velocity[k] = at(12);
  }
  for ([[maybe_unused]] auto _ : state) {
    if (osculate_evaluate_forces(law, &in, memory.data(), &forces) != OSCULATE_OK)
      state.SkipWithError(osculate_error_message());
    benchmark::ClobberMemory();
  }
  per_contact(state, size);
  osculate_free_law(law);
}

}  // namespace

BENCHMARK(contacts_cpp)->Arg(512)->Arg(20000);
BENCHMARK(contacts_c)->Arg(512)->Arg(20000);
BENCHMARK(forces_cpp)->Arg(512)->Arg(20000);
BENCHMARK(forces_c)->Arg(512)->Arg(20000);
BENCHMARK_MAIN();
