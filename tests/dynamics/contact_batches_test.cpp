#include "dynamics/contact_batches.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "dynamics/contact_edge.hpp"
#include "osculate/dynamics/random.hpp"

using namespace osculate;

namespace {

/// Bodies in any motion, and pairs of them: as many as asked for, whole batches or not.
struct Sample {
  std::vector<BodyRecord> records;
  std::vector<std::int32_t> bodies;
  std::vector<LocalPair> pairs;

  explicit Sample(std::size_t count) {
    Random random(7 + count);
    for (std::int32_t i = 0; i < 12; ++i) {
      BodyRecord& record = records.emplace_back();
      for (double& number : record.placed) number = random.normal();
      for (Vec3* v :
           {&record.velocity, &record.mean_angular_velocity, &record.last_velocity, &record.last_angular_velocity})
        *v = random.uniform(0.0, 3.0) * random.direction();
      if (i % 2 == 0) bodies.push_back(11 - i);
    }
    for (std::size_t i = 0; i < count; ++i)
      pairs.push_back({static_cast<std::uint16_t>(i % 5), static_cast<std::uint16_t>((i + 1 + i / 5 % 2) % 6)});
  }
  PairRecords of() const { return {pairs, bodies.data(), records.data()}; }
  const BodyRecord& body(std::uint16_t place) const { return records[static_cast<std::size_t>(bodies[place])]; }
};

template <std::size_t N>
Vec3 vector_at(const Columns<N>& columns, std::size_t first, std::size_t i) {
  return {columns[first][i], columns[first + 1][i], columns[first + 2][i]};
}
template <std::size_t N>
void put(const Vec3& v, Columns<N>& columns, std::size_t first, std::size_t i) {
  for (std::size_t k = 0; k < 3; ++k) columns[first + k][i] = v[static_cast<Eigen::Index>(k)];
}

/// Numbers of order one through a dozen operations.
constexpr double round_off = 1e-13;

}  // namespace

TEST_CASE("Bodies' records become columns of pairs as they are") {
  for (const std::size_t count : {1, 2, 3, 7, 8, 9, 23}) {
    const Sample sample(count);
    SuperquadricPairs pairs;
    ReadAhead nothing;
    fill_pairs(sample.of(), pairs, nothing);
    REQUIRE(pairs.size() == count);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < SuperquadricPairs::per_body; ++k) {
        CHECK(pairs.columns[k][i] == sample.body(sample.pairs[i].first).placed[k]);
        CHECK(pairs.columns[SuperquadricPairs::per_body + k][i] == sample.body(sample.pairs[i].second).placed[k]);
      }
  }
}

