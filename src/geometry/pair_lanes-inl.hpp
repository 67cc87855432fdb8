// Jobs of one kind, side by side in the lanes of a Real: what goes into the contact solver and what comes out.
#if defined(OSCULATE_GEOMETRY_PAIR_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_GEOMETRY_PAIR_LANES_INL
#undef OSCULATE_GEOMETRY_PAIR_LANES_INL
#else
#define OSCULATE_GEOMETRY_PAIR_LANES_INL
#endif

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

#include "geometry/common_normal-inl.hpp"
#include "geometry/pair_job.hpp"
#include "geometry/pair_order.hpp"
#include "shapes/potential_surface-inl.hpp"
#include "shapes/wall_surface-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Up to one batch of jobs.
struct Jobs {
  PairJob* const* job;
  std::size_t count;

  const PairJob& operator[](std::size_t i) const { return *job[i]; }
  std::uint64_t all() const { return (std::uint64_t{1} << count) - 1; }
};

inline bool has(std::uint64_t set, std::size_t lane) {
  return (set >> lane & 1U) != 0;
}

/// Lanes beyond the last job repeat it.
template <class Real, class Get>
HWY_INLINE Real gather(const Jobs& jobs, const Get& get) {
  HWY_ALIGN double values[lanes<Real>()];
  for (std::size_t i = 0; i < lanes<Real>(); ++i) values[i] = get(jobs[std::min(i, jobs.count - 1)]);
  return load<Real>(values, lanes<Real>());
}
template <class Real, class Get>
HWY_INLINE V3<Real> gather3(const Jobs& jobs, const Get& get) {
  return {gather<Real>(jobs, [&](const PairJob& job) { return get(job).x(); }),
          gather<Real>(jobs, [&](const PairJob& job) { return get(job).y(); }),
          gather<Real>(jobs, [&](const PairJob& job) { return get(job).z(); })};
}

/// The lanes of a number, one by one.
template <class Real>
class Lanes {
 public:
  HWY_INLINE explicit Lanes(const Real& value) { store(value, values_, lanes<Real>()); }
  double operator[](std::size_t i) const { return values_[i]; }

 private:
  HWY_ALIGN double values_[lanes<Real>()];
};
template <class Real>
class Lanes3 {
 public:
  HWY_INLINE explicit Lanes3(const V3<Real>& v) : x_(v.x), y_(v.y), z_(v.z) {}
  Vec3 operator[](std::size_t i) const { return {x_[i], y_[i], z_[i]}; }

 private:
  Lanes<Real> x_, y_, z_;
};

/// The kinds of particle: how numbers are gathered, and which surfaces they make.
struct BluntParticle {
  template <class Real>
  using Numbers = SuperquadricNumbers<Real>;
  template <class Real>
  using Lift = GaugeSurface<Real, RealPower>;
  template <class Real>
  using Support = SupportSurface<BluntJet<Real>, Real, RealPower>;
};
struct SharpParticle {
  template <class Real>
  using Numbers = SuperquadricNumbers<Real>;
  template <class Real>
  using Lift = MixedSurface<Real>;
  template <class Real>
  using Support = SupportSurface<SharpJet<Real>, Real, RealPower>;
};
struct ImplicitParticle {
  template <class Real>
  using Numbers = PotentialNumbers<Real>;
  template <class Real>
  using Lift = PotentialSurface<Real>;
  template <class Real>
  using Support = PotentialSurface<Real>;
};

template <class Real, class Get>
HWY_INLINE void read_numbers(const Jobs& jobs, const Get& shape_of, SuperquadricNumbers<Real>& numbers) {
  const auto each = [&](const auto& get) HWY_ATTR {
    return gather<Real>(jobs, [&](const PairJob& job) { return get(superquadric_of(shape_of(job))); });
  };
  numbers.half_axes = {each([](const Superquadric& s) { return s.half_axes.x(); }),
                       each([](const Superquadric& s) { return s.half_axes.y(); }),
                       each([](const Superquadric& s) { return s.half_axes.z(); })};
  numbers.n1 = each([](const Superquadric& s) { return s.exponents.n1; });
  numbers.n2 = each([](const Superquadric& s) { return s.exponents.n2; });
}

