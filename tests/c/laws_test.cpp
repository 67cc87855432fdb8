#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "c/c_bodies.hpp"
#include "mechanics/law_bed.hpp"
#include "mechanics/law_choices.hpp"

using namespace osculate;

namespace {

struct LawHandle {
  osculate_law* handle = nullptr;

  explicit LawHandle(const LawChoice& choice) {
    std::vector<osculate_law_setting> settings;
    for (const ChosenLaw& law : choice) {
      settings.push_back({law.name.c_str(), nullptr, 0.0});
      for (const auto& [name, value] : law.parameters) settings.push_back({law.name.c_str(), name.c_str(), value});
    }
    const osculate_material one{glass.youngs_modulus, glass.poissons_ratio},
        two{steel.youngs_modulus, steel.poissons_ratio};
    osculate_new_law(settings.size(), settings.data(), &one, &two, &handle);
  }
  LawHandle(const LawHandle&) = delete;
  LawHandle& operator=(const LawHandle&) = delete;
  ~LawHandle() { osculate_free_law(handle); }
};

osculate_approach_columns c_input(const LawInput& in) {
  const auto data = [](std::span<const double> column) { return column.empty() ? nullptr : column.data(); };
  osculate_approach_columns to{};
  const auto fill = [&](const double*(&columns)[3], const Vectors<const double>& from) {
    columns[0] = data(from.x), columns[1] = data(from.y), columns[2] = data(from.z);
  };
  to.size = in.R_i.size();
  to.R_i = data(in.R_i), to.R_j = data(in.R_j), to.overlap = data(in.overlap);
  fill(to.normal, in.normal);
  fill(to.major_axis, in.major_axis);
  fill(to.velocity, in.velocity);
  fill(to.angular_velocity, in.angular_velocity);
  fill(to.mean_angular_velocity, in.mean_angular_velocity);
  to.reduced_mass = data(in.reduced_mass), to.effective_radius = data(in.effective_radius);
  to.smallest_radius = data(in.smallest_radius);
  to.time_step = in.time_step;
  return to;
}

/// Forces in the order of osculate_force.
struct ForceColumns {
  explicit ForceColumns(std::size_t size) : status(size, -1), values(15, std::vector<double>(size, -1.0)) {}
  osculate_force_columns view() {
    const auto at = [&](std::size_t k) { return values[k].data(); };
    return {status.data(),
            {at(0), at(1), at(2)},
            {at(3), at(4), at(5)},
            at(6),
            at(7),
            at(8),
            at(9),
            at(10),
            at(11),
            at(12),
            at(13),
            at(14)};
  }
  std::vector<std::int32_t> status;
  std::vector<std::vector<double>> values;
};

std::vector<double> numbers_of(const osculate_force& f) {
  return {f.force[0],      f.force[1],          f.force[2],     f.couple[0],     f.couple[1],
          f.couple[2],     f.normal_force,      f.a_c,          f.axis_ratio,    f.stiffness,
          f.stored_normal, f.stored_tangential, f.viscous_loss, f.friction_loss, f.hysteresis_loss};
}

std::vector<double> numbers_of(LawBed& bed, std::size_t i) {
  const Vec3 force = bed.force(i), couple = bed.couple(i);
  return {force.x(),
          force.y(),
          force.z(),
          couple.x(),
          couple.y(),
          couple.z(),
          bed.normal_force[i],
          bed.a_c[i],
          bed.axis_ratio[i],
          bed.stiffness[i],
          bed.stored_normal[i],
          bed.stored_tangential[i],
          bed.viscous_loss[i],
          bed.friction_loss[i],
          bed.hysteresis_loss[i]};
}

osculate_approach approach_at(const osculate_approach_columns& from, std::size_t i) {
  osculate_approach to{};
  to.R_i = from.R_i[i], to.R_j = from.R_j[i], to.overlap = from.overlap[i];
  for (int k = 0; k < 3; ++k) {
    to.normal[k] = from.normal[k][i];
    to.major_axis[k] = from.major_axis[k][i];
    to.velocity[k] = from.velocity[k][i];
    to.angular_velocity[k] = from.angular_velocity[k][i];
    to.mean_angular_velocity[k] = from.mean_angular_velocity[k][i];
  }
  to.reduced_mass = from.reduced_mass[i], to.effective_radius = from.effective_radius[i];
  to.time_step = from.time_step;
  return to;
}

}  // namespace

