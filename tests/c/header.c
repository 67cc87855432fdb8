/* The header is C99 and nothing more, and a C program links to what it declares. */
#include "osculate/osculate.h"

int abi_version_seen_by_c(void);
int abi_version_seen_by_c(void) {
  return osculate_abi_version() == OSCULATE_ABI_VERSION ? OSCULATE_ABI_VERSION : -1;
}
