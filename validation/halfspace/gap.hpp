#pragma once
// The true gap between two bodies around their contact point, not its quadratic approximation.

#include <functional>
#include <vector>

#include "osculate/geometry/contact_geometry.hpp"
#include "osculate/shapes/shape.hpp"
#include "validation/halfspace/solver.hpp"

namespace osculate::validation::halfspace {

/// How far apart the two surfaces are, above the point (x, y) of the contact plane, once the bodies just touch; x runs
/// along the direction of R_i. Beyond the outline of a body: ∞.
using GapField = std::function<double(double x, double y)>;

/// z(x, y) of both bodies, measured along the normal from their tangent planes, by the gauges of the shapes: each is
/// the root of N(on + x e_i + y e_j ∓ z n) = 1 by Newton's method on a convex function, to round-off. `contact` must be
/// resolved; particles only. Throws InputError otherwise.
GapField true_gap(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2,
                  const ContactGeometry& contact);

/// x²/(2R_i) + y²/(2R_j), what Hertz sees.
GapField quadratic_gap(double R_i, double R_j);

/// A grid that just holds where gap < δ: no pressure can be outside. `size` is a first guess of its half-width [m].
/// @pre the gap is convex; cells ≥ 8
Grid grid_around(const GapField& gap, double overlap, double size, int cells);

/// The gap at the cell centres.
std::vector<double> sampled(const GapField& gap, const Grid& grid);

}  // namespace osculate::validation::halfspace
