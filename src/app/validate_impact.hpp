#pragma once
// osculate validate impact: single impacts through the engine, against closed forms.

#include <CLI/CLI.hpp>

namespace osculate::app {

void add_validate_impact(CLI::App& validate);

}  // namespace osculate::app
