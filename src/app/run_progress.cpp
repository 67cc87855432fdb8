#include "app/run_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "io/quantity_text.hpp"

namespace osculate::app {
namespace {

constexpr std::chrono::milliseconds on_terminal{250}, elsewhere{10000};

std::string short_quantity(double value, const char* unit) {
  const io::PrefixedUnit prefixed = io::prefixed_unit(value, unit);
  return fmt::format("{:.4g} {}", value / prefixed.size, prefixed.symbol);
}

}  // namespace

std::string clock_text(double seconds) {
  constexpr std::int64_t minute = 60, hour = 3600;
  const auto whole = static_cast<std::int64_t>(std::llround(std::min(seconds, 1e12)));
  if (whole >= hour) return fmt::format("{}:{:02}:{:02}", whole / hour, whole % hour / minute, whole % minute);
  return fmt::format("{}:{:02}", whole / minute, whole % minute);
}

RunProgress::RunProgress(std::uint64_t first_step) : first_step_(first_step), terminal_(::isatty(STDERR_FILENO) == 1) {}

RunProgress::~RunProgress() {
  if (shown_ && terminal_) fmt::print(stderr, "\r\033[K");
}

bool RunProgress::is_due() const {
  return Clock::now() - last_ >= (terminal_ ? on_terminal : elsewhere);
}

void RunProgress::show(const RunStatus& status) {
  last_ = Clock::now();
  shown_ = true;
  const double spent = std::chrono::duration<double>(last_ - start_).count();
  const auto done = static_cast<double>(status.step - first_step_);
  const double rate = done / spent;
  const double left = static_cast<double>(status.steps - status.step) / rate;
  fmt::print(stderr, "{}t = {} of {} ({:.1f} %), {:.0f} steps/s, {} contacts, kinetic energy {}, {} left{}",
             terminal_ ? "\r\033[K" : "", short_quantity(status.time, "s"), short_quantity(status.duration, "s"),
             100.0 * static_cast<double>(status.step) / static_cast<double>(status.steps), rate, status.contacts,
             short_quantity(status.kinetic_energy, "J"), clock_text(left), terminal_ ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace osculate::app
