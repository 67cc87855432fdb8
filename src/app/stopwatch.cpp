#include "app/stopwatch.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace osculate::app {

Timing time_of(std::size_t items, int repetitions, const std::function<void()>& prepare,
               const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  // The first run, untimed, warms the memory and the processor.
  prepare();
  work();
  for (int i = 0; i < repetitions; ++i) {
    prepare();
    const Clock::time_point start = Clock::now();
    work();
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count() /
                    static_cast<double>(items));
  }
  std::sort(times.begin(), times.end());
  const auto at = [&](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  return {.median = at(0.5), .spread = 0.5 * (at(0.75) - at(0.25))};
}

}  // namespace osculate::app
