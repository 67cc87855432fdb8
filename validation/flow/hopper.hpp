#pragma once
// Discharge of a wedge hopper through a slot, against the law of Beverloo.                               [BLV61]
//   W = C ρ_b √g L (D − k d)^{3/2}   for a slot of width D and length L

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace osculate::validation {

struct HopperCase {
  std::string shape;        ///< as a scene file has it: "{kind = \"ellipsoid\", half_axes = [3, 3, 2]}", in mm
  double width;             ///< D of the slot [m]
  double gravity = 9.81;    ///< [m/s²]
  std::uint64_t particles;  ///< in the hopper
};

struct Discharge {
  double rate;      ///< W [kg/s], while the hopper is between full and a third full
  double error;     ///< its standard error, from four parts of that time [kg/s]
  double diameter;  ///< d of the sphere of a grain's volume [m]
};

/// The slot is shut by a plate that drops away when the grains have come to rest.
/// @param done  is told now and then how far it is, 0 to 1
/// Throws std::runtime_error if nothing has left the hopper for half a second.
Discharge discharge(const HopperCase& hopper, const std::function<void(double)>& done = {});

/// What a series of widths says of the law.
struct BeverlooFit {
  double k;            ///< of a straight line through W^{2/3} over D
  double scale;        ///< C ρ_b √g L of the same line [kg/(s m^{3/2})]
  double correlation;  ///< of the points along it
  double exponent;     ///< of W over D − 1.4 d, Beverloo's own k
};
/// Throws InputError unless there are three widths at least, all of them above 1.4 d.
BeverlooFit beverloo_fit(const std::vector<double>& widths, const std::vector<Discharge>& discharges);

/// W at a width, by a fit [kg/s].
double beverloo_rate(const BeverlooFit& fit, double diameter, double width);

}  // namespace osculate::validation
