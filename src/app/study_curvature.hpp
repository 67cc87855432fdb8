#pragma once
// `study curvature`: what simpler pictures of a contact cost.

#include <CLI/CLI.hpp>

namespace osculate::app {

void add_curvature_study(CLI::App& study);

}  // namespace osculate::app
