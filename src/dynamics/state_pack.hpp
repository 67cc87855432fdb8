#pragma once
// Names and order of the arrays of a state, said once for storing and restoring.

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "osculate/core/error.hpp"
#include "osculate/dynamics/state.hpp"

namespace osculate {

/// Visits vectors of trivially copyable items made of doubles, 32-bit or 64-bit integers, and appends them to a state.
class StateWriter {
 public:
  explicit StateWriter(State& state) : state_(state) {}

  template <class Number, class Item>
  void array(const std::string& name, const std::vector<Item>& items) {
    static_assert(sizeof(Item) % sizeof(Number) == 0);
    std::vector<Number> values(items.size() * (sizeof(Item) / sizeof(Number)));
    if (!items.empty())
      std::memcpy(values.data(), static_cast<const void*>(items.data()), values.size() * sizeof(Number));
    state_.arrays.push_back({name, std::move(values)});
  }
  template <class Number>
  void value(const std::string& name, const Number& one) {
    state_.arrays.push_back({name, std::vector<Number>{one}});
  }

 private:
  State& state_;
};

/// Visits the same and fills them.
class StateReader {
 public:
  explicit StateReader(const State& state) : state_(state) {}

  template <class Number, class Item>
  void array(const std::string& name, std::vector<Item>& items) {
    const auto& values = numbers<Number>(name);
    const std::size_t each = sizeof(Item) / sizeof(Number);
    if (values.size() % each != 0)
      throw InputError("state", "array " + name + " of " + std::to_string(values.size()) + " numbers",
                       "a multiple of " + std::to_string(each));
    items.resize(values.size() / each);
    if (!items.empty()) std::memcpy(static_cast<void*>(items.data()), values.data(), values.size() * sizeof(Number));
  }
  template <class Number>
  void value(const std::string& name, Number& one) {
    const auto& values = numbers<Number>(name);
    if (values.size() != 1)
      throw InputError("state", "array " + name + " of " + std::to_string(values.size()) + " numbers", "one");
    one = values[0];
  }

 private:
  template <class Number>
  const std::vector<Number>& numbers(const std::string& name) const {
    const auto* values = std::get_if<std::vector<Number>>(&state_.at(name).values);
    if (values == nullptr)
      throw InputError("state", "array " + name + " of another type", "the type it was stored with");
    return *values;
  }

  const State& state_;
};

}  // namespace osculate
