#include "osculate/dynamics/body_shape.hpp"

#include <Eigen/Eigenvalues>
#include <limits>

namespace osculate {
namespace {

/// Off-diagonal moments and offsets below this share are the quadrature's error.
constexpr double negligible = 1e-6;

Pose principal_frame(const MassProperties& properties, double size) {
  Pose frame;
  if (properties.centroid.norm() > negligible * size) frame.position = properties.centroid;
  Mat3 off_diagonal = properties.inertia;
  off_diagonal.diagonal().setZero();
  if (off_diagonal.norm() > negligible * properties.inertia.trace()) {
    Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(properties.inertia).eigenvectors();
    if (axes.determinant() < 0.0) axes.col(2) = -axes.col(2);
    frame.orientation = Quat(axes);
  }
  return frame;
}

}  // namespace

BodyShape body_shape(const Shape& shape) {
  validate(shape);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!is_particle(shape)) return {shape, Pose{}, 0.0, Vec3::Zero(), infinity, infinity, infinity};
  const MassProperties properties = mass_properties(shape);
  const double radius = bounding_radius(shape);
  const Pose principal = principal_frame(properties, radius);
  const Mat3 axes = principal.orientation.toRotationMatrix();
  const Quat back = principal.orientation.conjugate();
  return {.shape = shape,
          .frame = {.position = back * -principal.position, .orientation = back},
          .volume = properties.volume,
          .inertia = (axes.transpose() * properties.inertia * axes).diagonal(),
          .volume_radius = volume_equivalent_radius(properties.volume),
          .bounding_radius = radius + principal.position.norm(),
          .half_width = oriented_box(shape).half_extents.minCoeff()};
}

std::vector<BodyShape> face_shapes(const SurfaceTriangles& triangles) {
  const auto surface = std::make_shared<const MeshSurface>(mesh_surface(triangles));
  std::vector<BodyShape> shapes;
  for (std::size_t f = 0; f < surface->faces.size(); ++f) {
    BodyShape shape = body_shape(HalfSpace{});
    shape.bounding_radius = surface->faces[f].radius;
    shape.surface = surface;
    shape.face = static_cast<int>(f);
    shape.centre = surface->faces[f].centre;
    shapes.push_back(shape);
  }
  return shapes;
}

Pose shape_pose(const BodyShape& shape, const Pose& body) {
  return {.position = body.to_world(shape.frame.position), .orientation = body.orientation * shape.frame.orientation};
}

}  // namespace osculate
