#include "validation/chung_ooi2011/restitution_curve.hpp"

#include "osculate/mechanics/damped_hertz.hpp"
#include "validation/chung_ooi2011/collision.hpp"

namespace osculate::validation {
namespace {

constexpr double reference_speed = 1.0, reference_restitution = 0.9;

Collision impact_at(double speed, const ChosenLaw& dashpot) {
  const Material glass{.name = "glass", .elastic = {.youngs_modulus = 71e9, .poissons_ratio = 0.22}, .density = 2500.0};
  const Ball ball{.radius = 1.59e-3, .material = glass, .velocity = {0.5 * speed, 0.0, 0.0}};
  Ball other = ball;
  other.velocity = -ball.velocity;
  return {.ball_1 = ball, .ball_2 = other, .law = {{"hertz", {}}, dashpot}};
}

RestitutionCurve curve(const ChosenLaw& dashpot, const damped_hertz::Model& model, double mass,
                       const std::vector<double>& speeds) {
  RestitutionCurve result{.law = dashpot.name, .speeds = speeds, .theory = {}, .computed = {}};
  for (const double speed : speeds) {
    result.theory.push_back(damped_hertz::impact(model, mass, speed, Attraction::cut_off).restitution);
    const Outcome outcome = collide(impact_at(speed, dashpot));
    result.computed.push_back((outcome.velocity_2.x() - outcome.velocity_1.x()) / speed);
  }
  return result;
}

}  // namespace

std::vector<RestitutionCurve> restitution_curves(const std::vector<double>& speeds) {
  const CollisionPair two = pair_of(impact_at(reference_speed, {"tsuji", {}}));
  const ImpactPair pair{.mass = two.reduced_mass, .radius = two.radius, .modulus = two.modulus};
  const damped_hertz::Model solid =
      damped_hertz::viscoelastic_with(pair, reference_speed, reference_restitution, Attraction::cut_off);
  return {
      curve({"tsuji", {{"restitution", reference_restitution}}},
            damped_hertz::tsuji(pair, reference_restitution, Attraction::cut_off), pair.mass, speeds),
      curve({"brilliantov", {{"dissipative_time", solid.damping / (1.5 * solid.stiffness)}}}, solid, pair.mass, speeds),
      curve({"kuwabara_kono", {{"damping", solid.damping}}}, solid, pair.mass, speeds)};
}

}  // namespace osculate::validation
