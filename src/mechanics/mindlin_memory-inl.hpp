// Springs of a tangential contact over Real (double or Batch): one step of many contacts at once, without branches that
// depend on a single one of them.
#if defined(OSCULATE_MECHANICS_MINDLIN_MEMORY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_MECHANICS_MINDLIN_MEMORY_INL
#undef OSCULATE_MECHANICS_MINDLIN_MEMORY_INL
#else
#define OSCULATE_MECHANICS_MINDLIN_MEMORY_INL
#endif

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "core/vector-inl.hpp"
#include "osculate/mechanics/mindlin_memory.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Deviations from a straight line below this, relative to the sliding deflection, are rounding: that of a frame that
/// turned hundreds of times leaves 1e-11.
inline constexpr double straight = 1e-10;
/// Points nearer than this share of the overlap are one.
inline constexpr double nearest = 1e-15;
/// What a reciprocal is taken of at the least.
inline constexpr double smallest_normal = std::numeric_limits<double>::min();

/// A spring by the root of its depth, which is what forces and energies are integrals over.
template <class Real>
struct LayerOf {
  Real root, x, y;

  HWY_INLINE Real depth() const { return root * root; }
};
template <class Real>
HWY_INLINE LayerOf<Real> select(MaskType<Real> condition, const LayerOf<Real>& yes, const LayerOf<Real>& no) {
  return {select(condition, yes.root, no.root), select(condition, yes.x, no.x), select(condition, yes.y, no.y)};
}
/// The point of the line between two at a share of its depth.
template <class Real>
HWY_INLINE LayerOf<Real> between(const LayerOf<Real>& a, const LayerOf<Real>& b, const Real& t) {
  const Real depth = fma(t, b.depth() - a.depth(), a.depth());
  return {sqrt(max(depth, Real(0.0))), fma(t, b.x - a.x, a.x), fma(t, b.y - a.y, a.y)};
}

/// The polyline of each contact. Points from a contact's `count` on, up to place `most`, are its rim, where s = 0.
template <class Real>
struct SpringsOf {
  static constexpr int room = mindlin::layers + 4;
  LayerOf<Real> at[room];
  Real rim_root, count;
  int most;  ///< the largest count

  HWY_INLINE LayerOf<Real> rim() const { return {rim_root, Real(0.0), Real(0.0)}; }
};

template <class Real>
struct ConeOf {
  Real overlap, rim_root, friction;

  HWY_INLINE Real radius(const LayerOf<Real>& layer) const { return friction * (overlap - layer.depth()); }
  HWY_INLINE MaskType<Real> slides(const LayerOf<Real>& layer) const {
    return fma(layer.x, layer.x, layer.y * layer.y) > square(radius(layer));
  }
  HWY_INLINE MaskType<Real> at_rim(const LayerOf<Real>& layer) const { return layer.root >= rim_root; }
  HWY_INLINE LayerOf<Real> projected(const LayerOf<Real>& layer) const {
    const Real r = radius(layer), size = fma(layer.x, layer.x, layer.y * layer.y);
    const MaskType<Real> out = size > r * r;
    const Real share = select(out, r * inverse_sqrt(select(out, size, Real(1.0))), Real(1.0));
    return {layer.root, layer.x * share, layer.y * share};
  }
  /// Where the line from a spring that sticks to one that slides leaves the cone; the second itself if it sticks too.
  HWY_INLINE LayerOf<Real> crossing(const LayerOf<Real>& sticks, const LayerOf<Real>& slips) const {
    const MaskType<Real> leaves = slides(slips);
    if (!any(leaves)) return slips;
    const Real zero(0.0), one(1.0);
    const Real drop = friction * (slips.depth() - sticks.depth()), r = radius(sticks);
    const Real dx = slips.x - sticks.x, dy = slips.y - sticks.y;
    const Real A = dx * dx + dy * dy - drop * drop;
    const Real B = sticks.x * dx + sticks.y * dy + r * drop;
    const Real C = min(sticks.x * sticks.x + sticks.y * sticks.y - r * r, zero);
    // B² − AC, written so that small deflections keep their digits.
    const Real px = r * dx + drop * sticks.x, py = r * dy + drop * sticks.y, twist = sticks.x * dy - sticks.y * dx;
    const Real root = sqrt(max(px * px + py * py - twist * twist, zero));
    const MaskType<Real> forward = B > zero;
    const Real divisor = select(forward, B + root, A);
    const MaskType<Real> sound = divisor > zero;
    const Real t = select(sound, select(forward, -C, root - B) / select(sound, divisor, one), zero);
    return select(leaves, between(sticks, slips, max(zero, min(t, one))), slips);
  }
};

