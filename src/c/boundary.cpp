#include "c/boundary.hpp"

#include <cstdio>

namespace {

thread_local char last_message[1024] = "";

}  // namespace

namespace osculate::c {

void set_error_message(const char* where, const char* message) noexcept {
  std::snprintf(last_message, sizeof last_message, "%s: %s", where, message);
}

}  // namespace osculate::c

const char* osculate_error_message(void) {
  return last_message;
}

int osculate_abi_version(void) {
  return OSCULATE_ABI_VERSION;
}

const char* osculate_version(void) {
  return OSCULATE_VERSION;
}
