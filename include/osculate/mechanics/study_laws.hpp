#pragma once
// Theories of the review that no time step takes, by name: functions of a state, for studies. What a law of the
// registry (law_registry.hpp) is to a contact, one of these is to a patch, a polygon or a single number.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "osculate/mechanics/law_registry.hpp"

namespace osculate {

/// One number that a theory answers.
struct StudyResult {
  std::string_view name;   ///< "sliding_share"
  std::string_view title;  ///< in words, with the symbol
  std::string_view unit;   ///< SI; "" for a pure number
};

struct StudyLaw {
  std::string_view name;
  LawSlot slot;  ///< what it would be a law of
  std::string_view title;
  std::string_view formula;                  ///< one line
  std::string_view equations;                ///< of the review
  std::string_view source;                   ///< keys of docs/references.md
  std::string_view reason;                   ///< why no composition takes it
  std::span<const LawParameter> parameters;  ///< materials and state among them
  std::span<const StudyResult> results;
  std::string_view shown;  ///< the parameter that a picture varies, from `shown_from` to `shown_to`
  double shown_from, shown_to;
  /// Of all parameters, each in its range; as many numbers as `results`.
  std::vector<double> (*answer)(const std::map<std::string, double>& parameters);
};

std::span<const StudyLaw* const> study_laws();
/// nullptr where there is none of this name.
const StudyLaw* study_law(std::string_view name);

/// What the theory answers; parameters left out take their standard value. Throws InputError for a parameter that is
/// unknown, out of range or missing, and for what the theory itself refuses.
std::vector<double> evaluate(const StudyLaw& law, const std::map<std::string, double>& parameters);

}  // namespace osculate
