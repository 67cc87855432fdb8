#include "geometry/penetration_hull.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace osculate {

PenetrationHull::PenetrationHull(const Vec3& centre, const std::array<Vec3, 3>& arms, double scale)
    : centre_(centre), round_off_(1e-12 * scale) {
  for (const Vec3& arm : arms) {
    vertices_.push_back(centre + arm);
    vertices_.push_back(centre - arm);
  }
  for (int i = 0; i < 2; ++i)
    for (int j = 2; j < 4; ++j)
      for (int k = 4; k < 6; ++k) add_face(i, j, k);
}

void PenetrationHull::add_face(int a, int b, int c) {
  const auto at = [&](int i) -> const Vec3& { return vertices_[static_cast<std::size_t>(i)]; };
  Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
  const double length = normal.norm();
  if (!(length > round_off_ * round_off_)) {
    // A sliver: its neighbours cover its directions; it only keeps the surface closed.
    faces_.push_back({Vec3::Zero(), std::numeric_limits<double>::infinity(), {a, b, c}, true});
    return;
  }
  normal /= length;
  if (normal.dot(at(a) - centre_) < 0.0) {
    normal = -normal;
    std::swap(b, c);
  }
  faces_.push_back({normal, normal.dot(at(a)), {a, b, c}, false});
}

const PenetrationHull::Face* PenetrationHull::lowest() const {
  const Face* best = nullptr;
  for (const Face& face : faces_)
    if (!face.closed && (best == nullptr || face.offset < best->offset)) best = &face;
  return best;
}

void PenetrationHull::expand(const Face& face, const Vec3& support_point) {
  if (face.normal.dot(support_point) - face.offset <= round_off_) {
    faces_[static_cast<std::size_t>(&face - faces_.data())].closed = true;
    return;
  }
  // The connected patch of faces that see the new point. Faces elsewhere that see it by round-off alone stay: a patch
  // of n faces has at most n + 2 edges to the rest, so that the hull grows by two faces at a time.
  const auto adjacent = [](const Face& f, const Face& g) {
    return std::count_if(f.vertices.begin(), f.vertices.end(), [&](int v) {
             return std::find(g.vertices.begin(), g.vertices.end(), v) != g.vertices.end();
           }) >= 2;
  };
  std::vector<Face> patch{face}, others;
  for (const Face& f : faces_)
    if (&f != &face) others.push_back(f);
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const Face centre = patch[k];
    const auto joins = [&](const Face& f) {
      return f.normal.dot(support_point) > f.offset + 0.5 * round_off_ && adjacent(f, centre);
    };
    const auto first = std::stable_partition(others.begin(), others.end(), [&](const Face& f) { return !joins(f); });
    patch.insert(patch.end(), first, others.end());
    others.erase(first, others.end());
  }
  std::vector<std::array<int, 2>> horizon;
  for (const Face& f : patch)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = f.vertices[k], b = f.vertices[(k + 1) % 3];
      const auto twin = std::find_if(horizon.begin(), horizon.end(), [&](const std::array<int, 2>& edge) {
        return (edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a);
      });
      if (twin != horizon.end())
        horizon.erase(twin);
      else
        horizon.push_back({a, b});
    }
  faces_ = std::move(others);
  const int apex = static_cast<int>(vertices_.size());
  vertices_.push_back(support_point);
  for (const auto& edge : horizon) add_face(edge[0], edge[1], apex);
}

}  // namespace osculate
