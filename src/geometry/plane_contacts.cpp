#include "osculate/geometry/plane_contacts.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/plane_contacts.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "geometry/common_normal-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// The particle of each pair and the half-space it meets.
struct PlanePairs {
  SuperquadricNumbers<Batch> particle;
  V3<Batch> centre;
  Rotation<Batch> frame;  ///< of the particle → world
  V3<Batch> on_plane, outward;
  Mask plane_first, is_with_plane;

  HWY_INLINE PlanePairs(const SuperquadricPairs& pairs, std::size_t start, std::size_t count) {
    constexpr std::size_t second = SuperquadricPairs::per_body;
    const Mask swapped = column(pairs, 0, start, count) == Batch(0.0);
    const auto of_particle = [&](std::size_t k) HWY_ATTR {
      return select(swapped, column(pairs, second + k, start, count), column(pairs, k, start, count));
    };
    const auto of_plane = [&](std::size_t k) HWY_ATTR {
      return select(swapped, column(pairs, k, start, count), column(pairs, second + k, start, count));
    };
    particle = {{of_particle(0), of_particle(1), of_particle(2)}, of_particle(3), of_particle(4)};
    centre = {of_particle(5), of_particle(6), of_particle(7)};
    frame = rotation_of(of_particle(8), V3<Batch>{of_particle(9), of_particle(10), of_particle(11)});
    on_plane = {of_plane(5), of_plane(6), of_plane(7)};
    outward = rotation_of(of_plane(8), V3<Batch>{of_plane(9), of_plane(10), of_plane(11)}).column_z;
    plane_first = swapped;
    is_with_plane = of_plane(0) == Batch(0.0);
  }

 private:
  static HWY_INLINE Batch column(const SuperquadricPairs& pairs, std::size_t k, std::size_t start, std::size_t count) {
    return load<Batch>(pairs.columns[k] + start, count);
  }
};

/// The support point against the plane's normal.
void on_planes(const SuperquadricPairs& pairs, ContactColumns& contacts) {
  constexpr std::size_t width = lanes<Batch>();
  const Batch zero(0.0), one(1.0);
  for (std::size_t start = 0; start < pairs.size(); start += width) {
    const std::size_t count = std::min(width, pairs.size() - start);
    const PlanePairs of(pairs, start, count);
    const V3<Batch> inward = of.frame.apply_inverse(-of.outward);
    const auto jet = SupportSurface<BluntJet<Batch>, Batch, RealPower>(of.particle).support(inward);
    const Batch overlap = dot(jet.point, inward) + dot(of.outward, of.on_plane - of.centre);
    const V3<Batch> on_particle = of.centre + of.frame.apply(jet.point), on_plane = on_particle + overlap * of.outward;

    const Batch size = max(max(of.particle.half_axes.x, of.particle.half_axes.y), of.particle.half_axes.z);
    const TangentBasis<Batch> basis = tangent_basis(inward);
    const Eigen2<Batch> curvature = convex(eigen(shape_operator(jet, basis)), Batch(vanishing_curvature) / size);
    const V3<Batch> sharpest = of.frame.apply(lift(basis, curvature.direction)),
                    major_axis = cross(of.outward, sharpest);
    const V3<Batch> sum_3 = on_particle + on_plane + of.outward + sharpest;
    const Batch sum = sum_3.x + sum_3.y + sum_3.z + overlap + curvature.max;
    const Mask found = (sum - sum == zero) & of.is_with_plane;

    const auto put = [&](std::size_t k, const Batch& value)
                         HWY_ATTR { store(select(found, value, zero), contacts.columns[k] + start, count); };
    const auto put_3 = [&](std::size_t k, const V3<Batch>& v) HWY_ATTR {
      put(k, v.x);
      put(k + 1, v.y);
      put(k + 2, v.z);
    };
    const auto put_curvature = [&](std::size_t k, Mask of_particle) HWY_ATTR {
      put(k, select(of_particle, curvature.max, zero));
      put(k + 1, select(of_particle, curvature.min, zero));
      put_3(k + 2, sharpest);
    };
    const Mask& swapped = of.plane_first;
    put_3(0, select(swapped, of.outward, -of.outward));
    put(3, overlap);
    put_3(4, select(swapped, on_plane, on_particle));
    put_3(7, select(swapped, on_particle, on_plane));
    put_curvature(10, !swapped);
    put_curvature(15, swapped);
    put(20, one / curvature.min);
    put(21, one / curvature.max);
    put_3(22, major_axis);
    const std::uint64_t resolved = bits(found), apart = bits(overlap < zero),
                        flat = bits(curvature.min * size < Batch(flat_curvature));
    for (std::size_t i = 0; i < count; ++i) {
      const auto in = [&](std::uint64_t set) { return (set >> i & 1U) != 0; };
      contacts.statuses[start + i] = !in(resolved) ? ContactStatus::degenerate
                                     : in(apart)   ? ContactStatus::separated
                                     : in(flat)    ? ContactStatus::flat
                                                   : ContactStatus::touching;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {

HWY_EXPORT(on_planes);

void plane_contacts(const SuperquadricPairs& pairs, ContactColumns& contacts) {
  contacts.resize(pairs.size());
  HWY_DYNAMIC_DISPATCH(on_planes)(pairs, contacts);
}

}  // namespace osculate
#endif