template <class Real>
struct PlanarOf {
  Real x, y;
};

/// ∫ η^{−1/2} s_x², s_y² dη along a straight piece from a to b. With v the share of the way in √η that is
/// 2 (√η_b − √η_a) ∫ s² dv, s = s_a + (s_b − s_a) ((1 − k) v + k v²), k = (√η_b − √η_a)/(√η_b + √η_a): mean and
/// variance of s over v, both of which keep their sign.
/// @param inverse  1/(√η_a + √η_b)
template <class Real>
HWY_INLINE PlanarOf<Real> squared(const LayerOf<Real>& a, const LayerOf<Real>& b, const Real& inverse) {
  const Real width = b.root - a.root;
  const Real k = width * inverse;
  const Real middle = fma(Real(-1.0 / 6.0), k, Real(0.5)), spread = fma(Real(1.0 / 180.0) * k, k, Real(1.0 / 12.0));
  const auto mean_square = [&](const Real& from, const Real& to) HWY_ATTR {
    const Real rise = to - from, mean = fma(rise, middle, from);
    return fma(mean, mean, spread * rise * rise);
  };
  const Real twice = width + width;
  return {twice * mean_square(a.x, b.x), twice * mean_square(a.y, b.y)};
}

/// What a whole polyline comes to, component by component.
template <class Real>
struct SumsOf {
  PlanarOf<Real> traction;  ///< ∫ F' (−s') dη/k
  PlanarOf<Real> squared;   ///< ∫ η^{−1/2} s² dη
};

/// On a straight piece (q_2³ − q_1³)/(q_2² − q_1²) of q = √η is the mean of F'/k.
/// @pre overlap > 0 wherever the result is used
template <class Real>
HWY_INLINE SumsOf<Real> sums(const SpringsOf<Real>& line) {
  const Real zero(0.0);
  SumsOf<Real> sum{{zero, zero}, {zero, zero}};
  LayerOf<Real> a = line.at[0];
  for (int i = 0; i < line.most; ++i) {
    const LayerOf<Real> b = line.at[i + 1];
    const Real inverse = reciprocal(a.root + b.root);
    const Real mean = fma(a.root, a.root * inverse, b.root);
    sum.traction.x -= mean * (b.x - a.x);
    sum.traction.y -= mean * (b.y - a.y);
    const PlanarOf<Real> piece = squared(a, b, inverse);
    sum.squared.x += piece.x;
    sum.squared.y += piece.y;
    a = b;
  }
  return sum;
}

/// Where a contact holds more than `layers` points, leaves out the one whose triangle with its neighbours is smallest.
template <class Real>
HWY_INLINE void forget_one(SpringsOf<Real>& line) {
  Real least = line.count, smallest(std::numeric_limits<double>::infinity());
  LayerOf<Real> a = line.at[0], at = line.at[1];
  Real left = at.depth() - a.depth();
  for (int i = 1; i < line.most; ++i) {
    const LayerOf<Real> b = line.at[i + 1];
    const Real right = b.depth() - at.depth(), stretch = left + right;
    const Real bend_x = at.x * stretch - a.x * right - b.x * left;
    const Real bend_y = at.y * stretch - a.y * right - b.y * left;
    const Real area = abs(bend_x) + abs(bend_y);
    const MaskType<Real> better = (Real(double(i)) < line.count) & (area < smallest);
    smallest = select(better, area, smallest);
    least = select(better, Real(double(i)), least);
    a = at, at = b, left = right;
  }
  const MaskType<Real> over = line.count > Real(double(mindlin::layers));
  least = select(over, least, line.count);
  for (int i = 1; i < line.most; ++i) line.at[i] = select(Real(double(i)) >= least, line.at[i + 1], line.at[i]);
  line.count = min(line.count, max(line.count - Real(1.0), Real(double(mindlin::layers))));
  --line.most;
}