TEST_CASE("Contacts see the motion of the step in their plane and that of its end along the normal") {
  for (const std::size_t count : {1, 3, 8, 13, 24}) {
    const Sample sample(count);
    Random random(count);
    ContactColumns found;
    found.resize(count);
    ImageShifts images;
    Columns<3>& shift = images.shift;
    shift.resize(count);
    if (count % 2 == 0) images.flow = ImageFlow{.flow = 2, .gradient = 1, .rate = 0.7};
    std::vector<double> cap;
    const std::size_t proved = count / 2;  // not resolved
    for (std::size_t i = 0; i < count; ++i) {
      put(random.direction(), found.columns, of_geometry::normal, i);
      put(random.direction(), found.columns, of_geometry::on_1, i);
      put(random.direction(), found.columns, of_geometry::on_2, i);
      put(random.direction(), found.columns, of_geometry::major_axis, i);
      put(random.direction(), shift, 0, i);
      found.columns[of_geometry::R_j][i] = i == proved ? 0.0 : random.uniform(0.5, 1.5);
      found.columns[of_geometry::R_i][i] = i == proved ? 0.0 : 2.0;
      cap.push_back(i % 3 == 0 ? 1.0 : 3.0);
    }
    const ContactColumns before = found;
    Columns<of_arms::columns> arms;
    Columns<of_motion::columns> motion;
    ReadAhead nothing;
    describe_motion(sample.of(), images, cap, {.angular_velocity = true, .mean_angular_velocity = true}, found, arms,
                    motion, nothing);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 n = vector_at(found.columns, of_geometry::normal, i);
      if (i == proved) {
        CHECK(found.columns[of_geometry::R_i][i] == cap[i]);
        CHECK(found.columns[of_geometry::R_j][i] == cap[i]);
        const Vec3 axis = vector_at(found.columns, of_geometry::major_axis, i);
        CHECK(std::fabs(axis.norm() - 1.0) < round_off);
        CHECK(std::fabs(axis.dot(n)) < round_off);
        CHECK(vector_at(motion, of_motion::velocity, i).isZero(0.0));
        continue;
      }
      const BodyRecord &one = sample.body(sample.pairs[i].first), &two = sample.body(sample.pairs[i].second);
      const Vec3 point =
          0.5 * (vector_at(before.columns, of_geometry::on_1, i) + vector_at(before.columns, of_geometry::on_2, i));
      const Vec3 arm_1 = point - one.position(), arm_2 = point - (two.position() + vector_at(shift, 0, i));
      const Vec3 of_image = count % 2 == 0 ? Vec3(0.0, 0.0, 0.7 * shift[1][i]) : Vec3::Zero();
      const Vec3 step = two.velocity + of_image + two.mean_angular_velocity.cross(arm_2) -
                        (one.velocity + one.mean_angular_velocity.cross(arm_1));
      const Vec3 end = two.last_velocity + of_image + two.last_angular_velocity.cross(arm_2) -
                       (one.last_velocity + one.last_angular_velocity.cross(arm_1));
      const Mat3 along = n * n.transpose();
      const Vec3 velocity = (Mat3::Identity() - along) * step + along * end;
      CHECK((vector_at(arms, of_arms::arm_1, i) - arm_1).norm() < round_off);
      CHECK((vector_at(arms, of_arms::arm_2, i) - arm_2).norm() < round_off);
      CHECK((vector_at(motion, of_motion::velocity, i) - velocity).norm() < 10.0 * round_off);
      CHECK((vector_at(motion, of_motion::angular, i) - two.mean_angular_velocity + one.mean_angular_velocity).norm() <
            round_off);
      CHECK((vector_at(motion, of_motion::mean_angular, i) -
             0.5 * (two.mean_angular_velocity + one.mean_angular_velocity))
                .norm() < round_off);
      CHECK(found.columns[of_geometry::R_i][i] == std::min(2.0, cap[i]));
      CHECK(found.columns[of_geometry::R_j][i] == std::min(before.columns[of_geometry::R_j][i], cap[i]));
    }
  }
}

