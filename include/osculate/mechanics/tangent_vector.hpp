#pragma once
// Components in the contact plane, along two unit tangents of the caller's choice. Trivially copyable, so that memories
// made of it can be checkpointed as they are; the caller turns them with the plane.

#include <cmath>

namespace osculate {

struct TangentVector {
  double x = 0.0;
  double y = 0.0;
};

inline TangentVector operator+(const TangentVector& a, const TangentVector& b) {
  return {a.x + b.x, a.y + b.y};
}
inline TangentVector operator-(const TangentVector& a, const TangentVector& b) {
  return {a.x - b.x, a.y - b.y};
}
inline TangentVector operator*(double s, const TangentVector& a) {
  return {s * a.x, s * a.y};
}
inline double dot(const TangentVector& a, const TangentVector& b) {
  return a.x * b.x + a.y * b.y;
}
inline double norm(const TangentVector& a) {
  return std::hypot(a.x, a.y);
}

/// The vector, shortened to `longest` ≥ 0 if it is longer.
inline TangentVector shortened(const TangentVector& a, double longest) {
  const double length = norm(a);
  return length > longest ? (longest / length) * a : a;
}

}  // namespace osculate
