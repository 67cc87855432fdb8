// What must hold for every law of the registry, composed.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include "mechanics/law_bed.hpp"
#include "mechanics/law_choices.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"

using namespace osculate;

namespace {

/// Two bodies with constant radii of relative curvature whose centres are a diameter apart when they touch: a sphere's
/// motion with an ellipse's contact.
struct Collision {
  static constexpr double radius = 1e-3, density = 2500.0;
  static constexpr double mass = 4.0 / 3.0 * M_PI * radius * radius * radius * density;
  static constexpr double inertia = 0.4 * mass * radius * radius;

  Vec3 x_1{0, 0, -radius}, x_2{0, 0, radius}, v_1{0, 0, 0}, v_2{0, 0, 0}, w_1{0, 0, 0}, w_2{0, 0, 0};
  Vec3 major{1, 0, 0};
  double viscous = 0.0, friction = 0.0, hysteresis = 0.0, largest_force = 0.0;

  double kinetic() const {
    return 0.5 * mass * (v_1.squaredNorm() + v_2.squaredNorm()) +
           0.5 * inertia * (w_1.squaredNorm() + w_2.squaredNorm());
  }
  double overlap() const { return 2.0 * radius - (x_2 - x_1).norm(); }

  /// Velocity Verlet from just before the touch until the bodies are apart again.
  void run(const ContactLaw& law, double step, double range) {
    LawBed bed(law, 1);
    bed.time_step = step;
    Vec3 force = Vec3::Zero(), torque_1 = force, torque_2 = force;
    const auto kick = [&] {
      v_1 += 0.5 * step / mass * force, v_2 -= 0.5 * step / mass * force;
      w_1 += 0.5 * step / inertia * torque_1, w_2 += 0.5 * step / inertia * torque_2;
    };
    for (int k = 0; k < 200000; ++k) {
      kick();
      x_1 += step * v_1, x_2 += step * v_2;
      const Vec3 normal = (x_2 - x_1).normalized();
      major = (major - major.dot(normal) * normal).normalized();
      const double arm = radius - 0.5 * overlap();
      const Vec3 arm_1 = arm * normal, arm_2 = -arm * normal;
      bed.set(0, {.R_i = 0.75e-3,
                  .R_j = 0.5e-3,
                  .overlap = overlap(),
                  .normal = normal,
                  .major = major,
                  .velocity = v_2 + w_2.cross(arm_2) - v_1 - w_1.cross(arm_1),
                  .angular = w_2 - w_1,
                  .mean_angular = 0.5 * (w_1 + w_2),
                  .reduced_mass = 0.5 * mass,
                  .effective_radius = 0.5 * radius});
      bed.evaluate(law);
      REQUIRE(bed.status[0] != LawStatus::bad_input);
      REQUIRE(bed.status[0] != LawStatus::not_converged);
      force = bed.force(0);
      torque_1 = arm_1.cross(force) + bed.couple(0);
      torque_2 = arm_2.cross(-force) - bed.couple(0);
      kick();
      viscous += bed.viscous_loss[0], friction += bed.friction_loss[0], hysteresis += bed.hysteresis_loss[0];
      largest_force = std::max(largest_force, force.norm());
      if (overlap() < -range && (v_2 - v_1).dot(normal) > 0.0) {
        CHECK(bed.status[0] == LawStatus::open);
        for (const double entry : bed.memory) CHECK(entry == 0.0);
        return;
      }
    }
    FAIL("the bodies never part");
  }
};

Collision oblique() {
  Collision pair;
  pair.v_1 = {0.3, -0.1, 0.5}, pair.v_2 = {-0.2, 0.1, -0.5};
  pair.w_1 = {50, 100, 300}, pair.w_2 = {-100, 200, -250};
  return pair;
}

}  // namespace

