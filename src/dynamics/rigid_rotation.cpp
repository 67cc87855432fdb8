#include "osculate/dynamics/rigid_rotation.hpp"

#include <cmath>

namespace osculate {
namespace {

/// Rotates the body about its axis k by 2 atan(half); a and b are the other two axes in cyclic order.
/// `turn` grows by the factor (1, half e_k), not normalised.
template <int k, int a, int b>
void rotate_about(double half, Quat& turn, Vec3& momentum) {
  const double scale = 1.0 / (1.0 + half * half);
  const double cosine = (1.0 - half * half) * scale, sine = 2.0 * half * scale;
  const double m_a = momentum[a], m_b = momentum[b];
  momentum[a] = cosine * m_a + sine * m_b;
  momentum[b] = cosine * m_b - sine * m_a;
  const double w = turn.w(), q_k = turn.vec()[k], q_a = turn.vec()[a], q_b = turn.vec()[b];
  turn.w() = w - half * q_k;
  turn.vec()[k] = q_k + half * w;
  turn.vec()[a] = q_a + half * q_b;
  turn.vec()[b] = q_b - half * q_a;
}

}  // namespace

Turn rotate_free(const Spin& spin, const Vec3& inertia, double dt) {
  const Vec3 half_rate = (0.5 * dt) * inertia.cwiseInverse();
  Quat turn = Quat::Identity();
  Vec3 momentum = spin.momentum;
  rotate_about<0, 1, 2>(0.5 * half_rate[0] * momentum[0], turn, momentum);
  rotate_about<1, 2, 0>(0.5 * half_rate[1] * momentum[1], turn, momentum);
  rotate_about<2, 0, 1>(half_rate[2] * momentum[2], turn, momentum);
  rotate_about<1, 2, 0>(0.5 * half_rate[1] * momentum[1], turn, momentum);
  rotate_about<0, 1, 2>(0.5 * half_rate[0] * momentum[0], turn, momentum);
  const Quat orientation = (spin.orientation * turn).normalized();
  // The axis of the turn is the same before and after it.
  const Vec3 mean_velocity = orientation * (2.0 / (dt * turn.w()) * turn.vec());
  return {.spin = {.orientation = orientation, .momentum = momentum}, .mean_velocity = mean_velocity};
}

}  // namespace osculate
