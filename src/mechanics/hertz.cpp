#include "osculate/mechanics/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "mechanics/require.hpp"
#include "osculate/core/error.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/hertz.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "mechanics/hertz-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

void hertz_contacts(const hertz::BatchInput& input, const hertz::BatchOutput& output) {
  using hertz::Validity;
  const auto code = [](Validity validity) { return Batch(static_cast<double>(validity)); };
  const Batch zero(0.0), one(1.0), infinity(std::numeric_limits<double>::infinity());
  const std::size_t size = input.R_i.size();
  for (std::size_t start = 0; start < size; start += lanes<Batch>()) {
    const std::size_t count = std::min(lanes<Batch>(), size - start);
    const Batch R_i = load<Batch>(&input.R_i[start], count), R_j = load<Batch>(&input.R_j[start], count);
    const Batch modulus = load<Batch>(&input.modulus[start], count);
    const Batch overlap = load<Batch>(&input.overlap[start], count);
    const Batch smallest_radius = load<Batch>(&input.smallest_radius[start], count);
    const Mask good = (R_j > zero) & (R_j < infinity) & (R_i >= R_j) & (modulus > zero) & (modulus < infinity) &
                      (abs(overlap) < infinity) & (smallest_radius > zero);

    const Batch minor = select(good, R_j, one);
    const Batch major = select(good, limited(R_i, R_j), one);
    const auto state = hertz_state(ellipse_of(major, minor), select(good, modulus, zero), select(good, overlap, zero));
    const Batch size_validity =
        select(state.a_c < Batch(0.5) * smallest_radius, code(Validity::valid), code(Validity::large_contact));
    const Batch validity =
        select(good, select(major < R_i, code(Validity::line_contact), size_validity), code(Validity::bad_input));

    store(state.force, &output.force[start], count);
    store(state.a_c, &output.a_c[start], count);
    store(state.b_c, &output.b_c[start], count);
    store(state.peak_pressure, &output.peak_pressure[start], count);
    store(state.stiffness, &output.stiffness[start], count);
    store(state.strain_energy, &output.strain_energy[start], count);
    HWY_ALIGN double codes[lanes<Batch>()];
    store(validity, codes, lanes<Batch>());
    for (std::size_t i = 0; i < count; ++i)
      output.validity[start + i] = static_cast<Validity>(static_cast<int>(codes[i]));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(hertz_contacts);

namespace hertz {
namespace {

HWY_NAMESPACE::HertzState<double> state_of(const ContactEllipse& ellipse, double modulus, double overlap) {
  if (!(modulus > 0.0) || !std::isfinite(modulus))
    throw InputError("hertz", "effective modulus " + std::to_string(modulus), "a positive, finite value [Pa]");
  if (!std::isfinite(overlap)) throw InputError("hertz", "overlap " + std::to_string(overlap), "a finite value [m]");
  return HWY_NAMESPACE::hertz_state<double>({ellipse.R_c, ellipse.axis_ratio, ellipse.e2, ellipse.K, ellipse.E},
                                            modulus, overlap);
}

}  // namespace

std::string_view name(Validity validity) {
  switch (validity) {
    case Validity::valid:
      return "valid";
    case Validity::large_contact:
      return "large contact";
    case Validity::line_contact:
      return "line contact";
    case Validity::bad_input:
      return "bad input";
  }
  return "unknown";
}

double force(const ContactEllipse& ellipse, double modulus, double overlap) {
  return state_of(ellipse, modulus, overlap).force;
}

Contact contact(const ContactEllipse& ellipse, double modulus, double overlap, double smallest_radius) {
  if (!(smallest_radius > 0.0))
    throw InputError("hertz", "smallest radius " + std::to_string(smallest_radius), "a positive value [m]");
  const auto state = state_of(ellipse, modulus, overlap);
  Validity validity = state.a_c < 0.5 * smallest_radius ? Validity::valid : Validity::large_contact;
  if (ellipse.ratio_limited) validity = Validity::line_contact;
  return {.force = state.force,
          .a_c = state.a_c,
          .b_c = state.b_c,
          .peak_pressure = state.peak_pressure,
          .stiffness = state.stiffness,
          .strain_energy = state.strain_energy,
          .validity = validity};
}

void contacts(const BatchInput& input, const BatchOutput& output) {
  const std::size_t size = input.R_i.size();
  require_columns("hertz::contacts", size,
                  {input.R_j.size(), input.smallest_radius.size(), input.modulus.size(), input.overlap.size(),
                   output.force.size(), output.a_c.size(), output.b_c.size(), output.peak_pressure.size(),
                   output.stiffness.size(), output.strain_energy.size(), output.validity.size()});
  HWY_DYNAMIC_DISPATCH(hertz_contacts)(input, output);
}

}  // namespace hertz
}  // namespace osculate
#endif