TEST_CASE("Every law through C is the C++ law bit for bit, and its memory is bytes that move") {
  const NamedChoice named = GENERATE(from_range(law_choices()));
  INFO(named.name);
  const ContactLaw law = make_contact_law(named.choice, glass, steel);
  const LawHandle handle(named.choice);
  REQUIRE(handle.handle != nullptr);
  const std::size_t size = 267;  // more than are worked on at a time, and no whole block
  const std::size_t bytes = osculate_memory_size(handle.handle);
  REQUIRE(bytes == law.memory_size() * sizeof(double));
  LawBed bed(law, size);
  OddBytes memory(size * bytes);
  std::vector<OddBytes> single(size, OddBytes(bytes));
  std::mt19937_64 random(29);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int step = 0; step < 5; ++step) {
    for (std::size_t i = 0; i < size; ++i) {
      const Vec3 normal = Vec3(0.01 * step, 0.1 * static_cast<double>(i), 1.0).normalized();
      bed.set(i, {.R_i = 1e-3 * (1.0 + 0.1 * static_cast<double>(i)),
                  .R_j = 1e-3,
                  .overlap = i % 7 == 0 && step % 3 == 2 ? -1e-6 : 1e-6 * (1.0 + 0.5 * uniform(random)),
                  .normal = normal,
                  .major = normal.cross(Vec3(1.0, 0.3, 0.01 * step)).normalized(),
                  .velocity = 0.05 * Vec3(uniform(random), uniform(random), uniform(random)),
                  .angular = 10.0 * Vec3(uniform(random), uniform(random), uniform(random)),
                  .mean_angular = 1e3 * Vec3(uniform(random), uniform(random), uniform(random))});
    }
    bed.evaluate(law);
    const osculate_approach_columns approach = c_input(bed.input());
    ForceColumns forces(size);
    const osculate_force_columns view = forces.view();
    REQUIRE(osculate_evaluate_forces(handle.handle, &approach, memory.data(), &view) == OSCULATE_OK);
    memory.move();
    for (std::size_t i = 0; i < size; ++i) {
      REQUIRE(forces.status[i] == static_cast<int>(bed.status[i]));
      const std::vector<double> expected = numbers_of(bed, i);
      for (std::size_t k = 0; k < expected.size(); ++k) REQUIRE(forces.values[k][i] == expected[k]);
      if (i % 41 != 0) continue;
      const osculate_approach one = approach_at(approach, i);
      osculate_force force;
      REQUIRE(osculate_evaluate_force(handle.handle, &one, single[i].data(), &force) == OSCULATE_OK);
      single[i].move();
      REQUIRE(force.status == forces.status[i]);
      REQUIRE(numbers_of(force) == expected);
    }
  }
}

TEST_CASE("A law tells what it needs") {
  for (const NamedChoice& named : law_choices()) {
    INFO(named.name);
    const ContactLaw law = make_contact_law(named.choice, glass, steel);
    const LawHandle handle(named.choice);
    const int needs = osculate_law_needs(handle.handle);
    CHECK(((needs & OSCULATE_NEEDS_ANGULAR_VELOCITY) != 0) == law.needs().angular_velocity);
    CHECK(((needs & OSCULATE_NEEDS_MEAN_ANGULAR_VELOCITY) != 0) == law.needs().mean_angular_velocity);
    CHECK(((needs & OSCULATE_NEEDS_REDUCED_MASS) != 0) == law.needs().reduced_mass);
    CHECK(((needs & OSCULATE_NEEDS_EFFECTIVE_RADIUS) != 0) == law.needs().effective_radius);
    CHECK(((needs & OSCULATE_MAKES_COUPLES) != 0) == law.makes_couples());
    double range = -1.0;
    REQUIRE(osculate_interaction_range(handle.handle, 2e-3, 1e-3, &range) == OSCULATE_OK);
    CHECK(range == law.interaction_range(2e-3, 1e-3));
  }
}

