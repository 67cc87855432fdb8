#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/law_evaluation.hpp"
#include "app/law_picture.hpp"
#include "app/study_law.hpp"
#include "io/atomic_file.hpp"
#include "io/quantity_text.hpp"
#include "io/table.hpp"
#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

using nlohmann::ordered_json;

constexpr const char* help =
    R"(Without a name: every law, by slot. With a name: what the law is. With numbers: what it says.
Numbers are in SI units; keys are those of the law and of the contact (both listed by `osculate law NAME`).

  osculate law                                                    all laws
  osculate law jamari_schipper                                    one law: formula, parameters, what it goes with
  osculate law hertz --set R_i=2e-3 R_j=1e-3 overlap=1e-6         a state
  osculate law jkr --set work_of_adhesion=0.05 --picture jkr.png  loading and unloading (the law's usual path)
  osculate law mindlin --with brilliantov --set friction=0.3 dissipative_time=1e-8 --sweep x=0:4e-7:50
  osculate law brilliantov --set dissipative_time=1e-7 --sweep overlap=1e-8:1e-5:40:log --csv force.csv
  osculate law mindlin --set friction=0.3 --path load.csv --picture loop.svg
  osculate law polygon_energy --set coefficient=1e5 --sweep turn=0:1.5:100 --picture turned.svg

A load path is a table of comma-separated numbers under a header, with any of the columns
  time [s], overlap [m], x, y [m] (displacement of body 2 along the major and minor axis), twist [rad].
A sweep of overlap, x, y or twist is such a path too: the contact remembers. For any other key each value is a contact
of its own. Losses are sums from the start.
Theories that no time step takes stand at the end of the list. They answer for a state, which is all in their
parameters; a table given to --path has columns of these, and each row is a state of its own.)";

struct Options {
  std::string name;
  std::vector<std::string> with, assignments;
  std::string sweep, path, csv, picture;
  bool json = false;

  bool evaluates() const {
    return !assignments.empty() || !sweep.empty() || !path.empty() || !csv.empty() || !picture.empty();
  }
};

ordered_json json_of(std::span<const LawParameter> parameters) {
  ordered_json result = ordered_json::array();
  for (const LawParameter& parameter : parameters) {
    ordered_json one{{"name", parameter.name},
                     {"symbol", parameter.symbol},
                     {"unit", parameter.unit},
                     {"meaning", parameter.meaning},
                     {"range", parameter.range()}};
    if (parameter.standard) one["default"] = *parameter.standard;
    result.push_back(one);
  }
  return result;
}

ordered_json json_of(const StudyLaw& law) {
  ordered_json results = ordered_json::array();
  for (const StudyResult& result : law.results)
    results.push_back({{"name", result.name}, {"title", result.title}, {"unit", result.unit}});
  return {{"name", law.name},
          {"slot", name(law.slot)},
          {"title", law.title},
          {"formula", law.formula},
          {"equations", law.equations},
          {"source", law.source},
          {"in_no_time_step", law.reason},
          {"parameters", json_of(law.parameters)},
          {"results", results}};
}

ordered_json json_of(const LawDescription& law) {
  ordered_json result{{"name", law.name},
                      {"slot", name(law.slot)},
                      {"title", law.title},
                      {"formula", law.formula},
                      {"equations", law.equations},
                      {"source", law.source},
                      {"memory_doubles", law.memory},
                      {"parameters", json_of(law.parameters)},
                      {"refused_with", ordered_json::array()}};
  for (const LawConflict& conflict : law.conflicts)
    result["refused_with"].push_back({{"other", conflict.other}, {"but", conflict.but}, {"reason", conflict.reason}});
  return result;
}

std::string parameters_text(std::span<const LawParameter> parameters) {
  std::string text;
  for (const LawParameter& parameter : parameters) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", parameter.name);
    if (!parameter.unit.empty()) text += fmt::format(" [{}]", parameter.unit);
    if (parameter.standard) text += fmt::format(" = {:.4g}", *parameter.standard);
  }
  return text;
}

