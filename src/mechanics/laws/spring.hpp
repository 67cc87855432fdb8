#pragma once
// One tangential spring: how it is remembered and carried with the contact plane.

#include <algorithm>
#include <cmath>

#include "mechanics/laws/law_part.hpp"

namespace osculate::laws {

/// Memory of a spring: its stretch of body 2 against body 1 and the normal, world frame, and the stiffness at the last
/// step.
inline constexpr std::size_t spring_memory = 7;

/// A tangential vector of the last step, carried along the turn of the normal by the shortest way, then by the spin.
inline Vec3 carried(const Contact& contact, const Vec3& vector, const Vec3& old_normal) {
  const double share = vector.dot(contact.normal) / std::max(1.0 + old_normal.dot(contact.normal), 1e-30);
  const Vec3 moved = vector - share * (old_normal + contact.normal);
  return std::cos(contact.spin) * moved + std::sin(contact.spin) * contact.normal.cross(moved);
}

inline Vec3 vector_at(const Memory& memory, std::size_t entry) {
  return {memory[entry], memory[entry + 1], memory[entry + 2]};
}

inline void put(const Vec3& vector, const Memory& memory, std::size_t entry) {
  for (int k = 0; k < 3; ++k) memory[entry + static_cast<std::size_t>(k)] = vector[k];
}

inline void forget(const Memory& memory, std::size_t size) {
  for (std::size_t k = 0; k < size; ++k) memory[k] = 0.0;
}

/// In the axes of the contact ellipse, and back.
inline TangentVector planar(const Contact& contact, const Vec3& vector) {
  return {vector.dot(contact.major), vector.dot(contact.minor)};
}
inline Vec3 spatial(const Contact& contact, const TangentVector& vector) {
  return vector.x * contact.major + vector.y * contact.minor;
}

}  // namespace osculate::laws
