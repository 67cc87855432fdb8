#include "osculate/mechanics/polygon_energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate::polygon_energy {
namespace {

/// A polygon's indicator function is the signed sum over its edges of "below this edge". No decision about topology is
/// ever taken: every pair of edges adds its part, and vertices shared by two edges give both exactly the same limits.
struct Edge {
  double left, right;        ///< left ≤ right
  double at_left, at_right;  ///< heights
  double sign;               ///< +1 for an upper edge (counter-clockwise polygons run leftwards there)

  double height(double x) const {
    if (x <= left) return at_left;
    if (x >= right) return at_right;
    const double part = (x - left) / (right - left);
    return part < 0.5 ? at_left + part * (at_right - at_left) : at_right + (1.0 - part) * (at_left - at_right);
  }
};

struct Box {
  Vec2 low, high;
};

Box bounds(std::span<const Vec2> polygon) {
  Box box{polygon[0], polygon[0]};
  for (const Vec2& vertex : polygon) {
    box.low = box.low.cwiseMin(vertex);
    box.high = box.high.cwiseMax(vertex);
  }
  return box;
}

/// The upper and lower edges of a polygon over the box, heights above the box's floor, cut off at floor and ceiling.
/// What lies on the floor is left out: nothing is below it.
std::vector<Edge> edges_over(std::span<const Vec2> polygon, const Box& box) {
  std::vector<Edge> edges;
  const double ceiling = box.high.y() - box.low.y(), width = box.high.x() - box.low.x();
  const auto add = [&](double left, double right, double at_left, double at_right, double sign) {
    at_left = std::clamp(at_left, 0.0, ceiling), at_right = std::clamp(at_right, 0.0, ceiling);
    if (right > left && (at_left > 0.0 || at_right > 0.0)) edges.push_back({left, right, at_left, at_right, sign});
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 from = polygon[i] - box.low, to = polygon[(i + 1) % polygon.size()] - box.low;
    const Edge whole = from.x() < to.x() ? Edge{from.x(), to.x(), from.y(), to.y(), -1.0}
                                         : Edge{to.x(), from.x(), to.y(), from.y(), 1.0};
    const double left = std::clamp(whole.left, 0.0, width), right = std::clamp(whole.right, 0.0, width);
    if (!(right > left)) continue;
    double cuts[4] = {left, left, left, right};
    std::size_t count = 1;
    const double rise = whole.at_right - whole.at_left;
    double crossings[2] = {whole.left - whole.at_left / rise * (whole.right - whole.left),
                           whole.left + (ceiling - whole.at_left) / rise * (whole.right - whole.left)};
    if (crossings[0] > crossings[1]) std::swap(crossings[0], crossings[1]);
    for (const double crossing : crossings)
      if (crossing > cuts[count - 1] && crossing < right) cuts[count++] = crossing;
    cuts[count] = right;
    for (std::size_t k = 0; k < count; ++k) {
      // A piece is judged by its middle, so that rounding at the cuts cannot lift it off floor or ceiling.
      const double middle = whole.height(0.5 * (cuts[k] + cuts[k + 1]));
      if (middle <= 0.0) continue;
      if (middle >= ceiling)
        add(cuts[k], cuts[k + 1], ceiling, ceiling, whole.sign);
      else
        add(cuts[k], cuts[k + 1], whole.height(cuts[k]), whole.height(cuts[k + 1]), whole.sign);
    }
  }
  return edges;
}

struct Moments {
  double area = 0.0;
  Vec2 first = Vec2::Zero();  ///< ∫ x dA, ∫ y dA
};

/// What lies below the straight line from (x0, y0) to (x1, y1).
void add_trapezoid(Moments& sum, double sign, double x0, double x1, double y0, double y1) {
  const double width = sign * (x1 - x0);
  sum.area += width * 0.5 * (y0 + y1);
  sum.first.x() += width * (x0 * (2.0 * y0 + y1) + x1 * (y0 + 2.0 * y1)) / 6.0;
  sum.first.y() += width * (y0 * y0 + y0 * y1 + y1 * y1) / 6.0;
}

/// What lies below both edges.
void add_common(Moments& sum, const Edge& a, const Edge& b) {
  const double left = std::max(a.left, b.left), right = std::min(a.right, b.right);
  if (!(right > left)) return;
  const double sign = a.sign * b.sign;
  const double a_left = a.height(left), a_right = a.height(right), b_left = b.height(left), b_right = b.height(right);
  const double gap_left = a_left - b_left, gap_right = a_right - b_right;
  if ((gap_left < 0.0) == (gap_right < 0.0) || gap_left == 0.0 || gap_right == 0.0) {
    const bool a_below = gap_left + gap_right < 0.0;
    return add_trapezoid(sum, sign, left, right, a_below ? a_left : b_left, a_below ? a_right : b_right);
  }
  const double crossing = left + gap_left / (gap_left - gap_right) * (right - left);
  const double height = 0.5 * (a.height(crossing) + b.height(crossing));
  add_trapezoid(sum, sign, left, crossing, gap_left < 0.0 ? a_left : b_left, height);
  add_trapezoid(sum, sign, crossing, right, height, gap_left < 0.0 ? b_right : a_right);
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

struct Change {
  Vec2 gradient = Vec2::Zero();
  double turning = 0.0;
};

/// ∫ n ds and ∫ (x − pivot) × n ds over the part of the segment that lies in the polygon of `edges`.
void add_boundary(Change& sum, const Vec2& from, const Vec2& to, const std::vector<Edge>& edges, const Box& box,
                  const Vec2& pivot) {
  const Vec2 start = from - box.low, along = to - from;
  const Vec2 outward(along.y(), -along.x());
  const double ceiling = box.high.y() - box.low.y();
  // The part of the segment within the box's floor and ceiling.
  double first = 0.0, last = 1.0;
  if (along.y() != 0.0) {
    const double at_floor = -start.y() / along.y(), at_ceiling = (ceiling - start.y()) / along.y();
    first = std::max(first, std::min(at_floor, at_ceiling));
    last = std::min(last, std::max(at_floor, at_ceiling));
  } else if (start.y() < 0.0 || start.y() > ceiling) {
    return;
  }
  for (const Edge& edge : edges) {
    double low = first, high = last;
    if (along.x() != 0.0) {
      const double to_left = (edge.left - start.x()) / along.x(), to_right = (edge.right - start.x()) / along.x();
      low = std::max(low, std::min(to_left, to_right));
      high = std::min(high, std::max(to_left, to_right));
    } else if (start.x() < edge.left || start.x() >= edge.right) {
      continue;
    }
    if (!(high > low)) continue;
    const auto clearance = [&](double t) {
      return edge.height(start.x() + t * along.x()) - (start.y() + t * along.y());
    };
    const double at_low = clearance(low), at_high = clearance(high);
    if (at_low <= 0.0 && at_high <= 0.0) continue;
    if (at_low < 0.0) low += at_low / (at_low - at_high) * (high - low);
    if (at_high < 0.0) high -= at_high / (at_high - at_low) * (high - low);
    const double part = edge.sign * (high - low);
    sum.gradient += part * outward;
    sum.turning += part * cross(from + 0.5 * (low + high) * along - pivot, outward);
  }
}

double side(const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(b - a, c - a);
}

bool edges_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

}  // namespace

double EnergyFunction::energy(double area) const {
  return area > 0.0 ? coefficient * std::pow(area, exponent) : 0.0;
}

double EnergyFunction::slope(double area) const {
  return area > 0.0 ? coefficient * exponent * std::pow(area, exponent - 1.0) : 0.0;
}

void validate(const EnergyFunction& function) {
  if (!(function.coefficient > 0.0) || !std::isfinite(function.coefficient))
    throw InputError("polygon_energy", "coefficient k = " + std::to_string(function.coefficient),
                     "a positive, finite value");
  if (!(function.exponent >= 1.0) || !std::isfinite(function.exponent))
    throw InputError("polygon_energy", "exponent m = " + std::to_string(function.exponent),
                     "a finite value of at least 1");
}

void validate(std::span<const Vec2> polygon) {
  const std::size_t size = polygon.size();
  if (size < 3) throw InputError("polygon", std::to_string(size) + " vertices", "at least three");
  double twice_area = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    if (!polygon[i].allFinite()) throw InputError("polygon", "vertex " + std::to_string(i) + " not finite", "numbers");
    twice_area += cross(polygon[i] - polygon[0], polygon[(i + 1) % size] - polygon[0]);
  }
  if (!(twice_area > 0.0))
    throw InputError("polygon", "area " + std::to_string(0.5 * twice_area), "vertices in counter-clockwise order");
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = i + 1; k < size; ++k)
      if (edges_cross(polygon[i], polygon[i + 1], polygon[k], polygon[(k + 1) % size]))
        throw InputError("polygon", "edges " + std::to_string(i) + " and " + std::to_string(k) + " cross",
                         "a simple polygon");
}

