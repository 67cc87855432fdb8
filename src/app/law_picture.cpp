#include "app/law_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/law_evaluation.hpp"
#include "io/quantity_text.hpp"

namespace osculate::app {
namespace {

struct ColumnText {
  std::string_view name, title, unit;
};
constexpr std::array columns{ColumnText{"overlap", "overlap δ", "m"},
                             ColumnText{"x", "displacement along the major axis", "m"},
                             ColumnText{"y", "displacement along the minor axis", "m"},
                             ColumnText{"twist", "twist φ", "rad"},
                             ColumnText{"time", "time", "s"},
                             ColumnText{"rate", "speed of approach", "m/s"},
                             ColumnText{"slip", "sliding speed", "m/s"},
                             ColumnText{"spin", "spin", "rad/s"},
                             ColumnText{"normal_force", "normal force F_n", "N"},
                             ColumnText{"tangential_x", "tangential force, major axis", "N"},
                             ColumnText{"tangential_y", "tangential force, minor axis", "N"},
                             ColumnText{"couple", "couple about the normal", "N m"},
                             ColumnText{"a_c", "major semi-axis a_c", "m"},
                             ColumnText{"b_c", "minor semi-axis b_c", "m"},
                             ColumnText{"stiffness", "stiffness dF_n/dδ", "N/m"},
                             ColumnText{"stored_normal", "stored by the normal force", "J"},
                             ColumnText{"stored_tangential", "stored by tangential springs", "J"},
                             ColumnText{"viscous_loss", "lost by viscosity", "J"},
                             ColumnText{"friction_loss", "lost by friction", "J"},
                             ColumnText{"hysteresis_loss", "lost by plastic flow or snap-off", "J"}};

const ColumnText* text_of(std::string_view column) {
  const auto* found = std::ranges::find(columns, column, &ColumnText::name);
  return found == columns.end() ? nullptr : found;
}

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) result = std::max(result, std::fabs(value));
  return result;
}

std::vector<double> scaled(const std::vector<double>& values, double unit) {
  std::vector<double> result(values.size());
  std::ranges::transform(values, result.begin(), [unit](double value) { return value / unit; });
  return result;
}

/// Titles as the plot sets them: "F_n" with a lowered n, "m^2" with a raised 2.
std::string typeset(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((text[i] == '_' || text[i] == '^') && i + 1 < text.size()) {
      const char shift = text[i];
      result += fmt::format("{}{{{}}}", shift, text[++i]);
    } else {
      result += text[i];
    }
  }
  return result;
}

bool is_logarithmic(const std::vector<double>& values) {
  constexpr double decades = 30.0;
  return values.front() > 0.0 && values.back() > 0.0 && values.size() > 2 &&
         std::max(values.front(), values.back()) > decades * std::min(values.front(), values.back()) &&
         std::fabs(values[1] / values[0] - values[2] / values[1]) < 1e-6 * values[1] / values[0];
}

std::string with_unit(const std::string& label, const std::string& unit) {
  return unit.empty() ? typeset(label) : fmt::format("{} [{}]", typeset(label), typeset(unit));
}

}  // namespace

io::PrefixedUnit unit_for(double size, std::string_view unit) {
  if (unit == "m^2") {
    constexpr double few = 10.0;  // 0.3 mm^2 rather than 300000 µm^2
    const io::PrefixedUnit side = io::prefixed_unit(std::sqrt(few * std::fabs(size)), "m");
    return {side.symbol + "^2", side.size * side.size};
  }
  if (unit.empty() || unit.find('^') != std::string_view::npos) return {std::string(unit), 1.0};
  return io::prefixed_unit(size, unit);
}

io::Panel panel_over(const io::NumberTable& numbers, const AxisText& axis, const std::string& label,
                     std::vector<std::string> names, const ColumnWords& words) {
  double size = 0.0;
  for (const std::string& name : names) size = std::max(size, largest(*numbers.find(name)));
  std::erase_if(names,
                [&](const std::string& name) { return name != names.front() && largest(*numbers.find(name)) == 0.0; });
  const std::vector<double>& values = *numbers.find(axis.column);
  const auto x_unit = unit_for(largest(values), axis.unit), unit = unit_for(size, words.unit(names.front()));
  io::Panel result{.title = "",
                   .x = {.label = with_unit(axis.title, x_unit.symbol),
                         .scale = is_logarithmic(values) ? io::Scale::logarithmic : io::Scale::linear},
                   .y = {.label = with_unit(label, unit.symbol)},
                   .curves = {}};
  for (const std::string& name : names)
    result.curves.push_back({.name = names.size() > 1 ? typeset(words.title(name)) : "",
                             .x = scaled(values, x_unit.size),
                             .y = scaled(*numbers.find(name), unit.size)});
  return result;
}

std::string_view answer_title(std::string_view column) {
  const ColumnText* text = text_of(column);
  return text != nullptr ? text->title : column;
}

std::string_view answer_unit(std::string_view column) {
  const ColumnText* text = text_of(column);
  return text != nullptr ? text->unit : "";
}

std::string law_axis(const io::NumberTable& numbers, const std::string& swept_key) {
  if (!swept_key.empty()) return swept_key;
  const auto moves = [&](const std::string& name) {
    const auto& values = *numbers.find(name);
    std::size_t count = 0;
    for (std::size_t i = 1; i < values.size(); ++i) count += values[i] != values[i - 1] ? 1 : 0;
    return count;
  };
  std::string best = numbers.names.front();
  std::size_t most = 0;
  // Motion is drawn over what moves; over time only where nothing else does.
  for (const char* name : {"x", "y", "twist", "overlap", "rate", "slip", "time"})
    if (numbers.find(name) != nullptr && moves(name) > most) best = name, most = moves(name);
  return best;
}

io::Plot law_plot(const LawDescription& law, const io::NumberTable& numbers, const std::string& axis,
                  const std::string& unit) {
  const AxisText x{axis, unit.empty() ? axis : std::string(answer_title(axis)), unit};
  io::Plot plot{.title = std::string(law.title), .panels = {}};
  const auto draw = [&](const std::string& label, const std::vector<std::string>& names) {
    plot.panels.push_back(panel_over(numbers, x, label, names, {answer_title, answer_unit}));
  };
  switch (law.slot) {
    case LawSlot::normal:
    case LawSlot::adhesion:
    case LawSlot::roughness:
    case LawSlot::plasticity:
      draw("normal force F_n", {"normal_force"});
      draw("semi-axes of the contact", {"a_c", "b_c"});
      draw("energy", {"stored_normal", "viscous_loss", "hysteresis_loss"});
      break;
    case LawSlot::dissipation:
      draw("normal force F_n", {"normal_force"});
      draw("lost in a step", {"viscous_loss"});
      break;
    case LawSlot::tangential:
      draw("tangential force", {"tangential_x", "tangential_y"});
      draw("energy", {"stored_tangential", "viscous_loss", "friction_loss"});
      break;
    case LawSlot::rolling:
      draw("tangential force", {"tangential_x", "tangential_y"});
      if (largest(*numbers.find("couple")) > 0.0) draw("couple about the normal", {"couple"});
      break;
    case LawSlot::twisting:
      draw("couple about the normal", {"couple"});
      draw("energy", {"stored_tangential", "friction_loss"});
      break;
  }
  if (plot.panels.size() == 3) plot.columns = 3;
  return plot;
}

}  // namespace osculate::app