template <class Real, class Get>
HWY_INLINE void read_numbers(const Jobs& jobs, const Get& shape_of, PotentialNumbers<Real>& numbers) {
  const auto particle = [&](const PairJob& job) -> const PotentialParticle& {
    return std::get<PotentialParticle>(shape_of(job));
  };
  std::size_t most_planes = 0;
  for (std::size_t i = 0; i < jobs.count; ++i) most_planes = std::max(most_planes, particle(jobs[i]).planes.size());
  numbers.planes.resize(most_planes);
  numbers.in_play.resize(most_planes);
  for (std::size_t k = 0; k < most_planes; ++k) {
    const auto plane = [&](const PairJob& job) -> FacePlane {
      const auto& planes = particle(job).planes;
      return k < planes.size() ? planes[k] : FacePlane{Vec3::Zero(), 1.0};
    };
    numbers.planes[k] = {gather3<Real>(jobs, [&](const PairJob& job) { return plane(job).normal; }),
                         gather<Real>(jobs, [&](const PairJob& job) { return plane(job).distance; })};
  }
  const Real k = gather<Real>(jobs, [&](const PairJob& job) { return particle(job).sphericity; });
  const Real r = gather<Real>(jobs, [&](const PairJob& job) { return particle(job).edge_radius; });
  const Real R = gather<Real>(jobs, [&](const PairJob& job) { return particle(job).sphere_radius; });
  const Real one(1.0);
  numbers.of_planes = (one - k) / (r * r);
  numbers.of_sphere = k / (R * R);
  numbers.face_offset = r / sqrt(one - k);
  numbers.farthest = R / sqrt(k);
}

/// A length of the order of the body.
template <class Real>
HWY_INLINE Real size_of(const SuperquadricNumbers<Real>& numbers) {
  return max(max(numbers.half_axes.x, numbers.half_axes.y), numbers.half_axes.z);
}
template <class Real>
HWY_INLINE Real size_of(const PotentialNumbers<Real>& numbers) {
  Real furthest_plane(0.0);
  for (const auto& plane : numbers.planes)
    furthest_plane =
        max(furthest_plane, select(dot(plane.normal, plane.normal) > Real(0.0), plane.distance, Real(0.0)));
  return min(furthest_plane + numbers.face_offset, numbers.farthest);
}

/// Where the bodies of a batch of jobs are, seen from the first.
template <class Real>
struct Placement {
  Rotation<Real> frame;  ///< of body 1 → world
  V3<Real> origin;
  Rotation<Real> rotation;  ///< frame of body 2 → frame of body 1
  V3<Real> centre_2;        ///< in the frame of body 1
};

template <class Real>
HWY_NOINLINE Placement<Real> placement_of(const Jobs& jobs) {
  const V3<Real> position_1 = gather3<Real>(jobs, [](const PairJob& job) { return job.pose_1.position; });
  const V3<Real> position_2 = gather3<Real>(jobs, [](const PairJob& job) { return job.pose_2.position; });
  const Real w1 = gather<Real>(jobs, [](const PairJob& job) { return job.pose_1.orientation.w(); });
  const Real w2 = gather<Real>(jobs, [](const PairJob& job) { return job.pose_2.orientation.w(); });
  const V3<Real> v1 = gather3<Real>(jobs, [](const PairJob& job) -> Vec3 { return job.pose_1.orientation.vec(); });
  const V3<Real> v2 = gather3<Real>(jobs, [](const PairJob& job) -> Vec3 { return job.pose_2.orientation.vec(); });
  const Rotation<Real> frame = rotation_of(w1, v1);
  return {frame, position_1, rotation_of(w1 * w2 + dot(v1, v2), w1 * v2 - w2 * v1 - cross(v1, v2)),
          frame.apply_inverse(position_2 - position_1)};
}

/// The cached contact, in the frame of body 1. `centre_2` is where body 2's origin really is.
template <class Real>
HWY_INLINE Touch<Real> read_touch(const Jobs& jobs, const Placement<Real>& placement, const V3<Real>& centre_2) {
  return {
      gather3<Real>(jobs, [](const PairJob& job) { return job.cache->point_1; }),
      gather3<Real>(jobs, [](const PairJob& job) { return job.cache->normal_1; }),
      placement.rotation.apply(gather3<Real>(jobs, [](const PairJob& job) { return job.cache->point_2; })) + centre_2,
      placement.rotation.apply(gather3<Real>(jobs, [](const PairJob& job) { return job.cache->normal_2; }))};
}

