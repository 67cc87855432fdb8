#pragma once
// A contact as a picture: both bodies half-transparent, the normal, the two points, the contact ellipse.

#include <filesystem>

#include "app/contact_analysis.hpp"

namespace osculate::app {

/// Writes a PNG file. The ellipse is magnified by a round factor until it can be seen; a note in the picture says by
/// how much.
void write_contact_picture(const ContactAnalysis& analysis, const std::filesystem::path& path);

}  // namespace osculate::app
