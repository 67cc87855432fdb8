#pragma once
// What of a setup does not change during a run but for the images of a sheared box, in the form in which the loop wants
// it.

#include <array>
#include <set>
#include <vector>

#include "osculate/dynamics/body_shape.hpp"
#include "osculate/dynamics/setup.hpp"

namespace osculate {

struct World {
  Setup setup;
  std::vector<BodyShape> shapes;             ///< the setup's, then the faces of its meshes
  std::vector<BodyStart> starts;             ///< the setup's bodies, then the faces
  std::vector<std::int32_t> first_face;      ///< of each mesh: index of its first body
  std::vector<std::int32_t> law_of;          ///< index into setup.interactions or −1, material by material
  std::vector<double> reach;                 ///< of each interaction: the largest gap at which it acts [m]
  double least_half_width = 0.0;             ///< of all particles [m]
  double least_skin = 0.0, most_skin = 0.0;  ///< of a body: how far it may go between two lists of pairs [m]
  double largest_radius = 0.0;               ///< of all particles' bounding spheres [m]
  double largest_reach = 0.0;                ///< of all interactions [m]
  PeriodicBox box;                           ///< as it is now: a shear moves its images

  std::int32_t law_between(std::int32_t material_1, std::int32_t material_2) const {
    return law_of[static_cast<std::size_t>(material_1) * setup.materials.size() + static_cast<std::size_t>(material_2)];
  }
};

/// Throws InputError as `validate` does.
World make_world(const Setup& setup);

/// Bodies of a kind have the same impacts.
struct BodyKind {
  std::int32_t shape, material;
  bool is_free;
  friend auto operator<=>(const BodyKind&, const BodyKind&) = default;
};
/// Of the bodies that are there and of those that will be poured.
std::set<BodyKind> body_kinds(const World& world);

/// Another body. Throws InputError if a free one has no mass; `where` names it.
void append_body(const World& world, const BodyStart& start, const std::string& where, Bodies& bodies);

/// The bodies at time 0. Throws InputError as `validate` does.
Bodies make_bodies(const World& world);

}  // namespace osculate
