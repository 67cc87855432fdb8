#include "io/ambient_occlusion.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace osculate::io;

namespace {

template <class Depth>
DepthMap map_of(int side, const Depth& depth) {
  DepthMap map{side, side, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) map.depth.push_back(depth(x, y));
  return map;
}

constexpr float nothing = -std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("A plane sees the whole sky, upright or inclined, up to where it ends") {
  for (const float slope : {0.0F, 0.7F}) {
    for (const float seen :
         seen_sky(map_of(60, [&](int x, int) { return x < 50 ? slope * static_cast<float>(x) : nothing; }), 10.0)) {
      CHECK(seen == 1.0F);
    }
  }
}

TEST_CASE("The bottom of a groove is darker than its brim, and the more so the narrower it is") {
  const auto middle_of = [](int width) {
    const auto sky =
        seen_sky(map_of(80, [&](int x, int) { return std::abs(x - 40) <= width / 2 ? -20.0F : 0.0F; }), 12.0);
    return std::pair{sky[40 * 80 + 40], sky[40 * 80 + 5]};
  };
  const auto [narrow, far] = middle_of(4);
  const auto [wide, also_far] = middle_of(16);
  CHECK(far == 1.0F);
  CHECK(also_far == 1.0F);
  CHECK(narrow < 0.8F);
  CHECK(narrow < wide);
  CHECK(wide < 1.0F);
}
