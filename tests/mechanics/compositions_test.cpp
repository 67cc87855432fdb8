// Every composition that the registry can name works, or is refused with a reason.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "mechanics/law_bed.hpp"
#include "mechanics/law_choices.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;

namespace {

/// Each law once, with the parameters of these tests.
LawChoice all_laws() {
  std::map<std::string, ChosenLaw> by_name;
  for (const NamedChoice& one : law_choices())
    for (const ChosenLaw& law : one.choice) by_name.emplace(law.name, law);
  LawChoice laws;
  for (const LawDescription* law : law_registry()) laws.push_back(by_name.at(std::string(law->name)));
  return laws;
}

/// The same without friction, damping, adhesion: zero wherever a parameter may be zero.
LawChoice without_effect(LawChoice laws) {
  for (ChosenLaw& law : laws)
    for (const LawParameter& parameter : law_named(law.name).parameters)
      if (parameter.allows(0.0)) law.parameters[std::string(parameter.name)] = 0.0;
  return laws;
}

/// One law of each slot, or none.
void for_each_composition(const LawChoice& laws, const std::function<void(const LawChoice&)>& visit,
                          std::size_t slot = 0, const LawChoice& chosen = {}) {
  if (slot == law_slots) return visit(chosen);
  if (static_cast<LawSlot>(slot) != LawSlot::normal) for_each_composition(laws, visit, slot + 1, chosen);
  for (const ChosenLaw& law : laws) {
    if (law_named(law.name).slot != static_cast<LawSlot>(slot)) continue;
    LawChoice longer = chosen;
    longer.push_back(law);
    for_each_composition(laws, visit, slot + 1, longer);
  }
}

std::string names_of(const LawChoice& choice) {
  std::string names;
  for (const ChosenLaw& law : choice) names += law.name + ' ';
  return names;
}

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// Whether a refusal names two laws of the composition and gives a reason of one of them.
bool explains(const std::string& refusal, const LawChoice& choice) {
  const auto named =
      std::ranges::count_if(choice, [&](const ChosenLaw& law) { return holds(refusal, '"' + law.name + '"'); });
  const bool has_reason = std::ranges::any_of(choice, [&](const ChosenLaw& law) {
    return std::ranges::any_of(law_named(law.name).conflicts,
                               [&](const LawConflict& conflict) { return holds(refusal, conflict.reason); });
  });
  return named == 2 && has_reason;
}

/// A few steps of contacts at the edges of what may happen.
constexpr int steps = 8;
constexpr std::size_t contacts = 10;
LawRow row_at(std::size_t contact, int step) {
  const double swing = std::sin(1.3 * step);
  LawRow row;
  switch (contact) {
    case 0:  // nothing moves
      break;
    case 1:  // together and apart, past touching
      row.overlap = 1e-6 * swing, row.velocity = {0, 0, -0.5 * std::cos(1.3 * step)};
      break;
    case 2:  // touches, just
      row.overlap = step % 2 == 0 ? 0.0 : 1e-300;
      row.velocity = {0.1, 0.2, 0}, row.angular = {10, 20, 30};
      break;
    case 3:  // slides without rolling
      row.velocity = {0.1 * swing, 0.05, 0};
      break;
    case 4:  // rolls without slip
      row.angular = {100, 200 * swing, 0};
      break;
    case 5:  // spins in place
      row.angular = row.mean_angular = {0, 0, 1e4 * swing};
      break;
    case 6:  // a line contact, rolling, slipping and spinning
      row.R_i = std::numeric_limits<double>::infinity();
      row.velocity = {0.1, swing, 0.01}, row.angular = {30, swing, 100};
      break;
    case 7:  // a circle, pressed hard and then torn open
      row.R_i = row.R_j, row.overlap = step < steps / 2 ? 2e-4 : -1.0, row.velocity = {1, 1, 100};
      break;
    case 8:  // bodies of very different size, violent
      row.R_j = 1e-9, row.overlap = 1e-10, row.velocity = {1e3, 1e3, -1e3 * swing}, row.angular = {1e9, 1e9, 1e9};
      break;
    default:  // hardly anything moves
      row.velocity = {1e-300, 1e-300, 0}, row.angular = {1e-305, 0, 1e-300};
  }
  return row;
}

/// Whether all that a law says of the bed is a number, and an open contact neither pushes nor remembers.
void check_answers(LawBed& bed, const LawChoice& choice) {
  const auto finite = [](const auto& column) {
    return std::ranges::all_of(column, [](double value) { return std::isfinite(value); });
  };
  const LawOutput out = bed.output();
  const std::array columns{out.force.x,      out.force.y,       out.force.z,        out.couple.x,
                           out.couple.y,     out.couple.z,      out.normal_force,   out.a_c,
                           out.axis_ratio,   out.stiffness,     out.stored_normal,  out.stored_tangential,
                           out.viscous_loss, out.friction_loss, out.hysteresis_loss};
  if (!std::ranges::all_of(columns, finite) || !finite(bed.memory)) FAIL_CHECK("not a number in " << names_of(choice));
  for (std::size_t i = 0; i < contacts; ++i) {
    if (bed.status[i] == LawStatus::bad_input || bed.status[i] == LawStatus::not_converged)
      FAIL_CHECK(name(bed.status[i]) << " at contact " << i << " of " << names_of(choice));
    if (bed.status[i] == LawStatus::open && (bed.force(i) != Vec3::Zero() || bed.couple(i) != Vec3::Zero()))
      FAIL_CHECK("a force of an open contact, " << i << " of " << names_of(choice));
  }
}

}  // namespace

TEST_CASE("Every composition of laws gives numbers, or is refused by two of its laws with the reason") {
  const auto& laws = GENERATE(all_laws(), without_effect(all_laws()));
  std::set<std::string> working;
  for_each_composition(laws, [&](const LawChoice& choice) {
    const LawChoice reversed(choice.rbegin(), choice.rend());
    try {
      const ContactLaw law = make_contact_law(choice, glass, steel);
      for (const ChosenLaw& one : choice) working.insert(one.name);
      const ContactLaw same = make_contact_law(reversed, glass, steel);
      LawBed bed(law, contacts), twin(same, contacts);
      for (int step = 0; step < steps; ++step) {
        for (std::size_t i = 0; i < contacts; ++i) bed.set(i, row_at(i, step)), twin.set(i, row_at(i, step));
        bed.evaluate(law), twin.evaluate(same);
        check_answers(bed, choice);
        for (std::size_t i = 0; i < contacts; ++i)
          if (bed.force(i) != twin.force(i)) FAIL_CHECK("the order counts in " << names_of(choice));
      }
    } catch (const InputError& refusal) {
      if (!explains(refusal.what(), choice)) FAIL_CHECK(names_of(choice) << "refused with " << refusal.what());
      CHECK_THROWS_AS(make_contact_law(reversed, glass, steel), InputError);
    }
  });
  CHECK(working.size() == law_registry().size());
}
