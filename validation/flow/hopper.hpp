#pragma once
// Discharge of a wedge hopper through a slot, against the law of Beverloo.                               [BLV61]
//   W = C ρ_b √g L (D − k d)^{3/2}   for a slot of width D and length L

#include <cstdint>
#include <functional>
#include <vector>

namespace osculate::validation {

/// d of the hopper's grains, the diameter of the sphere of an ellipsoid 3 : 3 : 2 mm [m]
double hopper_grain_diameter();
/// A bin fifteen diameters wide above the wedge. [m]
inline constexpr double hopper_bin_width = 0.078;

struct HopperCase {
  double width;             ///< D of the slot [m]
  double gravity = 9.81;    ///< [m/s²]
  std::uint64_t particles;  ///< in the hopper
  std::uint64_t seed = 1;
};

/// What leaves, in time. Entries are a millisecond apart, from the opening of the slot on.
struct Outflow {
  std::vector<double> times;    ///< [s]
  std::vector<double> masses;   ///< that have left [kg]
  std::vector<double> heights;  ///< of the filling above the slot [m]: of the centroids that lie below 95 % of it
  double total = 0.0;           ///< mass in the hopper at first [kg]
  double overlap = 0.0;         ///< mean of grains on grains when the slot opens [m]
};

/// A plate shuts the slot until the grains have come to rest, and drops away. Ends when the filling is no higher than
/// the bin is wide.
/// @param done  is told now and then how far it is, 0 to 1
/// Throws std::runtime_error if nothing leaves for half a second.
Outflow outflow(const HopperCase& hopper, const std::function<void(double)>& done = {});

/// A rate of flow [kg/s].
struct Discharge {
  double rate;
  double error;  ///< its standard error, from parts of the time
};

/// While the flow is steady: from when a tenth has left until the filling is no higher than the bin is wide.
/// Throws std::runtime_error if that is too short to tell.
Discharge steady_discharge(const Outflow& out);

/// Mean of several hoppers alike, one at least. Its error is what their differences give it, or their own errors where
/// those give more: three of a kind may agree by chance.
Discharge mean_discharge(const std::vector<Discharge>& discharges);

/// What a series of widths says of the law.
struct BeverlooFit {
  double k;               ///< of a straight line through W^{2/3} over D
  double k_error;         ///< that the errors of the rates give it
  double scale;           ///< C ρ_b √g L of the same line [kg/(s m^{3/2})]
  double correlation;     ///< of the points along it
  double exponent;        ///< of W over D − 1.4 d, Beverloo's own k
  double exponent_error;  ///< in the same way
};
/// Throws InputError unless there are three widths at least, all of them above 1.4 d.
BeverlooFit beverloo_fit(const std::vector<double>& widths, const std::vector<Discharge>& discharges, double diameter);

/// W at a width, by a fit [kg/s].
double beverloo_rate(const BeverlooFit& fit, double diameter, double width);

}  // namespace osculate::validation
