#include "validation/chung_ooi2011/impact_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "osculate/mechanics/damped_hertz.hpp"
#include "osculate/mechanics/impact.hpp"
#include "validation/chung_ooi2011/collision.hpp"

namespace osculate::validation {
namespace {

// A thousand steps an impact: velocity Verlet's error is of the order of 1e-6, sampling a maximum finds it to 1e-5, and
// touch and parting are each known to a step.
constexpr double of_integration = 1e-4;
constexpr double of_duration = 2e-3;
// The dashpot's force jumps to its value within the step of touch: a thousandth of the impulse at most.
constexpr double of_slip = 1e-3;

Material material(const char* name, double modulus, double poisson, double density) {
  return {.name = name, .elastic = {.youngs_modulus = modulus, .poissons_ratio = poisson}, .density = density};
}

const Material glass = material("glass", 48e9, 0.20, 2800.0);
const Material limestone = material("limestone", 20e9, 0.25, 2500.0);
const Material aluminium_2 = material("aluminium alloy", 70e9, 0.30, 2699.0);
const Material magnesium = material("magnesium alloy", 40e9, 0.35, 1800.0);
const Material alumina = material("aluminium oxide", 380e9, 0.23, 4000.0);
const Material cast_iron = material("cast iron", 100e9, 0.25, 7000.0);
const Material aluminium = material("aluminium alloy", 70e9, 0.33, 2700.0);
const Material steel = material("steel", 208e9, 0.30, 7850.0);
const Material polyethylene = material("polyethylene", 1e9, 0.40, 1400.0);
const Material copper = material("copper", 120e9, 0.35, 8900.0);
const Material nylon = material("nylon", 2.5e9, 0.40, 1000.0);

/// As stiff as the tests have their planes.
Material rigid(Material of) {
  of.name = "plane";
  of.elastic.youngs_modulus *= 1000.0;
  return of;
}

LawChoice normal_law(double restitution) {
  LawChoice choice{{"hertz", {}}};
  if (restitution < 1.0) choice.push_back({"tsuji", {{"restitution", restitution}}});
  return choice;
}

using Rows = std::vector<ImpactRow>;

// Member by member: g++ 12 warns of names that are not initialised where an aggregate's other members may throw.
Ball ball_of(double radius, const Material& material, const Vec3& velocity) {
  Ball ball{};
  ball.radius = radius;
  ball.material = material;
  ball.velocity = velocity;
  return ball;
}
Collision on_plane(const Ball& ball, const Material& plane) {
  Collision collision{};
  collision.ball_1 = ball;
  collision.plane = plane;
  return collision;
}
Collision of_balls(const Ball& ball_1, const Ball& ball_2) {
  Collision collision{};
  collision.ball_1 = ball_1;
  collision.ball_2 = ball_2;
  return collision;
}

/// Tests 1 and 2.
void elastic_impact(Rows& rows, int test, Collision collision) {
  collision.law = normal_law(1.0);
  const CollisionPair pair = pair_of(collision);
  const ImpactPair hertz{.mass = pair.reduced_mass, .radius = pair.radius, .modulus = pair.modulus};
  const Impact expected = hertz_impact::impact(hertz, pair.speed);
  const Outcome outcome = collide(collision);
  const std::string of = collision.ball_1.material.name, at = fmt::format("{:g} m/s", pair.speed);
  const double force = hertz.hertz_coefficient() * std::pow(expected.largest_overlap, 1.5);
  rows.push_back({test, of, at, "largest force [kN]", 1e-3 * force, 1e-3 * outcome.largest_force, of_integration});
  rows.push_back({test, of, at, "largest overlap [µm]", 1e6 * expected.largest_overlap, 1e6 * outcome.largest_overlap,
                  of_integration});
  rows.push_back({test, of, at, "duration [µs]", 1e6 * expected.duration, 1e6 * outcome.duration, of_duration});
  rows.push_back(
      {test, of, at, "speed after [m/s]", -collision.ball_1.velocity.x(), outcome.velocity_1.x(), of_integration});
}

void restitution(Rows& rows, const Material& of, double wanted) {
  constexpr double speed = 3.9;
  Collision collision = on_plane(ball_of(2.5e-3, of, {speed, 0.0, 0.0}), rigid(of));
  collision.law = normal_law(wanted);
  const Outcome outcome = collide(collision);
  rows.push_back({3, of.name, fmt::format("ε = {:g}", wanted), "restitution", wanted, -outcome.velocity_1.x() / speed,
                  2e-3});  // the dashpot acts within a step of touch and of parting
}

/// The impulse of the elastic part of Tsuji's force over that of the whole. The contact is a linear oscillator in
/// z = δ^{5/4}; its force falls to zero at z = c ε v/k, up to where the dashpot's impulse is ∫ c δ^{1/4} dδ = 4/5 c z.
/// From there the bodies part freely at ε v, while the elastic part goes on for ∫ k δ^{3/2} dδ/(ε v) = 2/5 c z.
double elastic_share(double restitution) {
  const double factor = damped_hertz::tsuji_factor(restitution, Attraction::cut_off);
  return 1.0 - 0.4 * factor * factor * restitution / (1.0 + restitution);
}

enum class Law {
  sliding,  ///< Coulomb's force from the first touch
  mindlin,  ///< sticks until its springs have come up to μF_n, which a dashpot makes large while they are still soft;
            ///< at the least they take the elastic force's share
};

struct Slip {
  double restitution;
  double friction;
  Law law;
};

struct SlipOutcome {
  double tangential_1;  ///< velocity of ball 1 along y
  double spin_1;        ///< about z
};

/// Slip from touch to parting: the impulse along the plane is µ times that across it, and acts at the arm R.
SlipOutcome after_slip(const Collision& collision, const Slip& slip) {
  const CollisionPair pair = pair_of(collision);
  const Ball& ball = collision.ball_1;
  // Ball 1's surface against the other's, where they touch.
  double surface = ball.velocity.y() + ball.radius * ball.angular_velocity.z();
  if (collision.ball_2) {
    surface -= collision.ball_2->velocity.y() - collision.ball_2->radius * collision.ball_2->angular_velocity.z();
  }
  const double impulse =
      -std::copysign(slip.friction * (1.0 + slip.restitution) * pair.reduced_mass * pair.speed, surface);
  const double inertia = 0.4 * pair.mass_1 * ball.radius * ball.radius;
  return {ball.velocity.y() + impulse / pair.mass_1, ball.angular_velocity.z() + ball.radius * impulse / inertia};
}

void slipping(Rows& rows, int test, const std::string& condition, Collision collision, const Slip& slip) {
  const char* const friction = slip.law == Law::sliding ? "sliding" : "mindlin";
  collision.law = normal_law(slip.restitution);
  collision.law.push_back({friction, {{"friction", slip.friction}}});
  const SlipOutcome expected = after_slip(collision, slip);
  const Outcome outcome = collide(collision);
  // The engine's arm ends in the middle of the overlap and is shorter than R by half of it at most.
  const Ball& ball = collision.ball_1;
  const CollisionPair pair = pair_of(collision);
  const double deepest =
      hertz_impact::impact({pair.reduced_mass, pair.radius, pair.modulus}, pair.speed).largest_overlap;
  const double sticking = slip.law == Law::sliding ? 0.0 : 1.0 - elastic_share(slip.restitution);
  const auto share_of_change = [](double before, double after) { return std::fabs((after - before) / after); };
  const double of_velocity = sticking * share_of_change(ball.velocity.y(), expected.tangential_1);
  const double of_spin =
      (sticking + 0.5 * deepest / ball.radius) * share_of_change(ball.angular_velocity.z(), expected.spin_1);
  const std::string where = fmt::format("{}, {}", condition, friction);
  rows.push_back({test, ball.material.name, where, "tangential velocity [m/s]", expected.tangential_1,
                  outcome.velocity_1.y(), of_slip + of_velocity});
  rows.push_back({test, ball.material.name, where, "angular velocity [rad/s]", expected.spin_1,
                  outcome.angular_velocity_1.z(), of_slip + of_spin});
}

}  // namespace

const std::vector<std::string>& impact_test_titles() {
  static const std::vector<std::string> titles{
      "Elastic normal impact of two equal spheres, R = 10 mm",
      "Elastic normal impact of a sphere on a rigid plane, R = 100 mm",
      "Normal impact at 3.9 m/s with a restitution, R = 2.5 mm, on a rigid plane",
      "Oblique impact at 3.9 m/s under various angles, R = 2.5 mm, µ = 0.092, ε = 0.98, on a rigid plane",
      "Oblique impact, 5 m/s across and various speeds along the plane, R = 10 µm, µ = 0.3, ε = 1",
      "Spinning sphere at 0.2 m/s on a rigid plane, R = 100 mm, µ = 0.4, ε = 0.5",
      "Two equal spinning spheres at ±0.2 m/s, R = 100 mm, µ = 0.4, ε = 0.5",
      "Spinning sphere at 0.2 m/s on one of five times its radius and a thousand times its density, µ = 0.4, ε = 0.5"};
  return titles;
}

std::vector<ImpactRow> impact_tests() {
  Rows rows;
  for (const Material& of : {glass, limestone}) {
    elastic_impact(rows, 1, of_balls(ball_of(10e-3, of, {10.0, 0.0, 0.0}), ball_of(10e-3, of, {-10.0, 0.0, 0.0})));
  }
  for (const Material& of : {aluminium_2, magnesium}) {
    elastic_impact(rows, 2, on_plane(ball_of(0.1, of, {0.2, 0.0, 0.0}), rigid(of)));
  }
  for (const Material& of : {alumina, cast_iron}) {
    for (const double wanted : {0.2, 0.4, 0.6, 0.8, 1.0}) restitution(rows, of, wanted);
  }
  for (const Material& of : {alumina, aluminium}) {
    for (const double degrees : {40.0, 50.0, 60.0, 70.0, 80.0}) {
      const double angle = degrees * std::numbers::pi / 180.0;
      slipping(rows, 4, fmt::format("incidence {:g}°", degrees),
               on_plane(ball_of(2.5e-3, of, 3.9 * Vec3(std::cos(angle), std::sin(angle), 0.0)), rigid(of)),
               {.restitution = 0.98, .friction = 0.092, .law = Law::mindlin});
    }
  }
  for (const Material& of : {steel, polyethylene}) {
    for (const double along : {15.0, 20.0, 30.0, 70.0}) {
      slipping(rows, 5, fmt::format("{:g} m/s along", along), on_plane(ball_of(10e-6, of, {5.0, along, 0.0}), of),
               {.restitution = 1.0, .friction = 0.3, .law = Law::mindlin});
    }
  }
  for (const Law law : {Law::sliding, Law::mindlin}) {
    const Slip slip{.restitution = 0.5, .friction = 0.4, .law = law};
    const auto spinning = [](const Material& of, double spin) {
      Ball ball = ball_of(0.1, of, {0.2, 0.0, 0.0});
      ball.angular_velocity = {0.0, 0.0, spin};
      return ball;
    };
    for (const Material& of : {aluminium, nylon}) {
      for (const double spin : {5.0, 21.0}) {
        const std::string condition = fmt::format("{:g} rad/s", spin);
        slipping(rows, 6, condition, on_plane(spinning(of, spin), rigid(of)), slip);
        Ball heavy = ball_of(0.5, of, Vec3::Zero());
        heavy.material.density *= 1000.0;
        slipping(rows, 8, condition, of_balls(spinning(of, spin), heavy), slip);
      }
    }
    for (const Material& of : {aluminium, copper}) {
      for (const double spin : {5.0, 22.0}) {
        Ball other = spinning(of, spin);
        other.velocity.x() = -0.2;
        slipping(rows, 7, fmt::format("{:g} rad/s both", spin), of_balls(spinning(of, spin), other), slip);
      }
    }
  }
  std::ranges::stable_sort(rows, {}, &ImpactRow::test);
  return rows;
}

}  // namespace osculate::validation
