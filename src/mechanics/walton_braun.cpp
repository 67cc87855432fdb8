#include "osculate/mechanics/walton_braun.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/require.hpp"

namespace osculate::walton_braun {
namespace {

constexpr const char* here = "walton_braun";

double unloading_stiffness(const Model& model, double largest_overlap) {
  return model.unloading + model.hardening * model.loading * largest_overlap;
}

}  // namespace

void validate(const Model& model) {
  require_positive(here, "loading stiffness", model.loading, "[N/m]");
  require_not_negative(here, "hardening", model.hardening, "[1/m]");
  if (!(model.unloading >= model.loading) || !std::isfinite(model.unloading))
    throw InputError(here, "unloading stiffness " + std::to_string(model.unloading),
                     "a finite value of at least the loading stiffness " + std::to_string(model.loading));
}

Model constant_unloading(double loading, double restitution) {
  require_restitution(here, restitution);
  const Model model{.loading = loading, .unloading = loading / (restitution * restitution)};
  validate(model);
  return model;
}

Model variable_unloading(double loading, double hardening) {
  const Model model{.loading = loading, .unloading = loading, .hardening = hardening};
  validate(model);
  return model;
}

double residual_overlap(const Model& model, const Memory& memory) {
  return memory.largest_overlap * (1.0 - model.loading / unloading_stiffness(model, memory.largest_overlap));
}

double force(const Model& model, double overlap, Memory& memory) {
  memory.largest_overlap = std::max(memory.largest_overlap, overlap);
  const double unloaded = memory.largest_overlap - overlap;
  return std::max(
      0.0, model.loading * memory.largest_overlap - unloading_stiffness(model, memory.largest_overlap) * unloaded);
}

Impact impact(const Model& model, double mass, double speed) {
  validate(model);
  require_positive(here, "effective mass", mass, "[kg]");
  require_positive(here, "speed", speed, "[m/s]");
  const double loading = std::sqrt(model.loading / mass), largest = speed / loading;
  const double unloading = std::sqrt(unloading_stiffness(model, largest) / mass);
  return {.duration = 0.5 * std::numbers::pi * (1.0 / loading + 1.0 / unloading),
          .largest_overlap = largest,
          .restitution = loading / unloading};
}

}  // namespace osculate::walton_braun