TEST_CASE("Sums over contacts count each once, and springs of any power gain what their coefficient grew") {
  for (const double power : {1.0, 1.5, 1.8})
    for (const std::size_t count : {1, 5, 8, 17}) {
      Random random(count);
      ContactColumns found;
      found.resize(count);
      Columns<of_arms::columns> arms;
      arms.resize(count);
      Columns<of_motion::columns> motion;
      motion.resize(count);
      Columns<of_answer::columns> out;
      out.resize(count);
      std::vector<double> mass;
      std::vector<NormalSpring> springs;
      LawSums expected;
      const double time_step = 0.1;
      std::vector<Vec3> forces;
      for (std::size_t i = 0; i < count; ++i) {
        const double overlap = random.uniform(0.5, 1.0), coefficient = random.uniform(1.0, 2.0);
        const double last = i % 4 == 1 ? 0.0 : overlap * 0.9, last_coefficient = random.uniform(1.0, 2.0);
        const double stored = coefficient * std::pow(overlap, power + 1.0);
        const double stiffness = coefficient * power * (power + 1.0) * std::pow(overlap, power - 1.0);
        const Vec3 n = random.direction();
        // Every third one comes in so fast that this is its first sample.
        const Vec3 velocity = (i % 3 == 2 ? 20.0 : 0.1) * n;
        const Vec3 force = random.direction();
        found.columns[of_geometry::overlap][i] = overlap;
        put(n, found.columns, of_geometry::normal, i);
        put(velocity, motion, of_motion::velocity, i);
        put(force, out, of_answer::force, i);
        put(random.direction(), out, of_answer::couple, i);
        put(random.direction(), arms, of_arms::arm_1, i);
        put(random.direction(), arms, of_arms::arm_2, i);
        out[of_answer::stored_normal][i] = stored;
        out[of_answer::stiffness][i] = stiffness;
        out[of_answer::viscous_loss][i] = random.uniform();
        mass.push_back(random.uniform(1.0, 2.0));
        springs.push_back({last, last == 0.0 ? 0.0 : last_coefficient});
        forces.push_back(force - edge_force(overlap, velocity.norm() * time_step, stored, stiffness) * n);
        expected.viscous_loss += out[of_answer::viscous_loss][i];
        expected.stored_normal += stored;
        expected.stiffest = std::max(expected.stiffest, stiffness / mass.back());
        expected.deepest = std::max(expected.deepest, overlap);
        if (last > 0.0)
          expected.curvature_gain += (coefficient - last_coefficient) * std::pow(0.5 * (last + overlap), power + 1.0);
      }
      // Five bodies, so that some have several contacts in a batch.
      std::vector<LocalPair> pairs;
      for (std::size_t i = 0; i < count; ++i)
        pairs.push_back({static_cast<std::uint16_t>(i % 3), static_cast<std::uint16_t>(3 + i % 2)});
      std::vector<Wrench> wrenches(5);
      std::vector<Vec3> contact_forces(count), contact_couples(count);
      ReadAhead nothing;
      const LawSums sums = collect({found, arms, motion, out, time_step, true, true}, mass,
                                   {springs, contact_forces, contact_couples, pairs, wrenches}, nothing);
      const double tolerance = 1e-12 * static_cast<double>(count);  // sums of numbers of order one
      CHECK(std::fabs(sums.viscous_loss - expected.viscous_loss) < tolerance);
      CHECK(std::fabs(sums.stored_normal - expected.stored_normal) < tolerance);
      CHECK(std::fabs(sums.curvature_gain - expected.curvature_gain) < 10.0 * tolerance);
      CHECK(std::fabs(sums.stiffest - expected.stiffest) < tolerance);
      CHECK(sums.deepest == expected.deepest);
      std::vector<Vec3> force_on(5, Vec3::Zero()), torque_on(5, Vec3::Zero());
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 couple = vector_at(out, of_answer::couple, i);
        CHECK((contact_forces[i] - forces[i]).norm() < 100.0 * round_off);
        CHECK(contact_couples[i] == couple);
        force_on[pairs[i].first] += forces[i];
        force_on[pairs[i].second] -= forces[i];
        torque_on[pairs[i].first] += vector_at(arms, of_arms::arm_1, i).cross(forces[i]) + couple;
        torque_on[pairs[i].second] -= vector_at(arms, of_arms::arm_2, i).cross(forces[i]) + couple;
      }
      for (std::size_t body = 0; body < 5; ++body) {
        CHECK((wrenches[body].force() - force_on[body]).norm() < 1000.0 * round_off);
        CHECK((wrenches[body].torque() - torque_on[body]).norm() < 1000.0 * round_off);
        CHECK(wrenches[body].numbers[3] == 0.0);
        CHECK(wrenches[body].numbers[7] == 0.0);
      }
    }
}

TEST_CASE("A sleeping pair's planes still separate after rounding to floats") {
  Random random(3);
  const double radius = 3e-3;
  for (int i = 0; i < 10000; ++i) {
    // A ball: the support in any direction is its radius.
    ContactCache cache{.state = ContactCache::State::separation};
    cache.normal_1 = random.direction(), cache.normal_2 = random.direction();
    cache.point_1 = radius * cache.normal_1, cache.point_2 = radius * cache.normal_2;
    const ContactCache kept = FarCache(cache).cache(radius, radius);
    REQUIRE(kept.point_1.dot(kept.normal_1) >= radius);
    REQUIRE(kept.point_2.dot(kept.normal_2) >= radius);
    REQUIRE(kept.point_1.dot(kept.normal_1) < radius * (1.0 + 1e-6));
    const double x = random.normal();
    REQUIRE(static_cast<double>(rounded_down(x)) <= x);
    REQUIRE(x - static_cast<double>(rounded_down(x)) <= 2.0 * 0x1p-23 * std::fabs(x));
  }
}
