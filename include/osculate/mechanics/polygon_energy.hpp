#pragma once
// Energy-conserving contact of polygons in the plane: the force is the gradient of an energy of the overlap area.
// [FO04] Polygons may be non-convex and may overlap in several regions. Per unit of thickness.

#include <Eigen/Core>
#include <span>
#include <vector>

namespace osculate::polygon_energy {

using Vec2 = Eigen::Vector2d;

/// The vertices of a simple polygon, counter-clockwise [m].
using Polygon = std::vector<Vec2>;

/// W(A) = k A^m. m = 1 is the linear function: a constant pressure k over the contact, whose force does not vanish with
/// the overlap of a face; m > 1 the power function.                                             [KDY23 (54)]
struct EnergyFunction {
  double coefficient;     ///< k > 0 [J/m^{2m}]
  double exponent = 1.0;  ///< m ≥ 1

  double energy(double area) const;  ///< W [J]
  double slope(double area) const;   ///< dW/dA [J/m²]
};

/// Throws InputError unless k > 0 and m ≥ 1, both finite.
void validate(const EnergyFunction& function);

/// Throws InputError unless there are at least three vertices, all finite, counter-clockwise, and no two edges cross.
void validate(std::span<const Vec2> polygon);

/// Overlap of two polygons, its centroid, and how it changes when body 2 moves.
struct Overlap {
  double area;     ///< A [m²], all regions together
  Vec2 centroid;   ///< of all regions together; zero if A = 0 [m]
  Vec2 gradient;   ///< ∂A/∂x of body 2 [m]: ∫ n ds over the part of its boundary inside body 1
  double turning;  ///< ∂A/∂θ of body 2 turning about `pivot` [m²/rad]
};

/// Positions of all vertices in one frame. The area is a continuous function of them whatever the polygons' position
/// (aligned edges, vertices on edges, vertices on vertices), to about 1e-15 of the common bounding box. Where edges
/// coincide the gradient jumps; one of its one-sided values, or a mean of them, is given.
/// @pre both polygons are valid
Overlap overlap(std::span<const Vec2> body_1, std::span<const Vec2> body_2, const Vec2& pivot);

struct Contact {
  double area;           ///< A [m²]
  double energy;         ///< W(A) [J]
  Vec2 force_on_2;       ///< F [N]; body 1 receives −F
  double moment_on_1;    ///< about `centre_1` [N m]
  double moment_on_2;    ///< about `centre_2` [N m]
  Vec2 reference_point;  ///< on the line along which the forces act, nearest to the overlap's centroid [m]
};

/// Forces and moments of two polygons, whose work along any path is −ΔW.                          [KDY23 (55)]
///   F = −W'(A) ∂A/∂x,  M = −W'(A) ∂A/∂θ
/// One region with two crossings of the boundaries: F is W' times the chord between them, square to it, through its
/// middle.
Contact contact(std::span<const Vec2> body_1, const Vec2& centre_1, std::span<const Vec2> body_2, const Vec2& centre_2,
                const EnergyFunction& function);

}  // namespace osculate::polygon_energy
