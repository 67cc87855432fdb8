// Walls as the contact solver sees them: the surface point nearest to a guess, to second order, in the wall's frame.
#if defined(OSCULATE_SHAPES_WALL_SURFACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_SHAPES_WALL_SURFACE_INL
#undef OSCULATE_SHAPES_WALL_SURFACE_INL
#else
#define OSCULATE_SHAPES_WALL_SURFACE_INL
#endif

#include "shapes/superquadric_surface-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

template <class Real>
struct PlaneSurface {
  HWY_INLINE BluntJet<Real> lift(const V3<Real>& point, const V3<Real>&) const {
    const Real zero(0.0), one(1.0);
    return {{point.x, point.y, zero}, {zero, zero, one}, {zero, zero, {one, zero, zero}, {zero, one, zero}}};
  }
};

/// K = ±1/R around, 0 along the axis.
template <class Real>
struct CylinderSurface {
  Real radius;
  Real side;  ///< 1 for a rod, −1 for a drum

  HWY_INLINE BluntJet<Real> lift(const V3<Real>& point, const V3<Real>& normal) const {
    const Real zero(0.0), one(1.0), length = sqrt(fma(point.x, point.x, point.y * point.y));
    const MaskType<Real> on_axis = length <= zero;
    const Real over = one / select(on_axis, one, length);
    const Real x = select(on_axis, side * normal.x, point.x * over),
               y = select(on_axis, side * normal.y, point.y * over);
    return {{radius * x, radius * y, point.z},
            {side * x, side * y, zero},
            {side / radius, zero, {-y, x, zero}, {zero, zero, one}}};
  }
};

/// K = −1/R: solid outside, normal to the centre.
template <class Real>
struct ContainerSurface {
  Real radius;

  HWY_INLINE BluntJet<Real> lift(const V3<Real>& point, const V3<Real>& normal) const {
    const Real zero(0.0), one(1.0), length = norm(point), bend = Real(-1.0) / radius;
    const MaskType<Real> at_centre = length <= zero;
    const V3<Real> outward = select(at_centre, -normal, (one / select(at_centre, one, length)) * point);
    const TangentBasis<Real> basis = tangent_basis(outward);
    return {radius * outward, -outward, {bend, bend, basis.e1, basis.e2}};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
