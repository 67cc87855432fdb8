// Scalar or batch: one formula, two number types.
// A kernel is a template over Real, which is `double` or `Batch` (one SIMD vector of doubles). This header gives both
// the same vocabulary: arithmetic, comparison, select, min, max, sqrt, reciprocal, log, exp, sin, cos, any, all.
// Highway includes it once per instruction set (foreach_target), hence the toggled guard; each inclusion lands in a
// namespace of its own.
#if defined(OSCULATE_CORE_BATCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_CORE_BATCH_INL
#undef OSCULATE_CORE_BATCH_INL
#else
#define OSCULATE_CORE_BATCH_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
using IntTag = hn::RebindToSigned<Tag>;

struct Mask {
  hn::Mask<Tag> m;
};

struct Batch {
  hn::Vec<Tag> v;

  Batch() = default;
  HWY_INLINE Batch(double x) : v(hn::Set(Tag(), x)) {}  // NOLINT: constants in formulas convert by design
  HWY_INLINE explicit Batch(hn::Vec<Tag> x) : v(x) {}
};

/// How many contacts one Real holds.
template <class Real>
constexpr std::size_t lanes() {
  return 1;
}
template <>
constexpr std::size_t lanes<Batch>() {
  return hn::MaxLanes(Tag());
}

template <class Real>
struct MaskOf {
  using type = bool;
};
template <>
struct MaskOf<Batch> {
  using type = Mask;
};
template <class Real>
using MaskType = typename MaskOf<Real>::type;

HWY_INLINE Batch operator+(Batch a, Batch b) {
  return Batch(hn::Add(a.v, b.v));
}
HWY_INLINE Batch operator-(Batch a, Batch b) {
  return Batch(hn::Sub(a.v, b.v));
}
HWY_INLINE Batch operator*(Batch a, Batch b) {
  return Batch(hn::Mul(a.v, b.v));
}
HWY_INLINE Batch operator/(Batch a, Batch b) {
  return Batch(hn::Div(a.v, b.v));
}
HWY_INLINE Batch operator-(Batch a) {
  return Batch(hn::Neg(a.v));
}
HWY_INLINE Batch& operator+=(Batch& a, Batch b) {
  return a = a + b;
}
HWY_INLINE Batch& operator-=(Batch& a, Batch b) {
  return a = a - b;
}
HWY_INLINE Batch& operator*=(Batch& a, Batch b) {
  return a = a * b;
}
HWY_INLINE Mask operator<(Batch a, Batch b) {
  return {hn::Lt(a.v, b.v)};
}
HWY_INLINE Mask operator<=(Batch a, Batch b) {
  return {hn::Le(a.v, b.v)};
}
HWY_INLINE Mask operator>(Batch a, Batch b) {
  return {hn::Gt(a.v, b.v)};
}
HWY_INLINE Mask operator>=(Batch a, Batch b) {
  return {hn::Ge(a.v, b.v)};
}
HWY_INLINE Mask operator==(Batch a, Batch b) {
  return {hn::Eq(a.v, b.v)};
}
HWY_INLINE Mask operator&(Mask a, Mask b) {
  return {hn::And(a.m, b.m)};
}
HWY_INLINE Mask operator|(Mask a, Mask b) {
  return {hn::Or(a.m, b.m)};
}
HWY_INLINE Mask operator!(Mask a) {
  return {hn::Not(a.m)};
}

