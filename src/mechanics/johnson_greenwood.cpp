#include "osculate/mechanics/johnson_greenwood.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "mechanics/quadrature.hpp"
#include "mechanics/require.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/hertz.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/johnson_greenwood.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "mechanics/johnson_greenwood-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

void johnson_greenwood_contacts(const johnson_greenwood::BatchInput& input, std::span<johnson_greenwood::Memory> memory,
                                const johnson_greenwood::BatchOutput& output) {
  using johnson_greenwood::Status;
  const auto code = [](Status status) { return Batch(static_cast<double>(status)); };
  const Batch zero(0.0), one(1.0), largest(1e300);
  const std::size_t size = input.R_i.size();
  for (std::size_t start = 0; start < size; start += lanes<Batch>()) {
    const std::size_t count = std::min(lanes<Batch>(), size - start);
    const Batch R_i = load<Batch>(&input.R_i[start], count), R_j = load<Batch>(&input.R_j[start], count);
    const Batch modulus = load<Batch>(&input.modulus[start], count);
    const Batch work = load<Batch>(&input.work_of_adhesion[start], count);
    const Batch overlap = load<Batch>(&input.overlap[start], count);
    HWY_ALIGN double last_a[lanes<Batch>()], last_g[lanes<Batch>()];
    for (std::size_t i = 0; i < lanes<Batch>(); ++i) {
      const auto& last = memory[start + std::min(i, count - 1)];
      last_a[i] = last.a_c;
      last_g[i] = last.axis_ratio;
    }
    const Batch a_before = load<Batch>(last_a, lanes<Batch>()), g_before = load<Batch>(last_g, lanes<Batch>());

    const Mask good = (R_j > zero) & (R_i >= R_j) & (R_i <= Batch(largest_radius_ratio) * R_j) & (R_i < largest) &
                      (modulus > zero) & (modulus < largest) & (work >= zero) & (work < largest) &
                      (abs(overlap) < largest);
    const Mask was_closed = (a_before > zero) & (a_before < largest) & (g_before > zero) & (g_before <= one);
    const Mask touching = good & select(work > zero, was_closed | (overlap >= zero), overlap > zero);

    const auto pair = adhesive_pair(select(good, R_i, one), select(good, R_j, one), select(good, modulus, one),
                                    select(good, work, zero));
    const Batch depth = select(touching, overlap, one);
    const Batch fresh_a = major_axis_guess(pair, depth);
    const auto from_fresh = [&](Mask wanted) {
      const Batch g = min(max(axis_ratio_guess(pair, fresh_a), pair.hertz.axis_ratio), one);
      return search_curve<OverlapControl>(pair, depth, fresh_a, g, wanted);
    };
    const Batch g_before_on = min(max(g_before, pair.hertz.axis_ratio), one);
    auto search = search_curve<OverlapControl>(pair, depth, a_before, g_before_on, touching & was_closed);
    // New contacts, and those whose memory led nowhere: only a search from the right can tell that one has parted.
    const Mask unsettled = touching & !search.found;
    if (any(unsettled)) search = select(unsettled, from_fresh(unsettled), search);

    const Mask closed = touching & !search.abandoned;
    const Batch a = select(closed, search.a, zero), g = select(closed, search.g, zero);
    store(select(closed, search.force, zero), &output.force[start], count);
    store(select(closed, search.stiffness, zero), &output.stiffness[start], count);
    store(a, &output.a_c[start], count);
    store(a * g, &output.b_c[start], count);
    const Batch status = select(
        good,
        select(closed, select(search.found, code(Status::closed), code(Status::not_converged)), code(Status::apart)),
        code(Status::bad_input));
    HWY_ALIGN double codes[lanes<Batch>()];
    store(status, codes, lanes<Batch>());
    store(g, last_g, lanes<Batch>());
    store(a, last_a, lanes<Batch>());
    for (std::size_t i = 0; i < count; ++i) {
      output.status[start + i] = static_cast<Status>(static_cast<int>(codes[i]));
      memory[start + i] = {.a_c = last_a[i], .axis_ratio = last_g[i]};
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(johnson_greenwood_contacts);

namespace johnson_greenwood {
namespace {
namespace kernel = HWY_NAMESPACE;
using kernel::AdhesivePair;

constexpr double pi = 3.14159265358979323846;
constexpr const char* place = "johnson_greenwood";

std::string text(double value) {
  return std::to_string(value);
}

AdhesivePair<double> prepared(const Pair& pair) {
  validate(pair);
  return kernel::adhesive_pair(pair.R_i, pair.R_j, pair.modulus, pair.work_of_adhesion);
}

/// The g of equilibrium for a given a: the edge condition rises with g from g_Hertz to 1.
double equilibrium_axis_ratio(const AdhesivePair<double>& pair, double a) {
  double low = pair.hertz.axis_ratio, high = 1.0;
  double g = std::clamp(kernel::axis_ratio_guess(pair, a), low, high);
  for (int step = 0; step < 100 && high > low; ++step) {
    const auto edge = kernel::curve_point(pair, a, g).edge;
    (edge.value > 0.0 ? high : low) = g;
    const double newton = g * (1.0 - edge.value / edge.by_x);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    const bool settled = std::abs(newton - g) <= 1e-15 * g;
    g = std::clamp(settled ? newton : next, low, high);
    if (settled) break;
  }
  return g;
}

kernel::CurvePoint<double> equilibrium(const AdhesivePair<double>& pair, double a) {
  return kernel::curve_point(pair, a, equilibrium_axis_ratio(pair, a));
}

State state_of(const AdhesivePair<double>& pair, double a) {
  const double g = equilibrium_axis_ratio(pair, a);
  const auto point = kernel::curve_point(pair, a, g);
  return {.axis_ratio = g,
          .a_c = a,
          .b_c = a * g,
          .force = point.force.value,
          .overlap = point.overlap.value,
          .stiffness = kernel::along_curve(point, point.force) / kernel::along_curve(point, point.overlap)};
}

/// Where a quantity of the curve is least: the sign change of its slope, which is negative at small a.
template <class Control>
double least(const AdhesivePair<double>& pair) {
  if (!(pair.strength > 0.0))
    throw InputError(place, "work of adhesion 0", "W > 0: without adhesion a contact parts at zero force and overlap");
  const auto slope = [&](double a) {
    const auto point = equilibrium(pair, a);
    return kernel::along_curve(point, Control::quantity(point));
  };
  double low = pair.length, high = 2.0 * pair.length;
  while (slope(low) > 0.0) low *= 0.5;
  while (slope(high) < 0.0) high *= 2.0;
  // Regula falsi that halves the weight of an end that stays (Illinois): faster than linear, and never lost.
  double slope_low = slope(low), slope_high = slope(high);
  for (int step = 0; step < 200 && std::abs(high - low) > 4e-16 * high; ++step) {
    const double a = high - slope_high * (high - low) / (slope_high - slope_low);
    const double s = slope(a);
    if (s == 0.0) return a;
    if ((s > 0.0) == (slope_high > 0.0)) {
      slope_low *= 0.5;
    } else {
      low = high;
      slope_low = slope_high;
    }
    if (std::abs(a - high) <= 1e-16 * a) return a;
    high = a;
    slope_high = s;
  }
  return high;
}

template <class Control>
std::optional<State> stable(const AdhesivePair<double>& pair, double target, double a_start) {
  const double g_start = std::clamp(kernel::axis_ratio_guess(pair, a_start), pair.hertz.axis_ratio, 1.0);
  const auto search = kernel::search_curve<Control, double>(pair, target, a_start, g_start, true);
  if (!search.found) return std::nullopt;
  return State{.axis_ratio = search.g,
               .a_c = search.a,
               .b_c = search.a * search.g,
               .force = search.force,
               .overlap = search.overlap,
               .stiffness = search.stiffness};
}

/// An equilibrium without dimensions: the tension that g asks for, in the unit of p_1, and the factors it gives.
struct Shape {
  double p_1, p_2, T, load, depth;
};

kernel::PressureConstants<double> constants_of(double radius_ratio, double axis_ratio) {
  if (!(radius_ratio >= 1.0 && radius_ratio <= largest_radius_ratio))
    throw InputError(place, "radius ratio " + text(radius_ratio), "1 <= R_i/R_j <= 1e12");
  if (!(axis_ratio > 0.0 && axis_ratio <= 1.0)) throw InputError(place, "axis ratio " + text(axis_ratio), "0 < g <= 1");
  return kernel::pressure_constants(kernel::radii_of_contact(radius_ratio, 1.0), axis_ratio);
}

Shape shape_of(double radius_ratio, double axis_ratio) {
  const auto p = constants_of(radius_ratio, axis_ratio);
  if (!(p.difference > 0.0 && axis_ratio < 1.0))
    throw InputError(place, "axis ratio " + text(axis_ratio) + " at radius ratio " + text(radius_ratio),
                     "a value between Hertz's and 1");
  const double T = p.root_g * p.difference * (1.0 + p.root_g) / (1.0 - axis_ratio);
  return {p.p_1, p.p_1 + p.difference, T, kernel::load_factor(p, T), kernel::depth_factor(p, T)};
}

/// a³ in units of length³: T² = strength²/a³ and length³ = 9π²/8 strength².
double cubed_axis(const Shape& shape) {
  return 8.0 / (9.0 * pi * pi * shape.T * shape.T);
}

Shape pressed_shape(double radius_ratio, double axis_ratio) {
  const Shape shape = shape_of(radius_ratio, axis_ratio);
  if (!(shape.depth > 0.0))
    throw InputError(place, "axis ratio " + text(axis_ratio), "one with positive overlap, where gamma and beta exist");
  return shape;
}

CompleteElliptic integrals(double axis_ratio) {
  return complete_elliptic(axis_ratio * axis_ratio);
}

}  // namespace

void validate(const Pair& pair) {
  constexpr double largest = 1e300;
  if (!(pair.R_j > 0.0 && pair.R_i >= pair.R_j && pair.R_i <= largest_radius_ratio * pair.R_j && pair.R_i < largest))
    throw InputError(place, "R_i = " + text(pair.R_i) + ", R_j = " + text(pair.R_j),
                     "0 < R_j <= R_i <= 1e12 R_j, finite [m]");
  if (!(pair.modulus > 0.0 && pair.modulus < largest))
    throw InputError(place, "effective modulus " + text(pair.modulus), "a positive, finite value [Pa]");
  if (!(pair.work_of_adhesion >= 0.0 && pair.work_of_adhesion < largest))
    throw InputError(place, "work of adhesion " + text(pair.work_of_adhesion), "W >= 0, finite [J/m2]");
}

double State::area() const {
  return pi * a_c * b_c;
}

Units units(const Pair& pair) {
  validate(pair);
  const double R = std::sqrt(pair.R_i) * std::sqrt(pair.R_j), W = pair.work_of_adhesion;
  const double length = std::cbrt(2.25 * pi * W / pair.modulus * R * R);
  return {.force = 3.0 * pi * R * W, .length = length, .overlap = length * length / R};
}

double shape_constant_major(double radius_ratio, double axis_ratio) {
  return 2.0 * axis_ratio * constants_of(radius_ratio, axis_ratio).p_1;
}

double shape_constant_minor(double radius_ratio, double axis_ratio) {
  const auto p = constants_of(radius_ratio, axis_ratio);
  return 2.0 * (p.p_1 + p.difference) / axis_ratio;
}

double integral_D(double axis_ratio) {
  return integrals(axis_ratio).D;
}
double integral_B(double axis_ratio) {
  return integrals(axis_ratio).B;
}
double integral_C(double axis_ratio) {
  return integrals(axis_ratio).C;
}

double force_of(double radius_ratio, double axis_ratio) {
  const Shape shape = shape_of(radius_ratio, axis_ratio);
  return 0.5 * pi * axis_ratio * cubed_axis(shape) * shape.load;
}

double overlap_of(double radius_ratio, double axis_ratio) {
  const Shape shape = shape_of(radius_ratio, axis_ratio);
  return axis_ratio * std::pow(cubed_axis(shape), 2.0 / 3.0) * shape.depth;
}

double area_of(double radius_ratio, double axis_ratio) {
  return axis_ratio * std::pow(cubed_axis(shape_of(radius_ratio, axis_ratio)), 2.0 / 3.0);
}

double gamma(double radius_ratio, double axis_ratio) {
  const Shape shape = pressed_shape(radius_ratio, axis_ratio);
  return 0.5 * pi * shape.load / (std::sqrt(axis_ratio) * std::pow(shape.depth, 1.5));
}

double beta(double radius_ratio, double axis_ratio) {
  return 1.0 / pressed_shape(radius_ratio, axis_ratio).depth;
}

State at_major_axis(const Pair& pair, double a_c) {
  const auto ready = prepared(pair);
  if (!(a_c > 0.0) || !std::isfinite(a_c))
    throw InputError(place, "major semi-axis " + text(a_c), "a positive, finite value [m]");
  return state_of(ready, a_c);
}

State pull_off(const Pair& pair) {
  const auto ready = prepared(pair);
  return state_of(ready, least<kernel::ForceControl>(ready));
}

State snap_off(const Pair& pair) {
  const auto ready = prepared(pair);
  return state_of(ready, least<kernel::OverlapControl>(ready));
}

std::optional<State> at_force(const Pair& pair, double force) {
  const auto ready = prepared(pair);
  if (!std::isfinite(force)) throw InputError(place, "force " + text(force), "a finite value [N]");
  if (!(pair.work_of_adhesion > 0.0) && !(force > 0.0)) return std::nullopt;
  // Hertz's overlap under the force puts the start right of the root, as for a prescribed overlap.
  const auto& hertz = ready.hertz;
  const double unit = pi * pair.modulus * std::sqrt(2.0 * hertz.R_c * hertz.E / hertz.K) / (hertz.K * hertz.axis_ratio);
  const double depth = std::pow(1.5 * std::max(force, 0.0) / unit, 2.0 / 3.0);
  return stable<kernel::ForceControl>(ready, force, kernel::major_axis_guess(ready, depth));
}

std::optional<State> at_overlap(const Pair& pair, double overlap) {
  const auto ready = prepared(pair);
  if (!std::isfinite(overlap)) throw InputError(place, "overlap " + text(overlap), "a finite value [m]");
  if (!(pair.work_of_adhesion > 0.0) && !(overlap > 0.0)) return std::nullopt;
  return stable<kernel::OverlapControl>(ready, overlap, kernel::major_axis_guess(ready, overlap));
}

double hysteresis_loss(const Pair& pair) {
  const auto ready = prepared(pair);
  if (!(pair.work_of_adhesion > 0.0)) return 0.0;
  const double torn = least<kernel::OverlapControl>(ready);
  const double formed = stable<kernel::OverlapControl>(ready, 0.0, kernel::major_axis_guess(ready, 0.0)).value().a_c;
  const auto scale = units(pair);
  return -quadrature::integrate(
      [&](double log_a) {
        const auto point = equilibrium(ready, std::exp(log_a));
        return point.force.value * kernel::along_curve(point, point.overlap);
      },
      std::log(torn), std::log(formed), 1e-11 * scale.force * scale.overlap);
}

double tabor_parameter(const Pair& pair, double range) {
  validate(pair);
  if (!(range > 0.0)) throw InputError(place, "range of attraction " + text(range), "a positive length [m]");
  const double R = std::sqrt(pair.R_i) * std::sqrt(pair.R_j), stretch = pair.work_of_adhesion / pair.modulus;
  return std::cbrt(R * stretch * stretch) / range;
}

Regime regime(double tabor_parameter) {
  constexpr double hard_below = 0.1, soft_above = 5.0;
  if (!(tabor_parameter >= 0.0)) throw InputError(place, "Tabor parameter " + text(tabor_parameter), "a value >= 0");
  if (tabor_parameter < hard_below) return Regime::hard;
  return tabor_parameter > soft_above ? Regime::soft : Regime::intermediate;
}

std::string_view name(Regime regime) {
  switch (regime) {
    case Regime::hard:
      return "hard (DMT)";
    case Regime::intermediate:
      return "intermediate";
    case Regime::soft:
      return "soft (JKR)";
  }
  return "unknown";
}

std::optional<State> derjaguin_muller_toporov(const Pair& pair, double overlap) {
  validate(pair);
  if (!(overlap >= 0.0)) return std::nullopt;
  const auto contact = hertz::contact(contact_ellipse(pair.R_i, pair.R_j), pair.modulus, overlap, pair.R_j);
  const double R = std::sqrt(pair.R_i) * std::sqrt(pair.R_j);
  return State{.axis_ratio = contact_ellipse(pair.R_i, pair.R_j).axis_ratio,
               .a_c = contact.a_c,
               .b_c = contact.b_c,
               .force = contact.force - 2.0 * pi * R * pair.work_of_adhesion,
               .overlap = overlap,
               .stiffness = contact.stiffness};
}

std::string_view name(Status status) {
  switch (status) {
    case Status::apart:
      return "apart";
    case Status::closed:
      return "closed";
    case Status::not_converged:
      return "not converged";
    case Status::bad_input:
      return "bad input";
  }
  return "unknown";
}

void contacts(const BatchInput& input, std::span<Memory> memory, const BatchOutput& output) {
  const std::size_t size = input.R_i.size();
  require_columns(
      "johnson_greenwood::contacts", size,
      {input.R_j.size(), input.modulus.size(), input.work_of_adhesion.size(), input.overlap.size(), memory.size(),
       output.force.size(), output.a_c.size(), output.b_c.size(), output.stiffness.size(), output.status.size()});
  HWY_DYNAMIC_DISPATCH(johnson_greenwood_contacts)(input, memory, output);
}

}  // namespace johnson_greenwood
}  // namespace osculate
#endif