TEST_CASE("The choices of these tests hold every law of the registry") {
  std::set<std::string_view> used;
  for (const NamedChoice& one : law_choices())
    for (const ChosenLaw& law : one.choice) used.insert(law_named(law.name).name);
  for (const LawDescription* law : law_registry()) {
    INFO(law->name);
    CHECK(used.contains(law->name));
  }
}

TEST_CASE("What a collision loses of its motion is what the law's ledger says, for every law") {
  for (const NamedChoice& one : law_choices()) {
    INFO(one.name);
    const ContactLaw law = make_contact_law(one.choice, glass, glass);
    const double range = law.interaction_range(0.75e-3, 0.5e-3);
    const auto error = [&](double step) {
      Collision pair = oblique();
      const double before = pair.kinetic();
      pair.run(law, step, range);
      const double lost = before - pair.kinetic(), booked = pair.viscous + pair.friction + pair.hysteresis;
      CHECK(pair.largest_force > 1.0);
      CHECK(lost > -1e-3 * before);
      return std::fabs(lost - booked) / before;
    };
    // The motion is of second order in the step; the ledger of a force that follows the velocity is of first.
    const double coarse = error(4e-8), fine = error(1e-8);
    CHECK(coarse < 1e-2);
    CHECK(fine < std::max(0.3 * coarse, 2e-5));
  }
}

TEST_CASE("A frictionless elastic collision gives the motion back") {
  const ContactLaw law = make_contact_law({{"hertz", {}}}, glass, glass);
  Collision pair = oblique();
  const double before = pair.kinetic();
  pair.run(law, 1e-8, 0.0);
  CHECK(pair.kinetic() == Approx(before).epsilon(1e-6));
  CHECK(pair.viscous + pair.friction + pair.hysteresis == 0.0);
}

TEST_CASE("Restitution asked for is restitution found") {
  const std::string law = GENERATE("tsuji", "linear_dashpot");
  const ChosenLaw spring = law == "tsuji" ? ChosenLaw{"hertz", {}} : ChosenLaw{"linear", {{"stiffness", 1e6}}};
  const ContactLaw composed = make_contact_law({spring, {law, {{"restitution", 0.6}}}}, glass, glass);
  Collision pair;
  pair.v_1 = {0, 0, 0.5}, pair.v_2 = {0, 0, -0.5};
  pair.run(composed, 1e-8, 0.0);
  CHECK((pair.v_2 - pair.v_1).norm() == Approx(0.6).epsilon(1e-3));  // second order in a step of duration/1000
}