TEST_CASE("Laws that cannot be are refused with the reason") {
  const osculate_material material{71e9, 0.22}, bad_material{-1.0, 0.22};
  osculate_law* law = nullptr;
  const auto refused = [&](std::vector<osculate_law_setting> settings, const std::string& part) {
    CHECK(osculate_new_law(settings.size(), settings.data(), &material, &material, &law) == OSCULATE_INVALID_INPUT);
    CHECK(law == nullptr);
    CHECK_THAT(osculate_error_message(), Catch::Contains(part));
  };
  refused({}, "normal");
  refused({{"herz", nullptr, 0.0}}, "hertz");
  refused({{"hertz", nullptr, 0.0}, {"mindlin", "frction", 0.3}}, "friction");
  refused({{"hertz", nullptr, 0.0}, {"mindlin", "friction", std::nan("")}}, "friction");
  refused({{"hertz", nullptr, 0.0}, {"mindlin", nullptr, 0.0}}, "friction");
  refused({{"hertz", nullptr, 0.0}, {"mindlin", "friction", 0.3}, {"mindlin", "friction", 0.4}}, "twice");
  refused({{"hertz", nullptr, 0.0}, {"linear", "stiffness", 1e6}}, "normal");
  const osculate_law_setting hertz{"hertz", nullptr, 0.0}, nameless{nullptr, nullptr, 0.0};
  CHECK(osculate_new_law(1, &hertz, &bad_material, &material, &law) == OSCULATE_INVALID_INPUT);
  CHECK(osculate_new_law(1, &nameless, &material, &material, &law) == OSCULATE_NULL_POINTER);
  CHECK(osculate_new_law(1, nullptr, &material, &material, &law) == OSCULATE_NULL_POINTER);
  CHECK(osculate_new_law(1, &hertz, nullptr, &material, &law) == OSCULATE_NULL_POINTER);
  CHECK(osculate_new_law(1, &hertz, &material, &material, nullptr) == OSCULATE_NULL_POINTER);
  CHECK(law == nullptr);
  CHECK(osculate_memory_size(nullptr) == 0);
  osculate_free_law(nullptr);
}

TEST_CASE("A contact with a bad number is named, keeps its memory, and does not keep the others from their forces") {
  const LawHandle law({{"hertz", {}}, {"tsuji", {{"restitution", 0.7}}}, {"mindlin", {{"friction", 0.4}}}});
  const ContactLaw plain = make_contact_law(
      {{"hertz", {}}, {"tsuji", {{"restitution", 0.7}}}, {"mindlin", {{"friction", 0.4}}}}, glass, steel);
  const std::size_t size = 300, bytes = osculate_memory_size(law.handle);
  LawBed bed(plain, size);
  for (std::size_t i = 0; i < size; ++i) bed.set(i, {.velocity = Vec3(0.01, 0.02, -0.01)});
  std::vector<unsigned char> memory(size * bytes, 0);
  ForceColumns forces(size);
  const osculate_force_columns view = forces.view();
  osculate_approach_columns approach = c_input(bed.input());
  REQUIRE(osculate_evaluate_forces(law.handle, &approach, memory.data(), &view) == OSCULATE_OK);
  const std::vector<unsigned char> before = memory;
  bed.set(270, {.overlap = std::nan("")});
  bed.set(280, {.R_j = -1e-3});
  approach = c_input(bed.input());
  CHECK(osculate_evaluate_forces(law.handle, &approach, memory.data(), &view) == OSCULATE_INVALID_INPUT);
  CHECK_THAT(osculate_error_message(), Catch::Contains("contact 270"));
  for (const std::size_t i : {270U, 280U}) {
    CHECK(forces.status[i] == OSCULATE_BAD_NUMBER);
    CHECK(forces.values[2][i] == 0.0);
    CHECK(std::equal(memory.begin() + static_cast<long>(i * bytes), memory.begin() + static_cast<long>((i + 1) * bytes),
                     before.begin() + static_cast<long>(i * bytes)));
  }
  CHECK(forces.status[299] == OSCULATE_CLOSED);
  CHECK(forces.values[2][299] < 0.0);

  const osculate_approach one = approach_at(approach, 270);
  osculate_force force;
  CHECK(osculate_evaluate_force(law.handle, &one, memory.data(), &force) == OSCULATE_INVALID_INPUT);
  CHECK(force.status == OSCULATE_BAD_NUMBER);
  CHECK(numbers_of(force) == std::vector<double>(15, 0.0));
}

