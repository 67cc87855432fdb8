#include "shapes/direction_search.hpp"

#include <algorithm>
#include <array>
#include <queue>
#include <vector>

namespace osculate {
namespace {

constexpr double tightness = 1e-9;
constexpr int enough_support_points = 4000;

struct Cell {
  std::array<Vec3, 3> corners;  // unit vectors
  double bound;                 // of |x| in the cell
};
struct SmallerBound {
  bool operator()(const Cell& a, const Cell& b) const { return a.bound < b.bound; }
};

}  // namespace

double largest_radius(const std::function<Vec3(const Vec3&)>& support_point) {
  double reached = 0.0;
  int support_points = 0;
  std::priority_queue<Cell, std::vector<Cell>, SmallerBound> cells;
  const auto examine = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 centre = (a + b + c).normalized();
    const double cosine = std::min({centre.dot(a), centre.dot(b), centre.dot(c)});
    const Vec3 x = support_point(centre);
    reached = std::max(reached, x.norm());
    ++support_points;
    cells.push({{a, b, c}, centre.dot(x) / cosine});
  };
  for (int octant = 0; octant < 8; ++octant) {
    examine((octant & 1 ? -1.0 : 1.0) * Vec3::UnitX(), (octant & 2 ? -1.0 : 1.0) * Vec3::UnitY(),
            (octant & 4 ? -1.0 : 1.0) * Vec3::UnitZ());
  }
  while (cells.top().bound > reached * (1.0 + tightness) && support_points < enough_support_points) {
    const auto [a, b, c] = cells.top().corners;
    cells.pop();
    const Vec3 ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
    examine(a, ab, ca);
    examine(ab, b, bc);
    examine(ca, bc, c);
    examine(ab, bc, ca);
  }
  return std::max(cells.top().bound, reached * (1.0 + tightness));
}

}  // namespace osculate
