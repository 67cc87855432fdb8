#include "dynamics/driven_travel.hpp"

#include <cmath>

namespace osculate {

double driven_travel(const BodyShape& shape, const Pose& pose, const DrivenStep& step,
                     const ParticlesWithin& particles) {
  const auto& [displacement, turn] = step;
  if (shape.is_face()) return displacement.norm() + turn.norm() * (shape.centre.norm() + shape.bounding_radius);
  if (is_particle(shape.shape)) return displacement.norm() + turn.norm() * shape.bounding_radius;
  const double arm = particles.radius + (pose.position - particles.centre).norm();
  const Vec3 axis = pose.orientation * Vec3::UnitZ();
  if (std::holds_alternative<HalfSpace>(shape.shape))
    return std::fabs(displacement.dot(axis)) + turn.cross(axis).norm() * arm;
  if (std::holds_alternative<Cylinder>(shape.shape))
    return displacement.cross(axis).norm() + turn.cross(axis).norm() * arm;
  return displacement.norm();
}

}  // namespace osculate
