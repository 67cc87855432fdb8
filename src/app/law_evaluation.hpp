#pragma once
// A law of the registry evaluated for one contact: at a state, along a sweep, along a load path.

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/number_table.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::app {

/// A number that is the contact's, not the law's.
struct ContactKey {
  std::string_view name, symbol, unit, meaning;
  double standard;
};
inline constexpr double like_body_1 = std::numeric_limits<double>::quiet_NaN();
/// Materials, geometry, state and motion; a load path may give those of `load_columns`.
inline constexpr std::array contact_keys{
    ContactKey{"E", "E", "Pa", "Young's modulus of body 1", 71e9},
    ContactKey{"nu", "ν", "", "Poisson's ratio of body 1", 0.22},
    ContactKey{"E_2", "E_2", "Pa", "Young's modulus of body 2", like_body_1},
    ContactKey{"nu_2", "ν_2", "", "Poisson's ratio of body 2", like_body_1},
    ContactKey{"R_i", "R_i", "m", "larger radius of relative curvature", 2e-3},
    ContactKey{"R_j", "R_j", "m", "smaller radius of relative curvature", 1e-3},
    ContactKey{"effective_radius", "R", "m", "R_1 R_2/(R_1 + R_2) of the volume-equivalent spheres", 1e-3},
    ContactKey{"reduced_mass", "m", "kg", "m_1 m_2/(m_1 + m_2)", 1e-5},
    ContactKey{"overlap", "δ", "m", "overlap", 1e-6},
    ContactKey{"x", "x", "m", "tangential displacement of body 2 along the major axis", 0.0},
    ContactKey{"y", "y", "m", "the same along the minor axis", 0.0},
    ContactKey{"twist", "φ", "rad", "turn of body 2 about the normal", 0.0},
    ContactKey{"rate", "dδ/dt", "m/s", "speed of approach, beside that of the path", 0.0},
    ContactKey{"slip", "v_x", "m/s", "sliding speed of body 2 along the major axis, beside that of the path", 0.0},
    ContactKey{"spin", "ω_z", "rad/s", "spin of body 2 about the normal, likewise", 0.0},
    ContactKey{"rolling", "V", "m/s", "speed of the contact over the bodies along the major axis; 1 with a rolling law",
               0.0},
    ContactKey{"time_step", "Δt", "s", "time between two states", 1e-6},
};
inline constexpr std::array<std::string_view, 5> load_columns{"time", "overlap", "x", "y", "twist"};

/// A law with the contact it is evaluated for.
struct LawCase {
  LawChoice choice;
  std::map<std::string, double, std::less<>> contact;  ///< by key, all of them
};

/// Sorts `assignments` ("key=value") into the contact's and the laws' numbers. A parameter that several laws share is
/// given to each, "law.key" to one. Where no normal law is
/// named, the first that goes with the others is taken: hertz, if it does.
/// Throws InputError for what is no assignment, an unknown law or key, a value that is no number.
LawCase law_case(const std::vector<std::string>& laws, const std::vector<std::string>& assignments);

/// "key=value".
std::pair<std::string, double> assignment_of(const std::string& text);

/// `count` ≥ 2 numbers from one to the other.
std::vector<double> spaced(double from, double to, std::size_t count);

/// Sets one number of a case, as in law_case.
void set(LawCase& law_case, const std::string& key, double value);

/// key=from:to:n[:log]
struct Sweep {
  std::string key;
  std::vector<double> values;
};
Sweep sweep_of(const std::string& text);

/// States one after the other through one contact's memory; starts from no displacement at the first overlap. Columns:
/// those of the path, then force and what else the law says, losses summed from the start.
/// @param path  columns of `load_columns`; what is missing stays as in the case
io::NumberTable along(const LawCase& law_case, const io::NumberTable& path);

/// A swept overlap, displacement or twist is a path; for every other key each value is a contact of its own.
io::NumberTable swept(const LawCase& law_case, const Sweep& sweep);

/// The path that shows a law of this slot: loading and unloading, a cycle to and fro; nothing where a sweep of the
/// motion shows it, see `usual_sweep`.
std::optional<io::NumberTable> usual_path(const LawCase& law_case, LawSlot slot);
Sweep usual_sweep(const LawCase& law_case, LawSlot slot);

}  // namespace osculate::app
