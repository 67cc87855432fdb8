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
  return inverse_sqrt(dot(a, a)) * a;
}
/// Component by component.
template <class Real>
HWY_INLINE V3<Real> times(const V3<Real>& a, const V3<Real>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class Real>
HWY_INLINE V3<Real> inverse(const V3<Real>& a) {
  const Real one(1.0);
  return {one / a.x, one / a.y, one / a.z};
}
template <class Real>
HWY_INLINE V3<Real> absolute(const V3<Real>& a) {
  return {abs(a.x), abs(a.y), abs(a.z)};
}
template <class Real>
HWY_INLINE V3<Real> sign_of(const V3<Real>& a) {
  const Real one(1.0);
  return {copysign(one, a.x), copysign(one, a.y), copysign(one, a.z)};
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
  const Real one(1.0), squared = w * w + dot(v, v), excess = squared - one;
  // A unit quaternion's 2/|q|² needs no division.
  Real two = Real(2.0) * fma(excess, excess - one, one);
  const MaskType<Real> unit = abs(excess) < Real(1e-6);
  if (!all(unit)) two = select(unit, two, Real(2.0) / squared);
  const Real xx = two * v.x * v.x, yy = two * v.y * v.y, zz = two * v.z * v.z;
  const Real xy = two * v.x * v.y, yz = two * v.y * v.z, zx = two * v.z * v.x;
  const Real wx = two * w * v.x, wy = two * w * v.y, wz = two * w * v.z;
  return {{one - yy - zz, xy + wz, zx - wy}, {xy - wz, one - zz - xx, yz + wx}, {zx + wy, yz - wx, one - xx - yy}};
}

/// Two unit tangents that make a right-handed frame with a unit normal, continuous but for n_z = 0. (Duff et al. 2017)
template <class Real>
struct TangentBasis {
  V3<Real> e1, e2;
};
template <class Real>
HWY_INLINE TangentBasis<Real> select(MaskType<Real> condition, const TangentBasis<Real>& yes,
                                     const TangentBasis<Real>& no) {
  return {select(condition, yes.e1, no.e1), select(condition, yes.e2, no.e2)};
}
template <class Real>
HWY_INLINE TangentBasis<Real> tangent_basis(const V3<Real>& n) {
  const Real sign = copysign(Real(1.0), n.z);
  const Real a = -reciprocal(sign + n.z);
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
HWY_INLINE V3<Real> lift(const TangentBasis<Real>& basis, const V2<Real>& v) {
  return v.p * basis.e1 + v.q * basis.e2;
}
template <class Real>
HWY_INLINE V2<Real> coordinates(const TangentBasis<Real>& basis, const V3<Real>& v) {
  return {dot(basis.e1, v), dot(basis.e2, v)};
}

template <class Real>
HWY_INLINE Real determinant(const Sym2<Real>& m) {
  return fma(m.pp, m.qq, -(m.pq * m.pq));
}

/// Eigenvalues max ≥ min of a symmetric matrix and the unit eigenvector of `max`; (1, 0) where any direction serves.
template <class Real>
struct Eigen2 {
  Real max, min;
  V2<Real> direction;
};
template <class Real>
HWY_INLINE Eigen2<Real> eigen(const Sym2<Real>& m) {
  const Real half(0.5), zero(0.0), one(1.0), tiny(1e-150);
  const Real mean = half * (m.pp + m.qq), difference = half * (m.pp - m.qq);
  const Real squared = fma(difference, difference, m.pq * m.pq);
  const Real radius = squared * inverse_sqrt(max(squared, tiny * tiny));
  // The eigenvector from the larger of the two equivalent forms: (radius + |difference|, pq) up to an exchange.
  const Real long_side = radius + abs(difference),
             inverse = inverse_sqrt(max(Real(2.0) * radius * long_side, tiny * tiny));
  const Real major = long_side * inverse, minor = m.pq * inverse;
  const V2<Real> direction = select(difference >= zero, V2<Real>{major, minor}, V2<Real>{minor, major});
  return {mean + radius, mean - radius, select(radius <= tiny, V2<Real>{one, zero}, direction)};
}
template <class Real>
HWY_INLINE Eigen2<Real> select(MaskType<Real> condition, const Eigen2<Real>& yes, const Eigen2<Real>& no) {
  return {select(condition, yes.max, no.max), select(condition, yes.min, no.min),
          select(condition, yes.direction, no.direction)};
}

/// General 2×2 matrix by its columns.
template <class Real>
struct Mat2 {
  V2<Real> column_1, column_2;
};
template <class Real>
HWY_INLINE V2<Real> operator*(const Mat2<Real>& m, const V2<Real>& v) {
  return {fma(m.column_1.p, v.p, m.column_2.p * v.q), fma(m.column_1.q, v.p, m.column_2.q * v.q)};
}
template <class Real>
HWY_INLINE Mat2<Real> operator*(const Mat2<Real>& m, const Mat2<Real>& n) {
  return {m * n.column_1, m * n.column_2};
}
template <class Real>
HWY_INLINE Mat2<Real> operator+(const Mat2<Real>& m, const Mat2<Real>& n) {
  return {m.column_1 + n.column_1, m.column_2 + n.column_2};
}
template <class Real>
HWY_INLINE Mat2<Real> operator*(const Real& s, const Mat2<Real>& m) {
  return {s * m.column_1, s * m.column_2};
}
template <class Real>
HWY_INLINE Real determinant(const Mat2<Real>& m) {
  return fma(m.column_1.p, m.column_2.q, -(m.column_2.p * m.column_1.q));
}
template <class Real>
HWY_INLINE Real trace(const Mat2<Real>& m) {
  return m.column_1.p + m.column_2.q;
}
/// The matrix that gives the inverse when divided by the determinant.
template <class Real>
HWY_INLINE Mat2<Real> adjugate(const Mat2<Real>& m) {
  return {{m.column_2.q, -m.column_1.q}, {-m.column_2.p, m.column_1.p}};
}

/// A symmetric matrix of rank two: weight_a a aᵀ + weight_b b bᵀ.
template <class Real>
struct RankTwo {
  Real weight_a, weight_b;
  V3<Real> a, b;
};

template <class Real>
HWY_INLINE RankTwo<Real> select(MaskType<Real> condition, const RankTwo<Real>& yes, const RankTwo<Real>& no) {
  return {select(condition, yes.weight_a, no.weight_a), select(condition, yes.weight_b, no.weight_b),
          select(condition, yes.a, no.a), select(condition, yes.b, no.b)};
}

/// Projection on a tangent plane.
template <class Real>
HWY_INLINE Sym2<Real> project(const RankTwo<Real>& m, const TangentBasis<Real>& basis) {
  const V2<Real> a = coordinates(basis, m.a), b = coordinates(basis, m.b);
  const V2<Real> wa = m.weight_a * a, wb = m.weight_b * b;
  return {fma(wa.p, a.p, wb.p * b.p), fma(wa.p, a.q, wb.p * b.q), fma(wa.q, a.q, wb.q * b.q)};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
