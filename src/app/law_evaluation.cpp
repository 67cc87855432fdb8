#include "app/law_evaluation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/nearest_name.hpp"
#include "osculate/core/aligned_allocator.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/mindlin.hpp"

namespace osculate::app {
namespace {

double number_of(std::string_view text, const std::string& where) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(where, "\"" + std::string(text) + "\"", "a finite number in SI units");
  return value;
}

const ContactKey* contact_key(std::string_view name) {
  const auto* found = std::ranges::find(contact_keys, name, &ContactKey::name);
  return found == contact_keys.end() ? nullptr : found;
}

bool has_parameter(const LawDescription& law, std::string_view name) {
  return std::ranges::find(law.parameters, name, &LawParameter::name) != law.parameters.end();
}

[[noreturn]] void refuse_key(const LawCase& law_case, const std::string& key) {
  std::vector<std::string> known;
  for (const ChosenLaw& law : law_case.choice)
    for (const LawParameter& parameter : law_named(law.name).parameters) known.emplace_back(parameter.name);
  for (const ContactKey& contact : contact_keys) known.emplace_back(contact.name);
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
  throw InputError("--set", "a key \"" + key + "\"" + io::suggestion(key, known), "one of " + list);
}

struct Materials {
  ElasticMaterial body_1, body_2;
};
Materials materials(const LawCase& law_case) {
  const auto at = [&](const char* key) { return law_case.contact.find(key)->second; };
  const auto or_1 = [](double value, double of_1) { return std::isnan(value) ? of_1 : value; };
  return {{.youngs_modulus = at("E"), .poissons_ratio = at("nu")},
          {.youngs_modulus = or_1(at("E_2"), at("E")), .poissons_ratio = or_1(at("nu_2"), at("nu"))}};
}

/// One contact with its memory, taken from state to state.
class Probe {
 public:
  explicit Probe(const LawCase& law_case)
      : case_(law_case), law_(bound(law_case)), memory_(law_.memory_length(1), 0.0) {}

  struct State {
    double overlap, x, y, twist;
  };
  struct Answer {
    double normal_force, tangential_x, tangential_y, couple, a_c, axis_ratio, stiffness;
    double stored_normal, stored_tangential, viscous, friction, hysteresis;
    LawStatus status;
  };

  State at_rest() const { return {number("overlap"), number("x"), number("y"), number("twist")}; }

  /// The first state is reached from no displacement at its overlap.
  Answer to(const State& state, double time_step) {
    if (!started_) {
      started_ = true;
      last_ = {state.overlap, 0.0, 0.0, 0.0};
      if (state.x != 0.0 || state.y != 0.0 || state.twist != 0.0) step(last_, time_step);
    }
    return step(state, time_step);
  }

 private:
  static ContactLaw bound(const LawCase& law_case) {
    const auto [material_1, material_2] = materials(law_case);
    return make_contact_law(law_case.choice, material_1, material_2);
  }
  double number(std::string_view key) const { return case_.contact.find(key)->second; }

  Answer step(const State& state, double time_step) {
    const double rate = number("rate") + (state.overlap - last_.overlap) / time_step;
    const double vx = number("slip") + (state.x - last_.x) / time_step, vy = (state.y - last_.y) / time_step;
    const double wz = number("spin") + (state.twist - last_.twist) / time_step;
    last_ = state;
    // Rolling along the major axis (x) with speed V turns body 2 against body 1 by V/R_i about the minor axis (y).
    const double R_i = number("R_i"), R_j = number("R_j"), wy = number("rolling") / R_i, vz = -rate;
    const double zero = 0.0, one = 1.0, mass = number("reduced_mass"), radius = number("effective_radius");
    const auto in = [](const double& value) { return std::span<const double>(&value, 1); };
    const auto out = [](double& value) { return std::span<double>(&value, 1); };
    Answer answer{};
    double fx = 0.0, fy = 0.0, fz = 0.0, mx = 0.0, my = 0.0;
    law_.evaluate({.R_i = in(R_i),
                   .R_j = in(R_j),
                   .overlap = in(state.overlap),
                   .normal = {in(zero), in(zero), in(one)},
                   .major_axis = {in(one), in(zero), in(zero)},
                   .velocity = {in(vx), in(vy), in(vz)},
                   .angular_velocity = {in(zero), in(wy), in(wz)},
                   .mean_angular_velocity = {in(zero), in(zero), in(zero)},
                   .reduced_mass = in(mass),
                   .effective_radius = in(radius),
                   .time_step = time_step},
                  memory_,
                  {.force = {out(fx), out(fy), out(fz)},
                   .couple = {out(mx), out(my), out(answer.couple)},
                   .normal_force = out(answer.normal_force),
                   .status = {&answer.status, 1},
                   .a_c = out(answer.a_c),
                   .axis_ratio = out(answer.axis_ratio),
                   .stiffness = out(answer.stiffness),
                   .stored_normal = out(answer.stored_normal),
                   .stored_tangential = out(answer.stored_tangential),
                   .viscous_loss = out(answer.viscous),
                   .friction_loss = out(answer.friction),
                   .hysteresis_loss = out(answer.hysteresis)});
    answer.tangential_x = fx, answer.tangential_y = fy;
    if (answer.status == LawStatus::bad_input)
      throw InputError("contact", "numbers that make no contact",
                       "R_i >= R_j > 0, reduced_mass > 0, effective_radius > 0, all finite");
    if (answer.status == LawStatus::not_converged)
      throw InputError("contact", "a state at which the law's search does not end", "a state nearer to equilibrium");
    return answer;
  }

