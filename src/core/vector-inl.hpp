// Small vectors and 2×2 tangent-plane matrices over Real (double or Batch).
#if defined(OSCULATE_CORE_VECTOR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_CORE_VECTOR_INL
#undef OSCULATE_CORE_VECTOR_INL
#else
#define OSCULATE_CORE_VECTOR_INL
#endif

#include "core/batch-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

template <class Real>
struct V3 {
  Real x, y, z;
};

template <class Real>
HWY_INLINE V3<Real> operator+(const V3<Real>& a, const V3<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
HWY_INLINE V3<Real> operator-(const V3<Real>& a, const V3<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
HWY_INLINE V3<Real> operator-(const V3<Real>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class Real>
HWY_INLINE V3<Real> operator*(const Real& s, const V3<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class Real>
HWY_INLINE Real dot(const V3<Real>& a, const V3<Real>& b) {
  return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}
template <class Real>
HWY_INLINE V3<Real> cross(const V3<Real>& a, const V3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
HWY_INLINE Real norm(const V3<Real>& a) {
  return sqrt(dot(a, a));
}
template <class Real>
HWY_INLINE V3<Real> normalised(const V3<Real>& a) {
  return (Real(1.0) / norm(a)) * a;
}
template <class Real>
HWY_INLINE V3<Real> select(MaskType<Real> condition, const V3<Real>& yes, const V3<Real>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z)};
}

/// A rotation by its columns: v = x·column_x + y·column_y + z·column_z.
template <class Real>
struct Rotation {
  V3<Real> column_x, column_y, column_z;

  HWY_INLINE V3<Real> apply(const V3<Real>& v) const { return v.x * column_x + v.y * column_y + v.z * column_z; }
  HWY_INLINE V3<Real> apply_inverse(const V3<Real>& v) const {
    return {dot(column_x, v), dot(column_y, v), dot(column_z, v)};
  }
};

/// The rotation of quaternion (w, v), whatever its length > 0.
template <class Real>
HWY_INLINE Rotation<Real> rotation_of(const Real& w, const V3<Real>& v) {
  const Real two = Real(2.0) / (w * w + dot(v, v));
  const Real xx = two * v.x * v.x, yy = two * v.y * v.y, zz = two * v.z * v.z;
  const Real xy = two * v.x * v.y, yz = two * v.y * v.z, zx = two * v.z * v.x;
  const Real wx = two * w * v.x, wy = two * w * v.y, wz = two * w * v.z;
  const Real one(1.0);
  return {{one - yy - zz, xy + wz, zx - wy}, {xy - wz, one - zz - xx, yz + wx}, {zx + wy, yz - wx, one - xx - yy}};
}

/// Two unit tangents that make a right-handed frame with a unit normal, continuous but for n_z = 0. (Duff et al. 2017)
template <class Real>
struct TangentBasis {
  V3<Real> e1, e2;

  HWY_INLINE V3<Real> lift(const Real& p, const Real& q) const { return p * e1 + q * e2; }
};
template <class Real>
HWY_INLINE TangentBasis<Real> tangent_basis(const V3<Real>& n) {
  const Real sign = copysign(Real(1.0), n.z);
  const Real a = Real(-1.0) / (sign + n.z);
  const Real b = n.x * n.y * a;
  return {{Real(1.0) + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// Vector and symmetric matrix in a tangent plane.
template <class Real>
struct V2 {
  Real p, q;
};
template <class Real>
struct Sym2 {
  Real pp, pq, qq;
};
template <class Real>
HWY_INLINE V2<Real> operator+(const V2<Real>& a, const V2<Real>& b) {
  return {a.p + b.p, a.q + b.q};
}
template <class Real>
HWY_INLINE V2<Real> operator-(const V2<Real>& a, const V2<Real>& b) {
  return {a.p - b.p, a.q - b.q};
}
template <class Real>
HWY_INLINE V2<Real> operator*(const Real& s, const V2<Real>& a) {
  return {s * a.p, s * a.q};
}
template <class Real>
HWY_INLINE V2<Real> operator*(const Sym2<Real>& m, const V2<Real>& v) {
  return {fma(m.pp, v.p, m.pq * v.q), fma(m.pq, v.p, m.qq * v.q)};
}
template <class Real>
HWY_INLINE Sym2<Real> operator+(const Sym2<Real>& a, const Sym2<Real>& b) {
  return {a.pp + b.pp, a.pq + b.pq, a.qq + b.qq};
}
template <class Real>
HWY_INLINE Sym2<Real> operator*(const Real& s, const Sym2<Real>& a) {
  return {s * a.pp, s * a.pq, s * a.qq};
}
template <class Real>
HWY_INLINE Real dot(const V2<Real>& a, const V2<Real>& b) {
  return fma(a.p, b.p, a.q * b.q);
}
template <class Real>
HWY_INLINE V2<Real> select(MaskType<Real> condition, const V2<Real>& yes, const V2<Real>& no) {
  return {select(condition, yes.p, no.p), select(condition, yes.q, no.q)};
}
template <class Real>
HWY_INLINE Sym2<Real> select(MaskType<Real> condition, const Sym2<Real>& yes, const Sym2<Real>& no) {
  return {select(condition, yes.pp, no.pp), select(condition, yes.pq, no.pq), select(condition, yes.qq, no.qq)};
}
template <class Real>
HWY_INLINE V2<Real> coordinates(const TangentBasis<Real>& basis, const V3<Real>& v) {
  return {dot(basis.e1, v), dot(basis.e2, v)};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
