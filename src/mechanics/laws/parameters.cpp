#include "mechanics/laws/parameters.hpp"

#include <cstdio>

#include "osculate/core/error.hpp"

namespace osculate::laws {
namespace {

std::string number(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", value);
  return buffer;
}

std::string range_of(const LawParameter& parameter) {
  return parameter.unit.empty() ? parameter.range() : parameter.range() + " " + std::string(parameter.unit);
}

}  // namespace

std::string quoted(std::string_view text) {
  std::string result(1, '"');
  result += text;
  return result += '"';
}

std::map<std::string, double> completed(const std::map<std::string, double>& given,
                                        std::span<const LawParameter> parameters, const std::string& where) {
  std::map<std::string, double> result;
  for (const LawParameter& parameter : parameters) {
    const auto found = given.find(std::string(parameter.name));
    if (found == given.end() && !parameter.standard)
      throw InputError(where, "no " + quoted(parameter.name),
                       std::string(parameter.meaning) + ", " + range_of(parameter));
    const double value = found != given.end() ? found->second : *parameter.standard;
    if (!parameter.allows(value))
      throw InputError(where, quoted(parameter.name) + " = " + number(value), range_of(parameter));
    result.emplace(parameter.name, value);
  }
  for (const auto& [name, value] : given) {
    if (result.contains(name)) continue;
    throw InputError(where, "a parameter " + quoted(name),
                     parameters.empty()
                         ? "none: the law has no parameters"
                         : one_of(parameters, [](const LawParameter& parameter) { return parameter.name; }));
  }
  return result;
}

}  // namespace osculate::laws
