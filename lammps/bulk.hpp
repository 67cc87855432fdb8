#pragma once
// What a scene has become at its end, on the library's own engine and on LAMMPS, over several beginnings.

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "io/scene.hpp"

namespace osculate::lammps {

struct BulkQuantity {
  std::string_view name;
  int decimals;
};
inline constexpr std::array<BulkQuantity, 9> bulk_quantities{{{"solid fraction", 4},
                                                              {"contacts a particle, walls counted", 3},
                                                              {"contacts a particle, of particles", 3},
                                                              {"share with fewer than two contacts", 4},
                                                              {"kinetic and rotational energy [mJ]", 6},
                                                              {"gravity's energy [mJ]", 4},
                                                              {"energy stored along normals [mJ]", 5},
                                                              {"energy lost to viscosity [mJ]", 4},
                                                              {"energy lost to friction [mJ]", 4}}};
using Bulk = std::array<double, bulk_quantities.size()>;

/// Mean and its standard error over the beginnings.
struct Estimate {
  double mean, error;
};
Estimate estimate(const std::vector<Bulk>& bulks, std::size_t quantity);

/// The difference of two means in standard errors of the difference: Welch's t.
double difference_in_errors(const Estimate& one, const Estimate& two);

/// One engine's, from every beginning.
using Ensemble = std::vector<Bulk>;

struct BulkOrders {
  std::vector<int> ranks;
  int beginnings;  ///< 2 at least
};

/// The library's engine first, then LAMMPS on each number of ranks; on the first rank, to which all come. Beginnings
/// differ by velocities added at random to the scene's. `progress` is told the share that is done, on the first rank.
/// Throws InputError for a scene without output.fraction_region.
std::vector<Ensemble> run_ensembles(const io::Scene& scene, const BulkOrders& orders,
                                    const std::function<void(double)>& progress);

}  // namespace osculate::lammps
