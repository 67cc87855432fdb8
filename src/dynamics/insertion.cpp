#include "osculate/dynamics/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/dynamics/body_shape.hpp"
#include "osculate/geometry/common_normal.hpp"

namespace osculate {
namespace {

void require(bool sound, const std::string& where, const std::string& found, const std::string& expected) {
  if (!sound) throw InputError(where, found, expected);
}

void check(const BoxRegion& box) {
  require(box.lower.allFinite() && box.upper.allFinite() && (box.upper - box.lower).minCoeff() > 0.0, "region",
          "a box without volume", "lower < upper in all three directions");
}
void check(const CylinderRegion& cylinder) {
  require(cylinder.base.allFinite() && cylinder.radius > 0.0 && cylinder.height > 0.0 &&
              std::isfinite(cylinder.radius + cylinder.height),
          "region", "a cylinder without volume", "radius and height > 0");
}
void check(const SphereRegion& sphere) {
  require(sphere.centre.allFinite() && sphere.radius > 0.0 && std::isfinite(sphere.radius), "region",
          "a sphere without volume", "radius > 0");
}

BoxRegion bounds(const BoxRegion& box) {
  return box;
}
BoxRegion bounds(const CylinderRegion& cylinder) {
  const Vec3 side(cylinder.radius, cylinder.radius, 0.0);
  return {.lower = cylinder.base - side, .upper = cylinder.base + side + cylinder.height * Vec3::UnitZ()};
}
BoxRegion bounds(const SphereRegion& sphere) {
  const Vec3 side = Vec3::Constant(sphere.radius);
  return {.lower = sphere.centre - side, .upper = sphere.centre + side};
}

/// How far inside a point lies; negative outside.
double depth(const BoxRegion& box, const Vec3& point) {
  return std::min((point - box.lower).minCoeff(), (box.upper - point).minCoeff());
}
double depth(const CylinderRegion& cylinder, const Vec3& point) {
  const Vec3 x = point - cylinder.base;
  return std::min({x.z(), cylinder.height - x.z(), cylinder.radius - std::hypot(x.x(), x.y())});
}
double depth(const SphereRegion& sphere, const Vec3& point) {
  return sphere.radius - (point - sphere.centre).norm();
}

double depth_in(const Region& region, const Vec3& point) {
  return std::visit([&](const auto& one) { return depth(one, point); }, region);
}
BoxRegion bounds_of(const Region& region) {
  return std::visit([](const auto& one) { return bounds(one); }, region);
}

/// The bodies placed so far, to be asked whether another one fits between them.
class Crowd {
 public:
  Crowd(const Setup& setup, double gap) : setup_(setup), gap_(gap) {
    for (const Shape& shape : setup.shapes) {
      shapes_.push_back(body_shape(shape));
      if (is_particle(shape)) largest_ = std::max(largest_, shapes_.back().bounding_radius);
    }
    for (const BodyStart& body : setup.bodies) add(body);
  }

  void add(const BodyStart& body) {
    if (is_particle(shape_of(body).shape))
      particles_[cell_of(wrapped(setup_.box, body.pose.position))].push_back(body);
    else
      walls_.push_back(body);
  }

  bool has_room_for(const BodyStart& body) const {
    if (std::any_of(walls_.begin(), walls_.end(), [&](const BodyStart& wall) { return touches(body, wall); }))
      return false;
    const std::vector<Vec3> images = nearby_images(body.pose.position);
    for (const Vec3& image : images) {
      const Cell middle = cell_of(image);
      for (std::int64_t k = 0; k < 27; ++k) {
        const auto found = particles_.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
        if (found == particles_.end()) continue;
        BodyStart moved = body;
        moved.pose.position = image;
        if (std::any_of(found->second.begin(), found->second.end(),
                        [&](const BodyStart& other) { return touches(moved, other); }))
          return false;
      }
    }
    return true;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  const BodyShape& shape_of(const BodyStart& body) const { return shapes_[static_cast<std::size_t>(body.shape)]; }
  double cell_size() const { return 2.0 * largest_ + gap_; }
  Cell cell_of(const Vec3& point) const {
    Cell cell{};
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::int64_t>(std::floor(point[static_cast<Eigen::Index>(k)] / cell_size()));
    return cell;
  }

  /// The point in the box, and where it repeats next to the box.
  std::vector<Vec3> nearby_images(const Vec3& position) const {
    const PeriodicBox& box = setup_.box;
    std::vector<Vec3> images{wrapped(box, position)};
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (!std::isfinite(box.length[k])) continue;
      const std::size_t count = images.size();
      for (std::size_t i = 0; i < count; ++i)
        for (const double side : {-1.0, 1.0}) {
          Vec3 image = images[i];
          image[k] += side * box.length[k];
          const double outside = std::max(box.origin[k] - image[k], image[k] - box.origin[k] - box.length[k]);
          if (outside <= cell_size()) images.push_back(image);
        }
    }
    return images;
  }

  bool touches(const BodyStart& body, const BodyStart& other) const {
    const BodyShape &one = shape_of(body), &two = shape_of(other);
    BodyStart near = other;
    if (is_particle(two.shape)) {
      near.pose.position = wrapped(setup_.box, other.pose.position);
      const double reach = one.bounding_radius + two.bounding_radius + gap_;
      if ((near.pose.position - body.pose.position).squaredNorm() > reach * reach) return false;
    }
    ContactCache cache;
    const ContactGeometry contact =
        common_normal(one.shape, shape_pose(one, body.pose), two.shape, shape_pose(two, near.pose), cache,
                      gap_ > 0.0 ? Gap::resolve : Gap::skip);
    // Where nothing can be said for certain there is no room.
    return !(is_resolved(contact.status) && contact.overlap < -gap_);
  }

