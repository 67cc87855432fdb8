#include "osculate/dynamics/measures.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

std::size_t index_of(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

/// A body and its images in a periodic box that reach into another box.
std::vector<Vec3> images(const PeriodicBox& periodic, const Vec3& position, double radius, const BoxRegion& box) {
  std::vector<Vec3> found = near_images(periodic, wrapped(periodic, position));
  std::erase_if(found, [&](const Vec3& at) {
    return (at - box.upper).maxCoeff() > radius || (box.lower - at).maxCoeff() > radius;
  });
  return found;
}

}  // namespace

Connectivity connectivity(const Simulation& simulation) {
  const Bodies& bodies = simulation.bodies();
  std::vector<int> touching(bodies.size(), 0);
  Connectivity result{};
  std::uint64_t ends = 0, free_ends = 0;
  const std::vector<Contact> contacts = simulation.contacts();
  for (const Contact& contact : contacts) {
    const bool free_1 = bodies.is_free(index_of(contact.body_1)), free_2 = bodies.is_free(index_of(contact.body_2));
    ++touching[index_of(contact.body_1)];
    ++touching[index_of(contact.body_2)];
    ends += (free_1 ? 1 : 0) + (free_2 ? 1 : 0);
    free_ends += free_1 && free_2 ? 2 : 0;
  }
  result.contacts = contacts.size();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.is_free(i)) continue;
    ++result.particles;
    if (touching[i] < 2) ++result.rattlers;
  }
  if (result.particles == 0) return result;
  result.coordination = static_cast<double>(ends) / static_cast<double>(result.particles);
  result.particle_coordination = static_cast<double>(free_ends) / static_cast<double>(result.particles);
  return result;
}

double solid_fraction(const Simulation& simulation, const Region& region, int per_axis) {
  validate(region);
  if (per_axis < 1) throw InputError("solid fraction", std::to_string(per_axis) + " points an axis", "1 or more");
  const BoxRegion box = bounds(region);
  const auto count = static_cast<Eigen::Index>(per_axis);
  const Vec3 cell = (box.upper - box.lower) / per_axis;
  const auto point = [&](Eigen::Index i, Eigen::Index j, Eigen::Index k) -> Vec3 {
    return box.lower + cell.cwiseProduct(Vec3(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5,
                                              static_cast<double>(k) + 0.5));
  };
  std::vector<char> solid(static_cast<std::size_t>(count * count * count), 0);
  const Bodies& bodies = simulation.bodies();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyShape& shape = simulation.shapes()[index_of(bodies.shape[b])];
    if (!is_particle(shape.shape)) continue;
    for (const Vec3& at : images(simulation.box(), bodies.position[b], shape.bounding_radius, box)) {
      const Pose pose = shape_pose(shape, {.position = at, .orientation = bodies.orientation[b]});
      Eigen::Array<Eigen::Index, 3, 1> first, last;
      for (Eigen::Index k = 0; k < 3; ++k) {
        const double low = (at[k] - shape.bounding_radius - box.lower[k]) / cell[k] - 0.5;
        const double high = (at[k] + shape.bounding_radius - box.lower[k]) / cell[k] - 0.5;
        first[k] = static_cast<Eigen::Index>(std::clamp(std::ceil(low), 0.0, static_cast<double>(count)));
        last[k] = static_cast<Eigen::Index>(std::clamp(std::floor(high) + 1.0, 0.0, static_cast<double>(count)));
      }
      for (Eigen::Index k = first[2]; k < last[2]; ++k)
        for (Eigen::Index j = first[1]; j < last[1]; ++j)
          for (Eigen::Index i = first[0]; i < last[0]; ++i) {
            char& filled = solid[static_cast<std::size_t>((k * count + j) * count + i)];
            if (filled == 0 && gauge(shape.shape, pose.to_body(point(i, j, k))).value <= 1.0) filled = 1;
          }
    }
  }
  std::uint64_t inside = 0, filled = 0;
  for (Eigen::Index k = 0; k < count; ++k)
    for (Eigen::Index j = 0; j < count; ++j)
      for (Eigen::Index i = 0; i < count; ++i) {
        if (!contains(region, point(i, j, k))) continue;
        ++inside;
        filled += static_cast<std::uint64_t>(solid[static_cast<std::size_t>((k * count + j) * count + i)]);
      }
  if (inside == 0) throw InputError("solid fraction", "no lattice point in the region", "more points an axis");
  return static_cast<double>(filled) / static_cast<double>(inside);
}

Stress stress(const Simulation& simulation, double volume) {
  if (!(volume > 0.0) || !std::isfinite(volume))
    throw InputError("stress", "a volume of " + std::to_string(volume) + " m³", "a finite value > 0");
  const Bodies& bodies = simulation.bodies();
  Stress result{.contact = Mat3::Zero(), .streaming = Mat3::Zero()};
  for (const Contact& contact : simulation.contacts()) {
    const std::size_t one = index_of(contact.body_1), two = index_of(contact.body_2);
    Vec3 branch = contact.branch;
    if (!bodies.is_free(two)) branch = contact.point - bodies.position[one];
    if (!bodies.is_free(one)) branch += bodies.position[one] - contact.point;
    result.contact += contact.force * branch.transpose() / volume;
  }
  // Velocities against the flow of a sheared box: those of the images are the same.
  const auto own_velocity = [&](std::size_t i) -> Vec3 {
    return bodies.velocity[i] - image_velocity(simulation.box(), bodies.position[i]);
  };
  double mass = 0.0;
  Vec3 momentum = Vec3::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.is_free(i)) continue;
    mass += bodies.mass[i];
    momentum += bodies.mass[i] * own_velocity(i);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.is_free(i)) continue;
    const Vec3 velocity = own_velocity(i) - momentum / mass;
    result.streaming -= bodies.mass[i] * velocity * velocity.transpose() / volume;
  }
  return result;
}

Mat3 fabric(const Simulation& simulation) {
  Mat3 sum = Mat3::Zero();
  const std::vector<Contact> contacts = simulation.contacts();
  for (const Contact& contact : contacts) sum += contact.normal * contact.normal.transpose();
  return contacts.empty() ? sum : Mat3(sum / static_cast<double>(contacts.size()));
}

}  // namespace osculate