HWY_INLINE Batch select(Mask condition, Batch yes, Batch no) {
  return Batch(hn::IfThenElse(condition.m, yes.v, no.v));
}
HWY_INLINE Mask select(Mask condition, Mask yes, Mask no) {
  return {hn::Or(hn::And(condition.m, yes.m), hn::AndNot(condition.m, no.m))};
}
constexpr std::size_t lanes_of(Mask) {
  return lanes<Batch>();
}
HWY_INLINE bool any(Mask a) {
  return !hn::AllFalse(Tag(), a.m);
}
HWY_INLINE bool all(Mask a) {
  return hn::AllTrue(Tag(), a.m);
}
HWY_INLINE Batch abs(Batch a) {
  return Batch(hn::Abs(a.v));
}
HWY_INLINE Batch sqrt(Batch a) {
  return Batch(hn::Sqrt(a.v));
}
#if HWY_TARGET <= HWY_AVX3
// The masked intrinsics, because g++ 12 warns of its own unmasked ones.
/// 1/a within 2 units in the last place, for normal a: a division takes four times as long. NaN for 0 and ∞.
HWY_INLINE Batch reciprocal(Batch a) {
  Batch x(hn::Vec<Tag>{_mm512_maskz_rcp14_pd(0xFF, a.v.raw)});
  const Batch one(1.0);
  for (int i = 0; i < 2; ++i) x = Batch(hn::MulAdd(x.v, hn::NegMulAdd(a.v, x.v, one.v), x.v));
  return x;
}
/// 1/√a, likewise.
HWY_INLINE Batch inverse_sqrt(Batch a) {
  Batch x(hn::Vec<Tag>{_mm512_maskz_rsqrt14_pd(0xFF, a.v.raw)});
  const Batch one(1.0), half(0.5);
  for (int i = 0; i < 2; ++i) {
    const Batch h = half * x, excess = Batch(hn::NegMulAdd((a * x).v, x.v, one.v));
    x = Batch(hn::MulAdd(h.v, excess.v, x.v));
  }
  return x;
}
#else
HWY_INLINE Batch reciprocal(Batch a) {
  return Batch(1.0) / a;
}
HWY_INLINE Batch inverse_sqrt(Batch a) {
  return Batch(1.0) / sqrt(a);
}
#endif
HWY_INLINE Batch min(Batch a, Batch b) {
  return Batch(hn::Min(a.v, b.v));
}
HWY_INLINE Batch max(Batch a, Batch b) {
  return Batch(hn::Max(a.v, b.v));
}
HWY_INLINE Batch log(Batch a) {
  return Batch(hn::Log(Tag(), a.v));
}
HWY_INLINE Batch exp(Batch a) {
  return Batch(hn::Exp(Tag(), a.v));
}
HWY_INLINE Batch sin(Batch a) {
  return Batch(hn::Sin(Tag(), a.v));
}
HWY_INLINE Batch cos(Batch a) {
  return Batch(hn::Cos(Tag(), a.v));
}
HWY_INLINE Batch floor(Batch a) {
  return Batch(hn::Floor(a.v));
}
HWY_INLINE Batch copysign(Batch magnitude, Batch sign) {
  return Batch(hn::CopySign(magnitude.v, sign.v));
}
/// Whether a whole number from 0 to 2^52 − 1 has a bit, given as its power of two.
HWY_INLINE Mask has_bit(Batch whole, std::int64_t bit) {
  const IntTag di;
  const auto bits = hn::BitCast(di, (whole + Batch(0x1p52)).v);  // its lowest bits are the number
  return {hn::RebindMask(Tag(), hn::TestBit(bits, hn::Set(di, bit)))};
}
/// a·b + c, rounded once where the processor can.
HWY_INLINE Batch fma(Batch a, Batch b, Batch c) {
  return Batch(hn::MulAdd(a.v, b.v, c.v));
}

/// Σ c[n] x^n as four polynomials in x⁴ side by side: a chain a quarter as long as Horner's.
template <std::size_t N>
HWY_INLINE Batch polynomial(const std::array<double, N>& c, Batch x) {
  static_assert(N > 4);
  const Batch x2 = x * x, x4 = x2 * x2;
  Batch part[4];
  for (std::size_t n = N; n-- > 0;) part[n % 4] = n + 4 < N ? fma(part[n % 4], x4, Batch(c[n])) : Batch(c[n]);
  return fma(fma(part[3], x, part[2]), x2, fma(part[1], x, part[0]));
}

/// artanh s = s Σ s^2n/(2n + 1)
constexpr std::array<double, 11> artanh_series = [] {
  std::array<double, 11> c{};
  for (std::size_t n = 0; n < c.size(); ++n) c[n] = 1.0 / static_cast<double>(2 * n + 1);
  return c;
}();
/// e^x = Σ x^n/n!
constexpr std::array<double, 14> exponential_series = [] {
  std::array<double, 14> c{1.0};
  for (std::size_t n = 1; n < c.size(); ++n) c[n] = c[n - 1] / static_cast<double>(n);
  return c;
}();

/// t^p for normal t > 0, held between 2^−1022 and 2^1023; within (4 + |p log2 t|) units in the last place.
HWY_INLINE Batch power(Batch t, Batch p) {
  constexpr double ln2 = 0.693147180559945309417, log2_e = 1.44269504088896340736;
  const Tag d;
  const IntTag di;
  // t = m 2^k with m between √½ and √2: log m = 2 artanh s with |s| < 0.172.
  const auto bits = hn::BitCast(di, t.v);
  const auto k = hn::ShiftRight<52>(hn::Sub(bits, hn::Set(di, 0x3FE6A09E667F3BCD)));
  const Batch m(hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<52>(k))));
  const Batch s = (m - Batch(1.0)) * reciprocal(m + Batch(1.0));
  // A whole number is the low bits of its sum with this.
  const Batch whole_bits(0x1.8p52);
  const Batch exponent = Batch(hn::BitCast(d, hn::Add(k, hn::BitCast(di, whole_bits.v)))) - whole_bits;
  const Batch log2_t = fma(Batch(2.0 * log2_e) * s, polynomial(artanh_series, s * s), exponent);
  // 2^y = 2^whole e^x with |x| < 0.35. The product is the second argument, so that NaN stays.
  const Batch y(hn::Min(hn::Set(d, 1023.0), hn::Max(hn::Set(d, -1022.0), (p * log2_t).v)));
  const Batch shifted = y + whole_bits, x = Batch(ln2) * (y - (shifted - whole_bits));
  const auto scale = hn::ShiftLeft<52>(hn::Add(hn::BitCast(di, shifted.v), hn::Set(di, 1023)));
  return polynomial(exponential_series, x) * Batch(hn::BitCast(d, scale));
}

