#include "osculate/dynamics/insertion.hpp"

#include <cmath>
#include <string>

#include "dynamics/crowd.hpp"
#include "osculate/core/error.hpp"

namespace osculate {
namespace {

void require(bool sound, const std::string& where, const std::string& found, const std::string& expected) {
  if (!sound) throw InputError(where, found, expected);
}

}  // namespace

std::vector<Vec3> lattice(const Region& region, double spacing) {
  validate(region);
  require(spacing > 0.0 && std::isfinite(spacing), "lattice", "spacing " + std::to_string(spacing) + " m",
          "a finite value > 0");
  const BoxRegion box = bounds(region);
  // A region meant to hold a whole number of cells does, in spite of rounding.
  constexpr double rounding = 1e-9;
  const Eigen::Array3d cells = ((box.upper - box.lower).array() / spacing + rounding).floor();
  const Vec3 first = 0.5 * (box.lower + box.upper) - 0.5 * spacing * (cells - 1.0).matrix();
  std::vector<Vec3> points;
  for (double k = 0.0; k < cells[2]; ++k)
    for (double j = 0.0; j < cells[1]; ++j)
      for (double i = 0.0; i < cells[0]; ++i) {
        const Vec3 point = first + spacing * Vec3(i, j, k);
        if (depth(region, point) >= (0.5 - rounding) * spacing) points.push_back(point);
      }
  return points;
}

void insert_randomly(Setup& setup, const RandomInsertion& insertion) {
  validate(insertion.region);
  check_kinds(setup, insertion.kinds, "insertion");
  check_numbers(insertion.gap, insertion.tries, insertion.velocity, insertion.fluctuation, "insertion");
  std::vector<BodyShape> shapes;
  for (const Shape& shape : setup.shapes) shapes.push_back(body_shape(shape));
  std::vector<Pose> faces;
  for (const MeshStart& mesh : setup.meshes)
    for (const BodyShape& face : face_shapes(mesh.triangles)) {
      shapes.push_back(face);
      faces.push_back(mesh.pose);
    }
  Crowd crowd(shapes, setup.box, insertion.gap);
  for (const BodyStart& body : setup.bodies) crowd.add(body.shape, body.pose);
  for (std::size_t f = 0; f < faces.size(); ++f)
    crowd.add(static_cast<std::int32_t>(setup.shapes.size() + f), faces[f]);
  Random random(insertion.seed);
  const std::vector<double> weights = weights_of(insertion.kinds);
  std::vector<BodyStart> placed;
  while (placed.size() < insertion.count) {
    const Kind& kind = insertion.kinds[random.pick(weights)];
    const std::optional<Pose> place = random_place(crowd, insertion.region, kind.shape, insertion.tries, random);
    if (!place)
      throw InputError("insertion",
                       std::to_string(placed.size()) + " of " + std::to_string(insertion.count) +
                           " particles found a place; the next one none in " + std::to_string(insertion.tries) +
                           " tries",
                       "a larger region, fewer or smaller particles");
    crowd.add(kind.shape, *place);
    placed.push_back({.shape = kind.shape,
                      .material = kind.material,
                      .pose = *place,
                      .velocity = random_velocity(insertion.velocity, insertion.fluctuation, random)});
  }
  setup.bodies.insert(setup.bodies.end(), placed.begin(), placed.end());
}

}  // namespace osculate
