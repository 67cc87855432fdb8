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

/// GJK and EPA (ccdGJKPenetration): the depth of a polytope inscribed in the difference body, refined until a new
/// support point gains less than `tolerance` (relative to the smaller body's R_vol). EPA refines the nearest face of
/// its polytope, so that depth ≤ true depth ≤ depth + tolerance · R_vol where it converges on the right face; where
/// libccd gives up early (degenerate faces) its answer may be far off on either side. Nothing if it finds no overlap or
/// fails.
std::optional<CcdPenetration> ccd_gjk_epa(const Pair& pair, double tolerance);

/// Minkowski portal refinement (ccdMPRPenetration): the overlap along the portal's normal near the centre line. It is
/// no minimum: depth ≥ true depth − tolerance · R_vol.
std::optional<CcdPenetration> ccd_mpr(const Pair& pair, double tolerance);

}  // namespace osculate::validation
