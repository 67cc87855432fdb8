#pragma once
// The part of a wall near a contact, as a surface to draw.

#include "osculate/shapes/mesh.hpp"

namespace osculate::app {

/// The wall's surface within `reach` [m] of its point nearest to `point_b`, wall frame. Not for particles.
TriangleMesh wall_patch(const Shape& wall, const Vec3& point_b, double reach);

}  // namespace osculate::app
