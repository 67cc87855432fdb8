#pragma once
// gnuplot as a program of its own: a script in, what it draws out.

#include <string>

namespace osculate::io {

/// Runs the script and returns what it wrote to its standard output.
/// Throws InputError when gnuplot is not installed, std::runtime_error with its message when the script fails.
std::string run_gnuplot(const std::string& script);

}  // namespace osculate::io
