#pragma once
// A law of contact: how two bodies that touch push, rub and turn each other. Composed of parts by make_contact_law
// (law_registry.hpp), bound to a pair of materials, evaluated for all contacts of a time step at once.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "osculate/core/vectors.hpp"

namespace osculate {

/// The contacts of one step, structure of arrays; all spans of one length, those marked optional may be empty unless
/// the law needs them (ContactLaw::needs). SI units, world frame, normals from body 1 to body 2.
struct LawInput {
  std::span<const double> R_i;       ///< radii of relative curvature, R_i ≥ R_j > 0; R_i = ∞ is a line contact
  std::span<const double> R_j;       ///< [m]
  std::span<const double> overlap;   ///< δ [m]; ≤ 0 is a gap
  Vectors<const double> normal;      ///< unit
  Vectors<const double> major_axis;  ///< unit tangent along R_i, sign free
  Vectors<const double> velocity;    ///< of body 2 against body 1 at the contact point [m/s]
  Vectors<const double> angular_velocity = {};  ///< of body 2 against body 1 [rad/s], optional
  Vectors<const double> mean_angular_velocity =
      {};                                         ///< half the sum of both bodies' [rad/s], optional: turns the memory
  std::span<const double> reduced_mass = {};      ///< m1 m2/(m1 + m2) [kg], optional
  std::span<const double> effective_radius = {};  ///< R1 R2/(R1 + R2) of the volume-equivalent spheres [m], optional
  std::span<const double> smallest_radius = {};   ///< least principal radius of both bodies [m], optional: where it is
                                                  ///< given, contacts too large for a half-space theory are said [FO57]
  double time_step = 0.0;                         ///< since the last evaluation [s]

  LawInput part(std::size_t start, std::size_t count) const;
};

enum class LawStatus : std::uint8_t {
  open,           ///< no contact: no force, nothing remembered
  closed,         ///< in contact; an adhesive one may pull, also across a gap
  large_contact,  ///< closed, and a_c ≥ half the smallest radius: the numbers are the theory's all the same
  not_converged,  ///< an inner search ran out of steps; the numbers are its last
  bad_input,      ///< a number was NaN, infinite or of the wrong sign: no force, the memory as it was
};
std::string_view name(LawStatus status);

/// What the law says; spans of the input's length, those marked optional may be empty and then cost nothing.
struct LawOutput {
  Vectors<double> force;           ///< on body 1 at the contact point [N]; body 2 feels the opposite
  Vectors<double> couple = {};     ///< on body 1 [N m], of twisting and rolling; optional unless the law makes couples
  std::span<double> normal_force;  ///< F_n [N], elastic and viscous; > 0 pushes the bodies apart
  std::span<LawStatus> status;
  std::span<double> a_c = {};                ///< major semi-axis [m], optional
  std::span<double> axis_ratio = {};         ///< b_c/a_c, optional; 0 where there is no contact
  std::span<double> stiffness = {};          ///< dF_n/dδ of the elastic part [N/m], optional: for the time step
  std::span<double> stored_normal = {};      ///< energy that unloading gives back [J], optional
  std::span<double> stored_tangential = {};  ///< of the tangential, twisting and rolling springs [J], optional
  // Energy lost in this step [J], optional. What is stored and lost is what the force took from the motion, to second
  // order in the step. A tangential spring whose stiffness follows the overlap gives energy where it stiffens under
  // load; that energy is in `friction_loss` with a minus, so that the sum stays right.
  std::span<double> viscous_loss = {};
  std::span<double> friction_loss = {};    ///< slip in all directions
  std::span<double> hysteresis_loss = {};  ///< plastic flow, adhesive snap-off

  LawOutput part(std::size_t start, std::size_t count) const;
};

/// Which optional columns of the input a law reads.
struct LawNeeds {
  bool angular_velocity = false;
  bool mean_angular_velocity = false;
  bool reduced_mass = false;
  bool effective_radius = false;
};

/// Contacts a block of memory holds side by side.
inline constexpr std::size_t law_lanes = 8;

/// How a law works on the contacts of one part of the batch. Sizes have been checked.
using LawEvaluation = std::function<void(const LawInput&, double* memory, const LawOutput&)>;

/// A law bound to a pair of materials. A value: copies are independent, and evaluation from several threads is safe.
///
/// Memory. A contact remembers `memory_size()` doubles. Contacts lie side by side in blocks of `law_lanes`: entry m of
/// contact i is memory[(i/8·memory_size() + m)·8 + i%8], aligned to 64 bytes. All zeros is a contact not yet made, and
/// what an open contact is set back to; moving, storing or sending a memory is copying its doubles.
class ContactLaw {
 public:
  struct Traits {
    std::size_t memory_size = 0;
    LawNeeds needs;
    bool makes_couples = false;
    std::function<double(double R_i, double R_j)> range = {};  ///< see interaction_range; none where it is 0
  };
  ContactLaw(const Traits& traits, LawEvaluation evaluation);

  std::size_t memory_size() const { return traits_.memory_size; }
  /// Doubles that the memory of `contacts` contacts takes: whole blocks.
  std::size_t memory_length(std::size_t contacts) const;
  const LawNeeds& needs() const { return traits_.needs; }
  bool makes_couples() const { return traits_.makes_couples; }
  /// The largest gap at which a contact of these radii may still act [m]: 0 without adhesion or roughness. The contact
  /// list must hold such pairs.
  double interaction_range(double R_i, double R_j) const;

  /// One step of all contacts. A contact's answer does not depend on its neighbours. Throws InputError when a column
  /// that the law needs is missing, lengths differ, the memory is not memory_length(n) long or the time step is not a
  /// finite number ≥ 0; trouble with a single contact is its status.
  void evaluate(const LawInput& input, std::span<double> memory, const LawOutput& output) const;

 private:
  Traits traits_;
  LawEvaluation evaluation_;
};

}  // namespace osculate
