// Forces of creepage between bodies that roll on each other.

#include <array>
#include <cmath>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "osculate/mechanics/vermeulen_johnson.hpp"

namespace osculate::laws {
namespace {

constexpr std::array vermeulen_johnson_parameters{friction_parameter};
constexpr std::array conflicts{
    LawConflict{"tangential", "a rolling law is the friction of the contact, from creepage instead of displacement"}};

/// How the contact rolls: the patch's speed over the bodies, its direction in the contact plane, creepage times speed.
struct Rolling {
  double speed;
  TangentVector direction;
  kalker::Creepage slip;
};

/// The patch moves over the bodies as their normals turn, s = K^{-1} (n × (ω_1 − ω_2)) with K the relative curvature.
/// The creepage's own share of s (bodies of different curvature that slip) is of second order and left out.
Rolling rolling_of(const Contact& contact) {
  const Vec3 turn = -contact.normal.cross(contact.angular_velocity);
  const TangentVector way{contact.R_i * turn.dot(contact.major), contact.R_j * turn.dot(contact.minor)};
  const double speed = norm(way);
  const TangentVector x = speed > 0.0 ? (1.0 / speed) * way : TangentVector{1.0, 0.0};
  const TangentVector y{-x.y, x.x};
  return {speed,
          x,
          {.longitudinal = -dot(contact.velocity, x),
           .lateral = -dot(contact.velocity, y),
           .spin = -contact.angular_velocity.dot(contact.normal)}};
}

kalker::Creepage over(const kalker::Creepage& slip, double speed) {
  return {slip.longitudinal / speed, slip.lateral / speed, slip.spin / speed};
}

void act(Contact& contact, const Rolling& rolling, const kalker::Force& force) {
  const TangentVector y{-rolling.direction.y, rolling.direction.x};
  contact.force = contact.force + force.longitudinal * rolling.direction + force.lateral * y;
  contact.couple += force.moment * contact.normal;
  contact.friction_loss +=
      (dot(contact.force, contact.velocity) + force.moment * contact.angular_velocity.dot(contact.normal)) *
      contact.time_step;
}

/// What both laws know of a pair of materials.
struct Pair {
  kalker::Composite composite;
  kalker::Table table;
};

Pair pair_of(const Binding& binding) {
  const auto composite = kalker::composite(binding.material_1, binding.material_2);
  return {composite, kalker::table(composite.poissons_ratio)};
}

kalker::Coefficients coefficients_of(const Pair& pair, const Contact& contact, const Rolling& rolling) {
  const double angle = std::atan2(rolling.direction.y, rolling.direction.x);
  return kalker::coefficients(pair.table, kalker::axes_along_rolling(contact.axis_ratio, angle));
}

Part bind_kalker(const Binding& binding) {
  const auto step = [pair = pair_of(binding)](Contact& contact, Memory) {
    if (!contact.closed || !(contact.a_c > 0.0)) return;
    const Rolling rolling = rolling_of(contact);
    if (!(rolling.speed > 0.0)) return;
    act(contact, rolling,
        kalker::linear_force(coefficients_of(pair, contact, rolling), pair.composite.shear_modulus, contact.a_c,
                             contact.a_c * contact.axis_ratio, over(rolling.slip, rolling.speed)));
  };
  return {.step = step, .needs = {.angular_velocity = true}, .makes_couples = true};
}

/// Beyond this share of slip in the rolling the contact slides.
constexpr double slowest_rolling = 1e-9;

Part bind_vermeulen_johnson(const Binding& binding) {
  const auto step = [pair = pair_of(binding), friction = binding["friction"]](Contact& contact, Memory) {
    const double load = friction_load(contact);
    if (!contact.closed || !(contact.a_c > 0.0) || !(friction * load > 0.0)) return;
    const Rolling rolling = rolling_of(contact);
    const double slip = norm(contact.velocity);
    if (!(rolling.speed > slowest_rolling * slip)) {
      if (slip > 0.0) {
        contact.force = (friction * load / slip) * contact.velocity;
        contact.friction_loss += dot(contact.force, contact.displacement());
      }
      return;
    }
    const auto patch = vermeulen_johnson::contact(coefficients_of(pair, contact, rolling), pair.composite.shear_modulus,
                                                  contact.a_c, contact.a_c * contact.axis_ratio, friction, load);
    act(contact, rolling, vermeulen_johnson::force(patch, over(rolling.slip, rolling.speed)));
  };
  return {.step = step, .needs = {.angular_velocity = true}, .makes_couples = true};
}

}  // namespace

const Law vermeulen_johnson{{.name = "vermeulen_johnson",
                             .slot = LawSlot::rolling,
                             .title = "Creep forces from small creepage to sliding, with Kalker's coefficients",
                             .formula = "|F| = μ F_n [1 − (1 − τ)³], τ = |F_linear|/(3 μ F_n)",
                             .equations = "(92),(93)",
                             .source = "VJ64, SHE83, Kalker90",
                             .parameters = vermeulen_johnson_parameters,
                             .memory = 0,
                             .conflicts = conflicts},
                            bind_vermeulen_johnson};

const Law kalker{
    {.name = "kalker",
     .slot = LawSlot::rolling,
     .title = "Linear creep forces without slip: small creepage only, and none at rest",
     .formula = "F_x = −c² G C11 ξ_x, F_y = −c² G C22 ξ_y − c³ G C23 ξ_sp, M = c³ G C23 ξ_y − c⁴ G C33 ξ_sp",
     .equations = "(86)-(91)",
     .source = "Kalker90",
     .parameters = {},
     .memory = 0,
     .conflicts = conflicts},
    bind_kalker};

}  // namespace osculate::laws
