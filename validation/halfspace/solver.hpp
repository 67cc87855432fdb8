#pragma once
// Frictionless elastic contact on a half-space, for any gap between two bodies: pressure, force and area at a
// prescribed overlap. Knows no Hertz. [PK99]

#include <functional>
#include <vector>

namespace osculate::validation::halfspace {

/// A rectangle of cells around the contact point, in the contact plane.
struct Grid {
  int cells_x, cells_y;
  double cell_x, cell_y;  ///< size of a cell [m]

  double x(int i) const { return (i - 0.5 * (cells_x - 1)) * cell_x; }  ///< centre of cell i [m]
  double y(int j) const { return (j - 0.5 * (cells_y - 1)) * cell_y; }
};

struct Solution {
  std::vector<double> pressure;  ///< by cells, x fastest [Pa]
  double force;                  ///< F = Σ p dA [N]
  double area;                   ///< cells under pressure [m²]
  double peak_pressure;          ///< [Pa]
  int iterations;
  double residual;  ///< largest violation of contact: of the overlap
  bool converged;
};

/// Pressure p ≥ 0 with gap + u − δ ≥ 0 and p (gap + u − δ) = 0, where u is the Boussinesq deflection of both bodies:
/// constant pressure per cell (Love's influence coefficients), convolved on a zero-padded grid by FFT, conjugate
/// gradients with the constraint of Polonsky & Keer. Force and area err by the cells along the edge of the contact.
/// @param gap      undeformed gap at the cell centres, 0 at the contact point [m]
/// @param modulus  Ê [Pa];  overlap δ > 0 [m]
/// Throws InputError for a grid, modulus or overlap that makes no sense.
Solution solve(const Grid& grid, const std::vector<double>& gap, double modulus, double overlap);

}  // namespace osculate::validation::halfspace