  const Setup& setup_;
  double gap_;
  double largest_ = 0.0;
  std::vector<BodyShape> shapes_;
  std::vector<BodyStart> walls_;
  std::map<Cell, std::vector<BodyStart>> particles_;
};

void check(const Setup& setup, const RandomInsertion& insertion) {
  validate(insertion.region);
  require(!insertion.kinds.empty(), "insertion", "no kinds of particles", "one at least");
  double weights = 0.0;
  for (const Kind& kind : insertion.kinds) {
    require(kind.shape >= 0 && static_cast<std::size_t>(kind.shape) < setup.shapes.size(), "insertion",
            "shape " + std::to_string(kind.shape), "one of " + std::to_string(setup.shapes.size()));
    require(is_particle(setup.shapes[static_cast<std::size_t>(kind.shape)]), "insertion",
            "shape " + std::to_string(kind.shape) + ", a wall", "a particle");
    require(kind.material >= 0 && static_cast<std::size_t>(kind.material) < setup.materials.size(), "insertion",
            "material " + std::to_string(kind.material), "one of " + std::to_string(setup.materials.size()));
    require(kind.weight >= 0.0 && std::isfinite(kind.weight), "insertion", "weight " + std::to_string(kind.weight),
            "a finite value >= 0");
    weights += kind.weight;
  }
  require(weights > 0.0, "insertion", "weights that add up to zero", "one above zero");
  require(insertion.gap >= 0.0 && std::isfinite(insertion.gap), "insertion",
          "gap " + std::to_string(insertion.gap) + " m", "a finite value >= 0");
  require(insertion.tries >= 1, "insertion", std::to_string(insertion.tries) + " tries", "1 or more");
  require(insertion.velocity.allFinite() && insertion.fluctuation >= 0.0 && std::isfinite(insertion.fluctuation),
          "insertion", "a velocity that is not finite", "finite numbers, a fluctuation >= 0");
}

}  // namespace

void validate(const Region& region) {
  std::visit([](const auto& one) { check(one); }, region);
}

double volume(const Region& region) {
  struct Volume {
    double operator()(const BoxRegion& box) const { return (box.upper - box.lower).prod(); }
    double operator()(const CylinderRegion& cylinder) const {
      return std::numbers::pi * cylinder.radius * cylinder.radius * cylinder.height;
    }
    double operator()(const SphereRegion& sphere) const {
      return 4.0 / 3.0 * std::numbers::pi * sphere.radius * sphere.radius * sphere.radius;
    }
  };
  return std::visit(Volume{}, region);
}

bool contains(const Region& region, const Vec3& point) {
  return depth_in(region, point) >= 0.0;
}

std::vector<Vec3> lattice(const Region& region, double spacing) {
  validate(region);
  require(spacing > 0.0 && std::isfinite(spacing), "lattice", "spacing " + std::to_string(spacing) + " m",
          "a finite value > 0");
  const BoxRegion box = bounds_of(region);
  // A region meant to hold a whole number of cells does, in spite of rounding.
  constexpr double rounding = 1e-9;
  const Eigen::Array3d cells = ((box.upper - box.lower).array() / spacing + rounding).floor();
  const Vec3 first = 0.5 * (box.lower + box.upper) - 0.5 * spacing * (cells - 1.0).matrix();
  std::vector<Vec3> points;
  for (double k = 0.0; k < cells[2]; ++k)
    for (double j = 0.0; j < cells[1]; ++j)
      for (double i = 0.0; i < cells[0]; ++i) {
        const Vec3 point = first + spacing * Vec3(i, j, k);
        if (depth_in(region, point) >= (0.5 - rounding) * spacing) points.push_back(point);
      }
  return points;
}

void insert_randomly(Setup& setup, const RandomInsertion& insertion) {
  check(setup, insertion);
  Random random(insertion.seed);
  Crowd crowd(setup, insertion.gap);
  std::vector<double> weights;
  for (const Kind& kind : insertion.kinds) weights.push_back(kind.weight);
  const BoxRegion box = bounds_of(insertion.region);
  std::vector<BodyStart> placed;
  while (placed.size() < insertion.count) {
    const Kind& kind = insertion.kinds[random.pick(weights)];
    BodyStart body{.shape = kind.shape, .material = kind.material, .pose = {}};
    int tried = 0;
    do {
      if (tried++ == insertion.tries)
        throw InputError("insertion",
                         std::to_string(placed.size()) + " of " + std::to_string(insertion.count) +
                             " particles found a place; the next one none in " + std::to_string(insertion.tries) +
                             " tries",
                         "a larger region, fewer or smaller particles");
      const double x = random.uniform(box.lower.x(), box.upper.x()), y = random.uniform(box.lower.y(), box.upper.y()),
                   z = random.uniform(box.lower.z(), box.upper.z());
      body.pose = {.position = {x, y, z}, .orientation = random.orientation()};
    } while (!contains(insertion.region, body.pose.position) || !crowd.has_room_for(body));
    const double u = random.normal(), v = random.normal(), w = random.normal();
    body.velocity = insertion.velocity + insertion.fluctuation * Vec3(u, v, w);
    crowd.add(body);
    placed.push_back(body);
  }
  setup.bodies.insert(setup.bodies.end(), placed.begin(), placed.end());
}

}  // namespace osculate
