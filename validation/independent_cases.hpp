#pragma once
// Simulations that have nothing to do with each other, side by side.

#include <functional>
#include <vector>

namespace osculate::validation {

/// Told how far something is, 0 to 1.
using Done = std::function<void(double)>;
using Case = std::function<void(const Done&)>;

/// Begins the cases in order, `threads` of them at a time. `done` is told how far they are on average, by the calling
/// thread. Once a case has thrown no other is begun; what the first of them in order threw comes out when all have
/// ended.
/// @pre threads > 0
void run_independent(const std::vector<Case>& cases, int threads, const Done& done);

int processors();

}  // namespace osculate::validation
