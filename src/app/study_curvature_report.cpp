#include "app/study_curvature_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "io/hdf5_image.hpp"
#include "io/table.hpp"

namespace osculate::app {
namespace {

namespace study = validation::curvature_models;
using study::CaseErrors;
using study::Group;
using study::Spread;

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

std::string percent(double error) {
  const double value = 100.0 * error;
  return fmt::format("{:+.{}f}", std::fabs(value) < 5e-3 ? 0.0 : value, std::fabs(value) < 10.0 ? 2 : 0);
}

std::string percent(const Spread& spread) {
  return fmt::format("{} [{}, {}]", percent(spread.median), percent(spread.low), percent(spread.high));
}

/// What rounding leaves of zero is written as zero.
double cleaned(double value) {
  return std::fabs(value) < 1e-9 ? 0.0 : value;
}

std::string number(const Spread& spread) {
  return fmt::format("{:.2g} [{:.2g}]", cleaned(spread.median), cleaned(spread.high));
}

using ErrorsOfModels = std::array<Spread, study::models.size()> Group::*;

std::string model_table(const std::vector<Group>& groups, ErrorsOfModels errors) {
  io::Table table{{"n", "c/a", "δ/R_vol"}, {}};
  for (const CurvatureModel model : study::models) table.header.emplace_back(name(model));
  for (const Group& group : groups) {
    table.rows.push_back(
        {fmt::format("{:g}", group.exponent), fmt::format("{:g}", group.aspect), fmt::format("{:g}", group.overlap)});
    for (const Spread& spread : group.*errors)
      table.rows.back().push_back(group.contacts > 0 ? percent(spread) : "no answer");
  }
  return io::to_text(table);
}

std::string potential_table(const std::vector<Group>& groups) {
  io::Table table{{"n", "c/a", "δ/R_vol", "point / δ", "normal [°]", "overlap [%]", "force [%]", "failed"}, {}};
  for (const Group& group : groups) {
    const Spread angle{degrees(group.normal.low), degrees(group.normal.median), degrees(group.normal.high)};
    table.rows.push_back({fmt::format("{:g}", group.exponent), fmt::format("{:g}", group.aspect),
                          fmt::format("{:g}", group.overlap), number(group.point), number(angle),
                          percent(group.overlap_error), percent(group.potential_force),
                          fmt::format("{}", group.potential_failures)});
  }
  return io::to_text(table);
}

/// The values that a parameter takes, ascending.
std::set<double> values_of(const std::vector<Group>& groups, double Group::*parameter) {
  std::set<double> values;
  for (const Group& group : groups) values.insert(group.*parameter);
  return values;
}

void join_or_dot(io::Curve& curve) {
  if (curve.x.size() == 1) curve.mark = io::Mark::points;
}

constexpr std::array<io::Colour, study::models.size()> model_colours{io::palette::black, io::palette::orange,
                                                                     io::palette::blue, io::palette::green};

/// Errors of all models over the exponent, at one aspect and overlap.
io::Panel model_panel(const std::vector<Group>& groups, ErrorsOfModels errors, const char* quantity, double aspect,
                      double overlap) {
  io::Panel panel{.title = fmt::format("{}, c/a = {:g}, δ = {:g} R_{{vol}}", quantity, aspect, overlap),
                  .x = {.label = "exponent n"},
                  .y = {.label = "error [%]"},
                  .curves = {}};
  for (std::size_t i = 0; i < study::models.size(); ++i) {
    const auto add = [&](std::string label, double Spread::*part, io::Mark mark) {
      io::Curve curve{.name = std::move(label), .x = {}, .y = {}, .mark = mark, .colour = model_colours[i]};
      for (const Group& group : groups) {
        if (group.aspect != aspect || group.overlap != overlap || group.contacts == 0) continue;
        curve.x.push_back(group.exponent);
        curve.y.push_back(100.0 * ((group.*errors)[i].*part));
      }
      if (curve.x.empty()) return;
      join_or_dot(curve);
      panel.curves.push_back(curve);
    };
    add(std::string(name(study::models[i])), &Spread::median, io::Mark::line);
    add("", &Spread::low, io::Mark::dotted);
    add("", &Spread::high, io::Mark::dotted);
  }
  return panel;
}

/// 95 % of an error's size over the overlap, one curve an exponent, at one aspect. Errors of zero have no place on the
/// axis: spheres have none.
template <class Size>
io::Panel potential_panel(const std::vector<Group>& groups, std::string title, std::string label, double aspect,
                          const Size& size) {
  io::Panel panel{.title = std::move(title),
                  .x = {.label = "overlap δ/R_{vol}", .scale = io::Scale::logarithmic},
                  .y = {.label = std::move(label), .scale = io::Scale::logarithmic},
                  .curves = {}};
  for (const double exponent : values_of(groups, &Group::exponent)) {
    io::Curve curve{.name = fmt::format("n = {:g}", exponent), .x = {}, .y = {}};
    for (const Group& group : groups) {
      const double error = size(group);
      constexpr double rounding = 1e-12;
      if (group.exponent != exponent || group.aspect != aspect || !(error > rounding)) continue;
      curve.x.push_back(group.overlap);
      curve.y.push_back(error);
    }
    if (curve.x.empty()) continue;
    join_or_dot(curve);
    panel.curves.push_back(curve);
  }
  return panel;
}

}  // namespace

std::string curvature_study_text(const std::vector<CaseErrors>& errors, const CurvatureStudyTitle& title) {
  const std::vector<Group> groups = study::groups_of(errors);
  std::size_t unanswered = 0;
  for (const Group& group : groups) unanswered += group.unanswered;
  return fmt::format(
      "Two equal superquadrics of half-axes 1 : 1 : c/a and exponent n, {} random orientations of each.\n"
      "Errors in per cent against {}: median [5 %, 95 %].\n\n"
      "Force, by the model of curvature\n{}\nArea of contact, by the model of curvature\n{}\n"
      "Geometric potential against common normal: distance of the contact points over δ and angle of the normals,\n"
      "median [95 %]; its overlap, and the elliptical Hertz force from its own curvatures and overlap\n{}{}",
      title.orientations, title.reference, model_table(groups, &Group::force), model_table(groups, &Group::area),
      potential_table(groups),
      unanswered > 0
          ? fmt::format("\nWithout a reference, and left out: {} contacts of {}.\n", unanswered, errors.size())
          : "");
}

std::vector<StudyColumn> curvature_study_columns(const std::vector<CaseErrors>& errors) {
  std::vector<StudyColumn> columns;
  const auto add = [&](std::string label, const char* meaning, const auto& value) {
    StudyColumn column{std::move(label), meaning, {}};
    column.values.reserve(errors.size());
    for (const CaseErrors& error : errors) column.values.push_back(value(error));
    columns.push_back(std::move(column));
  };
  add("exponent", "n1 = n2", [](const CaseErrors& e) { return e.input.exponent; });
  add("aspect", "c/a", [](const CaseErrors& e) { return e.input.aspect; });
  add("overlap", "δ/R_vol", [](const CaseErrors& e) { return e.input.overlap; });
  add("orientation", "number of the random orientation", [](const CaseErrors& e) { return e.input.orientation; });
  add("R_i", "larger radius of relative curvature over R_vol",
      [](const CaseErrors& e) { return e.input.contact.relative.R_i; });
  add("R_j", "smaller radius of relative curvature over R_vol",
      [](const CaseErrors& e) { return e.input.contact.relative.R_j; });
  add("has_reference", "1: the errors of forces and areas hold; 0: they are not known and written as 0",
      [](const CaseErrors& e) { return e.has_reference ? 1.0 : 0.0; });
  for (std::size_t i = 0; i < study::models.size(); ++i) {
    std::string label(name(study::models[i]));
    std::replace(label.begin(), label.end(), '-', '_');
    add(label + "_force_error", "force over the reference's, less 1", [i](const CaseErrors& e) { return e.force[i]; });
    add(label + "_area_error", "area over the reference's, less 1", [i](const CaseErrors& e) { return e.area[i]; });
    add(label + "_capped", "1: a radius was replaced by the cap",
        [i](const CaseErrors& e) { return e.capped[i] ? 1.0 : 0.0; });
  }
  add("potential_resolved", "1: the geometric potential has an answer; 0: its errors are written as 0",
      [](const CaseErrors& e) { return is_resolved(e.potential.status) ? 1.0 : 0.0; });
  add("potential_point_error", "distance of the contact points over δ",
      [](const CaseErrors& e) { return e.potential.point; });
  add("potential_normal_error", "angle of the normals [rad]", [](const CaseErrors& e) { return e.potential.normal; });
  add("potential_overlap_error", "overlap over δ, less 1", [](const CaseErrors& e) { return e.potential.overlap; });
  add("potential_force_error", "force over the reference's, less 1",
      [](const CaseErrors& e) { return e.potential.force; });
  return columns;
}

std::string csv_of(const std::vector<StudyColumn>& columns) {
  std::string csv;
  for (const StudyColumn& column : columns) csv += (csv.empty() ? "" : ",") + column.name;
  csv += '\n';
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      fmt::format_to(std::back_inserter(csv), "{}{:.10g}", i == 0 ? "" : ",", columns[i].values[row]);
    csv += '\n';
  }
  return csv;
}

