#pragma once
// The program's commands, one a file. Each adds itself to the command line; its work runs as the command's callback
// and throws InputError for anything the user can put right.

#include <CLI/CLI.hpp>

namespace osculate::app {

/// `shape`: what a shape is, as numbers, files and pictures.
void add_shape(CLI::App& program);

void add_validate(CLI::App& program);

}  // namespace osculate::app
