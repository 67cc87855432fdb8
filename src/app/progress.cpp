#include "app/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <utility>

namespace osculate::app {
namespace {

constexpr std::chrono::milliseconds between_updates{250};
constexpr int seconds_per_minute = 60;

std::string as_time(double seconds) {
  const int whole = static_cast<int>(seconds + 0.5);
  return fmt::format("{}:{:02}", whole / seconds_per_minute, whole % seconds_per_minute);
}

}  // namespace

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::update(double fraction) {
  const Clock::time_point now = Clock::now();
  if (!terminal_ || now - last_ < between_updates || fraction <= 0.0) return;
  last_ = now;
  shown_ = true;
  const double spent = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r\033[K{}: {:3.0f} %, {} left", what_, 100.0 * fraction,
             as_time(spent * (1.0 - fraction) / fraction));
  std::fflush(stderr);
}

}  // namespace osculate::app
