#pragma once
// What stands behind the opaque handles.

#include "osculate/mechanics/contact_law.hpp"
#include "osculate/osculate.h"
#include "osculate/shapes/shape.hpp"

struct osculate_shape {
  osculate::Shape shape;
};

struct osculate_law {
  osculate::ContactLaw law;
  bool acts_across_gaps;  ///< it has an interaction range
};
