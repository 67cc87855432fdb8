#pragma once
// What a long job says of itself on standard error.

#include <chrono>
#include <string>
#include <utility>

namespace osculate::io {

/// "1:02:03", "2:03".
std::string clock_text(double seconds);

/// On a terminal one line that is written over four times a second, and erased at the end; elsewhere, as in a log or
/// under mpirun, a line every ten seconds. Nothing of a job that is over before.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  bool is_due() const;
  void show(const std::string& text);
  double seconds_spent() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

/// "study halfspace:  37 %, 0:12 left".
class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)) {}

  /// `fraction` done, 0 to 1.
  void update(double fraction);

 private:
  std::string what_;
  ProgressLine line_;
};

}  // namespace osculate::io
