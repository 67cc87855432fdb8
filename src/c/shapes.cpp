#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "c/boundary.hpp"
#include "c/handles.hpp"

namespace {

using namespace osculate;
using c::guarded;
using c::required;

struct AsSuperquadric {
  std::optional<Superquadric> operator()(const Superquadric& shape) const { return shape; }
  std::optional<Superquadric> operator()(const Ellipsoid& shape) const { return as_superquadric(shape); }
  std::optional<Superquadric> operator()(const Sphere& shape) const { return as_superquadric(shape); }
  template <class Other>
  std::optional<Superquadric> operator()(const Other&) const {
    return std::nullopt;
  }
};

osculate_shape* handle_of(Shape shape) {
  const std::optional<Superquadric> smooth = std::visit(AsSuperquadric{}, shape);
  std::array<double, 5> columns{};
  if (smooth)
    columns = {smooth->half_axes.x(), smooth->half_axes.y(), smooth->half_axes.z(), smooth->exponents.n1,
               smooth->exponents.n2};
  const bool particle = is_particle(shape);
  return new osculate_shape{std::move(shape), particle, smooth.has_value(), columns};
}

/// Makes a shape of a C function's arguments and hands it over once it is known to be valid.
template <class Make>
int make_shape(const char* function, osculate_shape** shape, const Make& make) noexcept {
  return guarded(function, [&] {
    required(shape, "shape");
    Shape made = make();
    validate(made);
    *shape = handle_of(std::move(made));
  });
}

Vec3 vector(const double* values, const char* name) {
  return Eigen::Map<const Vec3>(&required(values, name));
}

}  // namespace

int osculate_new_sphere(double radius, osculate_shape** shape) {
  return make_shape("osculate_new_sphere", shape, [&] { return Sphere{radius}; });
}

int osculate_new_ellipsoid(const double half_axes[3], osculate_shape** shape) {
  return make_shape("osculate_new_ellipsoid", shape, [&] { return Ellipsoid{vector(half_axes, "half_axes")}; });
}

int osculate_new_superquadric(const double half_axes[3], double n1, double n2, osculate_shape** shape) {
  return make_shape("osculate_new_superquadric", shape, [&] {
    return Superquadric{vector(half_axes, "half_axes"), {n1, n2}};
  });
}

int osculate_new_potential_particle(size_t planes, const double* normals, const double* distances, double sphericity,
                                    double edge_radius, double sphere_radius, osculate_shape** shape) {
  return make_shape("osculate_new_potential_particle", shape, [&] {
    required(normals, "normals");
    required(distances, "distances");
    PotentialParticle particle{
        .planes = {}, .sphericity = sphericity, .edge_radius = edge_radius, .sphere_radius = sphere_radius};
    for (size_t i = 0; i < planes; ++i) particle.planes.push_back({vector(normals + 3 * i, "normals"), distances[i]});
    return particle;
  });
}

int osculate_new_half_space(osculate_shape** shape) {
  return make_shape("osculate_new_half_space", shape, [] { return HalfSpace{}; });
}

int osculate_new_cylinder(double radius, int solid, osculate_shape** shape) {
  return make_shape("osculate_new_cylinder", shape, [&] {
    if (solid != OSCULATE_SOLID_INSIDE && solid != OSCULATE_SOLID_OUTSIDE)
      throw InputError("solid", std::to_string(solid), "OSCULATE_SOLID_INSIDE or OSCULATE_SOLID_OUTSIDE");
    return Cylinder{radius, solid == OSCULATE_SOLID_INSIDE ? Cylinder::Solid::inside : Cylinder::Solid::outside};
  });
}

int osculate_new_sphere_container(double radius, osculate_shape** shape) {
  return make_shape("osculate_new_sphere_container", shape, [&] { return SphereContainer{radius}; });
}

void osculate_free_shape(osculate_shape* shape) {
  delete shape;
}

int osculate_bounding_radius(const osculate_shape* shape, double* radius) {
  return guarded("osculate_bounding_radius",
                 [&] { required(radius, "radius") = bounding_radius(required(shape, "shape").shape); });
}

int osculate_mass_properties(const osculate_shape* shape, double* volume, double centroid[3], double inertia[9]) {
  return guarded("osculate_mass_properties", [&] {
    const MassProperties found = mass_properties(required(shape, "shape").shape);
    if (volume != nullptr) *volume = found.volume;
    if (centroid != nullptr) Eigen::Map<Vec3>{centroid} = found.centroid;
    if (inertia != nullptr) Eigen::Map<Mat3>{inertia} = found.inertia;  // symmetric: rows are columns
  });
}
