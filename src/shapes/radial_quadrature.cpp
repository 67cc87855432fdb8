#include "shapes/radial_quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace osculate {
namespace {

struct Moments {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

Moments& operator+=(Moments& a, const Moments& b) {
  a.volume += b.volume;
  a.first += b.first;
  a.second += b.second;
  return a;
}

using Triangle = std::array<Vec3, 3>;

struct Cell {
  Triangle corners;
  std::array<Moments, 4> quarters;
  Moments fine;
  double volume_error, second_error;  // between the cell's one rule and its four quarters, see make_cell
};

/// Radon's rule of degree 5 on a flat triangle whose rays make the cell. With x on the triangle and dA in its
/// barycentric coordinates, dΩ = det(corners)/|x|³ dA, so that every |x| drops out.
Moments integrate(const Triangle& t, const std::function<double(const Vec3&)>& stretch) {
  static const double root = std::sqrt(15.0);
  struct Node {
    double near, far, weight;  // barycentric coordinates: two `near`, one `far`
  };
  static const std::array<Node, 2> rings = {
      Node{(6.0 - root) / 21.0, (9.0 + 2.0 * root) / 21.0, (155.0 - root) / 2400.0},
      Node{(6.0 + root) / 21.0, (9.0 - 2.0 * root) / 21.0, (155.0 + root) / 2400.0}};
  const double jacobian = t[0].dot(t[1].cross(t[2]));
  Moments moments;
  const auto add = [&](const Vec3& x, double weight) {
    const double s = stretch(x), s3 = s * s * s * weight * jacobian;
    moments.volume += s3 / 3.0;
    moments.first += (s3 * s / 4.0) * x;
    moments.second += (s3 * s * s / 5.0) * (x * x.transpose());
  };
  add((t[0] + t[1] + t[2]) / 3.0, 9.0 / 80.0);
  for (const Node& ring : rings) {
    add(ring.far * t[0] + ring.near * (t[1] + t[2]), ring.weight);
    add(ring.far * t[1] + ring.near * (t[2] + t[0]), ring.weight);
    add(ring.far * t[2] + ring.near * (t[0] + t[1]), ring.weight);
  }
  return moments;
}
constexpr int nodes_of_rule = 7;

std::array<Triangle, 4> quarters_of(const Triangle& t) {
  const Vec3 m01 = 0.5 * (t[0] + t[1]), m12 = 0.5 * (t[1] + t[2]), m20 = 0.5 * (t[2] + t[0]);
  return {Triangle{t[0], m01, m20}, Triangle{m01, t[1], m12}, Triangle{m20, m12, t[2]}, Triangle{m01, m12, m20}};
}

/// A kink that misses the nodes makes two resolutions agree by chance. So no cell is believed to be more than 128 times
/// better than the one it came from: between the gain per level at a kink, 2⁴, and on a smooth surface, 2⁸.
Cell make_cell(const Triangle& corners, const Moments& coarse, double volume_error_before, double second_error_before,
               const std::function<double(const Vec3&)>& stretch) {
  constexpr double largest_gain = 128.0;
  Cell cell{.corners = corners, .quarters = {}, .fine = {}, .volume_error = 0.0, .second_error = 0.0};
  const auto quarters = quarters_of(corners);
  for (std::size_t i = 0; i < 4; ++i) {
    cell.quarters[i] = integrate(quarters[i], stretch);
    cell.fine += cell.quarters[i];
  }
  cell.volume_error = std::max(std::fabs(cell.fine.volume - coarse.volume), volume_error_before / largest_gain);
  cell.second_error =
      std::max((cell.fine.second - coarse.second).cwiseAbs().maxCoeff(), second_error_before / largest_gain);
  return cell;
}

/// Turned out of every symmetry: along an edge of the body that coincides with sides of cells, a rounding narrower than
/// the gap between side and nodes would go unseen by both resolutions.
std::vector<Triangle> octahedron() {
  const Mat3 turn = Quat(0.83, 0.21, -0.37, 0.29).normalized().toRotationMatrix();
  std::vector<Triangle> faces;
  for (int octant = 0; octant < 8; ++octant) {
    const Vec3 x = (octant & 1 ? -1.0 : 1.0) * turn.col(0), y = (octant & 2 ? -1.0 : 1.0) * turn.col(1),
               z = (octant & 4 ? -1.0 : 1.0) * turn.col(2);
    const bool turned = x.dot(y.cross(z)) < 0.0;
    faces.push_back(turned ? Triangle{x, z, y} : Triangle{x, y, z});
  }
  return faces;
}

}  // namespace

MassProperties mass_properties_by_quadrature(const std::function<double(const Vec3&)>& stretch,
                                             const QuadratureEffort& effort) {
  std::vector<Cell> cells;
  double volume = 0.0, second_trace = 0.0, volume_error = 0.0, second_error = 0.0;
  const auto count = [&](const Cell& cell, double sign) {
    volume += sign * cell.fine.volume;
    second_trace += sign * cell.fine.second.trace();
    volume_error += sign * cell.volume_error;
    second_error += sign * cell.second_error;
  };
  int evaluations = 0;
  for (const Triangle& face : octahedron()) {
    for (const Triangle& quarter : quarters_of(face)) {
      cells.push_back(make_cell(quarter, integrate(quarter, stretch), 0.0, 0.0, stretch));
      count(cells.back(), 1.0);
      evaluations += 5 * nodes_of_rule;
    }
  }
  const auto error_of = [&](const Cell& cell) {
    return std::max(cell.volume_error / volume, cell.second_error / second_trace);
  };
  const auto relative_error = [&] { return std::max(volume_error / volume, second_error / second_trace); };
  // The scales of the order are those of the first pass: close enough, and the heap stays consistent.
  const double volume_scale = volume, second_scale = second_trace;
  const auto order = [&](const Cell& a, const Cell& b) {
    return std::max(a.volume_error / volume_scale, a.second_error / second_scale) <
           std::max(b.volume_error / volume_scale, b.second_error / second_scale);
  };
  std::make_heap(cells.begin(), cells.end(), order);
  while (relative_error() > effort.relative_error && evaluations < effort.evaluations &&
         error_of(cells.front()) > 0.0) {
    std::pop_heap(cells.begin(), cells.end(), order);
    const Cell parent = cells.back();
    cells.pop_back();
    count(parent, -1.0);
    const auto quarters = quarters_of(parent.corners);
    for (std::size_t i = 0; i < 4; ++i) {
      cells.push_back(make_cell(quarters[i], parent.quarters[i], parent.volume_error, parent.second_error, stretch));
      count(cells.back(), 1.0);
      evaluations += 4 * nodes_of_rule;
      std::push_heap(cells.begin(), cells.end(), order);
    }
  }

  Moments total;
  volume_error = second_error = 0.0;  // afresh, without the rounding of the running sums
  for (const Cell& cell : cells) {
    total += cell.fine;
    volume_error += cell.volume_error;
    second_error += cell.second_error;
  }
  const Vec3 centroid = total.first / total.volume;
  const Mat3 central = total.second - total.volume * centroid * centroid.transpose();
  const double error = std::max(volume_error / total.volume, second_error / total.second.trace());
  return {total.volume, centroid, central.trace() * Mat3::Identity() - central, error};
}

}  // namespace osculate