TEST_CASE("A gap that was skipped is open and forgets, beside contacts that are closed") {
  const LawChoice choice{{"hertz", {}}, {"mindlin", {{"friction", 0.4}}}};
  const LawHandle law(choice);
  const ContactLaw plain = make_contact_law(choice, glass, steel);
  LawBed bed(plain, 3);
  for (std::size_t i = 0; i < 3; ++i) bed.set(i, {.velocity = Vec3(0.01, 0.02, -0.01)});
  const std::size_t bytes = osculate_memory_size(law.handle);
  std::vector<unsigned char> memory(3 * bytes, 0);
  ForceColumns forces(3);
  const osculate_force_columns view = forces.view();
  osculate_approach_columns approach = c_input(bed.input());
  REQUIRE(osculate_evaluate_forces(law.handle, &approach, memory.data(), &view) == OSCULATE_OK);
  CHECK(std::any_of(memory.begin(), memory.end(), [](unsigned char byte) { return byte != 0; }));
  bed.set(1, {.R_i = 0.0, .R_j = 0.0, .overlap = -1e-4, .major = Vec3::Zero()});
  approach = c_input(bed.input());
  REQUIRE(osculate_evaluate_forces(law.handle, &approach, memory.data(), &view) == OSCULATE_OK);
  CHECK(forces.status == std::vector<std::int32_t>{OSCULATE_CLOSED, OSCULATE_OPEN, OSCULATE_CLOSED});
  CHECK(forces.values[2][1] == 0.0);
  CHECK(forces.values[2][0] == forces.values[2][2]);
  CHECK(std::all_of(memory.begin() + static_cast<long>(bytes), memory.begin() + static_cast<long>(2 * bytes),
                    [](unsigned char byte) { return byte == 0; }));

  SECTION("but a law that acts across gaps must see them") {
    const LawChoice sticky{{"hertz", {}}, {"jkr", {{"work_of_adhesion", 0.5}}}};
    const LawHandle adhesive(sticky);
    std::vector<unsigned char> own(3 * osculate_memory_size(adhesive.handle), 0);
    CHECK(osculate_evaluate_forces(adhesive.handle, &approach, own.data(), &view) == OSCULATE_INVALID_INPUT);
    CHECK(forces.status[1] == OSCULATE_BAD_NUMBER);
  }
}

TEST_CASE("Columns that a law needs and does not get are named") {
  const LawChoice choice{{"hertz", {}},
                         {"tsuji", {{"restitution", 0.7}}},
                         {"mindlin", {{"friction", 0.4}}},
                         {"twisting", {{"friction", 0.3}}}};
  const LawHandle law(choice);
  LawBed bed(make_contact_law(choice, glass, steel), 2);
  for (std::size_t i = 0; i < 2; ++i) bed.set(i, {});
  std::vector<unsigned char> memory(2 * osculate_memory_size(law.handle), 0);
  ForceColumns forces(2);
  osculate_force_columns to = forces.view();
  osculate_approach_columns from = c_input(bed.input());
  const auto refused = [&](int expected, const std::string& part) {
    CHECK(osculate_evaluate_forces(law.handle, &from, memory.data(), &to) == expected);
    CHECK_THAT(osculate_error_message(), Catch::Contains(part));
    CHECK(forces.status == std::vector<std::int32_t>{-1, -1});
  };
  SECTION("masses") {
    from.reduced_mass = nullptr;
    refused(OSCULATE_NULL_POINTER, "reduced_mass");
  }
  SECTION("half a vector") {
    from.velocity[2] = nullptr;
    refused(OSCULATE_NULL_POINTER, "velocity");
  }
  SECTION("a whole vector") {
    from.angular_velocity[0] = from.angular_velocity[1] = from.angular_velocity[2] = nullptr;
    refused(OSCULATE_NULL_POINTER, "angular_velocity");
  }
  SECTION("couples") {
    to.couple[0] = to.couple[1] = to.couple[2] = nullptr;
    refused(OSCULATE_NULL_POINTER, "couple");
  }
  SECTION("the time step") {
    from.time_step = std::nan("");
    refused(OSCULATE_INVALID_INPUT, "time step");
  }
  SECTION("memory") {
    CHECK(osculate_evaluate_forces(law.handle, &from, nullptr, &to) == OSCULATE_NULL_POINTER);
    CHECK_THAT(osculate_error_message(), Catch::Contains("memory"));
  }
  SECTION("anything at all") {
    CHECK(osculate_evaluate_forces(nullptr, &from, memory.data(), &to) == OSCULATE_NULL_POINTER);
    CHECK(osculate_evaluate_forces(law.handle, nullptr, memory.data(), &to) == OSCULATE_NULL_POINTER);
    CHECK(osculate_evaluate_forces(law.handle, &from, memory.data(), nullptr) == OSCULATE_NULL_POINTER);
    CHECK(osculate_evaluate_force(law.handle, nullptr, memory.data(), nullptr) == OSCULATE_NULL_POINTER);
  }
}
