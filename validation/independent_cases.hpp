#pragma once
// Simulations that have nothing to do with each other, side by side.

#include <functional>
#include <vector>

namespace osculate::validation {

/// Told how far something is, 0 to 1.
using Done = std::function<void(double)>;
/// A piece of work; its first error is kept.
using Case = std::function<void(const Done&)>;

/// Runs every case, on as many threads as there are processors; which comes first must not matter. `done` is told how
/// far they are on average, by the calling thread. Throws what a case threw, the first of them in order, when all have
/// ended; cases not yet begun by then are left out.
void run_independent(const std::vector<Case>& cases, const Done& done);

}  // namespace osculate::validation