HWY_INLINE double select(bool condition, double yes, double no) {
  return condition ? yes : no;
}
/// The truth of each lane as a bit, lane 0 the lowest.
HWY_INLINE std::uint64_t bits(Mask a) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), a.m, bytes);
  std::uint64_t result = 0;
  for (int i = 7; i >= 0; --i) result = result << 8 | bytes[i];
  return result;
}
HWY_INLINE std::uint64_t bits(bool a) {
  return a ? 1 : 0;
}
HWY_INLINE bool select(bool condition, bool yes, bool no) {
  return condition ? yes : no;
}
constexpr std::size_t lanes_of(bool) {
  return 1;
}
HWY_INLINE bool any(bool a) {
  return a;
}
HWY_INLINE bool all(bool a) {
  return a;
}
HWY_INLINE double abs(double a) {
  return std::fabs(a);
}
HWY_INLINE double sqrt(double a) {
  return std::sqrt(a);
}
HWY_INLINE double reciprocal(double a) {
  return 1.0 / a;
}
HWY_INLINE double inverse_sqrt(double a) {
  return 1.0 / std::sqrt(a);
}
HWY_INLINE double min(double a, double b) {
  return b < a ? b : a;
}
HWY_INLINE double max(double a, double b) {
  return a < b ? b : a;
}
HWY_INLINE double power(double t, double p) {
  return std::pow(t, p);
}
HWY_INLINE double log(double a) {
  return std::log(a);
}
HWY_INLINE double exp(double a) {
  return std::exp(a);
}
HWY_INLINE double floor(double a) {
  return std::floor(a);
}
HWY_INLINE double copysign(double magnitude, double sign) {
  return std::copysign(magnitude, sign);
}
HWY_INLINE bool has_bit(double whole, std::int64_t bit) {
  return (static_cast<std::int64_t>(whole) & bit) != 0;
}
HWY_INLINE double fma(double a, double b, double c) {
  return a * b + c;
}

/// `count` ≥ 1 consecutive values from memory; lanes beyond `count` repeat the last one.
template <class Real>
HWY_INLINE Real load(const double* from, std::size_t count);
template <>
HWY_INLINE double load<double>(const double* from, std::size_t) {
  return *from;
}
template <>
HWY_INLINE Batch load<Batch>(const double* from, std::size_t count) {
  if (count >= lanes<Batch>()) return Batch(hn::LoadU(Tag(), from));
  HWY_ALIGN double padded[lanes<Batch>()];
  double last = from[0];
  for (std::size_t i = 0; i < lanes<Batch>(); ++i) padded[i] = last = i < count ? from[i] : last;
  return Batch(hn::Load(Tag(), padded));
}

HWY_INLINE void store(double value, double* to, std::size_t) {
  *to = value;
}
HWY_INLINE void store(Batch value, double* to, std::size_t count) {
  if (count >= lanes<Batch>()) return hn::StoreU(value.v, Tag(), to);
  HWY_ALIGN double padded[lanes<Batch>()];
  hn::Store(value.v, Tag(), padded);
  for (std::size_t i = 0; i < count; ++i) to[i] = padded[i];
}

/// Calls work(start, count) for one batch of rows after another. The count is a constant where all lanes are used.
template <class Work>
HWY_INLINE void for_batches(std::size_t size, const Work& work) {
  constexpr std::size_t width = lanes<Batch>();
  std::size_t start = 0;
  for (; start + width <= size; start += width) work(start, std::integral_constant<std::size_t, width>());
  if (start < size) work(start, size - start);
}

/// Stores the lanes that the mask selects; memory of the others keeps its values. They are read and written back: a
/// masked store takes ten times as long on processors whose vectors have four doubles.
HWY_INLINE void store(double value, bool wanted, double* to) {
  if (wanted) *to = value;
}
HWY_INLINE void store(Batch value, Mask wanted, double* to) {
  hn::StoreU(hn::IfThenElse(wanted.m, value.v, hn::LoadU(Tag(), to)), Tag(), to);
}

template <class Real>
HWY_INLINE Real square(Real a) {
  return a * a;
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
