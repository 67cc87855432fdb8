#include "osculate/mechanics/elliptic_integrals.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "mechanics/elliptic_integrals-inl.hpp"
#include "osculate/core/error.hpp"

namespace osculate {

CompleteElliptic complete_elliptic(double complement) {
  if (!(complement >= 0.0 && complement <= 1.0))
    throw InputError("complete_elliptic", "complement 1 - m = " + std::to_string(complement), "a value in [0, 1]");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (complement == 0.0) return {.K = infinity, .E = 1.0, .B = 1.0, .C = infinity, .D = infinity};
  const auto [K, E, B, C, D] =
      HWY_NAMESPACE::elliptic_integrals<double>(1.0 - complement, complement, -std::log(complement));
  return {.K = K, .E = E, .B = B, .C = C, .D = D};
}

}  // namespace osculate
