#pragma once
// The program's commands, one a file. Each adds itself to the command line; its work runs as the command's callback
// and throws InputError for anything the user can put right.

#include <CLI/CLI.hpp>

namespace osculate::app {

/// `review`: the review's tables, computed anew.
void add_review(CLI::App& program);

}  // namespace osculate::app