/// Leaves out points until no contact holds more than `layers`, and returns the sums over what is left. That must not
/// create energy: what a component has gained by it, it loses by shrinking.
template <class Real>
HWY_INLINE SumsOf<Real> forget(SpringsOf<Real>& line) {
  const Real zero(0.0), one(1.0), half(0.5), least(smallest_normal);
  const MaskType<Real> over = line.count > Real(double(mindlin::layers));
  const bool forgets = line.most > mindlin::layers;
  const PlanarOf<Real> before = forgets ? sums(line).squared : PlanarOf<Real>{zero, zero};
  while (line.most > mindlin::layers) forget_one(line);
  const SumsOf<Real> sum = sums(line);
  if (!forgets) return sum;
  const auto shrink = [&](const Real& was, const Real& is) HWY_ATTR {
    const Real share = max(is - was, zero) * reciprocal(max(is, least));
    return select(over, one - half * share * (one + share), one);  // ≤ √(1 − share)
  };
  const Real x = shrink(before.x, sum.squared.x), y = shrink(before.y, sum.squared.y);
  for (int i = 0; i < line.most; ++i) line.at[i].x *= x, line.at[i].y *= y;
  return {{x * sum.traction.x, y * sum.traction.y}, {x * x * sum.squared.x, y * y * sum.squared.y}};
}

HWY_INLINE int largest(double count) {
  return static_cast<int>(count);
}
HWY_INLINE int largest(Batch count) {
  return static_cast<int>(hn::GetLane(hn::MaxOfLanes(Tag(), count.v)));
}

/// Added to a small whole number, this leaves its binary digits as the last ones of the sum.
inline constexpr double whole_bits = 0x1p52;
HWY_INLINE bool has_digit(double sum, int digit) {
  return (std::bit_cast<std::uint64_t>(sum) & static_cast<std::uint64_t>(digit)) != 0;
}
HWY_INLINE Mask has_digit(Batch sum, int digit) {
  const IntTag di;
  return {hn::RebindMask(Tag(), hn::TestBit(hn::BitCast(di, sum.v), hn::Set(di, digit)))};
}

/// Moves the points up over those that are idle, by one place where the last binary digit of the number of idle points
/// before them says so, then by two where the next one does, and so on.
template <class Real>
HWY_NOINLINE void close_up(SpringsOf<Real>& line, const MaskType<Real>* idle, int places) {
  const Real one(1.0), nowhere(whole_bits);
  const LayerOf<Real> rim = line.rim();
  Real way[SpringsOf<Real>::room], idle_before = nowhere, farthest = nowhere;
  way[0] = nowhere;
  for (int i = 1; i < places; ++i) {
    way[i] = select(idle[i], nowhere, idle_before);
    idle_before = select(idle[i], idle_before + one, idle_before);
    farthest = max(farthest, way[i]);
  }
  for (int step = 1; any(farthest >= Real(whole_bits + double(step))); step *= 2)
    for (int i = 0; i < places; ++i) {
      const MaskType<Real> leaves = has_digit(way[i], step);
      LayerOf<Real> point = select(leaves, rim, line.at[i]);
      Real stays = select(leaves, nowhere, way[i]);
      if (i + step < places) {
        const MaskType<Real> comes = has_digit(way[i + step], step);
        point = select(comes, line.at[i + step], point);
        stays = select(comes, way[i + step], stays);
      }
      line.at[i] = point, way[i] = stays;
    }
}

