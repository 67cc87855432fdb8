#pragma once
// What of a setup does not change during a run, in the form in which the loop wants it.

#include <array>
#include <vector>

#include "osculate/dynamics/body_shape.hpp"
#include "osculate/dynamics/setup.hpp"

namespace osculate {

struct World {
  Setup setup;
  std::vector<BodyShape> shapes;
  std::vector<std::int32_t> law_of;  ///< index into setup.interactions or −1, material by material
  std::vector<double> reach;         ///< of each interaction: the largest gap at which it acts [m]
  double least_half_width = 0.0;     ///< of all particles [m]
  double skin = 0.0;                 ///< [m]

  std::int32_t law_between(std::int32_t material_1, std::int32_t material_2) const {
    return law_of[static_cast<std::size_t>(material_1) * setup.materials.size() + static_cast<std::size_t>(material_2)];
  }
};

/// Throws InputError as `validate` does.
World make_world(const Setup& setup);

/// The bodies at time 0. Throws InputError as `validate` does.
Bodies make_bodies(const World& world);

}  // namespace osculate
