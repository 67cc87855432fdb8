// Two grains on a floor, their contacts and forces over a few time steps: examples/c/grains.c by the C++ library
// itself.
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "osculate/core/aligned_allocator.hpp"
#include "osculate/geometry/shape_contacts.hpp"
#include "osculate/mechanics/law_registry.hpp"

using namespace osculate;

namespace {

struct Body {
  Shape shape;
  Pose pose;
  double mass;  // [kg]
  Vec3 velocity;
  Vec3 angular_velocity;
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};

using Column = std::vector<double>;

Vectors<double> vectors(std::array<Column, 3>& columns) {
  return {columns[0], columns[1], columns[2]};
}
Vectors<const double> vectors(const ContactColumns& contacts, std::size_t first) {
  const auto column = [&](std::size_t k) { return std::span(contacts.columns[first + k], contacts.size()); };
  return {column(0), column(1), column(2)};
}
Vectors<const double> read_only(const std::array<Column, 3>& columns) {
  return {columns[0], columns[1], columns[2]};
}

void put(const Vec3& value, std::array<Column, 3>& columns, std::size_t k) {
  for (std::size_t c = 0; c < 3; ++c) columns[c][k] = value[static_cast<Eigen::Index>(c)];
}

}  // namespace

int main() {
  std::array bodies{
      Body{HalfSpace{}, {}, std::numeric_limits<double>::infinity(), Vec3::Zero(), Vec3::Zero()},
      Body{Superquadric{{5e-3, 3e-3, 2e-3}, {2.5, 3.0}},
           {{0.0, 0.0, 2.703e-3}, {0.9822618062296308, 0.10023079655404396, 0.15034619483106593, 0.05011539827702198}},
           4e-4,
           Vec3::Zero(),
           {1.0, 2.0, -1.0}},
      Body{Ellipsoid{{4e-3, 3e-3, 2.5e-3}},
           {{2e-3, 1e-3, 7.6662e-3}, {0.8660254037844386, 0.0, 0.5, 0.0}},
           3e-4,
           {0.05, 0.02, -0.01},
           {0.0, 10.0, 5.0}}};
  const ElasticMaterial glass{.youngs_modulus = 71e9, .poissons_ratio = 0.22};
  const ContactLaw law = make_contact_law(
      {{"hertz", {}}, {"tsuji", {{"restitution", 0.8}}}, {"mindlin", {{"friction", 0.4}}}}, glass, glass);

  constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {1, 2}, {0, 2}}};
  constexpr double time_step = 1e-6;  // [s]
  ShapePairs placed;
  ContactCaches caches;
  ContactColumns contacts;
  placed.resize(pairs.size());
  std::vector<double, AlignedAllocator<double>> memory(law.memory_length(pairs.size()));
  const Column column(pairs.size());
  std::array<Column, 3> velocity{column, column, column}, rotation = velocity, force = velocity;
  Column reduced_mass = column, normal_force = column;
  std::vector<LawStatus> status(pairs.size());

  for (int step = 0; step < 3; ++step) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Body &one = bodies[pairs[k][0]], &two = bodies[pairs[k][1]];
      placed.set(k, one.shape, one.pose, two.shape, two.pose);
    }
    common_normals(placed, caches, contacts);

    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Body &one = bodies[pairs[k][0]], &two = bodies[pairs[k][1]];
      const Vec3 point = contacts.get(k).point();
      put(two.velocity + two.angular_velocity.cross(point - two.pose.position) - one.velocity -
              one.angular_velocity.cross(point - one.pose.position),
          velocity, k);
      put(0.5 * (one.angular_velocity + two.angular_velocity), rotation, k);
      reduced_mass[k] = 1.0 / (1.0 / one.mass + 1.0 / two.mass);
    }
    const auto found = [&](std::size_t k) { return std::span<const double>(contacts.columns[k], contacts.size()); };
    law.evaluate({.R_i = found(20),
                  .R_j = found(21),
                  .overlap = found(3),
                  .normal = vectors(contacts, 0),
                  .major_axis = vectors(contacts, 22),
                  .velocity = read_only(velocity),
                  .mean_angular_velocity = read_only(rotation),
                  .reduced_mass = reduced_mass,
                  .time_step = time_step},
                 memory, {.force = vectors(force), .normal_force = normal_force, .status = status});

    for (Body& body : bodies) body.force = body.torque = Vec3::Zero();
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      Body &one = bodies[pairs[k][0]], &two = bodies[pairs[k][1]];
      const Vec3 on_one(force[0][k], force[1][k], force[2][k]), point = contacts.get(k).point();
      one.force += on_one, one.torque += (point - one.pose.position).cross(on_one);
      two.force -= on_one, two.torque -= (point - two.pose.position).cross(on_one);
    }

    // Here a host moves its bodies by its own integrator; these go on as they go.
    for (Body& body : bodies) body.pose.position += body.velocity * time_step;
  }

  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const ContactGeometry contact = contacts.get(k);
    if (contact.status != ContactStatus::touching) continue;
    std::printf("contact %zu %zu %.16e %.16e %.16e %.16e %.16e %.16e %.16e %.16e %.16e\n", pairs[k][0], pairs[k][1],
                contact.normal.x(), contact.normal.y(), contact.normal.z(), contact.overlap, contact.relative.R_i,
                contact.relative.R_j, force[0][k], force[1][k], force[2][k]);
  }
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Vec3 &total = bodies[i].force, &torque = bodies[i].torque;
    std::printf("body %zu %.16e %.16e %.16e %.16e %.16e %.16e\n", i, total.x(), total.y(), total.z(), torque.x(),
                torque.y(), torque.z());
  }
}
