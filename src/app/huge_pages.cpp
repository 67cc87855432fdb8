#include "app/huge_pages.hpp"

#include <unistd.h>

#include <cstdlib>

namespace osculate::app {

void use_huge_pages(char** argv) {
  constexpr const char* variable = "GLIBC_TUNABLES";
  if (std::getenv(variable) != nullptr || ::setenv(variable, "glibc.malloc.hugetlb=1", 0) != 0) return;
  ::execv("/proc/self/exe", argv);
}

}  // namespace osculate::app