inline bool is_finite(const ContactGeometry& contact) {
  return contact.normal.allFinite() && std::isfinite(contact.overlap) && contact.on_1.allFinite() &&
         contact.on_2.allFinite() && std::isfinite(contact.curvature_1.max) && std::isfinite(contact.curvature_2.max);
}

inline void give_up(const PairJob& job) {
  *job.contact = {};
  *job.cache = {};
}

/// Hands the wanted lanes of an answer to their jobs.
template <class Real>
HWY_NOINLINE void write_answer(const Jobs& jobs, const Placement<Real>& placement, const V3<Real>& centre_2,
                               const Real& length, const Answer<Real>& answer, std::uint64_t ambiguous,
                               std::uint64_t wanted) {
  const Real zero(0.0), one(1.0), infinity(std::numeric_limits<double>::infinity());
  const auto in_world = [&](const V2<Real>& t) HWY_ATTR { return placement.frame.apply(lift(answer.basis, t)); };
  const Real vanishing = Real(vanishing_curvature) / length;
  const auto principal = [&](const Sym2<Real>& shape) HWY_ATTR {
    const Eigen2<Real> curvature = eigen(shape);
    return Eigen2<Real>{select(abs(curvature.max) > vanishing, curvature.max, zero),
                        select(abs(curvature.min) > vanishing, curvature.min, zero), curvature.direction};
  };
  const Eigen2<Real> first = principal(answer.shape_1), second = principal(answer.shape_2);
  const Eigen2<Real> relative = principal(answer.shape_1 + answer.shape_2);
  const auto radius = [&](const Real& curvature)
                          HWY_ATTR { return select(curvature > zero, one / curvature, infinity); };
  const Touch<Real>& touch = answer.touch;
  const Lanes3<Real> normal(placement.frame.apply(answer.normal));
  const Lanes3<Real> on_1(placement.frame.apply(touch.point_1) + placement.origin);
  const Lanes3<Real> on_2(placement.frame.apply(touch.point_2) + placement.origin);
  const Lanes3<Real> direction_1(in_world(first.direction)), direction_2(in_world(second.direction));
  const Lanes3<Real> major_axis(in_world({-relative.direction.q, relative.direction.p}));
  const Lanes<Real> overlap(answer.overlap), max_1(first.max), min_1(max(first.min, zero)), max_2(second.max),
      min_2(second.min), R_i(radius(relative.min)), R_j(radius(relative.max));
  const Lanes3<Real> point_1(touch.point_1), normal_1(touch.normal_1);
  const Lanes3<Real> point_2(placement.rotation.apply_inverse(touch.point_2 - centre_2));
  const Lanes3<Real> normal_2(placement.rotation.apply_inverse(touch.normal_2));
  const std::uint64_t flat = bits(relative.min * length < Real(flat_curvature));
  for (std::size_t i = 0; i < jobs.count; ++i) {
    if (!has(wanted, i)) continue;
    ContactGeometry& contact = *jobs[i].contact;
    contact.status = has(ambiguous, i)  ? ContactStatus::ambiguous
                     : overlap[i] < 0.0 ? ContactStatus::separated
                     : has(flat, i)     ? ContactStatus::flat
                                        : ContactStatus::touching;
    contact.normal = normal[i];
    contact.overlap = overlap[i];
    contact.on_1 = on_1[i];
    contact.on_2 = on_2[i];
    contact.curvature_1 = {max_1[i], min_1[i], direction_1[i]};
    contact.curvature_2 = {max_2[i], min_2[i], direction_2[i]};
    contact.relative = {R_i[i], R_j[i], major_axis[i], false};
    *jobs[i].cache = {
        ContactCache::State::contact, point_1[i], normal_1[i], point_2[i], normal_2[i], Vec3::Zero(), Vec3::Zero()};
    if (!is_finite(contact)) give_up(jobs[i]);
  }
}

