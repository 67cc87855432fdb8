#pragma once
// osculate validate flow: discharge of a hopper and angle of repose through the engine, against known trends.

#include <CLI/CLI.hpp>

namespace osculate::app {

void add_validate_flow(CLI::App& validate);

}  // namespace osculate::app
