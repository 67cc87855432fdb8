#pragma once
// Vectors of many things, component by component.

#include <cstddef>
#include <span>

namespace osculate {

/// Views of three columns; all of one length, or all empty where the caller wants none.
template <class Real>
struct Vectors {
  std::span<Real> x, y, z;

  Vectors part(std::size_t start, std::size_t count) const {
    if (x.empty()) return {};
    return {x.subspan(start, count), y.subspan(start, count), z.subspan(start, count)};
  }
};

}  // namespace osculate
