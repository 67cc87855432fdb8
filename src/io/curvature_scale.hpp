#pragma once
// How a curvature is shown in colours: the range that lets faces and edges both be seen.

#include <vector>

#include "io/picture.hpp"
#include "io/surface_curvature.hpp"

namespace osculate::io {

/// lower < upper.
struct ScalarRange {
  double lower;
  double upper;
};

/// The range that holds all but the most extreme 2 % of the surface's area, from 0 where the curvature comes near it;
/// around the value itself where it is constant.
ScalarRange colour_range(const CurvedSurface& surface, const std::vector<double>& scalars);

/// A body coloured by curvature and its colour bar, in the unit of length that suits the body's size.
struct CurvaturePicture {
  PictureBody body;
  ColourBar colour_bar;
};

CurvaturePicture picture_of(const CurvedSurface& surface, CurvatureKind kind);

}  // namespace osculate::io
