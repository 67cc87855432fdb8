#pragma once
// Units as people write them in files. Inside the program everything is SI.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osculate::io {

struct Unit {
  std::string_view symbol;
  double in_si;  ///< one such unit in SI
};

/// A kind of quantity and the units it may be written in; the first is the SI unit.
struct Dimension {
  std::string_view name;
  std::vector<Unit> units;

  /// The SI value of one `symbol`, or nothing if the dimension has no such unit.
  std::optional<double> in_si(std::string_view symbol) const;
  /// "m, cm, mm …", for error messages.
  std::string symbols() const;
};

const Dimension& length();            ///< m, cm, mm, um, µm, nm, in
const Dimension& pressure();          ///< Pa, kPa, MPa, GPa
const Dimension& density();           ///< kg/m3, g/cm3
const Dimension& velocity();          ///< m/s, cm/s, mm/s
const Dimension& angular_velocity();  ///< rad/s, deg/s, rpm
const Dimension& angle();             ///< rad, deg
const Dimension& acceleration();      ///< m/s2
const Dimension& frequency();         ///< Hz, kHz, rpm
const Dimension& force();             ///< N, kN, mN, uN
const Dimension& duration();          ///< s, ms, us, ns
const Dimension& surface_energy();    ///< J/m2, mJ/m2
const Dimension& shear_rate();        ///< 1/s
const Dimension& mass_rate();         ///< kg/s, g/s, kg/min, t/h

/// The unit out of m, mm, µm and nm in which a length reads as 0.5 to 500.
Unit suitable_length(double metres);

}  // namespace osculate::io
