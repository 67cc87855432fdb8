#include "dynamics/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/geometry/common_normal.hpp"

namespace osculate {
namespace {

void require(bool sound, const std::string& where, const std::string& found, const std::string& expected) {
  if (!sound) throw InputError(where, found, expected);
}

}  // namespace

Crowd::Crowd(std::span<const BodyShape> shapes, const PeriodicBox& box, double gap)
    : shapes_(shapes), box_(box), gap_(gap) {
  for (const BodyShape& shape : shapes)
    if (is_particle(shape.shape)) largest_ = std::max(largest_, shape.bounding_radius);
}

void Crowd::add(std::int32_t shape, const Pose& pose) {
  const Member member{shape, pose};
  if (is_particle(shape_of(member).shape))
    particles_[cell_of(wrapped(box_, pose.position))].push_back(member);
  else
    walls_.push_back(member);
}

bool Crowd::has_room_for(std::int32_t shape, const Pose& pose) const {
  const Member body{shape, pose};
  if (std::any_of(walls_.begin(), walls_.end(), [&](const Member& wall) { return touches(body, wall); })) return false;
  for (const Vec3& image : nearby_images(pose.position)) {
    const Member moved{shape, {image, pose.orientation}};
    const Cell middle = cell_of(image);
    for (std::int64_t k = 0; k < 27; ++k) {
      const auto found = particles_.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
      if (found != particles_.end() && std::any_of(found->second.begin(), found->second.end(),
                                                   [&](const Member& other) { return touches(moved, other); }))
        return false;
    }
  }
  return true;
}

Crowd::Cell Crowd::cell_of(const Vec3& point) const {
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k)
    cell[k] = static_cast<std::int64_t>(std::floor(point[static_cast<Eigen::Index>(k)] / cell_size()));
  return cell;
}

/// The point in the box, and where it repeats next to the box.
std::vector<Vec3> Crowd::nearby_images(const Vec3& position) const {
  std::vector<Vec3> images{wrapped(box_, position)};
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (!std::isfinite(box_.length[k])) continue;
    const std::size_t count = images.size();
    for (std::size_t i = 0; i < count; ++i)
      for (const double side : {-1.0, 1.0}) {
        Vec3 image = images[i];
        image[k] += side * box_.length[k];
        const double outside = std::max(box_.origin[k] - image[k], image[k] - box_.origin[k] - box_.length[k]);
        if (outside <= cell_size()) images.push_back(image);
      }
  }
  return images;
}

bool Crowd::touches(const Member& one, const Member& other) const {
  const BodyShape &shape_1 = shape_of(one), &shape_2 = shape_of(other);
  if (shape_2.is_face()) {
    const SurfaceFace& face = shape_2.surface->faces[static_cast<std::size_t>(shape_2.face)];
    if (distance_to(face, other.pose.to_body(one.pose.position)) > shape_1.bounding_radius + gap_) return false;
    const Vec3 from_face = one.pose.position - other.pose.to_world(face.corners[0]);
    const Vec3 normal = other.pose.rotate_to_world(face.normal);
    const Pose particle = shape_pose(shape_1, one.pose);
    const Vec3 towards = normal.dot(from_face) > 0.0 ? Vec3(-normal) : normal;
    const Vec3 nearest = particle.to_world(support_point(shape_1.shape, particle.rotate_to_body(towards)));
    return towards.dot(nearest - other.pose.to_world(face.corners[0])) >= -gap_;
  }
  Pose near = other.pose;
  if (is_particle(shape_2.shape)) {
    near.position = wrapped(box_, near.position);
    const double reach = shape_1.bounding_radius + shape_2.bounding_radius + gap_;
    if ((near.position - one.pose.position).squaredNorm() > reach * reach) return false;
  }
  ContactCache cache;
  const ContactGeometry contact =
      common_normal(shape_1.shape, shape_pose(shape_1, one.pose), shape_2.shape, shape_pose(shape_2, near), cache,
                    gap_ > 0.0 ? Gap::resolve : Gap::skip);
  // Where nothing can be said for certain there is no room.
  return !(is_resolved(contact.status) && contact.overlap < -gap_);
}

std::optional<Pose> random_place(const Crowd& crowd, const Region& region, std::int32_t shape, int tries,
                                 Random& random) {
  const BoxRegion box = bounds(region);
  for (int tried = 0; tried < tries; ++tried) {
    const double x = random.uniform(box.lower.x(), box.upper.x()), y = random.uniform(box.lower.y(), box.upper.y()),
                 z = random.uniform(box.lower.z(), box.upper.z());
    const Pose pose{.position = {x, y, z}, .orientation = random.orientation()};
    if (contains(region, pose.position) && crowd.has_room_for(shape, pose)) return pose;
  }
  return std::nullopt;
}

void check_kinds(const Setup& setup, const std::vector<Kind>& kinds, const std::string& where) {
  require(!kinds.empty(), where, "no kinds of particles", "one at least");
  double weights = 0.0;
  for (const Kind& kind : kinds) {
    require(kind.shape >= 0 && static_cast<std::size_t>(kind.shape) < setup.shapes.size(), where,
            "shape " + std::to_string(kind.shape), "one of " + std::to_string(setup.shapes.size()));
    require(is_particle(setup.shapes[static_cast<std::size_t>(kind.shape)]), where,
            "shape " + std::to_string(kind.shape) + ", a wall", "a particle");
    require(kind.material >= 0 && static_cast<std::size_t>(kind.material) < setup.materials.size(), where,
            "material " + std::to_string(kind.material), "one of " + std::to_string(setup.materials.size()));
    require(kind.weight >= 0.0 && std::isfinite(kind.weight), where, "weight " + std::to_string(kind.weight),
            "a finite value >= 0");
    weights += kind.weight;
  }
  require(weights > 0.0, where, "weights that add up to zero", "one above zero");
}

void check_numbers(double gap, int tries, const Vec3& velocity, double fluctuation, const std::string& where) {
  require(gap >= 0.0 && std::isfinite(gap), where, "gap " + std::to_string(gap) + " m", "a finite value >= 0");
  require(tries >= 1, where, std::to_string(tries) + " tries", "1 or more");
  require(velocity.allFinite() && fluctuation >= 0.0 && std::isfinite(fluctuation), where,
          "a velocity that is not finite", "finite numbers, a fluctuation >= 0");
}

std::vector<double> weights_of(const std::vector<Kind>& kinds) {
  std::vector<double> weights;
  for (const Kind& kind : kinds) weights.push_back(kind.weight);
  return weights;
}

Vec3 random_velocity(const Vec3& mean, double fluctuation, Random& random) {
  const double u = random.normal(), v = random.normal(), w = random.normal();
  return mean + fluctuation * Vec3(u, v, w);
}

}  // namespace osculate
