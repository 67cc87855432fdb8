#pragma once
// Adaptive Gauss–Kronrod quadrature for smooth integrands.

#include <cmath>

namespace osculate::quadrature {

/// Both rules on one interval.
struct Estimate {
  double kronrod;  ///< 15 points, exact to degree 22
  double gauss;    ///< the 7 of them that are Gauss's, exact to degree 13
};

template <class Function>
Estimate gauss_kronrod(const Function& f, double from, double to) {
  static constexpr double node[] = {0.991455371120812639, 0.949107912342758525, 0.864864423359769073,
                                    0.741531185599394440, 0.586087235467691130, 0.405845151377397167,
                                    0.207784955007898468};
  static constexpr double weight[] = {0.022935322010529225, 0.063092092629978553, 0.104790010322250184,
                                      0.140653259715525919, 0.169004726639267903, 0.190350578064785410,
                                      0.204432940075298892};
  static constexpr double gauss_weight[] = {0.129484966168869693, 0.279705391489276668, 0.381830050505118945};
  const double centre = 0.5 * (from + to), half = 0.5 * (to - from);
  const double middle = f(centre);
  Estimate sum{0.209482141084727828 * middle, 0.417959183673469388 * middle};
  for (int i = 0; i < 7; ++i) {
    const double pair = f(centre - half * node[i]) + f(centre + half * node[i]);
    sum.kronrod += weight[i] * pair;
    if (i % 2 == 1) sum.gauss += gauss_weight[i / 2] * pair;
  }
  return {half * sum.kronrod, half * sum.gauss};
}

/// ∫ f, halving intervals until the two rules agree within `tolerance` (absolute), at most `depth` times. Between the
/// rules' difference and Kronrod's own error lie many digits, so the result is far better than asked.
template <class Function>
double integrate(const Function& f, double from, double to, double tolerance, int depth = 12) {
  const Estimate whole = gauss_kronrod(f, from, to);
  if (depth == 0 || std::abs(whole.kronrod - whole.gauss) <= tolerance) return whole.kronrod;
  const double middle = 0.5 * (from + to);
  return integrate(f, from, middle, 0.5 * tolerance, depth - 1) + integrate(f, middle, to, 0.5 * tolerance, depth - 1);
}

}  // namespace osculate::quadrature
