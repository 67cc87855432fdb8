#pragma once
// What a running simulation says of itself on standard error.

#include <cstdint>

#include "io/progress.hpp"

namespace osculate::app {

struct RunStatus {
  double time, duration;      ///< [s]
  std::uint64_t step, steps;  ///< done, and of the whole run
  std::uint64_t contacts;
  double kinetic_energy;  ///< translation and rotation [J]
};

class RunProgress {
 public:
  explicit RunProgress(std::uint64_t first_step) : first_step_(first_step) {}

  bool is_due() const { return line_.is_due(); }
  void show(const RunStatus& status);

 private:
  std::uint64_t first_step_;
  io::ProgressLine line_;
};

}  // namespace osculate::app
