#pragma once
// Poses that break contact detection elsewhere: aligned, degenerate, far away, tiny, huge.

#include <vector>

#include "validation/narrow_phase/robustness.hpp"

namespace osculate::validation {

/// Coincident centres, aligned faces, parallel and crossed edges, vertices on faces, symmetry rotations, size ratio
/// 1e-4, aspect 1e3, exponents 1.05 to 64, overlaps from 1e-12 R_vol to half the body, gaps, offsets by denormal
/// numbers, places 1e6 body sizes from the origin; at micrometre and metre scale. With the overlap along the contact
/// direction where it is known.
std::vector<Candidate> nasty_pairs();

}  // namespace osculate::validation
