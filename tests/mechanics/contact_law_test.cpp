#include "osculate/mechanics/contact_law.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "mechanics/law_bed.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;

namespace {

const std::array batched_laws{
    LawChoice{{"hertz", {}}, {"tsuji", {{"restitution", 0.7}}}},
    LawChoice{{"hertz", {}}, {"mindlin", {{"friction", 0.4}}}},
    LawChoice{{"hertz", {}}, {"brilliantov", {{"dissipative_time", 1e-7}}}, {"mindlin", {{"friction", 0.4}}}},
    LawChoice{{"hertz", {}}, {"tsuji", {{"restitution", 0.7}}}, {"mindlin", {{"friction", 0.4}}}},
    LawChoice{{"hertz", {}}, {"tsuji", {{"restitution", 0.7}}}, {"di_renzo", {{"friction", 0.3}}}},
    LawChoice{{"hertz", {}}, {"brilliantov", {{"dissipative_time", 1e-7}}}, {"tsuji_tangential", {{"friction", 0.3}}}},
    LawChoice{{"hertz", {}},
              {"tsuji", {{"restitution", 0.7}}},
              {"cundall_strack", {{"friction", 0.3}, {"tangential_stiffness", 1e6}, {"tangential_damping", 20.0}}}},
    LawChoice{{"hertz", {}}, {"mindlin", {{"friction", 0.4}}}, {"twisting", {{"friction", 0.3}}}},
    LawChoice{{"hertz", {}},
              {"brilliantov", {{"dissipative_time", 1e-7}}},
              {"tsuji_tangential", {{"friction", 0.3}}},
              {"twisting", {{"friction", 0.3}}}},
    LawChoice{{"hertz", {}}, {"tsuji", {{"restitution", 0.7}}}, {"vermeulen_johnson", {{"friction", 0.3}}}}};

bool holds(const LawChoice& choice, std::string_view name) {
  return std::ranges::any_of(choice, [&](const ChosenLaw& law) { return law.name == name; });
}

}  // namespace

TEST_CASE("A law in batches says what the same law says contact by contact") {
  const auto& choice = batched_laws[GENERATE(range(std::size_t{0}, batched_laws.size()))];
  const ContactLaw batch = make_contact_law(choice, glass, steel),
                   single = make_contact_law_scalar(choice, glass, steel);
  REQUIRE(batch.memory_size() == single.memory_size());
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const std::size_t size = 21;  // not a multiple of any vector length
  LawBed one(single, size), many(batch, size);
  for (int step = 0; step < 25; ++step) {
    for (std::size_t i = 0; i < size; ++i) {
      const Vec3 normal = Vec3(0.01 * step, 0.1 * static_cast<double>(i), 1.0).normalized();
      const LawRow row{.R_i = 1e-3 * (1.0 + static_cast<double>(i * i)),
                       .R_j = 1e-3,
                       .overlap = i % 7 == 0 && step % 10 == 9 ? -1e-7 : 1e-6 * (1.0 + 0.5 * uniform(random)),
                       .normal = normal,
                       .major = normal.cross(Vec3(1.0, 0.3, 0.01 * step)).normalized(),
                       .velocity = 0.05 * Vec3(uniform(random), uniform(random), uniform(random)),
                       .angular = 1e2 * Vec3(uniform(random), uniform(random), uniform(random)),
                       .mean_angular = 1e3 * Vec3(uniform(random), uniform(random), uniform(random))};
      one.set(i, row), many.set(i, row);
    }
    one.evaluate(single), many.evaluate(batch);
    // Once points of Mindlin's springs have to be forgotten, roundings now and then decide which; see
    // mindlin_contacts_test.
    const double tolerance = step < 4 || !holds(choice, "mindlin") ? 1e-10 : 5e-3;
    for (std::size_t i = 0; i < size; ++i) {
      REQUIRE(many.status[i] == one.status[i]);
      const double scale = one.normal_force[i] + 1e-3;
      CHECK((many.force(i) - one.force(i)).norm() <= tolerance * scale);
      // Rolling creeps by the small difference of two large motions.
      CHECK((many.couple(i) - one.couple(i)).norm() <= 1e-10 * one.couple(i).norm());
      CHECK(many.normal_force[i] == Approx(one.normal_force[i]).epsilon(1e-12).margin(1e-12));
      CHECK(many.a_c[i] == Approx(one.a_c[i]).epsilon(1e-12));
      CHECK(many.axis_ratio[i] == Approx(one.axis_ratio[i]).epsilon(1e-12));
      CHECK(many.stiffness[i] == Approx(one.stiffness[i]).epsilon(1e-12));
      CHECK(many.stored_normal[i] == Approx(one.stored_normal[i]).epsilon(1e-12));
      const double energy = scale * 1e-6;
      CHECK(std::fabs(many.stored_tangential[i] - one.stored_tangential[i]) <= tolerance * energy);
      CHECK(std::fabs(many.viscous_loss[i] - one.viscous_loss[i]) <= tolerance * energy);
      CHECK(std::fabs(many.friction_loss[i] - one.friction_loss[i]) <= tolerance * energy);
    }
  }
}

