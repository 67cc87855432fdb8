#include "osculate/mechanics/mindlin_contacts.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace mindlin = osculate::mindlin;
using mindlin::BatchStatus;
using osculate::Vec3;

namespace {

const osculate::ElasticMaterial glass{.youngs_modulus = 71e9, .poissons_ratio = 0.22};
const osculate::ElasticMaterial rubber{.youngs_modulus = 4e6, .poissons_ratio = 0.49};
constexpr double friction = 0.4, damping_time = 1e-7;

struct Batch {
  std::array<std::vector<double>, 14> in;
  std::array<std::vector<double>, 6> out;
  std::vector<BatchStatus> status;
  std::vector<mindlin::MemoryBlock> memory;

  explicit Batch(std::size_t size) : status(size), memory((size + 7) / 8) {
    for (auto& column : in) column.resize(size);
    for (auto& column : out) column.resize(size);
  }
  void set(std::size_t i, const std::array<double, 14>& row) {
    for (std::size_t c = 0; c < row.size(); ++c) in[c][i] = row[c];
  }
  void run(const mindlin::Pair& pair) {
    mindlin::contacts(pair,
                      {.R_i = in[0],
                       .R_j = in[1],
                       .overlap = in[2],
                       .overlap_rate = in[3],
                       .normal = {in[4], in[5], in[6]},
                       .major_axis = {in[7], in[8], in[9]},
                       .displacement = {in[10], in[11], in[12]},
                       .spin = in[13]},
                      memory,
                      {.force = {out[0], out[1], out[2]},
                       .normal_force = out[3],
                       .a_c = out[4],
                       .axis_ratio = out[5],
                       .status = status});
  }
};

}  // namespace

TEST_CASE("A batch steps every contact as the general law does one by one") {
  const auto pair = mindlin::pair(glass, rubber, friction, damping_time);
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const std::size_t size = 21;  // not a multiple of any vector length
  Batch batch(size);
  std::vector<mindlin::Memory> single(size);
  for (int step = 0; step < 60; ++step) {
    const bool turns = step % 3 != 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Vec3 normal = Vec3(0.02 * step, 0.1 * static_cast<double>(i), 1.0).normalized();
      const Vec3 major = normal.cross(Vec3(1.0, 0.3, 0.01 * step)).normalized();
      const double R_j = 1e-3, R_i = R_j * (1.0 + static_cast<double>(i * i));
      const double overlap = i % 7 == 0 && step % 10 == 9 ? -1e-7 : 1e-6 * (1.0 + 0.5 * uniform(random));
      const Vec3 moved = 1e-7 * Vec3(uniform(random), uniform(random), uniform(random));
      const double rate = 1e-2 * uniform(random), spin = turns ? 0.05 * uniform(random) : 0.0;
      batch.set(i, {R_i, R_j, overlap, rate, normal.x(), normal.y(), normal.z(), major.x(), major.y(), major.z(),
                    moved.x(), moved.y(), moved.z(), spin});
    }
    batch.run(pair);
    for (std::size_t i = 0; i < size; ++i) {
      const auto& in = batch.in;
      const Vec3 normal(in[4][i], in[5][i], in[6][i]), major(in[7][i], in[8][i], in[9][i]);
      const double overlap = in[2][i];
      const Vec3 force(batch.out[0][i], batch.out[1][i], batch.out[2][i]);
      if (overlap <= 0.0) {
        REQUIRE(batch.status[i] == BatchStatus::open);
        REQUIRE(force == Vec3::Zero());
        single[i] = mindlin::Memory{};
        continue;
      }
      REQUIRE(batch.status[i] == BatchStatus::pressed);
      const auto ellipse = osculate::contact_ellipse(in[0][i], in[1][i]);
      const auto pressed = osculate::hertz::contact(ellipse, pair.modulus, overlap, in[1][i]);
      const double normal_force = std::fmax(pressed.force + damping_time * pressed.stiffness * in[3][i], 0.0);
      const auto law =
          mindlin::law(pressed.force / std::pow(overlap, 1.5), mindlin::compliance_ratio(ellipse, glass, rubber),
                       friction * normal_force / pressed.force);
      const Vec3 tangential =
          mindlin::advance(single[i], law, {normal, major, overlap, Vec3(in[10][i], in[11][i], in[12][i]), in[13][i]});
      // Once points have to be forgotten, roundings now and then decide which: a difference as small as the point.
      const double tolerance = step < 4 ? 1e-11 : 1e-2 * friction;
      CHECK((force - (tangential - normal_force * normal)).norm() <= tolerance * pressed.force);
      CHECK(batch.out[3][i] == Approx(normal_force).epsilon(1e-13).margin(1e-12 * pressed.force));
      CHECK(batch.out[4][i] == Approx(pressed.a_c).epsilon(1e-13));
      CHECK(batch.out[5][i] == Approx(ellipse.axis_ratio).epsilon(1e-13));
      CHECK((force - force.dot(normal) * normal).norm() <= friction * normal_force * (1.0 + 1e-13));
    }
  }
}

