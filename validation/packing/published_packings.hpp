#pragma once
// Random packings of the engine beside what others have measured and computed.

#include <string>
#include <vector>

#include "validation/independent_cases.hpp"
#include "validation/packing/jammed_packing.hpp"

namespace osculate::validation {

struct PublishedRange {
  double least, most;

  /// Within the range, widened by so much.
  bool holds(double value, double tolerance) const { return value >= least - tolerance && value <= most + tolerance; }
};

struct PublishedPacking {
  std::string name;
  Shape shape;
  PublishedRange fraction;
  PublishedRange coordination;
  std::string source;  ///< what is known of the ranges, with keys of docs/references.md
};

/// Spheres, ellipsoids and superballs.
std::vector<PublishedPacking> published_packings();

struct Mean {
  double value;
  double error;  ///< standard error of the mean
};
/// Of two values at least.
Mean mean_of(const std::vector<double>& values);

struct PackingRow {
  PublishedPacking published;
  std::vector<JammedPacking> packings;  ///< one a seed
  Mean fraction, coordination, rattlers;

  /// Both means lie in their ranges, give or take two standard errors.
  bool agrees() const;
};

/// `seeds` ≥ 2 packings of each, with seeds 1, 2, …, `threads` of them at a time.
std::vector<PackingRow> packing_rows(const std::vector<PublishedPacking>& published, std::uint64_t particles, int seeds,
                                     int threads, const Done& done = {});

}  // namespace osculate::validation