namespace {

/// Slip, approach and turning that change at random times; the plane turns with the bodies' mean rotation.
class RandomPath {
 public:
  explicit RandomPath(std::uint64_t seed) : random_(seed) {
    row_.overlap = 1e-6 * (0.2 + uniform());
    row_.R_i = row_.R_j * (1.0 + 9.0 * uniform() * uniform());
    change();
  }
  LawRow next(double step) {
    if (uniform() < 0.05) change();
    if (row_.overlap > 1.5e-6) rate_ = -std::fabs(rate_);
    if (row_.overlap < 1e-7) rate_ = std::fabs(rate_);
    const Eigen::AngleAxisd turn(step * row_.mean_angular.norm(), row_.mean_angular.normalized());
    row_.normal = (turn * row_.normal).normalized();
    row_.major = turn * row_.major;
    row_.major = (row_.major - row_.major.dot(row_.normal) * row_.normal).normalized();
    slip_ = turn * slip_;
    row_.velocity = slip_ - slip_.dot(row_.normal) * row_.normal - rate_ * row_.normal;
    row_.overlap += rate_ * step;
    return row_;
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  Vec3 direction() { return {2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0}; }
  void change() {
    rate_ = 0.04 * uniform() - 0.02;
    slip_ = 0.02 * direction();
    row_.angular = 30.0 * direction();
    row_.mean_angular = 300.0 * direction();
  }

  std::mt19937_64 random_;
  double rate_ = 0.0;
  Vec3 slip_ = Vec3::Zero();
  LawRow row_{};
};

bool holds(const LawChoice& choice, std::string_view name) {
  return std::ranges::any_of(choice, [&](const ChosenLaw& law) { return law.name == name; });
}

/// What μ multiplies at least: adhesive contacts are held together by more than their load.
double held_by_adhesion(const LawChoice& choice, const LawRow& row) {
  const double pull = M_PI * std::sqrt(row.R_i * row.R_j) * 0.5;
  return holds(choice, "jkr") ? 3.0 * pull : holds(choice, "dmt") ? 2.0 * pull : 0.0;
}

}  // namespace

TEST_CASE("On random paths friction stays within what the load allows and no energy is created, for every law") {
  constexpr double friction = 0.3, rounding = 1e-12;
  constexpr std::size_t paths = 40;
  constexpr int steps = 600;
  for (const NamedChoice& one : law_choices()) {
    INFO(one.name);
    const ContactLaw law = make_contact_law(one.choice, glass, glass);
    LawBed bed(law, paths);
    bed.time_step = 2e-7;
    std::vector<RandomPath> path;
    for (std::size_t i = 0; i < paths; ++i) path.emplace_back(i);
    std::vector<double> lost(paths, 0.0), taken(paths, 0.0);
    double excess = 0.0, excess_moment = 0.0;
    for (int step = 0; step < steps; ++step) {
      std::vector<LawRow> rows(paths);
      for (std::size_t i = 0; i < paths; ++i) bed.set(i, rows[i] = path[i].next(bed.time_step));
      bed.evaluate(law);
      for (std::size_t i = 0; i < paths; ++i) {
        REQUIRE(bed.status[i] != LawStatus::bad_input);
        const Vec3 force = bed.force(i), normal = rows[i].normal;
        const double sliding = (force - force.dot(normal) * normal).norm();
        const double limit = friction * std::max(bed.normal_force[i] + held_by_adhesion(one.choice, rows[i]), 0.0);
        if (!holds(one.choice, "viscous")) excess = std::max(excess, sliding - limit * (1.0 + rounding) - 1e-9);
        // Spinning in place takes 3/8 μ F_n a_c E, the most that friction can give about the normal.
        const double arm = 0.375 * bed.a_c[i] * complete_elliptic(bed.axis_ratio[i] * bed.axis_ratio[i]).E;
        excess_moment = std::max(excess_moment, bed.couple(i).norm() - limit * arm * (1.0 + rounding) - 1e-13);
        const double loss = bed.viscous_loss[i] + bed.friction_loss[i] + bed.hysteresis_loss[i];
        lost[i] += loss;
        taken[i] += std::fabs(loss);
        if (one.conserves) CHECK(lost[i] >= -1e-3 * taken[i]);  // the trapezoidal rule's error where the path turns
      }
    }
    CHECK(excess <= 0.0);
    CHECK(excess_moment <= 0.0);
    CHECK(*std::ranges::min_element(taken) >= 0.0);
  }
}

namespace {

struct Excess {
  double friction = 0.0;  ///< of |F_t| over μF_n [N]
  double energy = 0.0;    ///< won from friction, over what the normal force stores
};

Excess excess_of_partial_slip(const LawChoice& dashpot, std::size_t paths, double time_step, int steps) {
  constexpr double friction = 0.3;
  LawChoice choice{{"hertz", {}}, {"mindlin", {{"friction", friction}}}};
  choice.insert(choice.end(), dashpot.begin(), dashpot.end());
  const ContactLaw law = make_contact_law(choice, glass, steel);
  LawBed bed(law, paths);
  bed.time_step = time_step;
  std::vector<RandomPath> path;
  for (std::size_t i = 0; i < paths; ++i) path.emplace_back(i);
  std::vector<double> lost(paths, 0.0);
  Excess excess;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < paths; ++i) bed.set(i, path[i].next(bed.time_step));
    bed.evaluate(law);
    for (std::size_t i = 0; i < paths; ++i) {
      // Half the digits: the normal part is taken off the square.
      const double sliding = std::sqrt(std::max(bed.force(i).squaredNorm() - std::pow(bed.normal_force[i], 2), 0.0));
      const double rounding = 1e-6 * bed.force(i).norm();
      excess.friction = std::max(excess.friction, sliding - friction * bed.normal_force[i] - rounding);
      lost[i] += bed.friction_loss[i];
      excess.energy = std::max(excess.energy, -lost[i] / bed.stored_normal[i]);
    }
  }
  return excess;
}

