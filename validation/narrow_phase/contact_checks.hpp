#pragma once
// What must hold of any answer of the narrow phase, whatever solver gave it: checked with the plain formulas, without
// knowing the right answer.

#include "osculate/geometry/contact_geometry.hpp"
#include "validation/narrow_phase/random_pairs.hpp"

namespace osculate::validation {

/// Lengths within which a right answer may differ from another right answer.
struct Tolerance {
  double overlap;  ///< [m] 1e-12 R_vol of the smaller body, and 50 roundings of the lengths the overlap is made of
  double point;    ///< [m] the same, and 4 roundings of the world coordinates
  double offset;   ///< [m] 1e-7 R_vol of the smaller body more: along a flat surface a point is less certain
};
Tolerance tolerance_of(const Pair& pair);

/// By how much each statement fails, over its tolerance: ≤ 1 holds, NaN never does.
struct SelfConsistency {
  double off_surface;  ///< gauge at on_1 and on_2: distance from the surface
  double off_support;  ///< h(n) − n·x: how far each point falls short of the extreme one along ±normal
  double off_overlap;  ///< overlap against (on_1 − on_2)·normal and against g(normal); |normal| against 1
  double off_line;     ///< |(on_1 − on_2) − overlap normal|: the points do not face each other
};
SelfConsistency self_consistency(const Pair& pair, const Tolerance& tolerance, const ContactGeometry& contact);

/// True if every number is finite; radii of relative curvature may be ∞.
bool is_finite(const ContactGeometry& contact);

/// Least g over 200 directions spread evenly, both bodies' axes and the centre line [m]: no right overlap is larger.
double least_of_samples(const Pair& pair);

/// g(normal) in double [m].
double overlap_in_double(const Pair& pair, const Vec3& normal);

/// `b` is `a` seen with the bodies exchanged, to the last bit.
bool is_exact_swap(const ContactGeometry& a, const ContactGeometry& b);

/// To the last bit.
bool is_same(const ContactGeometry& a, const ContactGeometry& b);

/// `b` is `a` with all lengths multiplied by `factor`, a power of two, to the last bit; but of vectors the components
/// whose squares vanish beside the largest.
bool is_exact_scaling(const ContactGeometry& a, const ContactGeometry& b, double factor);

}  // namespace osculate::validation