/// One step, see mindlin::advance; returns the sums after it. @pre overlap > 0
template <class Real>
HWY_INLINE SumsOf<Real> advance(SpringsOf<Real>& line, const Real& overlap, const PlanarOf<Real>& shift,
                                const Real& friction) {
  const Real zero(0.0), one(1.0);
  const int last = line.most;  // the place of the old rim, where a contact has no earlier one
  const Real rim_root = sqrt(overlap);
  const ConeOf<Real> cone{overlap, rim_root, friction};

  // The springs after the shift, before any slides. A contact's places past its old rim are beyond the new one.
  auto& next = line.at;
  for (int i = 0; i < last; ++i) next[i].x += shift.x, next[i].y += shift.y;
  next[last] = {line.rim_root, shift.x, shift.y};
  const auto beyond = [&](int i) HWY_ATTR { return cone.at_rim(next[i]) | (Real(double(i)) > line.count); };
  LayerOf<Real> inner = next[last], outer = next[last];
  int cut = last;  // from here on inwards no contact is beyond its rim
  for (; cut > 0; --cut) {
    const MaskType<Real> out = beyond(cut);
    if (!any(out)) break;
    inner = select(out, next[cut - 1], inner);
    outer = select(out, next[cut], outer);
  }
  const MaskType<Real> grows = rim_root > line.rim_root;
  const Real length = outer.depth() - inner.depth();
  const MaskType<Real> some = length > zero;
  const Real cut_at = (overlap - inner.depth()) / select(some, length, one);
  const LayerOf<Real> end{rim_root, select(grows, zero, fma(cut_at, outer.x - inner.x, inner.x)),
                          select(grows, zero, fma(cut_at, outer.y - inner.y, inner.y))};

  // From the rim inwards: which springs belong to the slide at the rim.
  MaskType<Real> tail[mindlin::layers + 1];
  LayerOf<Real> sticks = next[0], slips = end, further = end;
  MaskType<Real> inside = zero < one;
  int first = last + 1;  // from here on outwards some contact's springs slide
  for (int i = last; i >= 0; --i) {
    LayerOf<Real> point = next[i];
    MaskType<Real> out = cone.slides(point);
    if (i > cut) {
      const MaskType<Real> gone = beyond(i);
      point = select(gone, end, point);
      out = gone | out;
    }
    tail[i] = inside & out;
    const MaskType<Real> front = inside & !out;
    sticks = select(front, point, sticks);
    slips = select(front, further, slips);
    inside = tail[i];
    further = point;
    next[i] = point;
    if (any(out)) next[i] = cone.projected(point);
    if (any(inside)) first = i;
  }
  const MaskType<Real> all_slide = inside;
  const LayerOf<Real> front = cone.crossing(sticks, slips);

  // The front comes in before the springs that slide. In a full memory it takes the old rim's place where no older
  // spring slides: two points would come in at each step and two be forgotten. From the front out every trial
  // deflection lies beyond the cone along the front's direction, so friction does no negative work.
  line.rim_root = rim_root;
  const LayerOf<Real> rim = line.rim();
  int used = last + 2;  // from this place on all is rim
  const MaskType<Real> newest = tail[last] & !tail[last - 1] & (line.count == Real(double(mindlin::layers)));
  next[last + 1] = select(all_slide | newest, rim, select(tail[last], next[last], front));
  for (int i = last; i >= std::max(first, 1); --i)
    next[i] = select(all_slide | !tail[i], next[i], select(tail[i - 1], next[i - 1], front));

  // Where the slide turns, the outer springs turn first: the outermost piece is halved until it is an eighth, while
  // there is room.
  const LayerOf<Real> foot = select(all_slide, further, front);
  const Real sliding = friction * overlap;
  const MaskType<Real> turns = (abs(foot.x * shift.y - foot.y * shift.x) > Real(straight) * sliding * sliding) &
                               (line.count < Real(double(mindlin::layers)));
  if (any(turns)) {
    LayerOf<Real> outermost = next[0];
    Real places(1.0);
    for (int i = 1; i <= last + 1; ++i) {
      const MaskType<Real> is_rim = cone.at_rim(next[i]);
      outermost = select(is_rim, outermost, next[i]);
      places = select(is_rim, places, places + one);
    }
    const MaskType<Real> halve = turns & (all_slide | cone.slides(slips)) & (places < Real(double(mindlin::layers))) &
                                 (overlap - outermost.depth() > Real(0.125) * (overlap - foot.depth()));
    const Real share = (Real(0.5) * (outermost.depth() + overlap) - inner.depth()) / (overlap - inner.depth());
    const LayerOf<Real> middle = cone.projected(between(inner, end, share));
    next[used++] = rim;
    for (int i = 1; i < used; ++i) next[i] = select(halve & (places == Real(double(i))), middle, next[i]);
  }

  // Points on a straight line, or on top of each other, say nothing: the rim takes their places.
  next[used] = rim;
  const Real rounding = Real(straight) * sliding, close = Real(nearest) * overlap;
  MaskType<Real> idle[SpringsOf<Real>::room], gap = zero > one, gaps = gap;
  Real count(1.0);
  LayerOf<Real> previous = next[0], point = next[1];
  Real left = point.depth() - previous.depth();
  for (int i = 1; i < used; ++i) {
    const LayerOf<Real> coming = next[i + 1];
    const Real right = coming.depth() - point.depth(), stretch = left + right;
    const Real bend_x = abs(point.x * stretch - previous.x * right - coming.x * left);
    const Real bend_y = abs(point.y * stretch - previous.y * right - coming.y * left);
    idle[i] = ((max(bend_x, bend_y) <= rounding * stretch) & (right > close)) | (left <= close) |
              (overlap - point.depth() <= close);
    count = select(idle[i], count, count + one);
    gaps = gaps | (gap & !idle[i]);
    // Hardly ever is a point idle but the last ones: predicted so, no point's test waits for that of the one before.
    if (any(idle[i])) {
      gap = gap | idle[i];
      next[i] = select(idle[i], rim, point);
      // The next one is held against those that stay: of two points close together each is idle beside the other.
      previous = select(idle[i], previous, point), left = select(idle[i], left + right, right);
    } else {
      previous = point, left = right;
    }
    point = coming;
  }
  line.count = count;
  line.most = largest(count);
  if (any(gaps)) close_up(line, idle, used);
  return forget(line);
}