constexpr double coarse_step = 5e-7;  // up to a thirtieth of the sliding displacement

}  // namespace

TEST_CASE("A hundred thousand random paths in partial slip stay within μF_n and create no energy") {
  const Excess excess = excess_of_partial_slip({}, 100000, coarse_step, 40);
  CHECK(excess.friction <= 0.0);
  CHECK(excess.energy <= 1e-6);  // the trapezoidal rule's
}

TEST_CASE("A hundred thousand random paths stay within what a dashpot leaves of the load") {
  const ChosenLaw dashpot =
      GENERATE(ChosenLaw{"tsuji", {{"restitution", 0.3}}}, ChosenLaw{"brilliantov", {{"dissipative_time", 1e-5}}});
  INFO(dashpot.name);
  CHECK(excess_of_partial_slip({dashpot}, 100000, coarse_step, 40).friction <= 0.0);
}

TEST_CASE("Where a dashpot takes the whole load at once, the energy won is the trapezoidal rule's") {
  const ChosenLaw dashpot{"brilliantov", {{"dissipative_time", 3e-5}}};
  const double coarse = excess_of_partial_slip({dashpot}, 20000, coarse_step, 40).energy;
  const double fine = excess_of_partial_slip({dashpot}, 20000, coarse_step / 5.0, 200).energy;
  CHECK(coarse < 1e-2);
  CHECK(fine <= 0.1 * coarse);  // second order would be 0.04; the paths are not the same
}

TEST_CASE("Turning everything together turns the answer, for every law") {
  constexpr std::size_t paths = 5;
  const Vec3 rotation(700.0, -300.0, 500.0);  // [rad/s]
  for (const NamedChoice& one : law_choices()) {
    INFO(one.name);
    const ContactLaw law = make_contact_law(one.choice, glass, glass);
    // The rotation of a step is 0.9 mrad and its cube what the spin leaves out: 1e-10 a step, 200 steps. Langston's
    // dashpot is a fourth root of what is left to full slip, and magnifies.
    const double tolerance = holds(one.choice, "langston") ? 3e-5 : 3e-7;
    LawBed still(law, paths), turning(law, paths);
    still.time_step = turning.time_step = 1e-6;
    std::vector<RandomPath> path;
    for (std::size_t i = 0; i < paths; ++i) path.emplace_back(100 + i);
    Quat turned = Quat::Identity();
    for (int step = 0; step < 200; ++step) {
      const Eigen::AngleAxisd half(0.5 * still.time_step * rotation.norm(), rotation.normalized());
      const Quat midway = half * turned;
      turned = half * midway;
      for (std::size_t i = 0; i < paths; ++i) {
        LawRow row = path[i].next(still.time_step);
        still.set(i, row);
        for (Vec3* vector : {&row.normal, &row.major, &row.velocity, &row.angular}) *vector = turned * *vector;
        row.mean_angular = midway * row.mean_angular + rotation;
        turning.set(i, row);
      }
      still.evaluate(law), turning.evaluate(law);
      for (std::size_t i = 0; i < paths; ++i) {
        CHECK((turned * still.force(i) - turning.force(i)).norm() <= tolerance * still.normal_force[i] + 1e-9);
        CHECK((turned * still.couple(i) - turning.couple(i)).norm() <= 1e-9 * still.couple(i).norm() + 1e-15);
      }
    }
  }
}
