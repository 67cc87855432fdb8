#pragma once
// Timing of short work by repetition, in processor time.

#include <functional>

namespace osculate::app {

/// Time of one item: the median of the repetitions, and half the distance between their quartiles.
struct Timing {
  double median = 0.0;  ///< [ns]
  double spread = 0.0;  ///< [ns]
};

/// Runs `prepare` (not timed) and `work` (timed) again and again; `items` is how many items `work` handles.
Timing time_of(std::size_t items, int repetitions, const std::function<void()>& prepare,
               const std::function<void()>& work);

}  // namespace osculate::app
