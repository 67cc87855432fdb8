#include "app/study_law.hpp"

#include <algorithm>

#include "app/law_picture.hpp"

namespace osculate::app {

std::map<std::string, double> study_parameters(const StudyLaw& law, const std::vector<std::string>& assignments) {
  std::map<std::string, double> parameters;
  for (const std::string& text : assignments) {
    const auto [key, value] = assignment_of(text);
    const std::string own = std::string(law.name) + ".";
    parameters[key.starts_with(own) ? key.substr(own.size()) : key] = value;
  }
  return parameters;
}

io::NumberTable answers(const StudyLaw& law, const std::map<std::string, double>& parameters,
                        const io::NumberTable& varied) {
  io::NumberTable table = varied;
  for (const StudyResult& result : law.results) table.names.emplace_back(result.name);
  table.columns.resize(table.names.size());
  for (std::size_t row = 0; row < varied.rows(); ++row) {
    auto here = parameters;
    for (std::size_t k = 0; k < varied.names.size(); ++k) here[varied.names[k]] = varied.columns[k][row];
    const std::vector<double> answer = evaluate(law, here);
    for (std::size_t k = 0; k < answer.size(); ++k) table.columns[varied.names.size() + k].push_back(answer[k]);
  }
  return table;
}

Sweep usual_sweep(const StudyLaw& law) {
  constexpr std::size_t count = 121;
  return {std::string(law.shown), spaced(law.shown_from, law.shown_to, count)};
}

std::string_view title_of(const StudyLaw& law, std::string_view column) {
  const auto result = std::ranges::find(law.results, column, &StudyResult::name);
  if (result != law.results.end()) return result->title;
  const auto parameter = std::ranges::find(law.parameters, column, &LawParameter::name);
  return parameter != law.parameters.end() ? parameter->meaning : column;
}

std::string_view unit_of(const StudyLaw& law, std::string_view column) {
  const auto result = std::ranges::find(law.results, column, &StudyResult::name);
  if (result != law.results.end()) return result->unit;
  const auto parameter = std::ranges::find(law.parameters, column, &LawParameter::name);
  return parameter != law.parameters.end() ? parameter->unit : "";
}

namespace {

/// What several results of one unit have in common.
std::string quantity(const StudyResult& result) {
  for (const auto& [unit, word] : {std::pair{"N", "force"}, {"N m", "moment"}, {"m^2", "area"}, {"N/m", "stiffness"}})
    if (result.unit == unit) return word;
  return "length";
}

}  // namespace

io::Plot study_plot(const StudyLaw& law, const io::NumberTable& numbers) {
  const ColumnWords words{[&](std::string_view column) { return title_of(law, column); },
                          [&](std::string_view column) { return unit_of(law, column); }};
  const std::string& column = numbers.names.front();
  const AxisText axis{column, std::string(title_of(law, column)), std::string(unit_of(law, column))};
  const auto varies = [&](std::string_view name) {
    const auto [least, most] = std::ranges::minmax(*numbers.find(name));
    return least != most;
  };
  io::Plot plot{.title = std::string(law.title), .panels = {}};
  std::vector<std::string> done;
  for (const StudyResult& first : law.results) {
    if (std::ranges::find(done, first.unit) != done.end()) continue;
    done.emplace_back(first.unit);
    std::vector<std::string> names;
    for (const StudyResult& result : law.results)
      if (result.unit == first.unit) names.emplace_back(result.name);
    // What stays as it is tells nothing, but beside something that moves.
    if (std::ranges::none_of(names, varies) && !std::ranges::none_of(law.results, varies, &StudyResult::name)) continue;
    plot.panels.push_back(
        panel_over(numbers, axis, names.size() > 1 ? quantity(first) : std::string(first.title), names, words));
  }
  return plot;
}

}  // namespace osculate::app
