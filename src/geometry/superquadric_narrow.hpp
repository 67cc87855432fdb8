#pragma once
// The narrow phase of superquadrics for a caller that has memory fetched meanwhile.

#include "core/read_ahead.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate {

/// A warm contact takes as long as so many of the passes over rows that read ahead as they go.
constexpr std::size_t passes_of_a_contact = 3;

/// The same as without `ahead`, which goes on by so many rows with each contact solved.
void common_normals(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap,
                    Curvatures curvatures, ReadAhead& ahead);

}  // namespace osculate