  const LawCase& case_;
  ContactLaw law_;
  std::vector<double, AlignedAllocator<double>> memory_;
  State last_{};
  bool started_ = false;
};

const std::vector<std::string> answer_columns{
    "normal_force", "tangential_x",  "tangential_y",      "couple",       "a_c",           "b_c",
    "stiffness",    "stored_normal", "stored_tangential", "viscous_loss", "friction_loss", "hysteresis_loss"};

/// Answers below one another; losses are summed by the caller.
void add(io::NumberTable& table, std::size_t first, const Probe::Answer& a) {
  std::size_t column = first;
  for (const double value : {a.normal_force, a.tangential_x, a.tangential_y, a.couple, a.a_c, a.a_c * a.axis_ratio,
                             a.stiffness, a.stored_normal, a.stored_tangential, a.viscous, a.friction, a.hysteresis})
    table.columns[column++].push_back(value);
}

io::NumberTable empty_table(const std::vector<std::string>& keys) {
  io::NumberTable table{keys, {}};
  table.names.insert(table.names.end(), answer_columns.begin(), answer_columns.end());
  table.columns.resize(table.names.size());
  return table;
}

void append(std::vector<double>& to, const std::vector<double>& values) {
  to.insert(to.end(), values.begin(), values.end());
}

constexpr std::size_t leg = 61;

/// From zero to `most`, to its opposite, and back.
std::vector<double> cycle(double most) {
  std::vector<double> values = spaced(0.0, most, leg);
  append(values, spaced(most, -most, 2 * leg));
  append(values, spaced(-most, most, 2 * leg));
  return values;
}

double parameter_of(const LawCase& law_case, const std::string& name, double otherwise) {
  for (const ChosenLaw& law : law_case.choice)
    if (const auto found = law.parameters.find(name); found != law.parameters.end()) return found->second;
  return otherwise;
}

}  // namespace

void set(LawCase& law_case, const std::string& key, double value) {
  const std::size_t dot = key.find('.');
  const std::string owner = dot == std::string::npos ? "" : key.substr(0, dot);
  const std::string name = dot == std::string::npos ? key : key.substr(dot + 1);
  bool used = false;
  for (ChosenLaw& law : law_case.choice) {
    if ((!owner.empty() && law.name != owner) || !has_parameter(law_named(law.name), name)) continue;
    law.parameters[name] = value;
    used = true;
  }
  if (used) return;
  if (!owner.empty() || contact_key(name) == nullptr) refuse_key(law_case, key);
  law_case.contact[name] = value;
}

LawCase law_case(const std::vector<std::string>& laws, const std::vector<std::string>& assignments) {
  LawCase result;
  for (const ContactKey& key : contact_keys) result.contact.emplace(key.name, key.standard);
  bool has_normal = false;
  std::string normal = "hertz";
  for (const std::string& name : laws) {
    const LawDescription& law = law_named(name);
    has_normal |= law.slot == LawSlot::normal;
    if (law.slot == LawSlot::rolling) result.contact["rolling"] = 1.0;
    for (const LawConflict& conflict : law.conflicts)
      if (conflict.other == osculate::name(LawSlot::normal) && !conflict.but.empty()) normal = conflict.but.front();
    result.choice.push_back({name, {}});
  }
  if (!has_normal) result.choice.push_back({normal, {}});
  for (const std::string& text : assignments) {
    const auto [key, value] = assignment_of(text);
    set(result, key, value);
  }
  return result;
}

std::pair<std::string, double> assignment_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw InputError("--set", "\"" + text + "\"", "key=value");
  const std::string key = text.substr(0, equals);
  return {key, number_of(std::string_view(text).substr(equals + 1), "--set " + key)};
}

std::vector<double> spaced(double from, double to, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
  return values;
}

