#include "osculate/dynamics/rigid_rotation.hpp"

#include "dynamics/rigid_rotation-inl.hpp"

namespace osculate {

Turn rotate_free(const Spin& spin, const Vec3& inertia, double dt) {
  namespace kernel = HWY_NAMESPACE;
  const auto v3 = [](const auto& v) { return kernel::V3<double>{v.x(), v.y(), v.z()}; };
  const auto vec3 = [](const kernel::V3<double>& v) { return Vec3(v.x, v.y, v.z); };
  const kernel::TurnOf<double> turn = kernel::turned<double>({spin.orientation.w(), v3(spin.orientation)},
                                                             v3(spin.momentum), v3(inertia.cwiseInverse()), dt);
  const auto& [w, v] = turn.orientation;
  return {.spin = {.orientation = Quat(w, v.x, v.y, v.z), .momentum = vec3(turn.momentum)},
          .mean_velocity = vec3(turn.mean_velocity)};
}

}  // namespace osculate