/// Hands out a direction and the overlap along it, without points: a proof of separation, or the best that was found.
template <class Real>
HWY_NOINLINE void write_direction(const Jobs& jobs, const Placement<Real>& placement, const V3<Real>& direction,
                                  const Real& overlap, ContactStatus status, std::uint64_t wanted) {
  const Lanes3<Real> normal(placement.frame.apply(direction)), normal_1(direction),
      normal_2(placement.rotation.apply_inverse(-direction));
  const Lanes<Real> along(overlap);
  const auto state = status == ContactStatus::separated ? ContactCache::State::separation : ContactCache::State::empty;
  for (std::size_t i = 0; i < jobs.count; ++i) {
    if (!has(wanted, i)) continue;
    *jobs[i].contact = {};
    jobs[i].contact->status = status;
    jobs[i].contact->normal = normal[i];
    jobs[i].contact->overlap = along[i];
    *jobs[i].cache = {state, Vec3::Zero(), normal_1[i], Vec3::Zero(), normal_2[i], Vec3::Zero(), Vec3::Zero()};
    if (!is_finite(*jobs[i].contact)) give_up(jobs[i]);
  }
}

/// The answer at points whose normals are opposite already.
template <class Real, class Jet1, class Jet2, class Pair>
HWY_INLINE Answer<Real> answer_at(const Pair& pair, const Jet1& jet_1, const Jet2& jet_2) {
  Answer<Real> answer;
  answer.touch = {jet_1.point, jet_1.normal, jet_2.point, jet_2.normal};
  answer.normal = normalised(jet_1.normal - jet_2.normal);
  answer.basis = tangent_basis(answer.normal);
  answer.shape_1 = shape_operator(jet_1, answer.basis);
  answer.shape_2 = shape_operator(jet_2, pair.basis_in_2(answer.basis));
  answer.overlap = dot(jet_1.point - jet_2.point, answer.normal);
  answer.converged = answer.overlap == answer.overlap;
  return answer;
}

/// Newton's method, compiled once for each kind of pair.
template <class Pair, class Real = typename Pair::Number>
HWY_NOINLINE Answer<Real> newton(const Pair& pair, const Touch<Real>& start, int most_steps) {
  return polish(pair, {start, Real(0.0)}, most_steps);
}

/// Of a coordinate, relative to its size.
constexpr double round_off = 2.2e-16;

/// Where only one curvature is bounded, both bodies are treated by their responses.
template <class Real>
HWY_INLINE Mat2<Real> response_of(const Sym2<Real>& shape, const Real& length) {
  const Real one(1.0);
  const Mat2<Real> bend = length * matrix(shape);
  Mat2<Real> blown_up = bend;
  blown_up.column_1.p += one;
  blown_up.column_2.q += one;
  return (one / determinant(blown_up)) * (bend * adjugate(blown_up));
}
template <class Real>
HWY_INLINE void solve(const Mat2<Real>& A1, const Sym2<Real>& shape_2, const Real& length, Step<Real>& step) {
  solve(A1, response_of(shape_2, length), length, step);
}
template <class Real>
HWY_INLINE void solve(const Sym2<Real>& shape_1, const Mat2<Real>& A2, const Real& length, Step<Real>& step) {
  solve(response_of(shape_1, length), A2, length, step);
}

/// Calls `solve(jobs, std::type_identity<Real>())` for a list of jobs: many in batches, a single one in doubles.
template <class Solve>
void in_batches(const std::vector<PairJob*>& list, const Solve& solve) {
  if (list.size() == 1) return solve(Jobs{list.data(), 1}, std::type_identity<double>());
  for (std::size_t start = 0; start < list.size(); start += lanes<Batch>())
    solve(Jobs{list.data() + start, std::min(lanes<Batch>(), list.size() - start)}, std::type_identity<Batch>());
}

/// 0 blunt superquadric, 1 sharp superquadric, 2 potential particle.
constexpr std::size_t particle_kinds = 3;
inline std::size_t particle_kind(const Shape& shape) {
  if (std::holds_alternative<PotentialParticle>(shape)) return 2;
  const Exponents n = superquadric_of(shape).exponents;
  return std::min(n.n1, n.n2) < 2.0 ? 1 : 0;
}

/// Calls `visit` with the kind of particle that the number stands for.
template <class Visit>
void visit_kind(std::size_t kind, const Visit& visit) {
  switch (kind) {
    case 0:
      return visit(BluntParticle());
    case 1:
      return visit(SharpParticle());
    default:
      return visit(ImplicitParticle());
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