void list_laws(bool json) {
  if (json) {
    ordered_json all = ordered_json::array();
    for (const LawDescription* law : law_registry()) all.push_back(json_of(*law));
    for (const StudyLaw* law : study_laws()) all.push_back(json_of(*law));
    fmt::print("{}\n", all.dump(2));
    return;
  }
  fmt::print(
      "Laws of contact: at most one of each slot, and always a normal one. Equations are those of the review.\n");
  for (std::size_t s = 0; s < law_slots; ++s) {
    const auto slot = static_cast<LawSlot>(s);
    io::Table table{{std::string(name(slot)), "what it is", "equations", "parameters"}, {}, 4};
    for (const LawDescription* law : law_registry())
      if (law->slot == slot)
        table.rows.push_back({std::string(law->name), std::string(law->title), std::string(law->equations),
                              parameters_text(law->parameters)});
    fmt::print("\n{}", io::to_text(table));
  }
  io::Table table{{"in no time step", "what it is", "equations", "parameters without a default"}, {}, 4};
  for (const StudyLaw* law : study_laws()) {
    std::vector<LawParameter> required(law->parameters.begin(), law->parameters.end());
    std::erase_if(required, [](const LawParameter& parameter) { return parameter.standard.has_value(); });
    table.rows.push_back(
        {std::string(law->name), std::string(law->title), std::string(law->equations), parameters_text(required)});
  }
  fmt::print("\n{}", io::to_text(table));
  fmt::print("\n`osculate law NAME` says more about one; `osculate law --help` how to evaluate it.\n");
}

void print_parameters(std::span<const LawParameter> of) {
  io::Table parameters{{"parameter", "symbol", "unit", "range", "default", "meaning"}, {}, 6};
  for (const LawParameter& p : of)
    parameters.rows.push_back({std::string(p.name), std::string(p.symbol), std::string(p.unit), p.range(),
                               p.standard ? fmt::format("{:.4g}", *p.standard) : "required", std::string(p.meaning)});
  if (!parameters.rows.empty()) fmt::print("{}\n", io::to_text(parameters));
}

void describe(const StudyLaw& law) {
  fmt::print("{} ({})\n{}\n\n  {}\n\n", law.name, name(law.slot), law.title, law.formula);
  fmt::print("Equations of the review: {}\nSources: {} (docs/references.md)\nIn no time step: {}.\n\n", law.equations,
             law.source, law.reason);
  print_parameters(law.parameters);
  io::Table results{{"result", "unit", "meaning"}, {}, 3};
  for (const StudyResult& result : law.results)
    results.rows.push_back({std::string(result.name), std::string(result.unit), std::string(result.title)});
  fmt::print("{}", io::to_text(results));
}

void describe(const LawDescription& law) {
  fmt::print("{} ({})\n{}\n\n  {}\n\n", law.name, name(law.slot), law.title, law.formula);
  if (!law.equations.empty()) fmt::print("Equations of the review: {}\n", law.equations);
  fmt::print("Sources: {} (docs/references.md)\nMemory: {} doubles a contact\n\n", law.source, law.memory);
  print_parameters(law.parameters);
  for (const LawConflict& conflict : law.conflicts) {
    std::string but;
    for (const std::string_view one : conflict.but) but += fmt::format("{}{}", but.empty() ? "" : ", ", one);
    fmt::print("Not with {}{}: {}.\n", conflict.other, but.empty() ? "" : " other than " + but, conflict.reason);
  }
  if (!law.conflicts.empty()) fmt::print("\n");
  io::Table contact{{"contact", "symbol", "unit", "default", "meaning"}, {}, 5};
  for (const ContactKey& key : contact_keys)
    contact.rows.push_back({std::string(key.name), std::string(key.symbol), std::string(key.unit),
                            std::isnan(key.standard) ? "as body 1" : fmt::format("{:.4g}", key.standard),
                            std::string(key.meaning)});
  fmt::print("{}", io::to_text(contact));
}

