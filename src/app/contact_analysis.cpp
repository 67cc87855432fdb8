#include "app/contact_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "osculate/geometry/common_normal.hpp"
#include "osculate/geometry/curvature_models.hpp"

namespace osculate::app {
namespace {

double volume_radius_of(const Shape& shape) {
  if (!is_particle(shape)) return std::numeric_limits<double>::infinity();
  return volume_equivalent_radius(mass_properties(shape).volume);
}

/// Nothing where no finite force belongs to an overlap.
std::optional<ContactEllipse> ellipse_of(const RelativeCurvature& relative) {
  if (!std::isfinite(relative.R_i) || !(relative.R_j > 0.0)) return std::nullopt;
  return contact_ellipse(relative.R_i, relative.R_j);
}

/// min over both bodies of 1/k_max; ∞ where neither is convex.
double smallest_radius(const ContactGeometry& contact) {
  const double curvature = std::max(contact.curvature_1.max, contact.curvature_2.max);
  return curvature > 0.0 ? 1.0 / curvature : std::numeric_limits<double>::infinity();
}

std::string label_of(CurvatureModel model) {
  switch (model) {
    case CurvatureModel::exact:
      return "exact curvature";
    case CurvatureModel::gaussian:
      return fmt::format("Gaussian, capped at {:g} R_vol", review_cap);
    case CurvatureModel::mean:
      return "mean";
    case CurvatureModel::volume_equivalent:
      return "volume-equivalent sphere";
  }
  return std::string(name(model));
}

}  // namespace

ContactAnalysis analyse(const io::ContactFile& input) {
  const io::ContactFileBody& one = input.body_1;
  const io::ContactFileBody& two = input.body_2;
  ContactAnalysis analysis{.input = input,
                           .volume_radius_1 = volume_radius_of(one.shape),
                           .volume_radius_2 = volume_radius_of(two.shape),
                           .geometry = common_normal(one.shape, one.pose, two.shape, two.pose),
                           .effective_modulus = effective_modulus(one.material, two.material),
                           .hertz = std::nullopt,
                           .models = {}};
  ContactGeometry& contact = analysis.geometry;
  if (!is_resolved(contact.status)) return analysis;

  const ContactBody body_1{.curvature = contact.curvature_1, .volume_radius = analysis.volume_radius_1};
  const ContactBody body_2{.curvature = contact.curvature_2, .volume_radius = analysis.volume_radius_2};
  contact.relative = relative_curvature(CurvatureModel::exact, contact.normal, body_1, body_2, input.radius_cap);
  if (!(contact.overlap > 0.0)) return analysis;
  const std::optional<ContactEllipse> ellipse = ellipse_of(contact.relative);
  if (!ellipse) return analysis;
  const double radius = smallest_radius(contact);
  analysis.hertz =
      HertzContact{.ellipse = *ellipse,
                   .contact = hertz::contact(*ellipse, analysis.effective_modulus, contact.overlap, radius),
                   .smallest_radius = radius};

  analysis.models.push_back({label_of(CurvatureModel::exact), contact.relative, analysis.hertz->contact.force});
  constexpr double uncapped = std::numeric_limits<double>::infinity();
  constexpr std::array<std::pair<CurvatureModel, double>, 3> simpler{{{CurvatureModel::gaussian, review_cap},
                                                                      {CurvatureModel::mean, uncapped},
                                                                      {CurvatureModel::volume_equivalent, uncapped}}};
  for (const auto& [model, cap] : simpler) {
    const RelativeCurvature relative = relative_curvature(model, contact.normal, body_1, body_2, cap);
    ModelForce simpler_force{.model = label_of(model), .relative = relative, .force = std::nullopt};
    if (const std::optional<ContactEllipse> found = ellipse_of(relative))
      simpler_force.force = hertz::force(*found, analysis.effective_modulus, contact.overlap);
    analysis.models.push_back(simpler_force);
  }
  return analysis;
}

}  // namespace osculate::app
