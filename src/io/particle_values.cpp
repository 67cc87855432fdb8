#include "io/particle_values.hpp"

#include <fmt/format.h>

#include "osculate/core/error.hpp"
#include "osculate/dynamics/body_shape.hpp"

namespace osculate::io {

void require_shapes(const ParticleFrame& frame, const ResultsHead& head) {
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (frame.shape[i] >= head.shapes.size()) {
      throw InputError(fmt::format("particle {}", frame.id[i]), fmt::format("shape {}", frame.shape[i]),
                       fmt::format("one of the {} shapes of the results", head.shapes.size()));
    }
  }
}

Pose shape_pose_of(const ParticleFrame& frame, const ResultsHead& head, std::size_t particle) {
  const Pose& in_body = head.shapes[frame.shape[particle]].frame;
  return {frame.pose(particle).to_world(in_body.position), frame.orientation[particle] * in_body.orientation};
}

std::vector<double> kinetic_energies(const ParticleFrame& frame, const ResultsHead& head) {
  require_shapes(frame, head);
  std::vector<BodyShape> bodies;
  for (const ResultsShape& shape : head.shapes) bodies.push_back(body_shape(shape.shape));
  std::vector<double> energies;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const BodyShape& body = bodies[frame.shape[i]];
    const Vec3 omega = frame.orientation[i].conjugate() * frame.angular_velocity[i];
    energies.push_back(0.5 * head.shapes[frame.shape[i]].density *
                       (body.volume * frame.velocity[i].squaredNorm() + omega.dot(body.inertia.cwiseProduct(omega))));
  }
  return energies;
}

}  // namespace osculate::io
