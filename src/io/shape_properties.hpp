#pragma once
// What there is to know about a particle's shape, measured once.

#include "io/surface_curvature.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate::io {

struct ShapeProperties {
  MassProperties mass;        ///< unit density
  double equivalent_radius;   ///< R_vol, of the sphere of equal volume [m]
  double bounding_radius;     ///< about the body's origin [m]
  OrientedBox box;            ///< [m]
  double area;                ///< A [m²], from two meshes, extrapolated
  double area_error;          ///< the difference of the two meshes [m²]
  double sphericity;          ///< Ψ = area of the sphere of equal volume / A (Wadell 1932)
  double smallest_curvature;  ///< least k_min met on the mesh [1/m]
  double largest_curvature;   ///< largest k_max met on the mesh [1/m]; above 1e50/R_vol it stands for ∞
};

/// `surface` is the shape's own, whose vertices are asked for curvatures. Throws InputError for walls.
ShapeProperties measure(const Shape& shape, const CurvedSurface& surface, int resolution);

}  // namespace osculate::io
