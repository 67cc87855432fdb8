#include "validation/flow/grains.hpp"

#include "osculate/dynamics/time_step.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::validation {

ContactLaw grain_law(double friction) {
  constexpr double restitution = 0.4;
  return make_contact_law(
      {{"hertz", {}}, {"tsuji", {{"restitution", restitution}}}, {"mindlin", {{"friction", friction}}}}, soft, soft);
}

double flow_time_step(const Setup& setup) {
  constexpr double impact_speed = 1.0, steps_in_impact = 25.0;  // m/s
  return time_step_limits(setup, impact_speed).contact_duration / steps_in_impact;
}

BodyStart fixed_plane(const Vec3& point, const Vec3& normal, std::int32_t half_space, std::int32_t material) {
  return {.shape = half_space,
          .material = material,
          .motion = 0,
          .pose = {point, Quat::FromTwoVectors(Vec3::UnitZ(), normal)}};
}

}  // namespace osculate::validation
