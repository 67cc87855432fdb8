#pragma once
// Restitution against impact speed of the damped Hertz laws: the engine beside the one-dimensional theory.

#include <string>
#include <vector>

namespace osculate::validation {

struct RestitutionCurve {
  std::string law;
  std::vector<double> speeds;    ///< [m/s]
  std::vector<double> theory;    ///< of the equation of motion without attraction
  std::vector<double> computed;  ///< by the engine
};

/// Two glass spheres of 3.18 mm; every law loses as much as to make ε = 0.9 at 1 m/s.
std::vector<RestitutionCurve> restitution_curves(const std::vector<double>& speeds);

}  // namespace osculate::validation
