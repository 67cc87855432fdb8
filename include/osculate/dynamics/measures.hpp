#pragma once
// What an assembly of particles is like as a whole.

#include "osculate/dynamics/insertion.hpp"
#include "osculate/dynamics/simulation.hpp"

namespace osculate {

/// How particles are connected; averages are 0 where there are none.
struct Connectivity {
  std::uint64_t particles;       ///< free bodies
  std::uint64_t contacts;        ///< between any two bodies
  double coordination;           ///< contacts of a free body, counting those with walls, on average
  double particle_coordination;  ///< the same, between free bodies only
  std::uint64_t rattlers;        ///< free bodies with fewer than two contacts
};
Connectivity connectivity(const Simulation& simulation);

/// The share of a region's volume that lies inside particles, from a lattice of `per_axis`³ points over its bounding
/// box (those inside the region count). The error is of the order of 1/per_axis times the ratio of a particle's surface
/// to its volume times the region's size, and mostly far smaller. Throws InputError for a region without volume or
/// per_axis < 1.
double solid_fraction(const Simulation& simulation, const Region& region, int per_axis);

/// The stress in a volume V [Pa], pressure negative:
///   σ = 1/V Σ_c f ⊗ l,   f the force on body 1, l its branch to body 2, over contacts between free bodies (l between
///   the centroids) and of free bodies with driven ones (l from the centroid to the contact point) [CSR81]
/// The kinetic part −1/V Σ m v ⊗ v is `streaming`, with velocities against the mean, and against the flow of a sheared
/// box.
struct Stress {
  Mat3 contact;
  Mat3 streaming;
  double pressure() const { return -(contact + streaming).trace() / 3.0; }
};
Stress stress(const Simulation& simulation, double volume);

/// Second-order fabric tensor 1/N Σ n ⊗ n over all contacts; the trace is 1. Zero without contacts.        [Satake82]
Mat3 fabric(const Simulation& simulation);

}  // namespace osculate
