#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "shapes/mesh_map.hpp"

namespace osculate {
namespace {

using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

/// The factor that makes |margin · ∇f| a share of the body's size on a face.
double margin_of(const PotentialParticle& shape) {
  constexpr double share_of_size = 0.4;
  double nearest = shape.sphere_radius / std::sqrt(shape.sphericity);
  for (const FacePlane& plane : shape.planes) nearest = std::min(nearest, plane.distance);
  const double face_slope = 2.0 * std::sqrt(1.0 - shape.sphericity) / shape.edge_radius +
                            2.0 * shape.sphericity * nearest / (shape.sphere_radius * shape.sphere_radius);
  return share_of_size * nearest / face_slope;
}

}  // namespace

// Solves x + margin ∇f(x) = stretch · w with f(x) = 0 for x and stretch by Newton steps that must decrease the
// residual.
Vec3 mesh_point(const PotentialParticle& shape, const Vec3& w) {
  const double margin = margin_of(shape);
  const Vec3 direction = w.normalized();
  Vec3 x = direction / gauge(shape, direction).value;
  const double size = x.norm();
  ImplicitValue f = implicit_value(shape, x);
  double stretch = direction.dot(x + margin * f.gradient);
  const auto residual_of = [&](const Vec3& at, const ImplicitValue& value, double along) {
    Vec4 residual;
    residual << (at + margin * value.gradient - along * direction) / size, value.value;
    return residual;
  };
  Vec4 residual = residual_of(x, f, stretch);
  constexpr int enough_steps = 60, enough_halvings = 40;
  constexpr double good_enough = 1e-10;  // it only places the vertex
  for (int step = 0; step < enough_steps && residual.norm() > good_enough; ++step) {
    Mat4 jacobian;
    jacobian << (Mat3::Identity() + margin * f.hessian) / size, -direction / size, f.gradient.transpose(), 0.0;
    const Vec4 move = jacobian.partialPivLu().solve(-residual);
    bool moved = false;
    double fraction = 1.0;
    for (int halving = 0; halving < enough_halvings && !moved; ++halving, fraction *= 0.5) {
      const Vec3 candidate = x + fraction * move.head<3>();
      const double candidate_stretch = stretch + fraction * move[3];
      const ImplicitValue at_candidate = implicit_value(shape, candidate);
      const Vec4 candidate_residual = residual_of(candidate, at_candidate, candidate_stretch);
      if (!(candidate_residual.norm() < residual.norm())) continue;
      x = candidate;
      stretch = candidate_stretch;
      f = at_candidate;
      residual = candidate_residual;
      moved = true;
    }
    if (!moved) break;
  }
  return x / gauge(shape, x).value;
}

}  // namespace osculate