std::string json_of(const std::vector<StudyColumn>& columns) {
  nlohmann::ordered_json document;
  for (const StudyColumn& column : columns) document[column.name] = column.values;
  return document.dump();
}

std::string hdf5_of(const std::vector<StudyColumn>& columns, const CurvatureStudyTitle& title) {
  io::Hdf5Image file;
  file.add_group("/contacts");
  file.set_text("/contacts", "reference", title.reference);
  for (const StudyColumn& column : columns) {
    const std::string path = "/contacts/" + column.name;
    file.add_numbers(path, column.values);
    file.set_text(path, "meaning", column.meaning);
  }
  return file.bytes();
}

io::Plot curvature_study_plot(const std::vector<CaseErrors>& errors, const CurvatureStudyTitle& title) {
  const std::vector<Group> groups = study::groups_of(errors);
  const auto overlaps = values_of(groups, &Group::overlap);
  const double aspect = *values_of(groups, &Group::aspect).rbegin();
  const double overlap = *std::next(overlaps.begin(), static_cast<std::ptrdiff_t>((overlaps.size() - 1) / 2));
  io::Plot plot{.title = fmt::format("Errors of simpler contacts, against {}", title.reference), .panels = {}};
  const auto add = [&](io::Panel panel) {
    if (!panel.curves.empty()) plot.panels.push_back(std::move(panel));
  };
  add(model_panel(groups, &Group::force, "Force: median, 5 % and 95 %", aspect, overlap));
  add(model_panel(groups, &Group::area, "Area: median, 5 % and 95 %", aspect, overlap));
  add(potential_panel(groups, fmt::format("Normal of the geometric potential, c/a = {:g}", aspect),
                      "95 % of the angles to the common normal [°]", aspect,
                      [](const Group& group) { return degrees(group.normal.high); }));
  add(potential_panel(groups, fmt::format("Overlap of the geometric potential, c/a = {:g}", aspect),
                      "95 % of the overlaps' errors [%]", aspect, [](const Group& group) {
                        return 100.0 *
                               std::max(std::fabs(group.overlap_error.low), std::fabs(group.overlap_error.high));
                      }));
  return plot;
}

}  // namespace osculate::app
