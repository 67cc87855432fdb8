#pragma once
// The first and the last step of a contact.
//
// Steps fall on a force δ^p that begins and ends somewhere between two of them. The sum of its samples at overlaps
// (k + θ) h, k = 0, 1, …, is off its integral from 0 by h^{p+1} ζ(−p, θ), the Hurwitz zeta function [Navot61]: an
// energy that depends on where the steps happened to fall, and does not come back on the way out. Taking it from the
// sample nearest to the edge makes the sum right to the next order.

namespace osculate {

/// ζ(−p, θ) for 0 < θ ≤ 1 and 0 < p ≤ 4, to 1e-12.
double hurwitz_zeta_of_negative(double p, double theta);

/// The elastic force at the sample nearest to the edge, and what has to be added to it.
/// @param overlap    δ > 0 [m]
/// @param way        h > 0: |dδ/dt| times the time step [m]; at δ ≥ h the sample is not the nearest and gets 0
/// @param stored     elastic energy of the contact [J]
/// @param stiffness  dF/dδ [N/m]; with F ∝ δ^p, p(p + 1) = stiffness δ²/stored
/// @return the force to be added along the same direction [N]; 0 where no power p in (0, 4] fits
double edge_force(double overlap, double way, double stored, double stiffness);

/// The power p of an elastic force F ∝ δ^p from its energy and stiffness, p(p + 1) = stiffness δ²/stored. 3/2 for
/// Hertz.
double elastic_power(double overlap, double stored, double stiffness);

}  // namespace osculate
