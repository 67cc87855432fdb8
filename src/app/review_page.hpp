#pragma once
// The whole review as one page that needs no other file.

#include <filesystem>

namespace osculate::app {

/// Writes into a folder, which is made if need be: the tables as text, every figure as SVG, PNG and CSV, and all their
/// numbers as figures.h5.
void write_review_files(const std::filesystem::path& folder);

/// Writes index.html into a folder: tables, figures, errata and coverage, with the figures' numbers inside.
void write_review_page(const std::filesystem::path& folder);

}  // namespace osculate::app
