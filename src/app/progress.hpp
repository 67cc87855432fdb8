#pragma once
// A line on the terminal that says how far a long job is and when it will end.

#include <chrono>
#include <string>

namespace osculate::app {

/// Writes to standard error, only when that is a terminal and the job has lasted long enough to make one wonder.
class Progress {
 public:
  explicit Progress(std::string what);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// `fraction` done, 0 to 1.
  void update(double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace osculate::app
