#pragma once
// What stands behind the opaque handles.

#include <array>

#include "osculate/mechanics/contact_law.hpp"
#include "osculate/osculate.h"
#include "osculate/shapes/shape.hpp"

struct osculate_shape {
  osculate::Shape shape;
  bool is_particle;
  bool is_superquadric;           ///< or an ellipsoid or sphere: `columns` hold
  std::array<double, 5> columns;  ///< a, b, c [m], n1, n2, as in SuperquadricPairs
};

struct osculate_law {
  osculate::ContactLaw law;
  bool acts_across_gaps;  ///< it has an interaction range
};
