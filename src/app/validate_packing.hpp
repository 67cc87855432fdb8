#pragma once
// osculate validate packing: random packings through the engine, beside published ones.

#include <CLI/CLI.hpp>

namespace osculate::app {

void add_validate_packing(CLI::App& validate);

}  // namespace osculate::app
