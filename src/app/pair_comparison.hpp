#pragma once
// Computed contacts against the known answers of a pair table: the worst difference of each class, and what it may be.

#include <cstddef>
#include <string>
#include <vector>

#include "io/pair_table.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate::app {

/// How far a contact may be from the known answer. R_vol is the smaller body's volume-equivalent radius.
struct PairTolerances {
  double depth = 1e-12;        ///< |Δδ| / R_vol
  double normal = 1e-9;        ///< angle [rad]
  double curvature = 1e-8;     ///< relative, or times 1/R_vol where the surface is nearly flat
  double next_minimum = 1e-9;  ///< / a1: a nearer second minimum makes every number but the depth ambiguous
};

/// The worst of one class; differences of points are in units of R_vol.
struct ClassDifferences {
  std::string name;
  std::size_t lines = 0;
  double depth = 0.0;
  double normal = 0.0;     ///< [rad], unambiguous lines
  double point = 0.0;      ///< unambiguous lines
  double curvature = 0.0;  ///< in units of max(|k|, 1/R_vol), unambiguous lines
  std::size_t ambiguous = 0;
  std::vector<std::size_t> failing;  ///< line numbers
};

/// Adds up blocks; classes stand in the order in which they first appear.
class PairComparison {
 public:
  void add(const io::PairBlock& block, const ContactColumns& computed);
  const std::vector<ClassDifferences>& classes() const { return classes_; }
  bool passed() const;

 private:
  ClassDifferences& of_class(const std::string& name);

  PairTolerances tolerances_;
  std::vector<ClassDifferences> classes_;
};

/// The table that people read, with a line for every missed bar.
std::string to_text(const PairComparison& comparison);

}  // namespace osculate::app