TEST_CASE("A contact's answer does not depend on which outputs are asked for, nor on its neighbours") {
  const auto& choice = batched_laws[GENERATE(range(std::size_t{0}, batched_laws.size()))];
  const ContactLaw law = make_contact_law(choice, glass, glass);
  LawBed all(law, 11), few(law, 11), alone(law, 1);
  few.drop_optional();
  for (int step = 0; step < 9; ++step) {
    for (std::size_t i = 0; i < 11; ++i)
      for (LawBed* bed : {&all, &few})
        bed->set(i, {.overlap = 1e-6 * (1.0 + std::sin(static_cast<double>(i) + step)),
                     .velocity = Vec3(0.01 * step, 0.02, -0.01)});
    alone.set(0, {.overlap = 1e-6 * (1.0 + std::sin(6.0 + step)), .velocity = Vec3(0.01 * step, 0.02, -0.01)});
    all.evaluate(law), few.evaluate(law), alone.evaluate(law);
    for (std::size_t i = 0; i < 11; ++i) REQUIRE(few.force(i) == all.force(i));
    REQUIRE(alone.force(0) == all.force(6));
  }
}

TEST_CASE("Bad numbers are said in the status, alone, and leave the memory as it was") {
  const auto& choice = batched_laws[GENERATE(range(std::size_t{0}, batched_laws.size()))];
  const bool scalar = GENERATE(false, true);
  const ContactLaw law =
      scalar ? make_contact_law_scalar(choice, glass, glass) : make_contact_law(choice, glass, glass);
  const double nan = std::nan("");
  LawBed bed(law, 9);
  for (std::size_t i = 0; i < 9; ++i) bed.set(i, {.velocity = Vec3(0.01, 0.02, 0.0)});
  bed.evaluate(law);
  const auto memory = bed.memory;
  const Vec3 before = bed.force(8);
  bed.set(0, {.overlap = nan});
  bed.set(1, {.R_j = -1e-3});
  bed.set(2, {.R_i = 0.5e-3, .R_j = 1e-3});
  bed.set(3, {.velocity = Vec3(nan, 0.0, 0.0)});
  bed.set(4, {.normal = Vec3(0.0, nan, 1.0)});
  bed.evaluate(law);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(bed.status[i] == LawStatus::bad_input);
    CHECK(bed.force(i) == Vec3::Zero());
    CHECK(bed.normal_force[i] == 0.0);
    for (std::size_t m = 0; m < law.memory_size(); ++m)
      CHECK(bed.memory[m * law_lanes + i] == memory[m * law_lanes + i]);
  }
  CHECK(bed.status[8] == LawStatus::closed);
  CHECK((bed.force(8) - before).norm() < bed.normal_force[8]);
}

TEST_CASE("Columns that do not fit are an error, not a crash") {
  const ContactLaw law = make_contact_law(batched_laws[3], glass, glass);
  LawBed bed(law, 3);
  for (std::size_t i = 0; i < 3; ++i) bed.set(i, {});
  LawInput input = bed.input();
  input.reduced_mass = {};
  CHECK_THROWS_AS(law.evaluate(input, bed.memory, bed.output()), InputError);
  input = bed.input();
  input.normal.y = {};
  CHECK_THROWS_AS(law.evaluate(input, bed.memory, bed.output()), InputError);
  input = bed.input();
  input.time_step = -1.0;
  CHECK_THROWS_AS(law.evaluate(input, bed.memory, bed.output()), InputError);
  CHECK_THROWS_AS(law.evaluate(bed.input(), std::span(bed.memory).first(8), bed.output()), InputError);
}

TEST_CASE("A contact too large for a half-space says so") {
  const ContactLaw law = make_contact_law(batched_laws[GENERATE(0, 1, 4)], glass, glass);
  LawBed bed(law, 2);
  bed.set(0, {.R_i = 1e-3, .R_j = 1e-3, .overlap = 1e-6});
  bed.set(1, {.R_i = 1e-3, .R_j = 1e-3, .overlap = 1e-3});
  bed.smallest = {1e-3, 1e-3};
  bed.evaluate(law);
  CHECK(bed.status[0] == LawStatus::closed);
  CHECK(bed.status[1] == LawStatus::large_contact);
}
