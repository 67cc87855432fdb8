#pragma once
// How much of the sky a point of a picture sees: less in the gaps between grains, which tells their depth.

#include <vector>

namespace osculate::io {

/// Depths of a picture along parallel rays, rows from the top.
struct DepthMap {
  int width, height;         ///< [px]
  std::vector<float> depth;  ///< towards the viewer [px]; −∞ where there is nothing
};

/// The share of the sky that is seen, in (0, 1], one a pixel: 1 where nothing stands near. What is further away than
/// `radius` [px] hides nothing.
std::vector<float> seen_sky(const DepthMap& map, double radius);

}  // namespace osculate::io
