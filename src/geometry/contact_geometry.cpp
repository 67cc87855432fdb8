#include "osculate/geometry/contact_geometry.hpp"

namespace osculate {

std::string_view name(ContactStatus status) {
  switch (status) {
    case ContactStatus::touching:
      return "touching";
    case ContactStatus::separated:
      return "separated";
    case ContactStatus::ambiguous:
      return "ambiguous";
    case ContactStatus::flat:
      return "flat";
    case ContactStatus::not_converged:
      return "not converged";
    case ContactStatus::degenerate:
      return "degenerate";
  }
  return "unknown";
}

}  // namespace osculate
