#pragma once
// A polytope inside the Minkowski difference B1 − B2 of two overlapping bodies, grown towards its boundary where that
// is nearest to the origin. Every face bounds the overlap from below in the directions it covers, so that a minimum of
// the overlap can be told to be the global one. (The expanding polytope of van den Bergen 2001, used as a proof.)

#include <array>
#include <vector>

#include "osculate/core/types.hpp"

namespace osculate {

class PenetrationHull {
 public:
  /// The octahedron centre ± arm_k; `scale` is the size of the difference body, by which round-off is judged.
  PenetrationHull(const Vec3& centre, const std::array<Vec3, 3>& arms, double scale);

  struct Face {
    Vec3 normal;    ///< outward, unit
    double offset;  ///< of its plane from the origin along the normal: a lower bound of the overlap near the normal
    std::array<int, 3> vertices;
    bool closed;  ///< lies in the boundary of the difference body
  };

  /// The open face of least offset; nullptr when all are closed.
  const Face* lowest() const;
  const std::vector<Face>& faces() const { return faces_; }

  /// Takes in the support point along the normal of `face` (from `lowest()`), or closes the face if nothing is gained.
  void expand(const Face& face, const Vec3& support_point);

 private:
  void add_face(int a, int b, int c);

  std::vector<Vec3> vertices_;
  std::vector<Face> faces_;
  Vec3 centre_;
  double round_off_;
};

}  // namespace osculate
