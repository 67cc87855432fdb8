#pragma once
// The eight impact tests of Chung and Ooi through the engine, against the closed forms of elastic Hertz impact and of
// impacts with slip from beginning to end.                                                                      [CO11]

#include <string>
#include <vector>

namespace osculate::validation {

struct ImpactRow {
  int test;               ///< 1 to 8
  std::string material;   ///< "glass"
  std::string condition;  ///< "incidence 50°"
  std::string quantity;   ///< with its unit
  double closed_form;
  double computed;
  double tolerance;  ///< of the difference, relative to the closed form

  double difference() const { return computed / closed_form - 1.0; }
  bool agrees() const { return difference() <= tolerance && -difference() <= tolerance; }
};

/// What each test is: index test − 1.
const std::vector<std::string>& impact_test_titles();

/// All rows, test by test. Rows of oblique and spinning impacts are those in which the surfaces slip throughout:
/// v_s ≥ 7/2 µ (1 + ε) v_n for a sphere on a plane; the others need the partial-slip solution of [MBF76], which is no
/// closed form.
std::vector<ImpactRow> impact_tests();

}  // namespace osculate::validation
