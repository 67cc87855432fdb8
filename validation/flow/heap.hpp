#pragma once
// The angle of a heap that a lifted tube leaves.

#include <cstdint>
#include <functional>
#include <vector>

#include "osculate/core/types.hpp"

namespace osculate::validation {

struct HeapCase {
  double friction;  ///< μ between grains and with floor and tube
  double exponent;  ///< n of the grains, superquadrics of half-axes 2 : 2 : 3
  std::uint64_t seed = 1;
  std::uint64_t grains = 300;
};

/// The slope of the cone that has the same medians of distance from the axis and of height as the grains' centroids
/// have above the floor: r = R/2, z = (1 − 2^{−1/3}) H, tan θ = H/R. Single grains that roll away do not count. [rad]
double cone_angle(const std::vector<Vec3>& centroids);

/// @param done  is told now and then how far it is, 0 to 1
double heap_angle(const HeapCase& heap, const std::function<void(double)>& done = {});

}  // namespace osculate::validation
