#pragma once
// Parts of space with a volume, to put particles into or to look at.

#include <variant>

#include "osculate/core/types.hpp"

namespace osculate {

struct BoxRegion {
  Vec3 lower, upper;  ///< [m]
};
/// An upright cylinder.
struct CylinderRegion {
  Vec3 base;      ///< centre of the lower end [m]
  double radius;  ///< > 0 [m]
  double height;  ///< > 0 [m]
};
struct SphereRegion {
  Vec3 centre;    ///< [m]
  double radius;  ///< > 0 [m]
};
using Region = std::variant<BoxRegion, CylinderRegion, SphereRegion>;

/// Throws InputError unless the region has a volume.
void validate(const Region& region);
double volume(const Region& region);
/// How far inside a point lies [m]; negative outside.
double depth(const Region& region, const Vec3& point);
bool contains(const Region& region, const Vec3& point);
/// The smallest box that holds the region.
BoxRegion bounds(const Region& region);

}  // namespace osculate
