#include "app/stopwatch.hpp"

#include <time.h>

#include <algorithm>
#include <vector>

namespace osculate::app {
namespace {

/// The processor time of this thread [ns]: what other programs take meanwhile does not count.
double thread_time() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  constexpr double nanoseconds_per_second = 1e9;
  return nanoseconds_per_second * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

}  // namespace

Timing timing_of(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  return {.median = at(0.5), .spread = 0.5 * (at(0.75) - at(0.25))};
}

Timing time_of(std::size_t items, int repetitions, const std::function<void()>& prepare,
               const std::function<void()>& work) {
  return times_in_turns({{.items = items, .run = work, .prepare = prepare}}, repetitions).front();
}

std::vector<Timing> times_in_turns(const std::vector<TimedWork>& works, int repetitions) {
  std::vector<std::vector<double>> times(works.size());
  // The first turn warms memory and processor.
  for (int i = -1; i < repetitions; ++i)
    for (std::size_t k = 0; k < works.size(); ++k) {
      if (works[k].prepare) works[k].prepare();
      const double start = thread_time();
      works[k].run();
      if (i >= 0) times[k].push_back((thread_time() - start) / static_cast<double>(works[k].items));
    }
  std::vector<Timing> timings;
  for (const auto& one : times) timings.push_back(timing_of(one));
  return timings;
}

}  // namespace osculate::app
