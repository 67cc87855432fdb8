#pragma once
// osculate validate narrow: the narrow phase under stress.

#include <CLI/CLI.hpp>

namespace osculate::app {

void add_validate_narrow(CLI::App& validate);

}  // namespace osculate::app
