#pragma once
// Head-on impacts by GSL's adaptive Runge–Kutta: the witness of every closed form.

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <functional>

#include "osculate/mechanics/impact.hpp"

/// m δ̈ = −F(δ, δ̇) from δ = 0, δ̇ = v until `parted(δ, δ̇)`; the end is closed in on by halving the last step.
inline osculate::Impact collide(std::function<double(double, double)> force, double mass, double speed, double duration,
                                const std::function<bool(double, double)>& parted) {
  struct Problem {
    std::function<double(double, double)> force;
    double mass, speed, duration;
  };
  // Made dimensionless: time in `duration`, overlap in `speed · duration`.
  Problem problem{std::move(force), mass, speed, duration};
  gsl_odeiv2_system system{[](double, const double y[], double f[], void* p) {
                             const auto& q = *static_cast<Problem*>(p);
                             f[0] = y[1];
                             f[1] = -q.force(y[0] * q.speed * q.duration, y[1] * q.speed) * q.duration /
                                    (q.mass * q.speed);
                             return int(GSL_SUCCESS);
                           },
                           nullptr, 2, &problem};
  gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-6, 1e-13, 1e-13);
  double t = 0.0, y[2] = {0.0, 1.0}, largest = 0.0, step = 1e-3;
  while (step > 1e-13 && t < 100.0) {
    const double t_before = t, before[2] = {y[0], y[1]};
    gsl_odeiv2_driver_reset(driver);
    gsl_odeiv2_driver_reset_hstart(driver, std::fmin(1e-6, 0.1 * step));
    if (gsl_odeiv2_driver_apply(driver, &t, t + step, y) != GSL_SUCCESS) break;
    if (before[1] > 0.0 && y[1] <= 0.0) {
      // The turn: the step's part after which the speed is zero, by halving.
      double low = 0.0, high = t - t_before;
      for (int halving = 0; halving < 40; ++halving) {
        const double middle = 0.5 * (low + high);
        double now = t_before, z[2] = {before[0], before[1]};
        gsl_odeiv2_driver_reset(driver);
        gsl_odeiv2_driver_reset_hstart(driver, std::fmin(1e-6, 0.1 * middle));
        if (gsl_odeiv2_driver_apply(driver, &now, t_before + middle, z) != GSL_SUCCESS) break;
        (z[1] > 0.0 ? low : high) = middle;
        largest = z[0];
      }
    }
    if (parted(y[0] * speed * duration, y[1] * speed)) {
      t = t_before, y[0] = before[0], y[1] = before[1];
      step *= 0.5;
    }
  }
  gsl_odeiv2_driver_free(driver);
  return {.duration = t * duration, .largest_overlap = largest * speed * duration, .restitution = -y[1]};
}

/// Two 3.18 mm glass spheres at 1 m/s: 3.18 mm is the diameter.
inline osculate::ImpactPair glass_spheres() {
  constexpr double radius = 1.59e-3, density = 2500.0, youngs_modulus = 71e9, poisson = 0.22;
  const double mass = 4.0 / 3.0 * M_PI * radius * radius * radius * density;
  return osculate::sphere_pair(radius, mass, radius, mass, 0.5 * youngs_modulus / (1.0 - poisson * poisson));
}
