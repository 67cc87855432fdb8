#pragma once
// A theory that no time step takes, evaluated: at a state, along a sweep, for each row of a table.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/law_evaluation.hpp"
#include "io/number_table.hpp"
#include "io/plot.hpp"
#include "osculate/mechanics/study_laws.hpp"

namespace osculate::app {

/// Parameters from "key=value". Throws InputError for what is no assignment or no number.
std::map<std::string, double> study_parameters(const StudyLaw& law, const std::vector<std::string>& assignments);

/// Columns: those of `varied`, which are parameters of the law, then its results.
io::NumberTable answers(const StudyLaw& law, const std::map<std::string, double>& parameters,
                        const io::NumberTable& varied);

/// What a picture shows where nothing was varied.
Sweep usual_sweep(const StudyLaw& law);

/// In words, and the SI unit, of a parameter or a result.
std::string_view title_of(const StudyLaw& law, std::string_view column);
std::string_view unit_of(const StudyLaw& law, std::string_view column);

/// Results of one unit to a panel, over the first column.
io::Plot study_plot(const StudyLaw& law, const io::NumberTable& numbers);

}  // namespace osculate::app