Sweep sweep_of(const std::string& text) {
  const std::string expected = "key=from:to:n or key=from:to:n:log, n from 2 to 100000";
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw InputError("--sweep", "\"" + text + "\"", expected);
  std::vector<std::string> parts(1);
  for (const char c : text.substr(equals + 1)) {
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  const bool logarithmic = parts.size() == 4 && parts[3] == "log";
  if (parts.size() != 3 && !logarithmic) throw InputError("--sweep", "\"" + text + "\"", expected);
  const double from = number_of(parts[0], "--sweep"), to = number_of(parts[1], "--sweep");
  const double count = number_of(parts[2], "--sweep");
  if (!(count >= 2.0 && count <= 100000.0) || count != std::floor(count))
    throw InputError("--sweep", parts[2] + " values", expected);
  if (logarithmic && !(from > 0.0 && to > 0.0))
    throw InputError("--sweep", "\"" + text + "\"", "both ends above zero on a logarithmic scale");
  Sweep sweep{text.substr(0, equals), {}};
  const auto size = static_cast<std::size_t>(count);
  sweep.values = logarithmic ? spaced(std::log(from), std::log(to), size) : spaced(from, to, size);
  if (logarithmic)
    for (double& value : sweep.values) value = std::exp(value);
  sweep.values.front() = from, sweep.values.back() = to;
  return sweep;
}

io::NumberTable along(const LawCase& law_case, const io::NumberTable& path) {
  Probe probe(law_case);
  const Probe::State rest = probe.at_rest();
  io::NumberTable table = empty_table(path.names);
  const auto* time = path.find("time");
  const auto at = [&](const char* name, double otherwise, std::size_t row) {
    const auto* column = path.find(name);
    return column != nullptr ? (*column)[row] : otherwise;
  };
  const double standard_step = law_case.contact.find("time_step")->second;
  if (!(standard_step > 0.0)) throw InputError("--set time_step", "a step that is not positive", "a time above 0 [s]");
  double viscous = 0.0, friction = 0.0, hysteresis = 0.0;
  for (std::size_t row = 0; row < path.rows(); ++row) {
    double step = standard_step;
    if (time != nullptr && row > 0) step = (*time)[row] - (*time)[row - 1];
    if (!(step > 0.0))
      throw InputError("path", "time " + std::to_string((*time)[row]) + " in row " + std::to_string(row + 1),
                       "a time that grows from row to row");
    auto answer = probe.to(
        {at("overlap", rest.overlap, row), at("x", rest.x, row), at("y", rest.y, row), at("twist", rest.twist, row)},
        step);
    answer.viscous = viscous += answer.viscous;
    answer.friction = friction += answer.friction;
    answer.hysteresis = hysteresis += answer.hysteresis;
    for (std::size_t k = 0; k < path.columns.size(); ++k) table.columns[k].push_back(path.columns[k][row]);
    add(table, path.columns.size(), answer);
  }
  return table;
}

io::NumberTable swept(const LawCase& law_case, const Sweep& sweep) {
  if (sweep.key != "time" && std::ranges::find(load_columns, sweep.key) != load_columns.end())
    return along(law_case, {{sweep.key}, {sweep.values}});
  io::NumberTable table = empty_table({sweep.key});
  for (const double value : sweep.values) {
    LawCase one = law_case;
    set(one, sweep.key, value);
    Probe probe(one);
    table.columns[0].push_back(value);
    add(table, 1, probe.to(probe.at_rest(), one.contact.find("time_step")->second));
  }
  return table;
}

std::optional<io::NumberTable> usual_path(const LawCase& law_case, LawSlot slot) {
  const auto at = [&](std::string_view key) { return law_case.contact.find(key)->second; };
  const double overlap = at("overlap"), friction = parameter_of(law_case, "friction", 0.3);
  const auto [material_1, material_2] = materials(law_case);
  switch (slot) {
    case LawSlot::normal:
    case LawSlot::adhesion:
    case LawSlot::roughness:
    case LawSlot::plasticity: {
      const double range =
          1.3 * make_contact_law(law_case.choice, material_1, material_2).interaction_range(at("R_i"), at("R_j"));
      // As far as adhesion shows.
      constexpr double ranges = 5.0;
      const double most = slot == LawSlot::adhesion && range > 0.0 ? std::min(overlap, ranges * range) : overlap;
      std::vector<double> values = spaced(-range, most, 2 * leg);
      append(values, spaced(most, -range, 2 * leg));
      return io::NumberTable{{"overlap"}, {values}};
    }
    case LawSlot::tangential: {
      const auto ellipse = contact_ellipse(at("R_i"), at("R_j"));
      const double ratio = mindlin::compliance_ratio(ellipse, material_1, material_2).major;
      return io::NumberTable{{"x"}, {cycle(0.8 * friction * ratio * overlap)}};
    }
    case LawSlot::twisting: {
      // Some way past the turn at which the circular contact slides, 9π/128 μF_n/(G a²).
      const double turn = 9.0 / 16.0 * M_PI * friction * overlap / std::sqrt(at("R_j") * overlap);
      return io::NumberTable{{"twist"}, {cycle(turn)}};
    }
    case LawSlot::dissipation:
    case LawSlot::rolling:
      break;
  }
  return std::nullopt;
}

Sweep usual_sweep(const LawCase& law_case, LawSlot slot) {
  if (slot == LawSlot::rolling) {
    const double speed = law_case.contact.find("rolling")->second;
    const double slip = 0.01 * (speed > 0.0 ? speed : 1.0);
    return {"slip", spaced(-slip, slip, 2 * leg + 1)};
  }
  constexpr double speed = 0.1;
  return {"rate", spaced(-speed, speed, 2 * leg + 1)};
}

}  // namespace osculate::app
