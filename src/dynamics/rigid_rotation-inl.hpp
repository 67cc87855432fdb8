// Free rotation of a rigid body over Real (double or Batch); see rigid_rotation.hpp.
#if defined(OSCULATE_DYNAMICS_RIGID_ROTATION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_DYNAMICS_RIGID_ROTATION_INL
#undef OSCULATE_DYNAMICS_RIGID_ROTATION_INL
#else
#define OSCULATE_DYNAMICS_RIGID_ROTATION_INL
#endif

#include "core/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

template <class Real>
struct QuatOf {
  Real w;
  V3<Real> v;
};

template <class Real>
HWY_INLINE QuatOf<Real> product(const QuatOf<Real>& a, const QuatOf<Real>& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}

template <class Real>
HWY_INLINE QuatOf<Real> normalised(const QuatOf<Real>& q) {
  const Real scale = Real(1.0) / sqrt(fma(q.w, q.w, dot(q.v, q.v)));
  return {scale * q.w, scale * q.v};
}

/// Rotates the body about its axis k by 2 atan(half); a and b are the other two axes in cyclic order. The turn (w, k,
/// a, b) grows by the factor (1, half e_k), not normalised.
template <class Real>
HWY_INLINE void rotate_about(const Real& half, Real& w, Real& k, Real& a, Real& b, Real& momentum_a, Real& momentum_b) {
  const Real one(1.0), square_of_half = half * half;
  const Real scale = one / (one + square_of_half);
  const Real cosine = (one - square_of_half) * scale, sine = (half + half) * scale;
  const Real m_a = momentum_a, m_b = momentum_b;
  momentum_a = cosine * m_a + sine * m_b;
  momentum_b = cosine * m_b - sine * m_a;
  const Real w_before = w, a_before = a;
  w = w_before - half * k;
  k = k + half * w_before;
  a = a_before + half * b;
  b = b - half * a_before;
}

template <class Real>
struct TurnOf {
  QuatOf<Real> orientation;
  V3<Real> momentum;
  V3<Real> mean_velocity;
};

/// A step dt of free rotation; momentum in the body's frame.                                            [DLM97 §III]
template <class Real>
HWY_INLINE TurnOf<Real> turned(const QuatOf<Real>& orientation, V3<Real> momentum, const V3<Real>& inverse_inertia,
                               const Real& dt) {
  const V3<Real> half = (Real(0.5) * dt) * inverse_inertia, quarter = (Real(0.25) * dt) * inverse_inertia;
  const Real zero(0.0);
  QuatOf<Real> turn{Real(1.0), {zero, zero, zero}};
  auto& [w, v] = turn;
  auto& L = momentum;
  rotate_about(quarter.x * L.x, w, v.x, v.y, v.z, L.y, L.z);
  rotate_about(quarter.y * L.y, w, v.y, v.z, v.x, L.z, L.x);
  rotate_about(half.z * L.z, w, v.z, v.x, v.y, L.x, L.y);
  rotate_about(quarter.y * L.y, w, v.y, v.z, v.x, L.z, L.x);
  rotate_about(quarter.x * L.x, w, v.x, v.y, v.z, L.y, L.z);
  const QuatOf<Real> now = normalised(product(orientation, turn));
  // The axis of the turn is the same before and after it.
  const V3<Real> axis = (Real(2.0) / (dt * w)) * v;
  return {now, momentum, rotation_of(now.w, now.v).apply(axis)};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
