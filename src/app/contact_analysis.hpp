#pragma once
// One contact in full: the geometry, the elliptical Hertz contact on it, and what simpler curvatures would have given.

#include <optional>
#include <string>
#include <vector>

#include "io/contact_file.hpp"
#include "osculate/geometry/contact_geometry.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace osculate::app {

struct HertzContact {
  ContactEllipse ellipse;
  hertz::Contact contact;
  double smallest_radius;  ///< R_min [m] of the two bodies at the contact
};

/// The force at the same overlap with one model of the curvature; nothing where a radius is infinite.
struct ModelForce {
  std::string model;
  RelativeCurvature relative;
  std::optional<double> force;  ///< [N]
};

struct ContactAnalysis {
  io::ContactFile input;
  double volume_radius_1;  ///< R_vol [m], ∞ for walls
  double volume_radius_2;
  ContactGeometry geometry;
  double effective_modulus;           ///< Ê [Pa]
  std::optional<HertzContact> hertz;  ///< nothing when the bodies are apart, unresolved or flat without a cap
  std::vector<ModelForce> models;     ///< empty when `hertz` is; the first is the exact one

  double volume_radius() const { return volume_radius_1 < volume_radius_2 ? volume_radius_1 : volume_radius_2; }
};

ContactAnalysis analyse(const io::ContactFile& input);

/// Aligned blocks for people.
std::string to_text(const ContactAnalysis& analysis);

/// Every number with 17 digits; infinities as the strings "inf" and "-inf"; lengths in m, forces in N.
std::string to_json(const ContactAnalysis& analysis);

}  // namespace osculate::app
