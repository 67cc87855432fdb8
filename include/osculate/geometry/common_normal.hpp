#pragma once
// The narrow phase: the common normal of two convex bodies, that is the direction of minimal penetration.
//   δ = min over unit u of h1(u) + h2(−u) − u·(c2 − c1)
// A contact is found cold, or warm from the cache that the caller keeps beside the pair.

#include "osculate/geometry/contact_geometry.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate {

/// What the caller keeps beside a pair between two calls: it moves rigidly with the bodies.
struct ContactCache {
  enum class State : int {
    empty,       ///< nothing known: the next call starts cold
    contact,     ///< the points and normals of the last answer
    separation,  ///< the support points in a direction in which the bodies did not overlap, and that direction
  };
  State state = State::empty;
  Vec3 point_1 = Vec3::Zero();   ///< body 1 frame [m]
  Vec3 normal_1 = Vec3::Zero();  ///< outward unit normal there, body 1 frame
  Vec3 point_2 = Vec3::Zero();   ///< body 2 frame [m]
  Vec3 normal_2 = Vec3::Zero();  ///< outward unit normal there, body 2 frame
  /// Shape operators there, (11, 12, 22) in a tangent basis of the solver's choice [1/m]; zero where they do not serve.
  Vec3 shape_1 = Vec3::Zero();
  Vec3 shape_2 = Vec3::Zero();
};

/// How far the narrow phase goes when the bodies do not touch.
enum class Gap {
  resolve,  ///< find the common normal and the gap
  skip,     ///< stop at the first direction that proves separation: `overlap` is minus a lower bound of the gap, the
            ///< normal that direction; points and curvatures are zero unless the gap was resolved all the same
};

/// The contact of any two shapes; at most one of them may be a wall. Orientations must be unit quaternions.
/// Never throws for finite input: trouble is said in the status. Swapping the bodies swaps the answer exactly.
/// `cache` serves as the start if it holds one and is brought up to date.
ContactGeometry common_normal(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2,
                              ContactCache& cache, Gap gap = Gap::resolve);

/// The same, cold.
ContactGeometry common_normal(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2);

}  // namespace osculate
