// Forces of creepage between bodies that roll on each other.

#include <array>
#include <cmath>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "osculate/mechanics/twisting.hpp"
#include "osculate/mechanics/vermeulen_johnson.hpp"

namespace osculate::laws {
namespace {

constexpr std::array parameters{friction_parameter};
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

void act(Contact& contact, const Rolling& rolling, const kalker::Force& force) {
  const TangentVector y{-rolling.direction.y, rolling.direction.x};
  contact.force = contact.force + force.longitudinal * rolling.direction + force.lateral * y;
  contact.couple += force.moment * contact.normal;
  contact.friction_loss +=
      (dot(contact.force, contact.velocity) + force.moment * contact.angular_velocity.dot(contact.normal)) *
      contact.time_step;
}

/// Below this share of the slip the contact slides more than it rolls, and creepage says nothing.
constexpr double slowest_rolling = 1e-9;

/// `creep_force` of a rolling contact and its creepage, within what friction can give.
template <class CreepForce>
Part rolling_part(const Binding& binding, const CreepForce& creep_force) {
  const auto composite = kalker::composite(binding.material_1, binding.material_2);
  const auto step = [creep_force, friction = binding["friction"], G = composite.shear_modulus,
                     table = kalker::table(composite.poissons_ratio)](Contact& contact, Memory) {
    const double load = friction_load(contact);
    if (!contact.closed || !(contact.a_c > 0.0) || !(friction * load > 0.0)) return;
    const kalker::Limit limit{.force = friction * load,
                              .moment = twisting::limit(contact.ellipse(), contact.a_c, friction, load)};
    const Rolling rolling = rolling_of(contact);
    const auto& [along, across, spin] = rolling.slip;
    const double slip = norm(contact.velocity) + contact.a_c * std::fabs(spin);
    if (!(rolling.speed > slowest_rolling * slip)) {
      act(contact, rolling, kalker::sliding(along, across, spin, limit));
      return;
    }
    const double angle = std::atan2(rolling.direction.y, rolling.direction.x);
    const auto coefficients = kalker::coefficients(table, kalker::axes_along_rolling(contact.axis_ratio, angle));
    const auto patch =
        vermeulen_johnson::contact(coefficients, G, contact.a_c, contact.a_c * contact.axis_ratio, friction, load);
    const kalker::Force force =
        creep_force(patch, {along / rolling.speed, across / rolling.speed, spin / rolling.speed});
    act(contact, rolling, kalker::limited(force, limit));
  };
  return {.step = step, .needs = {.angular_velocity = true}, .makes_couples = true};
}

Part bind_vermeulen_johnson(const Binding& binding) {
  return rolling_part(binding, vermeulen_johnson::force);
}

Part bind_kalker(const Binding& binding) {
  return rolling_part(binding, [](const vermeulen_johnson::Contact& patch, const kalker::Creepage& creepage) {
    return kalker::linear_force(patch.coefficients, patch.shear_modulus, patch.a_c, patch.b_c, creepage);
  });
}

}  // namespace

const Law vermeulen_johnson{{.name = "vermeulen_johnson",
                             .slot = LawSlot::rolling,
                             .title = "Creep forces from small creepage to sliding, with Kalker's coefficients",
                             .formula = "|F| = μ F_n [1 − (1 − τ)³], τ = |F_linear|/(3 μ F_n)",
                             .equations = "(92),(93)",
                             .source = "VJ64, SHE83, Kalker90, HC96",
                             .parameters = parameters,
                             .memory = 0,
                             .conflicts = conflicts},
                            bind_vermeulen_johnson};

const Law kalker{
    {.name = "kalker",
     .slot = LawSlot::rolling,
     .title = "Linear creep forces, cut off where the contact slides",
     .formula = "F_x = −c² G C11 ξ_x, F_y = −c² G C22 ξ_y − c³ G C23 ξ_sp, M = c³ G C23 ξ_y − c⁴ G C33 ξ_sp",
     .equations = "(86)-(91)",
     .source = "Kalker90, HC96",
     .parameters = parameters,
     .memory = 0,
     .conflicts = conflicts},
    bind_kalker};

}  // namespace osculate::laws
