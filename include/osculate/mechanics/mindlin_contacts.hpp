#pragma once
// The contacts of a time step, many at once: elliptical Hertz, viscous damping along the normal, Mindlin's partial slip
// with memory.

#include <cstdint>
#include <span>

#include "osculate/mechanics/material.hpp"
#include "osculate/mechanics/mindlin_memory.hpp"

namespace osculate::mindlin {

/// What a pair of materials brings.
struct Pair {
  double modulus;       ///< Ê [Pa]
  double coupling;      ///< c of the compliance ratio, see `shear_coupling`
  double friction;      ///< μ
  double damping_time;  ///< A [s]: the viscous normal force is A dF_n/dδ dδ/dt
};

/// Throws InputError unless μ ≥ 0 and A ≥ 0 and the materials are valid.
Pair pair(const ElasticMaterial& material_1, const ElasticMaterial& material_2, double friction, double damping_time);

/// One contact of a batch; what it does not say is said in `Step`.
struct ContactInput {
  double R_i;  ///< radii of relative curvature, R_i ≥ R_j > 0 [m]; R_i = ∞ is a line contact
  double R_j;
  double overlap;                     ///< δ [m]; ≤ 0 is open
  double overlap_rate;                ///< dδ/dt [m/s], positive on approach
  std::array<double, 3> normal;       ///< unit, from body 1 to body 2, world
  std::array<double, 3> major_axis;   ///< unit tangent along a_c, world
  std::array<double, 3> displacement;  ///< of body 2 against body 1 since the last step [m]
  double spin;                        ///< see `Step` [rad]
};

enum class BatchStatus : std::uint8_t {
  open,       ///< no overlap: no force, nothing remembered
  pressed,    ///< in contact
  bad_input,  ///< a number was NaN, infinite or of the wrong sign: no force, the memory as it was
};

struct ContactOutput {
  std::array<double, 3> force;  ///< on body 1: −F_n n + F_t [N], world; body 2 feels the opposite
  double normal_force;          ///< elastic and viscous, never below 0 [N]
  double a_c;                   ///< [m]
  double axis_ratio;            ///< b_c/a_c
  BatchStatus status;
};

/// All contacts of one pair of materials. Friction is limited by the elastic part of the normal force, which is the one
/// that the memory knows. A contact's answer does not depend on its neighbours. Throws InputError only when the spans'
/// lengths differ.
void contacts(const Pair& pair, std::span<const ContactInput> input, std::span<Memory> memory,
              std::span<ContactOutput> output);

}  // namespace osculate::mindlin