/// How deflections turn into the new axes of the ellipse.
template <class Real>
struct TurnOf {
  Real sine, cosine;

  HWY_INLINE LayerOf<Real> operator()(const LayerOf<Real>& layer) const {
    return {layer.root, cosine * layer.x - sine * layer.y, sine * layer.x + cosine * layer.y};
  }
};

/// The old axis is carried along the turn that takes the old normal to the new one by the shortest way, then by the
/// spin, and keeps the springs with it.
template <class Real>
HWY_INLINE TurnOf<Real> carried(const V3<Real>& old_normal, const V3<Real>& old_axis, const V3<Real>& normal,
                                const V3<Real>& major, const V3<Real>& minor, const Real& sin_spin,
                                const Real& cos_spin) {
  const Real share = dot(old_axis, normal) / max(Real(1.0) + dot(old_normal, normal), Real(1e-30));
  const V3<Real> axis = old_axis - share * (old_normal + normal);
  const Real along = dot(axis, major), across = dot(axis, minor);
  const Real c = cos_spin * along - sin_spin * across, s = sin_spin * along + cos_spin * across;
  // Rounding must not add up: one Newton step to unit length.
  const Real unit = Real(1.5) - Real(0.5) * (c * c + s * s);
  return {s * unit, c * unit};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
