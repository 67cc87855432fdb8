// Complete elliptic integrals over Real (double or Batch).
#if defined(OSCULATE_MECHANICS_ELLIPTIC_INTEGRALS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_MECHANICS_ELLIPTIC_INTEGRALS_INL
#undef OSCULATE_MECHANICS_ELLIPTIC_INTEGRALS_INL
#else
#define OSCULATE_MECHANICS_ELLIPTIC_INTEGRALS_INL
#endif

#include "core/batch-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

template <class Real>
struct EllipticIntegrals {
  Real K, E, B, C, D;
};

/// c_0 + c_1 x + … as two polynomials in x² side by side: a chain half as long as Horner's.
template <class Real, std::size_t N>
HWY_INLINE Real polynomial(const double (&c)[N], const Real& x) {
  static_assert(N > 2);
  const Real square_x = x * x;
  Real part[2];
  for (std::size_t n = N; n-- > 0;) part[n % 2] = n + 2 < N ? fma(part[n % 2], square_x, Real(c[n])) : Real(c[n]);
  return fma(part[1], x, part[0]);
}

/// The integrals of parameter m with complement m1 = 1 − m in (0, 1] and −ln m1, all three given because each is exact
/// where another has lost its digits. B and C are fitted as P − ln(m1) Q, P and Q polynomials: the fits' relative
/// errors are 6.1e-17 (B) and 3.7e-17 (C), with the limits at m1 → 0 exact (docs/fits/elliptic.py). K, E and D are
/// sums of positive terms.
template <class Real>
HWY_INLINE EllipticIntegrals<Real> elliptic_integrals(const Real& m, const Real& m1, const Real& minus_log_m1) {
  static constexpr double b_regular[] = {
      1.0,
      0.05685281942585413,
      0.017084393964467193,
      0.008024039480524183,
      0.004262478199054916,
      -0.00378749295417393,
      -0.042977390614411526,
      -0.11298696349824436,
      -0.10689869303802316,
      -0.03218499901843365,
      -0.0019900285491654458,
  };
  static constexpr double b_logarithmic[] = {
      0.0,
      -0.24999999999852335,
      -0.28124999581012705,
      -0.2929674201699272,
      -0.29897174965163226,
      -0.30031263605631847,
      -0.28097707347457457,
      -0.2021280485815485,
      -0.0821024164933421,
      -0.013012474000334085,
      -0.0004251506532227385,
  };
  // (P − P(1))/m: the value at the circle is split off, so that C keeps its digits as m → 0.
  static constexpr double c_regular[] = {
      -0.8100551797294715, -1.4408928671752086,  -2.075014180844979,    -2.7102388375795314,
      -3.344525507856722,  -3.944647598069357,   -4.235398368247628,    -3.468914513924783,
      -1.6338912946331634, -0.31658356742010707, -0.014558451691667921,
  };
  static constexpr double c_logarithmic[] = {
      0.5,
      1.1249999999964104,
      1.7578124892126554,
      2.392574159245536,
      3.0277369641266314,
      3.652073393765868,
      4.141734100076735,
      3.9699694486098887,
      2.584314905343653,
      0.8753440713283013,
      0.11244255565795411,
      0.0029804354460105428,
  };
  static constexpr double c_circle = 0.19634954084936207;  // π/16

  EllipticIntegrals<Real> result;
  result.B = fma(minus_log_m1, polynomial(b_logarithmic, m1), polynomial(b_regular, m1));
  result.C = Real(c_circle) + fma(minus_log_m1, polynomial(c_logarithmic, m1), m * polynomial(c_regular, m1));
  result.D = fma(m, result.C, result.B);
  result.K = result.B + result.D;
  result.E = fma(m1, result.D, result.B);
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
