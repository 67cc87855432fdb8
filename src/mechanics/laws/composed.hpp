#pragma once
// Parts run one after the other.

#include <vector>

#include "mechanics/laws/law_part.hpp"

namespace osculate::laws {

/// A part and how many doubles it remembers.
struct BoundPart {
  Part part;
  std::size_t memory;
};

/// In the order of their slots; one part works on up to `stretch` contacts before the next.
ContactLaw composed(const std::vector<BoundPart>& parts);

/// A law in SIMD batches, then parts that take from it what carries the load: those of twisting and rolling.
ContactLaw followed(const ContactLaw& first, const std::vector<BoundPart>& parts);

}  // namespace osculate::laws
