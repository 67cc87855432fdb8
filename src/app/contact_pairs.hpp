#pragma once
// `osculate contact --pairs`: a table of superquadric pairs in, a table of contacts out.

#include <string>

namespace osculate::app {

enum class Evaluation {
  batched,  ///< several pairs at once in vector registers
  scalar,
};

enum class Start {
  cold,
  warm,  ///< from the answer of the same pair with body 2 turned and moved by 1e-4 (radians, and of its smallest
         ///< half-axis)
};

struct PairsRequest {
  std::string input;
  std::string output;  ///< empty: none
  Evaluation evaluation = Evaluation::batched;
  Start start = Start::cold;
  bool compare = false;  ///< with the reference columns of the input
};

/// Evaluates the table; returns the exit code: 0, or 1 when a comparison misses a bar.
/// Throws InputError for bad tables; then no output file is left behind.
int run_pairs(const PairsRequest& request);

}  // namespace osculate::app
