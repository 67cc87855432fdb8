#include "geometry/penetration_hull.hpp"

#include <algorithm>
#include <cstddef>

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
  if (!(length > round_off_ * round_off_)) return;  // a sliver: its neighbours cover its directions
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
  // The horizon: edges of exactly one face that sees the new point.
  std::vector<std::array<int, 2>> horizon;
  const auto toggle = [&](int a, int b) {
    const auto twin = std::find(horizon.begin(), horizon.end(), std::array<int, 2>{b, a});
    if (twin != horizon.end())
      horizon.erase(twin);
    else
      horizon.push_back({a, b});
  };
  const auto sees = [&](const Face& f) { return f.normal.dot(support_point) > f.offset + 0.5 * round_off_; };
  for (const Face& f : faces_) {
    if (!sees(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) toggle(f.vertices[k], f.vertices[(k + 1) % 3]);
  }
  faces_.erase(std::remove_if(faces_.begin(), faces_.end(), sees), faces_.end());
  const int apex = static_cast<int>(vertices_.size());
  vertices_.push_back(support_point);
  for (const auto& edge : horizon) add_face(edge[0], edge[1], apex);
}

}  // namespace osculate
