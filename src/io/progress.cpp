#include "io/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace osculate::io {
namespace {

constexpr std::chrono::milliseconds on_terminal{250}, elsewhere{10000};

}  // namespace

std::string clock_text(double seconds) {
  constexpr std::int64_t minute = 60, hour = 3600;
  const auto whole = static_cast<std::int64_t>(std::llround(std::min(seconds, 1e12)));
  if (whole >= hour) return fmt::format("{}:{:02}:{:02}", whole / hour, whole % hour / minute, whole % minute);
  return fmt::format("{}:{:02}", whole / minute, whole % minute);
}

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_ && terminal_) fmt::print(stderr, "\r\033[K");
}

bool ProgressLine::is_due() const {
  return Clock::now() - last_ >= (terminal_ ? on_terminal : elsewhere);
}

void ProgressLine::show(const std::string& text) {
  last_ = Clock::now();
  shown_ = true;
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r\033[K" : "", text, terminal_ ? "" : "\n");
  std::fflush(stderr);
}

double ProgressLine::seconds_spent() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::update(double fraction) {
  if (!line_.is_due() || fraction <= 0.0) return;
  const double left = line_.seconds_spent() * (1.0 - fraction) / fraction;
  line_.show(fmt::format("{}: {:3.0f} %, {} left", what_, 100.0 * fraction, clock_text(left)));
}

}  // namespace osculate::io
