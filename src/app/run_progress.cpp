#include "app/run_progress.hpp"

#include <fmt/format.h>

#include "io/quantity_text.hpp"

namespace osculate::app {
namespace {

std::string short_quantity(double value, const char* unit) {
  const io::PrefixedUnit prefixed = io::prefixed_unit(value, unit);
  return fmt::format("{:.4g} {}", value / prefixed.size, prefixed.symbol);
}

}  // namespace

void RunProgress::show(const RunStatus& status) {
  const double rate = static_cast<double>(status.step - first_step_) / line_.seconds_spent();
  const double left = static_cast<double>(status.steps - status.step) / rate;
  line_.show(fmt::format("t = {} of {} ({:.1f} %), {:.0f} steps/s, {} contacts, kinetic energy {}, {} left",
                         short_quantity(status.time, "s"), short_quantity(status.duration, "s"),
                         100.0 * static_cast<double>(status.step) / static_cast<double>(status.steps), rate,
                         status.contacts, short_quantity(status.kinetic_energy, "J"), io::clock_text(left)));
}

}  // namespace osculate::app
