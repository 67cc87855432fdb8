#pragma once
// Adaptive quadrature by GSL: the witness of closed-form integrals.

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <functional>

/// ∫ f from `from` to `to`, asked for a relative error of `tolerance`. Integrable end-point singularities are fine.
inline double quadrature(const std::function<double(double)>& f, double from, double to, double tolerance = 1e-12) {
  gsl_set_error_handler_off();
  gsl_function integrand;
  integrand.params = const_cast<std::function<double(double)>*>(&f);
  integrand.function = [](double x, void* g) { return (*static_cast<std::function<double(double)>*>(g))(x); };
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(1000);
  double value = 0.0, error = 0.0;
  gsl_integration_qags(&integrand, from, to, 0.0, tolerance, 1000, workspace, &value, &error);
  gsl_integration_workspace_free(workspace);
  return value;
}
