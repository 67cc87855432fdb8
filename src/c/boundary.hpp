#pragma once
// The border between C and C++: no exception crosses it, and every failure leaves its message with the thread.

#include <algorithm>
#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/osculate.h"

namespace osculate::c {

/// A pointer that is needed is NULL; the message says which.
class NullPointer : public std::runtime_error {
 public:
  explicit NullPointer(const std::string& name) : std::runtime_error(name + ": NULL; expected a pointer") {}
};

/// Leaves a message with the calling thread. Never fails: a message too long is cut.
void set_error_message(const char* where, const char* message) noexcept;

/// Throws NullPointer.
template <class T>
T& required(T* pointer, const char* name) {
  if (pointer == nullptr) throw NullPointer{name};
  return *pointer;
}

/// Whether a vector's columns are given. Throws NullPointer when some are and some are not.
template <class T, std::size_t N>
bool whole(T* const (&components)[N], const char* name) {
  const auto missing = std::count(components, components + N, nullptr);
  if (missing != 0 && missing != N) throw NullPointer(std::string(name) + ", some components");
  return missing == 0;
}

/// Runs the body of a function of the C API and turns what it throws into an error code.
template <class Body>
int guarded(const char* function, const Body& body) noexcept {
  try {
    body();
    return OSCULATE_OK;
  } catch (const NullPointer& missing) {
    set_error_message(function, missing.what());
    return OSCULATE_NULL_POINTER;
  } catch (const InputError& error) {
    set_error_message(function, error.what());
    return OSCULATE_INVALID_INPUT;
  } catch (const std::bad_alloc&) {
    set_error_message(function, "out of memory");
    return OSCULATE_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    set_error_message(function, error.what());
    return OSCULATE_INTERNAL_ERROR;
  } catch (...) {
    set_error_message(function, "an exception of unknown type");
    return OSCULATE_INTERNAL_ERROR;
  }
}

}  // namespace osculate::c
