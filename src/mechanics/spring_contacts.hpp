#pragma once
// The contacts of a time step, many at once: elliptical Hertz, a dashpot along the normal, and one tangential spring
// with dashpot and slider ("history friction").

#include "osculate/mechanics/contact_law.hpp"

namespace osculate::spring_contacts {

enum class Friction { none, spring };

/// What a pair of materials brings. Dashpot along the normal: A dF/dδ + α (m k)^{1/2} δ^{1/4}, as in mindlin::Pair.
struct Pair {
  Friction kind = Friction::none;     ///< without friction nothing is remembered
  double modulus;                     ///< Ê [Pa]
  double damping_time = 0.0;          ///< A [s]
  double damping_factor = 0.0;        ///< α
  double friction = 0.0;              ///< μ
  double tangential_stiffness = 0.0;  ///< constant part of k_t [N/m]
  double stiffness_ratio = 0.0;       ///< the part that follows the contact: k_t/(dF_n/dδ)
  double tangential_damping = 0.0;    ///< c_t [N s/m]
};

/// Memory as in laws/spring.hpp, none without friction. Sizes have been checked; the reduced mass is there where α > 0.
void evaluate(const Pair& pair, const LawInput& input, double* memory, const LawOutput& output);

}  // namespace osculate::spring_contacts
