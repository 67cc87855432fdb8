#pragma once
// Integrals over Gaussian asperity heights.

namespace osculate {

/// Which power of the interference the sum over asperities takes.
enum class HeightPower { one_half, three_halves };

/// ∫_h^∞ (z − h)^power φ(z) dz, φ the standard normal density, any h; relative error below 1e-13. Underflows to 0 as h
/// exceeds 38.
double height_integral(HeightPower power, double h);

}  // namespace osculate