Overlap overlap(std::span<const Vec2> body_1, std::span<const Vec2> body_2, const Vec2& pivot) {
  Overlap result{.area = 0.0, .centroid = Vec2::Zero(), .gradient = Vec2::Zero(), .turning = 0.0};
  const Box box_1 = bounds(body_1), box_2 = bounds(body_2);
  const Box box{box_1.low.cwiseMax(box_2.low), box_1.high.cwiseMin(box_2.high)};
  if (!(box.low.x() < box.high.x() && box.low.y() < box.high.y())) return result;

  const std::vector<Edge> edges_1 = edges_over(body_1, box), edges_2 = edges_over(body_2, box);
  Moments moments;
  for (const Edge& a : edges_1)
    for (const Edge& b : edges_2) add_common(moments, a, b);
  // Rounding of terms as large as the box.
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  const double box_area = (box.high - box.low).prod();
  if (moments.area <= rounding * box_area) return result;
  result.area = moments.area;
  result.centroid = (box.low + moments.first / moments.area).cwiseMax(box.low).cwiseMin(box.high);

  Change change;
  for (std::size_t i = 0; i < body_2.size(); ++i)
    add_boundary(change, body_2[i], body_2[(i + 1) % body_2.size()], edges_1, box, pivot);
  result.gradient = change.gradient;
  result.turning = change.turning;
  return result;
}

Contact contact(std::span<const Vec2> body_1, const Vec2& centre_1, std::span<const Vec2> body_2, const Vec2& centre_2,
                const EnergyFunction& function) {
  const Overlap common = overlap(body_1, body_2, centre_2);
  const double slope = function.slope(common.area);
  // Taken from zero: bodies apart feel 0, not −0.
  const Vec2 force = Vec2::Zero() - slope * common.gradient;
  const double moment = 0.0 - slope * common.turning;
  Contact contact{.area = common.area,
                  .energy = function.energy(common.area),
                  .force_on_2 = force,
                  // Force and moment on both bodies balance.
                  .moment_on_1 = 0.0 - moment - cross(centre_2 - centre_1, force),
                  .moment_on_2 = moment,
                  .reference_point = common.centroid};
  const double squared = force.squaredNorm();
  if (squared > 0.0) {
    const double missing = moment - cross(common.centroid - centre_2, force);
    contact.reference_point += missing / squared * Vec2(force.y(), -force.x());
  }
  return contact;
}

}  // namespace osculate::polygon_energy
