#pragma once
// Elliptical Cattaneo–Mindlin–Deresiewicz along any path: the normal overlap and both components of the tangential
// displacement change as they like, and the contact plane turns.
//
// The law. A Hertz contact is a nest of similar ellipses, one for each depth η in [0, δ] of the overlap. On one axis
// the traction of every load history is a superposition of Hertz tractions of that nest (Jäger 1993, Ciavarella 1998),
// and then the contact answers as if every depth were a spring of its own that slides when its deflection s(η) reaches
// μ(δ−η):                                                                          [Jaeger93; Ciavarella98; PH15]
//   F_t = ∫ s(η) F''(η) dη,   |s(η)| ≤ μ(δ − η),   F(η) = F_n(η) the Hertz force;
// deflections are displacements divided by the compliance ratio κ of their axis. The springs are kept as a polyline in
// η: bounded memory, exact while the polyline is.
//
// Exact (to rounding) for every history with tangential displacement along one axis, or along any one direction in a
// circular contact, as long as it has no more than `layers` open reversals; (59),(67),(72)–(74) are such. For two
// components the springs still obey Coulomb's law one by one, but no exact solution is known: the traction of the real
// contact is not a function of depth alone. What holds always: F_t ≤ μF_n, energy is never created, no direction is
// preferred but the ellipse's. Under full sliding F_t points against K⁻¹ times the sliding velocity, at most
// asin((κ_1−κ_2)/(κ_1+κ_2)) away from the velocity itself: 0 for a circle, 1.7° at b/a = 0.5 and ν = 0.3.

#include <array>
#include <cstdint>

#include "osculate/core/types.hpp"
#include "osculate/mechanics/mindlin.hpp"

namespace osculate::mindlin {

/// A vector in the contact plane.
struct Planar {
  double x;
  double y;
};

/// How many points the memory holds.
inline constexpr int layers = 6;

/// One point of the polyline: the spring deflection s at a depth.
struct Layer {
  double depth;  ///< η ≥ 0 [m]
  double x;      ///< s along the major axis [m]
  double y;      ///< s along the minor axis [m]
};

/// The springs of one contact, in the axes of its ellipse. Trivially copyable; a
/// zero-initialised one is a contact that has not been made. Between the points, and from the last point to
/// s = 0 at η = overlap, s is linear.
struct Springs {
  double overlap = 0.0;  ///< δ at the last step [m]
  std::int64_t count = 0;
  std::array<Layer, layers> at{};  ///< depths increase from 0; `count` of them are in use
};

/// One step of the path, from the last overlap to `overlap`, while the bodies move by `shift` on each other: the
/// displacement of body 2 against body 1 divided by κ, axis by axis [m].
/// @param friction  μ ≥ 0. overlap ≤ 0 opens the contact and forgets everything.
/// The path between is taken as straight. Never fails; finite in, finite out.
void advance(Springs& springs, double overlap, Planar shift, double friction);

/// Tangential force over the Hertz coefficient k of F_n = k δ^{3/2}: the force on body 1, along the displacement of
/// body 2, is k times this [m^{3/2}]. |result| ≤ μ δ^{3/2}.
Planar traction(const Springs& springs);

/// Elastic energy stored by the tangential traction [J], 1/2 ∫ s·(κ s) F'' dη.
/// @param coefficient  k [N/m^{3/2}]
double stored_energy(const Springs& springs, double coefficient, const Axes& compliance_ratio);

/// A contact plane's memory: the springs and the frame they live in. Trivially copyable.
struct Memory {
  Springs springs;
  std::array<double, 3> normal{};  ///< unit normal at the last step, from body 1 to body 2, world
  std::array<double, 3> axis{};    ///< unit tangent: the springs' major axis at the last step, world
};

/// Where the contact is now, and how it moved since the last step.
struct Step {
  Vec3 normal;        ///< unit, from body 1 to body 2, world
  Vec3 major_axis;    ///< unit tangent along a_c, orthogonal to the normal, world (sign free)
  double overlap;     ///< δ [m]
  Vec3 displacement;  ///< of body 2 against body 1 at the contact point since the last step [m]; its part along the
                      ///< normal is ignored. For a contact just made, since the surfaces met.
  double spin;        ///< mean rotation of the two bodies about the normal since the last step [rad], see `spin_of`
};

/// The contact's constants at this step.
struct Law {
  double coefficient;  ///< k = F_n/δ^{3/2} = 4/3 Ê R_c^{1/2} γ [N/m^{3/2}]
  Axes compliance_ratio;
  double friction;  ///< μ ≥ 0
};

/// Throws InputError unless k > 0, κ > 0 and μ ≥ 0, all finite.
Law law(double coefficient, const Axes& compliance_ratio, double friction);

/// The springs in the new plane: carried by parallel transport along the turn of the normal, then by the spin; not yet
/// moved.
Springs carried(const Memory& memory, const Step& step);

/// Carries the memory to the new plane (parallel transport along the turn of the normal, then the spin), moves the
/// springs, and returns the tangential force on body 1 [N], world frame; body 2 feels the opposite.
Vec3 advance(Memory& memory, const Law& law, const Step& step);

/// The twist about `normal` that a rotation contains (swing–twist) [rad]: for the mean rotation of two bodies between
/// two steps, with the normal at the first of them. With it a rigid rotation of both bodies rotates the force exactly.
double spin_of(const Quat& rotation, const Vec3& normal);

}  // namespace osculate::mindlin
