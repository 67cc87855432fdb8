#include "io/ambient_occlusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace osculate::io {
namespace {

constexpr int tile = 4;  // pixels of a tile look in turned directions; averaging over a tile takes the noise away
constexpr int looks = 14;

struct Look {
  float right, down;  ///< in units of the radius
};

/// Points spread evenly over the unit disc, a turned set for every pixel of a tile.
std::array<std::array<Look, looks>, tile * tile> all_looks() {
  std::array<std::array<Look, looks>, tile * tile> sets{};
  constexpr double golden = 2.399963229728653;  // the golden angle: a sunflower has no rows
  constexpr std::array<int, tile * tile> shuffled{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const double turn = 2.0 * std::numbers::pi * shuffled[s] / (tile * tile);
    for (std::size_t i = 0; i < looks; ++i) {
      const double radius = std::sqrt((static_cast<double>(i) + 0.5) / looks), angle = golden * static_cast<double>(i);
      sets[s][i] = {static_cast<float>(radius * std::cos(angle + turn)),
                    static_cast<float>(radius * std::sin(angle + turn))};
    }
  }
  return sets;
}

/// The average of the tile around every pixel, over what lies at the same depth.
std::vector<float> smoothed(const DepthMap& map, const std::vector<float>& sky, double radius) {
  std::vector<float> smooth(sky.size(), 1.0F);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const auto here = static_cast<std::size_t>(y * map.width + x);
      if (!std::isfinite(map.depth[here])) continue;
      float sum = 0.0F, count = 0.0F;
      for (int j = std::max(0, y - 2); j < std::min(map.height, y + 2); ++j) {
        for (int i = std::max(0, x - 2); i < std::min(map.width, x + 2); ++i) {
          const auto there = static_cast<std::size_t>(j * map.width + i);
          if (!(std::fabs(map.depth[there] - map.depth[here]) < 0.3 * radius)) continue;
          sum += sky[there];
          count += 1.0F;
        }
      }
      if (count > 0.0F) smooth[here] = sum / count;
    }
  }
  return smooth;
}

}  // namespace

std::vector<float> seen_sky(const DepthMap& map, double radius) {
  static const auto sets = all_looks();
  const auto at = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= map.width || y >= map.height) return -std::numeric_limits<float>::infinity();
    return map.depth[static_cast<std::size_t>(y * map.width + x)];
  };
  // The less steep of both one-sided slopes: the other may lead over an edge.
  const auto slope = [](float before, float here, float after) {
    const float back = here - before, on = after - here;
    const float less = std::fabs(back) < std::fabs(on) ? back : on;
    return std::isfinite(less) ? less : 0.0F;
  };
  const auto reach = static_cast<float>(radius);
  std::vector<float> sky(map.depth.size(), 1.0F);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const float z = at(x, y);
      if (!std::isfinite(z)) continue;
      const float right = slope(at(x - 1, y), z, at(x + 1, y)), down = slope(at(x, y - 1), z, at(x, y + 1));
      const float length = std::sqrt(1.0F + right * right + down * down);
      float hidden = 0.0F;
      for (const Look& look : sets[static_cast<std::size_t>(tile * (y % tile) + x % tile)]) {
        // Whole pixels, so that a plane is one.
        const float dx = std::round(reach * look.right), dy = std::round(reach * look.down);
        const float dz = at(x + static_cast<int>(dx), y + static_cast<int>(dy)) - z;
        if (!std::isfinite(dz)) continue;
        const float distance_2 = dx * dx + dy * dy + dz * dz;
        if (!(distance_2 > 0.0F)) continue;
        // Sine of the angle above the tangent plane, fading with the distance.
        const float above = (dz - right * dx - down * dy) / (length * std::sqrt(distance_2));
        const float fade = 1.0F / (1.0F + distance_2 / (reach * reach));
        hidden += std::max(0.0F, above - 0.12F) * fade;
      }
      sky[static_cast<std::size_t>(y * map.width + x)] = 1.0F - std::min(1.0F, 1.7F * hidden / looks);
    }
  }
  return smoothed(map, sky, radius);
}

}  // namespace osculate::io
