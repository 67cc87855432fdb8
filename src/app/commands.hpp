#pragma once
// The program's commands, one a file. Each adds itself to the command line; its work runs as the command's callback
// and throws InputError for anything the user can put right.

#include <CLI/CLI.hpp>

namespace osculate::app {

/// `contact`: one contact in full, or a table of pairs.
void add_contact(CLI::App& program);

/// `shape`: what a shape is, as numbers, files and pictures.
void add_shape(CLI::App& program);

/// `law`: the laws of contact, listed, explained, evaluated.
void add_law(CLI::App& program);

/// `run`: a scene, from a file to results.
void add_run(CLI::App& program);

/// `check`: a scene without running it.
void add_check(CLI::App& program);

/// `info`: what is in a results file.
void add_info(CLI::App& program);

/// `bench`: what a contact costs on this machine.
void add_bench(CLI::App& program);

/// `review`: the review's tables, computed anew.
void add_review(CLI::App& program);

/// `validate`: independent witnesses against the library.
void add_validate(CLI::App& program);

/// `export`: results for other programs.
void add_export(CLI::App& program);

/// `render`: pictures and films of results.
void add_render(CLI::App& program);

/// `study`: sweeps that show where a model holds.
void add_study(CLI::App& program);

}  // namespace osculate::app
