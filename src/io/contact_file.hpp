#pragma once
// Contact files: two bodies, where they are and what they are made of. The keys are described in docs/contact-files.md.

#include <filesystem>
#include <limits>
#include <string>

#include "osculate/core/types.hpp"
#include "osculate/mechanics/material.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate::io {

struct ContactFileBody {
  std::string shape_name;  ///< as the file names it, or the kind of an inline shape
  Shape shape;
  Pose pose;
  std::string material_name;  ///< a preset's name, or empty
  ElasticMaterial material;
};

struct ContactFile {
  std::string title;
  ContactFileBody body_1;
  ContactFileBody body_2;
  /// Largest radius of relative curvature, in units of the smaller particle's R_vol; ∞ does not cap.
  double radius_cap = std::numeric_limits<double>::infinity();
};

/// Throws InputError with file, line, key, what was found and what was expected.
ContactFile read_contact_file(const std::filesystem::path& path);

/// The keys of a contact file in a few lines, for help texts.
const char* contact_file_keys();

}  // namespace osculate::io
