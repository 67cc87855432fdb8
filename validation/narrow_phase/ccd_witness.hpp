#pragma once
// Penetration by libccd, on the plain support functions: a second opinion that knows nothing of superquadrics.

#include <optional>

#include "osculate/core/types.hpp"
#include "validation/narrow_phase/random_pairs.hpp"

namespace osculate::validation {

struct CcdPenetration {
  double depth;  ///< [m]
  Vec3 normal;   ///< from body 1 to body 2
};

/// GJK and EPA (ccdGJKPenetration): the distance to the nearest face of a polytope inscribed in the difference body. It
/// is a lower bound: depth ≤ true depth, short of it by about √tolerance R_vol of the smaller body (libccd holds
/// `tolerance` against squares). Where libccd gives up on degenerate faces it falls short by more: about one pair in a
/// thousand. Nothing if it finds no overlap or fails.
std::optional<CcdPenetration> ccd_gjk_epa(const Pair& pair, double tolerance);

/// Minkowski portal refinement (ccdMPRPenetration): the overlap along the portal's normal near the centre line. It is
/// no minimum: depth ≥ true depth − tolerance · R_vol.
std::optional<CcdPenetration> ccd_mpr(const Pair& pair, double tolerance);

}  // namespace osculate::validation
