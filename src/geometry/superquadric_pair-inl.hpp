// Two superquadrics as the common-normal solver sees them, in the frame of body 1.
#if defined(OSCULATE_GEOMETRY_SUPERQUADRIC_PAIR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_GEOMETRY_SUPERQUADRIC_PAIR_INL
#undef OSCULATE_GEOMETRY_SUPERQUADRIC_PAIR_INL
#else
#define OSCULATE_GEOMETRY_SUPERQUADRIC_PAIR_INL
#endif

#include "geometry/common_normal-inl.hpp"
#include "shapes/superquadric-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// What is known of the exponents of a pair, from the most special to the most general.
struct Ellipsoids {
  using Lift = SquarePower;
  using Support = SquarePower;
  static constexpr View lift_view = View::from_point;
};
struct EvenExponents {
  using Lift = EvenPower;
  using Support = RealPower;
  static constexpr View lift_view = View::from_point;
};
struct RealExponents {
  using Lift = RealPower;
  using Support = RealPower;
  static constexpr View lift_view = View::mixed;
};

/// A surface point in the pair's frame, with its second-order part in the body's own.
template <class Real>
struct PairJet {
  V3<Real> point, normal;
  V3<Real> point_a, point_b, normal_a, normal_b;  ///< body frame; the normals' parts per unit of weight
  Real weight_a, weight_b;
  Real steepness;  ///< |∇N|
};

template <class Real>
HWY_INLINE PairJet<Real> select(MaskType<Real> condition, const PairJet<Real>& yes, const PairJet<Real>& no) {
  return {select(condition, yes.point, no.point),        select(condition, yes.normal, no.normal),
          select(condition, yes.point_a, no.point_a),    select(condition, yes.point_b, no.point_b),
          select(condition, yes.normal_a, no.normal_a),  select(condition, yes.normal_b, no.normal_b),
          select(condition, yes.weight_a, no.weight_a),  select(condition, yes.weight_b, no.weight_b),
          select(condition, yes.steepness, no.steepness)};
}

template <class Real, class Kind>
struct SuperquadricPair {
  using Number = Real;
  static constexpr View lift_view = Kind::lift_view;

  ViewedSuperquadric<Real> lift_body_1, lift_body_2, support_body_1, support_body_2;
  Rotation<Real> rotation;  ///< frame of body 2 → frame of body 1
  V3<Real> centre_2;        ///< in the frame of body 1
  Real length;              ///< L: the smaller body's largest half-axis

  HWY_INLINE SuperquadricPair(const V3<Real>& axes_1, const V2<Real>& n_1, const V3<Real>& axes_2, const V2<Real>& n_2,
                              const Rotation<Real>& rotation_12, const V3<Real>& centre)
      : lift_body_1(viewed<lift_view>(axes_1, n_1.p, n_1.q)),
        lift_body_2(viewed<lift_view>(axes_2, n_2.p, n_2.q)),
        support_body_1(viewed<View::from_normal>(axes_1, n_1.p, n_1.q)),
        support_body_2(viewed<View::from_normal>(axes_2, n_2.p, n_2.q)),
        rotation(rotation_12),
        centre_2(centre),
        length(min(max(axes_1.x, max(axes_1.y, axes_1.z)), max(axes_2.x, max(axes_2.y, axes_2.z)))) {}

  HWY_INLINE PairJet<Real> lift_1(const V3<Real>& point, const V3<Real>& normal) const {
    return in_frame_of_1(locate<lift_view, typename Kind::Lift>(lift_body_1, point, normal));
  }
  HWY_INLINE PairJet<Real> lift_2(const V3<Real>& point, const V3<Real>& normal) const {
    return from_frame_of_2(locate<lift_view, typename Kind::Lift>(lift_body_2, rotation.apply_inverse(point - centre_2),
                                                                  rotation.apply_inverse(normal)));
  }
  HWY_INLINE PairJet<Real> support_1(const V3<Real>& normal) const {
    return in_frame_of_1(locate<View::from_normal, typename Kind::Support>(support_body_1, normal, normal));
  }
  HWY_INLINE PairJet<Real> support_2(const V3<Real>& normal) const {
    const V3<Real> normal_b = rotation.apply_inverse(normal);
    return from_frame_of_2(locate<View::from_normal, typename Kind::Support>(support_body_2, normal_b, normal_b));
  }

  HWY_INLINE Mat2<Real> response_1(const PairJet<Real>& jet, const TangentBasis<Real>& basis) const {
    return response_of(jet, basis);
  }
  HWY_INLINE Mat2<Real> response_2(const PairJet<Real>& jet, const TangentBasis<Real>& basis) const {
    return response_of(jet, basis_in_2(basis));
  }
  HWY_INLINE Curvature<Real> curvature_1(const PairJet<Real>& jet, const TangentBasis<Real>& basis) const {
    return principal(curvature_of(jet), basis);
  }
  HWY_INLINE Curvature<Real> curvature_2(const PairJet<Real>& jet, const TangentBasis<Real>& basis) const {
    return principal(curvature_of(jet), basis_in_2(basis));
  }

 private:
  static HWY_INLINE PairJet<Real> in_frame_of_1(const SurfaceJet<Real>& jet) {
    const Real steepness = norm(jet.gradient);
    const Real inverse = Real(1.0) / steepness;
    return {jet.point,
            inverse * jet.gradient,
            jet.point_a,
            jet.point_b,
            inverse * jet.gradient_a,
            inverse * jet.gradient_b,
            jet.weight_a,
            jet.weight_b,
            steepness};
  }
  HWY_INLINE PairJet<Real> from_frame_of_2(const SurfaceJet<Real>& in_2) const {
    PairJet<Real> jet = in_frame_of_1(in_2);
    jet.point = rotation.apply(jet.point) + centre_2;
    jet.normal = rotation.apply(jet.normal);
    return jet;
  }
  HWY_INLINE TangentBasis<Real> basis_in_2(const TangentBasis<Real>& basis) const {
    return {rotation.apply_inverse(basis.e1), rotation.apply_inverse(basis.e2)};
  }
  HWY_INLINE Mat2<Real> response_of(const PairJet<Real>& jet, const TangentBasis<Real>& basis) const {
    const Real one(1.0);
    const Real flat_a = one / (one + jet.weight_a), flat_b = one / (one + jet.weight_b);
    const Mat2<Real> points{flat_a * coordinates(basis, jet.point_a), flat_b * coordinates(basis, jet.point_b)};
    const Mat2<Real> normals{(jet.weight_a * flat_a) * coordinates(basis, jet.normal_a),
                             (jet.weight_b * flat_b) * coordinates(basis, jet.normal_b)};
    return response(points, normals, length);
  }
  /// The Hessian of the gauge over |∇N|: weight_x gradient_x gradient_xᵀ/|∇N| summed over both levels.
  static HWY_INLINE RankTwo<Real> curvature_of(const PairJet<Real>& jet) {
    return {jet.weight_a * jet.steepness, jet.weight_b * jet.steepness, jet.normal_a, jet.normal_b};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
