#pragma once
// The contacts of a time step, many at once: elliptical Hertz, viscous damping along the normal, Mindlin's partial slip
// with memory. What slides is limited by the whole normal force, the dashpot's share included: μ of a spring is
// μ F_n/F_n,elastic, so that F_t ≤ μF_n in approach as at parting.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "osculate/core/vectors.hpp"
#include "osculate/mechanics/material.hpp"
#include "osculate/mechanics/mindlin_memory.hpp"

namespace osculate::mindlin {

/// What a pair of materials brings.
struct Pair {
  double modulus;               ///< Ê [Pa]
  double coupling;              ///< c of the compliance ratio, see `shear_coupling`
  double friction;              ///< μ
  double damping_time;          ///< A [s]: the viscous normal force is A dF_n/dδ dδ/dt
  double damping_factor = 0.0;  ///< α of Tsuji's α (m k)^{1/2} δ^{1/4} dδ/dt, k = F_n/δ^{3/2}, on top          [TTI92]
};

/// Throws InputError unless μ ≥ 0 and A ≥ 0 and the materials are valid.
Pair pair(const ElasticMaterial& material_1, const ElasticMaterial& material_2, double friction, double damping_time);

/// Many contacts of one pair of materials, structure of arrays; all spans of one length. What this does not say is said
/// in `Step`.
struct BatchInput {
  std::span<const double> R_i;  ///< radii of relative curvature, R_i ≥ R_j > 0 [m]; R_i = ∞ is a line contact
  std::span<const double> R_j;
  std::span<const double> overlap;            ///< δ [m]; ≤ 0 is open
  std::span<const double> overlap_rate;       ///< dδ/dt [m/s], positive on approach
  Vectors<const double> normal;               ///< unit, from body 1 to body 2, world
  Vectors<const double> major_axis;           ///< unit tangent along a_c, world
  Vectors<const double> displacement;         ///< of body 2 against body 1 since the last step [m]
  std::span<const double> spin;               ///< [rad]
  std::span<const double> reduced_mass = {};  ///< m [kg]; may be empty where α = 0
};

/// The memories of `width` contacts side by side, as the batch walks them. Trivially copyable; a zero-initialised one
/// holds contacts not yet made. Contact i of a batch is lane i % width of block i / width.
struct alignas(64) MemoryBlock {
  static constexpr std::size_t width = 8;
  using Lanes = std::array<double, width>;

  Lanes overlap{};
  Lanes count{};
  std::array<Lanes, 3> normal{};
  std::array<Lanes, 3> axis{};
  std::array<Lanes, layers> root{};  ///< √η
  std::array<Lanes, layers> x{};
  std::array<Lanes, layers> y{};

  /// One contact's memory, to move it to another place, process or file.
  Memory get(std::size_t lane) const;
  void set(std::size_t lane, const Memory& memory);
};

enum class BatchStatus : std::uint8_t {
  open,       ///< no overlap: no force, nothing remembered
  pressed,    ///< in contact
  bad_input,  ///< a number was NaN, infinite or of the wrong sign: no force, the memory as it was
};

struct BatchOutput {
  Vectors<double> force;              ///< on body 1: −F_n n + F_t [N], world; body 2 feels the opposite
  std::span<double> normal_force;     ///< elastic and viscous, never below 0 [N]
  std::span<double> a_c = {};         ///< [m], may be empty as all below but the status
  std::span<double> axis_ratio = {};  ///< b_c/a_c
  std::span<BatchStatus> status;
  std::span<double> stiffness = {};          ///< dF_n/dδ, elastic [N/m]
  std::span<double> stored_normal = {};      ///< 2/5 F_n δ, elastic [J]
  std::span<double> stored_tangential = {};  ///< see `stored_energy` [J]
  std::span<double> viscous_power = {};      ///< (F_n − elastic) dδ/dt [W]
  std::span<double> friction_loss = {};  ///< in this step [J]: work on the springs less what they store more, by the
                                         ///< trapezoidal rule; all they stored where the contact has opened
};

/// One step of all contacts. A contact's answer does not depend on its neighbours. Throws InputError only when the
/// spans' lengths differ or there are not exactly as many blocks as the contacts fill.
void contacts(const Pair& pair, const BatchInput& input, std::span<MemoryBlock> memory, const BatchOutput& output);

}  // namespace osculate::mindlin