TEST_CASE("A memory moved to another lane goes on as if it had stayed") {
  const auto pair = mindlin::pair(glass, glass, friction, 0.0);
  Batch here(3), there(13);
  const auto drive = [&](Batch& batch, std::size_t lane, int step) {
    for (std::size_t i = 0; i < batch.status.size(); ++i)
      batch.set(i, {2e-3, 1e-3, 1e-6, 0, 0, 0, 1, 1, 0, 0, i == lane ? 1e-8 * step : 0.0, 3e-8 * std::sin(step), 0, 0});
    batch.run(pair);
  };
  for (int step = 0; step < 20; ++step) drive(here, 1, step);
  there.memory[1].set(3, here.memory[0].get(1));
  for (int step = 20; step < 30; ++step) {
    drive(here, 1, step);
    drive(there, 11, step);
    REQUIRE(there.out[0][11] == here.out[0][1]);
    REQUIRE(there.out[1][11] == here.out[1][1]);
  }
}

TEST_CASE("A contact's force does not depend by a bit on the contacts beside it") {
  const auto pair = mindlin::pair(glass, glass, friction, damping_time);
  constexpr std::size_t size = 16;
  Batch together(size);
  std::vector<Batch> alone(size, Batch(1));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::array<Vec3, size> drift;
  drift.fill(Vec3::Zero());
  for (int step = 0; step < 3000; ++step)
    for (std::size_t i = 0; i <= size; ++i) {
      if (i == size) {
        together.run(pair);
        for (std::size_t k = 0; k < size; ++k) {
          alone[k].run(pair);
          CAPTURE(step, k);
          for (std::size_t c = 0; c < 3; ++c) REQUIRE(together.out[c][k] == alone[k].out[c][0]);
        }
        break;
      }
      // Paths that wind more or less, so that some springs are full of corners while others are straight.
      const double winding = 0.3 * static_cast<double>(i) / size;
      drift[i] = 0.95 * drift[i] + winding * Vec3(uniform(random), uniform(random), 0.0);
      const Vec3 moved = 2e-9 * (drift[i] + Vec3(std::sin(0.01 * step), 0.0, 0.0));
      // Every third contact opens now and then: a memory of few corners beside full ones.
      const double phase = 0.003 * step * static_cast<double>(1 + i), base = i % 3 == 0 ? 0.2 : 1.0;
      const double overlap = 1e-6 * (base + 0.3 * std::sin(phase) + 1e-3 * winding * uniform(random));
      const std::array<double, 14> row{2e-3, 1e-3, overlap, 0,         0,         0, 1,
                                       1,    0,    0,       moved.x(), moved.y(), 0, 1e-3 * winding};
      together.set(i, row);
      alone[i].set(0, row);
    }
}

TEST_CASE("Bad numbers in the contacts of a step are said, give no force and leave the memory alone") {
  const auto pair = mindlin::pair(glass, glass, friction, damping_time);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const std::array<double, 14> good{2e-3, 1e-3, 1e-6, 0, 0, 0, 1, 1, 0, 0, 1e-8, 0, 0, 0};
  for (std::size_t column = 0; column < good.size(); ++column)
    for (const double bad : {nan, -infinity}) {
      Batch batch(9);
      for (std::size_t i = 0; i < 9; ++i) batch.set(i, good);
      batch.run(pair);
      const double before = batch.memory[0].x[0][4];
      batch.in[column][4] = bad;
      batch.run(pair);
      CAPTURE(column);
      REQUIRE(batch.status[4] == BatchStatus::bad_input);
      REQUIRE(batch.memory[0].x[0][4] == before);
      for (const auto& out : batch.out) {
        REQUIRE(out[4] == 0.0);
        REQUIRE(std::isfinite(out[3]));
      }
      REQUIRE(batch.status[3] == BatchStatus::pressed);
    }
  Batch batch(9);
  batch.memory.pop_back();
  REQUIRE_THROWS_AS(batch.run(pair), osculate::InputError);
}

TEST_CASE("Pairs of materials without sense are refused") {
  REQUIRE_THROWS_AS(mindlin::pair(glass, glass, -0.1, 0.0), osculate::InputError);
  REQUIRE_THROWS_AS(mindlin::pair(glass, glass, 0.1, std::nan("")), osculate::InputError);
  REQUIRE_THROWS_AS(mindlin::pair({.youngs_modulus = -1.0, .poissons_ratio = 0.2}, glass, 0.1, 0.0),
                    osculate::InputError);
}
