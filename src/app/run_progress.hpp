#pragma once
// What a running simulation says of itself on standard error.

#include <chrono>
#include <cstdint>
#include <string>

namespace osculate::app {

struct RunStatus {
  double time, duration;      ///< [s]
  std::uint64_t step, steps;  ///< done, and of the whole run
  std::uint64_t contacts;
  double kinetic_energy;  ///< translation and rotation [J]
};

/// On a terminal a line that is written over four times a second; elsewhere a line every ten seconds.
class RunProgress {
 public:
  explicit RunProgress(std::uint64_t first_step);
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;
  ~RunProgress();

  bool is_due() const;
  void show(const RunStatus& status);

 private:
  using Clock = std::chrono::steady_clock;
  std::uint64_t first_step_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

/// "1:02:03", "2:03".
std::string clock_text(double seconds);

}  // namespace osculate::app
