#include "validation/curvature/jet_curvature.hpp"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "osculate/geometry/curvature.hpp"

namespace osculate::validation {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Fitting = CGAL::Monge_via_jet_fitting<Kernel>;

struct Body {
  std::string name;
  Shape shape;
};
struct Place {
  std::string name;
  Vec3 ray;
};

std::vector<Body> bodies() {
  const Vec3 axes(0.010, 0.012, 0.009);
  PotentialParticle cube{{}, 0.1, 0.008, 0.02};
  for (int axis = 0; axis < 3; ++axis) {
    cube.planes.push_back({Vec3::Unit(axis), 0.01});
    cube.planes.push_back({-Vec3::Unit(axis), 0.01});
  }
  return {{"superquadric n = 2.5", Superquadric{axes, {2.5, 2.5}}},
          {"superquadric n = 4", Superquadric{axes, {4.0, 4.0}}},
          {"superquadric n = 6", Superquadric{axes, {6.0, 6.0}}},
          {"potential cube", cube}};
}

/// Off the symmetry planes, so that no symmetry flatters the fit.
std::vector<Place> places() {
  return {{"face", Vec3(1.0, 0.35, 0.45)}, {"edge", Vec3(1.0, 0.93, 0.35)}, {"corner", Vec3(1.0, 0.95, 0.91)}};
}

Vec3 on_surface(const Shape& shape, const Vec3& ray) {
  return ray / gauge(shape, ray).value;
}

/// True surface points around `centre`, the centre first, over a disc of the tangent plane.
std::vector<Kernel::Point_3> sample(const Shape& shape, const Vec3& centre, const Vec3& normal, double radius) {
  constexpr int rings = 4, spokes = 12;
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  std::vector<Kernel::Point_3> points = {{centre.x(), centre.y(), centre.z()}};
  for (int ring = 1; ring <= rings; ++ring) {
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double r = radius * ring / rings, angle = 2.0 * std::numbers::pi * (spoke + 0.5 * ring) / spokes;
      const Vec3 x = on_surface(shape, centre + r * (std::cos(angle) * e1 + std::sin(angle) * e2));
      points.emplace_back(x.x(), x.y(), x.z());
    }
  }
  return points;
}

}  // namespace

std::vector<JetFit> jet_fits() {
  std::vector<JetFit> fits;
  for (const Body& body : bodies()) {
    const double size = volume_equivalent_radius(mass_properties(body.shape).volume);
    for (const Place& place : places()) {
      const Vec3 centre = on_surface(body.shape, place.ray);
      const Vec3 normal = gauge(body.shape, centre).gradient.normalized();
      const PrincipalCurvatures exact = principal_curvatures(body.shape, centre);
      const double scale = std::max(exact.max, 1.0 / size);
      std::optional<double> previous;
      for (const double radius : {0.08, 0.04, 0.02, 0.01}) {
        const auto points = sample(body.shape, centre, normal, radius * size);
        Fitting fitting;
        Fitting::Monge_form monge = fitting(points.begin(), points.end(), jet_degree, 2);
        monge.comply_wrt_given_normal(Kernel::Vector_3(-normal.x(), -normal.y(), -normal.z()));  // convex: positive
        const double error_max = std::fabs(monge.principal_curvatures(0) - exact.max) / scale;
        const double error_min = std::fabs(monge.principal_curvatures(1) - exact.min) / scale;
        const double larger = std::max(error_max, error_min);
        fits.push_back({body.name, place.name, radius, error_max, error_min,
                        previous ? std::optional(std::log2(*previous / larger)) : std::nullopt});
        previous = larger;
      }
    }
  }
  return fits;
}

}  // namespace osculate::validation
