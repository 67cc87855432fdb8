#pragma once
// Parameters given by name, checked against what a law says of them.

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "osculate/mechanics/law_registry.hpp"

namespace osculate::laws {

std::string quoted(std::string_view text);

/// "one of a b c": the names of a list's items.
template <class List, class Name>
std::string one_of(const List& list, const Name& name) {
  std::string text = "one of";
  for (const auto& item : list) text.append(1, ' ').append(name(item));
  return text;
}

/// Every parameter with its value, given or standard. Throws InputError at `where` for one that is missing, out of
/// range or unknown.
std::map<std::string, double> completed(const std::map<std::string, double>& given,
                                        std::span<const LawParameter> parameters, const std::string& where);

}  // namespace osculate::laws
