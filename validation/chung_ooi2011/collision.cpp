#include "validation/chung_ooi2011/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "osculate/core/error.hpp"
#include "osculate/dynamics/simulation.hpp"
#include "osculate/mechanics/impact.hpp"

namespace osculate::validation {
namespace {

double mass_of(const Ball& ball) {
  return 4.0 / 3.0 * std::numbers::pi * std::pow(ball.radius, 3) * ball.material.density;
}

const Material& other_material(const Collision& collision) {
  return collision.ball_2 ? collision.ball_2->material : collision.plane;
}

BodyStart start_of(const Ball& ball, std::int32_t index, double x) {
  return {.shape = index,
          .material = index,
          .pose = {.position = {x, 0.0, 0.0}, .orientation = Quat::Identity()},
          .velocity = ball.velocity,
          .angular_velocity = ball.angular_velocity};
}

Setup setup_of(const Collision& collision, double time_step, double gap) {
  const Ball& ball = collision.ball_1;
  Setup setup;
  setup.materials = {ball.material, other_material(collision)};
  setup.materials[1].density = std::max(setup.materials[1].density, 1.0);  // a plane's does not matter
  setup.interactions.push_back(
      {0, 1, make_contact_law(collision.law, setup.materials[0].elastic, setup.materials[1].elastic)});
  setup.shapes = {Sphere{ball.radius}};
  setup.motions = {Fixed{}};
  setup.time_step = time_step;
  setup.bodies = {start_of(ball, 0, -ball.radius - gap)};
  if (collision.ball_2) {
    setup.shapes.emplace_back(Sphere{collision.ball_2->radius});
    setup.bodies.push_back(start_of(*collision.ball_2, 1, collision.ball_2->radius));
  } else {
    setup.shapes.emplace_back(HalfSpace{});
    BodyStart plane{.shape = 1, .material = 1, .motion = 0, .pose = {}};
    plane.pose.orientation = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(-Vec3::UnitX()));
    setup.bodies.push_back(plane);
  }
  return setup;
}

}  // namespace

CollisionPair pair_of(const Collision& collision) {
  const Ball& ball = collision.ball_1;
  CollisionPair pair{.mass_1 = mass_of(ball),
                     .mass_2 = std::numeric_limits<double>::infinity(),
                     .reduced_mass = mass_of(ball),
                     .radius = ball.radius,
                     .modulus = effective_modulus(ball.material.elastic, other_material(collision).elastic),
                     .speed = ball.velocity.x()};
  if (collision.ball_2) {
    const Ball& other = *collision.ball_2;
    pair.mass_2 = mass_of(other);
    pair.reduced_mass = pair.mass_1 * pair.mass_2 / (pair.mass_1 + pair.mass_2);
    pair.radius = ball.radius * other.radius / (ball.radius + other.radius);
    pair.speed -= other.velocity.x();
  }
  if (!(pair.speed > 0.0)) throw InputError("collision", "two that do not approach each other", "a positive speed");
  return pair;
}

Outcome collide(const Collision& collision) {
  const CollisionPair pair = pair_of(collision);
  const Impact elastic =
      hertz_impact::impact({.mass = pair.reduced_mass, .radius = pair.radius, .modulus = pair.modulus}, pair.speed);
  const double time_step = elastic.duration / collision.steps;
  constexpr double steps_before = 2.5;
  Simulation simulation(setup_of(collision, time_step, steps_before * pair.speed * time_step));
  Outcome outcome{};
  outcome.time_step = time_step;
  // Damping makes an impact longer, by far when it takes almost all.
  const int most = 20 * collision.steps;
  int touching = 0;
  for (int i = 0; i < most; ++i) {
    simulation.advance(1);
    const std::vector<Contact> contacts = simulation.contacts();
    if (contacts.empty()) {
      if (touching == 0) continue;
      outcome.duration = touching * time_step;
      const Bodies& bodies = simulation.bodies();
      outcome.velocity_1 = bodies.velocity[0];
      outcome.angular_velocity_1 = bodies.angular_velocity(0);
      outcome.velocity_2 = bodies.velocity[1];
      outcome.angular_velocity_2 = bodies.angular_velocity(1);
      return outcome;
    }
    ++touching;
    outcome.largest_overlap = std::max(outcome.largest_overlap, contacts[0].overlap);
    outcome.largest_force = std::max(outcome.largest_force, std::fabs(contacts[0].force.x()));
  }
  throw std::runtime_error("a simulated impact did not end");
}

}  // namespace osculate::validation
