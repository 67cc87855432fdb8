#pragma once
// Timing of short work by repetition, in processor time.

#include <cstddef>
#include <functional>
#include <vector>

namespace osculate::app {

/// Time of one item: the median of the repetitions, and half the distance between their quartiles.
struct Timing {
  double median = 0.0;  ///< [ns]
  double spread = 0.0;  ///< [ns]
};

/// Of the times of all repetitions, at least one.
Timing timing_of(std::vector<double> times);

/// Runs `prepare` (not timed) and `work` (timed) again and again; `items` is how many items `work` handles.
Timing time_of(std::size_t items, int repetitions, const std::function<void()>& prepare,
               const std::function<void()>& work);

struct TimedWork {
  std::size_t items;  ///< that it handles
  std::function<void()> run;
  std::function<void()> prepare = {};  ///< before each run, untimed
};

/// Times of each work, taken in turns: a machine that is slower for a while is so for all of them.
std::vector<Timing> times_in_turns(const std::vector<TimedWork>& works, int repetitions);

}  // namespace osculate::app
