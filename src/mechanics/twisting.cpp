#include "osculate/mechanics/twisting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>

#include "mechanics/require.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/twisting.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "mechanics/elliptic_integrals-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// One body's compliance times a_c³.
template <class Real>
HWY_INLINE Real torsional_compliance(const EllipticIntegrals<Real>& integrals, const Real& m1, double shear_modulus,
                                     double poissons_ratio) {
  const Real nu(poissons_ratio);
  return Real(1.5 / (std::numbers::pi * shear_modulus)) * (integrals.B * integrals.D - nu * integrals.E * integrals.C) /
         (integrals.E - Real(4.0) * nu * m1 * integrals.C);
}

void twisting_contacts(const ElasticMaterial& material_1, const ElasticMaterial& material_2,
                       const twisting::BatchInput& input, const twisting::BatchOutput& output) {
  const Batch one(1.0);
  const std::size_t size = input.a_c.size();
  const double G_1 = material_1.shear_modulus(), G_2 = material_2.shear_modulus();
  for (std::size_t start = 0; start < size; start += lanes<Batch>()) {
    const std::size_t count = std::min(lanes<Batch>(), size - start);
    const Batch a_c = load<Batch>(&input.a_c[start], count), ratio = load<Batch>(&input.axis_ratio[start], count);
    const Batch q = select(ratio > Batch(0.0), ratio, one), m1 = q * q;
    const auto integrals = elliptic_integrals((one - q) * (one + q), m1, Batch(-2.0) * log(q));
    const Batch compliance = torsional_compliance(integrals, m1, G_1, material_1.poissons_ratio) +
                             torsional_compliance(integrals, m1, G_2, material_2.poissons_ratio);
    store(a_c * a_c * a_c / compliance, &output.stiffness[start], count);
    store(Batch(0.375) * a_c * integrals.E, &output.arm[start], count);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(twisting_contacts);
}  // namespace osculate

namespace osculate::twisting {
namespace {

static_assert(std::is_trivially_copyable_v<Memory>);

void validate_material(const ElasticMaterial& material) {
  validate(material);
  if (!(material.poissons_ratio < 0.5))
    throw InputError("twisting", "Poisson's ratio " + std::to_string(material.poissons_ratio), "a value in (-1, 0.5)");
}

double body_compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material) {
  validate_material(material);
  const double m1 = ellipse.axis_ratio * ellipse.axis_ratio;
  const auto [K, E, B, C, D] = complete_elliptic(m1);
  return HWY_NAMESPACE::torsional_compliance<double>({K, E, B, C, D}, m1, material.shear_modulus(),
                                                     material.poissons_ratio) /
         (a_c * a_c * a_c);
}

void require(const char* name, double value, bool good, const char* expected) {
  if (!good || !std::isfinite(value))
    throw InputError("twisting", std::string(name) + " " + std::to_string(value), expected);
}

}  // namespace

double compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material_1,
                  const ElasticMaterial& material_2) {
  require("major semi-axis", a_c, a_c > 0.0, "a positive, finite value [m]");
  return body_compliance(ellipse, a_c, material_1) + body_compliance(ellipse, a_c, material_2);
}

double limit(const ContactEllipse& ellipse, double a_c, double friction, double normal_force) {
  require("friction coefficient", friction, friction >= 0.0, "a finite value >= 0");
  require("major semi-axis", a_c, a_c >= 0.0, "a finite value >= 0 [m]");
  require("normal force", normal_force, normal_force >= 0.0, "a finite value >= 0 [N]");
  return 0.375 * friction * normal_force * a_c * ellipse.E;
}

Contact contact(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material_1,
                const ElasticMaterial& material_2, double friction, double normal_force) {
  return {.stiffness = 1.0 / compliance(ellipse, a_c, material_1, material_2),
          .limit = limit(ellipse, a_c, friction, normal_force)};
}

void contacts(const ElasticMaterial& material_1, const ElasticMaterial& material_2, const BatchInput& input,
              const BatchOutput& output) {
  validate_material(material_1);
  validate_material(material_2);
  require_columns("twisting::contacts", input.a_c.size(),
                  {input.axis_ratio.size(), output.stiffness.size(), output.arm.size()});
  HWY_DYNAMIC_DISPATCH(twisting_contacts)(material_1, material_2, input, output);
}

double advance(Memory& memory, const Contact& contact, double twist) {
  const double kept = contact.stiffness < memory.stiffness ? contact.stiffness / memory.stiffness : 1.0;
  const double trial = kept * memory.moment + contact.stiffness * twist;
  memory = {.moment = std::clamp(trial, -contact.limit, contact.limit), .stiffness = contact.stiffness};
  return memory.moment;
}

}  // namespace osculate::twisting
#endif