/// The unit of a column of the answers, or of a key.
std::string unit_of_key(const LawCase& law_case, const std::string& key) {
  for (const ContactKey& contact : contact_keys)
    if (contact.name == key) return std::string(contact.unit);
  for (const ChosenLaw& law : law_case.choice)
    for (const LawParameter& parameter : law_named(law.name).parameters)
      if (parameter.name == key.substr(key.find('.') + 1)) return std::string(parameter.unit);
  return std::string(answer_unit(key));
}

void print_state(const io::NumberTable& table, const ColumnWords& words) {
  std::vector<io::Property> lines;
  for (std::size_t k = 0; k < table.names.size(); ++k) {
    const double value = table.columns[k].front();
    const auto unit = unit_for(value, words.unit(table.names[k]));
    lines.push_back(
        {std::string(words.title(table.names[k])), fmt::format("{:#.6g} {}", value / unit.size, unit.symbol)});
  }
  fmt::print("{}", io::to_text(lines));
}

template <class Unit>
void print_table(const io::NumberTable& numbers, const Unit& unit_of_column) {
  io::Table table{{}, {}, 0};
  for (const std::string& name : numbers.names) {
    const std::string unit(unit_of_column(name));
    table.header.push_back(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
  }
  for (std::size_t row = 0; row < numbers.rows(); ++row) {
    table.rows.emplace_back();
    for (const auto& column : numbers.columns) table.rows.back().push_back(fmt::format("{:.6g}", column[row]));
  }
  fmt::print("{}", io::to_text(table));
}

ordered_json rows_of(const io::NumberTable& numbers) {
  ordered_json rows = ordered_json::array();
  for (std::size_t row = 0; row < numbers.rows(); ++row) {
    ordered_json one;
    for (std::size_t k = 0; k < numbers.names.size(); ++k) one[numbers.names[k]] = numbers.columns[k][row];
    rows.push_back(one);
  }
  return rows;
}

void print_json(const LawCase& law_case, const io::NumberTable& numbers) {
  ordered_json laws = ordered_json::array();
  for (const ChosenLaw& law : law_case.choice) laws.push_back({{"name", law.name}, {"parameters", law.parameters}});
  ordered_json contact;
  for (const auto& [key, value] : law_case.contact)
    if (!std::isnan(value)) contact[key] = value;
  fmt::print("{}\n", ordered_json{{"laws", laws}, {"contact", contact}, {"rows", rows_of(numbers)}}.dump(2));
}

/// What is evaluated where neither a sweep nor a path was asked for: the usual one if it is to be drawn or stored.
io::NumberTable usual(const LawCase& law_case, LawSlot slot) {
  if (const auto path = usual_path(law_case, slot)) return along(law_case, *path);
  return swept(law_case, usual_sweep(law_case, slot));
}

void evaluate(const Options& options, const LawDescription& law) {
  std::vector<std::string> names{options.name};
  names.insert(names.end(), options.with.begin(), options.with.end());
  const LawCase one = law_case(names, options.assignments);
  const bool draws = !options.picture.empty() || !options.csv.empty();
  const bool is_state = options.sweep.empty() && options.path.empty() && !draws;
  const std::vector<std::string> columns(load_columns.begin(), load_columns.end());
  const io::NumberTable numbers = !options.path.empty()    ? along(one, io::read_numbers(options.path, columns))
                                  : !options.sweep.empty() ? swept(one, sweep_of(options.sweep))
                                  : is_state               ? along(one, {{"overlap"}, {{one.contact.at("overlap")}}})
                                                           : usual(one, law.slot);
  if (!options.csv.empty()) io::write_atomically(options.csv, io::to_csv(numbers));
  if (!options.picture.empty()) {
    const std::string swept_key = options.sweep.empty() ? "" : sweep_of(options.sweep).key;
    const std::string axis = law_axis(numbers, swept_key);
    io::write_plot(law_plot(law, numbers, axis, unit_of_key(one, axis)), options.picture);
  }
  if (options.json) return print_json(one, numbers);
  if (draws) return;
  if (is_state) return print_state(numbers, {answer_title, answer_unit});
  print_table(numbers, [&](const std::string& column) { return unit_of_key(one, column); });
}

void evaluate(const Options& options, const StudyLaw& law) {
  if (!options.with.empty())
    throw InputError("law " + std::string(law.name), "--with " + options.with.front(),
                     "the theory alone: " + std::string(law.reason));
  const auto parameters = study_parameters(law, options.assignments);
  const bool draws = !options.picture.empty() || !options.csv.empty();
  std::vector<std::string> known;
  for (const LawParameter& parameter : law.parameters) known.emplace_back(parameter.name);
  io::NumberTable varied;
  const auto sweep = [&](const Sweep& of) { varied = {{of.key}, {of.values}}; };
  if (!options.path.empty())
    varied = io::read_numbers(options.path, known);
  else if (!options.sweep.empty())
    sweep(sweep_of(options.sweep));
  else if (draws)
    sweep(usual_sweep(law));
  const bool is_state = varied.names.empty();
  if (is_state) {
    const std::string key(law.shown);
    const auto given = parameters.find(key);
    const double standard = *std::ranges::find(law.parameters, law.shown, &LawParameter::name)->standard;
    varied = {{key}, {{given != parameters.end() ? given->second : standard}}};
  }
  const io::NumberTable numbers = answers(law, parameters, varied);
  if (!options.csv.empty()) io::write_atomically(options.csv, io::to_csv(numbers));
  if (!options.picture.empty()) io::write_plot(study_plot(law, numbers), options.picture);
  if (options.json) {
    fmt::print("{}\n", ordered_json{{"law", law.name}, {"parameters", parameters}, {"rows", rows_of(numbers)}}.dump(2));
    return;
  }
  if (draws) return;
  const ColumnWords words{[&](std::string_view column) { return title_of(law, column); },
                          [&](std::string_view column) { return unit_of(law, column); }};
  if (is_state) return print_state(numbers, words);
  print_table(numbers, words.unit);
}

void run(const Options& options) {
  if (options.name.empty()) {
    if (options.evaluates() || !options.with.empty())
      throw InputError("law", "numbers without a law", "the name of one, see `osculate law`");
    return list_laws(options.json);
  }
  const auto say = [&](const auto& law) {
    if (options.evaluates() || !options.with.empty()) return evaluate(options, law);
    if (options.json)
      fmt::print("{}\n", json_of(law).dump(2));
    else
      describe(law);
  };
  if (const StudyLaw* law = study_law(options.name)) return say(*law);
  say(law_named(options.name));
}

}  // namespace

void add_law(CLI::App& program) {
  CLI::App* command = program.add_subcommand("law", "The laws of contact: list them, explain one, evaluate one");
  command->footer(help);
  const auto options = std::make_shared<Options>();
  command->add_option("NAME", options->name, "A law");
  command->add_option("--with", options->with, "Further laws, composed with it")->type_name("LAW");
  command->add_option("--set", options->assignments, "Numbers of the laws and of the contact")->type_name("key=value");
  CLI::Option* sweep =
      command->add_option("--sweep", options->sweep, "Evaluate at n values of a key")->type_name("key=from:to:n[:log]");
  command->add_option("--path", options->path, "Evaluate along a load path (CSV)")->type_name("FILE")->excludes(sweep);
  command->add_option("--csv", options->csv, "Write the numbers")->type_name("FILE");
  command->add_option("--picture", options->picture, "Draw them (.svg or .png)")->type_name("FILE");
  command->add_flag("--json", options->json, "Print as JSON");
  command->callback([options] { run(*options); });
}

}  // namespace osculate::app
