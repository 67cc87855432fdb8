#include "osculate/mechanics/mindlin.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"

namespace osculate::mindlin {
namespace {

using std::numbers::pi;

CompleteElliptic integrals(const ContactEllipse& ellipse) {
  return complete_elliptic(ellipse.axis_ratio * ellipse.axis_ratio);
}

/// 2πG a_c times one body's compliance.
Axes reduced_compliance(const ContactEllipse& ellipse, double poissons_ratio) {
  const auto [K, E, B, C, D] = integrals(ellipse);
  return {.major = (1.0 - poissons_ratio) * K + poissons_ratio * D, .minor = K - poissons_ratio * D};
}

/// 1 − (1 − x)^power without cancellation.
double lost(double x, double power) {
  return -std::expm1(power * std::log1p(-x));
}

/// 3/2 C μF_n: the scale of every displacement.
double scale(const Contact& contact) {
  return 1.5 * contact.compliance * contact.limit;
}

/// |F_t|/(μF_n), at most 1.
double load_ratio(const Contact& contact, double force) {
  return std::fmin(std::fabs(force) / contact.limit, 1.0);
}

double two_thirds(double x) {
  return std::pow(std::fmax(x, 0.0), 2.0 / 3.0);
}

double five_thirds(double x) {
  return std::pow(x, 5.0 / 3.0);
}

}  // namespace

Axes body_compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material) {
  validate(material);
  if (!(a_c > 0.0) || !std::isfinite(a_c))
    throw InputError("mindlin::body_compliance", "major semi-axis " + std::to_string(a_c),
                     "a positive, finite value [m]");
  const Axes reduced = reduced_compliance(ellipse, material.poissons_ratio);
  const double unit = 1.0 / (2.0 * pi * material.shear_modulus() * a_c);
  return {.major = unit * reduced.major, .minor = unit * reduced.minor};
}

Axes shape_factor(const ContactEllipse& ellipse, double poissons_ratio) {
  if (!(poissons_ratio > -1.0 && poissons_ratio <= 0.5))
    throw InputError("mindlin::shape_factor", "Poisson's ratio " + std::to_string(poissons_ratio),
                     "a value in (-1, 0.5]");
  const Axes reduced = reduced_compliance(ellipse, poissons_ratio);
  const double unit = 4.0 / (pi * (2.0 - poissons_ratio));
  return {.major = unit * reduced.major, .minor = unit * reduced.minor};
}

Axes compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material_1,
                const ElasticMaterial& material_2) {
  const Axes one = body_compliance(ellipse, a_c, material_1), two = body_compliance(ellipse, a_c, material_2);
  return {.major = one.major + two.major, .minor = one.minor + two.minor};
}

Axes compliance_ratio(const ContactEllipse& ellipse, const ElasticMaterial& material_1,
                      const ElasticMaterial& material_2) {
  const double coupling = shear_coupling(material_1, material_2);
  const auto [K, E, B, C, D] = integrals(ellipse);
  return {.major = 1.0 + coupling * (D / K), .minor = 1.0 + coupling * (B / K)};
}

double shear_coupling(const ElasticMaterial& material_1, const ElasticMaterial& material_2) {
  validate(material_1);
  validate(material_2);
  return 0.5 * effective_modulus(material_1, material_2) *
         (material_1.poissons_ratio / material_1.shear_modulus() +
          material_2.poissons_ratio / material_2.shear_modulus());
}

OffAxis off_axis(const Axes& compliance, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {.along = compliance.major * c * c + compliance.minor * s * s,
          .across = (compliance.minor - compliance.major) * c * s};
}

Contact contact(double compliance, double friction, double normal_force) {
  const auto require = [](const char* name, double value) {
    if (!(value > 0.0) || !std::isfinite(value))
      throw InputError("mindlin::contact", std::string(name) + " " + std::to_string(value), "a positive, finite value");
  };
  require("compliance", compliance);
  require("friction coefficient", friction);
  require("normal force", normal_force);
  return {.compliance = compliance, .limit = friction * normal_force};
}

double displacement(const Contact& contact, double force) {
  return std::copysign(scale(contact) * lost(load_ratio(contact, force), 2.0 / 3.0), force);
}

double force(const Contact& contact, double displacement) {
  const double share = std::fmin(std::fabs(displacement) / scale(contact), 1.0);
  return std::copysign(contact.limit * lost(share, 1.5), displacement);
}

double stiffness(const Contact& contact, double force) {
  return stick_ratio(contact, force) / contact.compliance;
}

double sliding_displacement(const Contact& contact) {
  return scale(contact);
}

double stick_ratio(const Contact& contact, double force) {
  return std::cbrt(1.0 - load_ratio(contact, force));
}

double unloading_displacement(const Contact& contact, double force, double peak) {
  const double since = (peak - force) / (2.0 * contact.limit);
  return scale(contact) * (lost(load_ratio(contact, peak), 2.0 / 3.0) - 2.0 * lost(since, 2.0 / 3.0));
}

double reloading_displacement(const Contact& contact, double force, double peak) {
  return -unloading_displacement(contact, -force, peak);
}

double unloading_stiffness(const Contact& contact, double force, double peak) {
  return std::cbrt(1.0 - (peak - force) / (2.0 * contact.limit)) / contact.compliance;
}

double cycle_energy(const Contact& contact, double peak) {
  const double t = lost(load_ratio(contact, peak), 1.0 / 3.0), q = 1.0 - t;
  return 1.2 * contact.compliance * contact.limit * contact.limit * t * t * t * (1.0 + 3.0 * q + q * q);
}

double small_cycle_energy(const Contact& contact, double peak) {
  return 2.0 / 9.0 * contact.compliance * peak * peak * std::fabs(peak) / contact.limit;
}

Contact Oblique::at(double force) const {
  const double growth = 1.0 + coupling * force / initial.limit;
  return {.compliance = initial.compliance / std::cbrt(growth), .limit = initial.limit * growth};
}

Oblique oblique(const Contact& initial, double coupling) {
  if (!(coupling >= 0.0) || !std::isfinite(coupling))
    throw InputError("mindlin::oblique", "coupling mu dF_n/dF_t = " + std::to_string(coupling), "a finite value >= 0");
  return {.initial = initial, .coupling = coupling};
}

double oblique_loading_compliance(const Oblique& oblique, double force) {
  const double theta = oblique.coupling;
  const Contact now = oblique.at(force);
  if (theta >= 1.0) return now.compliance;
  return now.compliance * (theta + (1.0 - theta) / stick_ratio(now, force));
}

double oblique_unloading_compliance(const Oblique& oblique, double force, double peak) {
  const double theta = oblique.coupling;
  const Contact now = oblique.at(force);
  if (theta >= 1.0) return now.compliance;
  const double moved_peak = peak - theta * (peak - force);
  return now.compliance * (-theta + (1.0 + theta) / std::cbrt(1.0 - (moved_peak - force) / (2.0 * now.limit)));
}

double oblique_displacement(const Oblique& oblique, double force) {
  const double theta = oblique.coupling, lambda = force / oblique.initial.limit;
  const double growth = std::expm1(2.0 / 3.0 * std::log1p(theta * lambda));
  if (theta > 1.0) return scale(oblique.initial) * growth / theta;
  return scale(oblique.initial) * (growth + lost(std::fmin((1.0 - theta) * lambda, 1.0), 2.0 / 3.0));
}

double oblique_unloading_displacement(const Oblique& oblique, double force, double peak) {
  const double theta = oblique.coupling;
  if (theta >= 1.0) return oblique_displacement(oblique, force);
  const double now = force / oblique.initial.limit, top = peak / oblique.initial.limit;
  const double normal = 1.0 + theta * now;
  if (now < -top * (1.0 - theta) / (1.0 + theta))
    return -scale(oblique.initial) * two_thirds(normal) * (1.0 - two_thirds(1.0 + now / normal));
  const double stuck = 1.0 - 0.5 * (top - now - theta * (top + now));
  return scale(oblique.initial) * (2.0 * two_thirds(stuck) - two_thirds(1.0 + theta * top - top) - two_thirds(normal));
}

double oblique_reloading_displacement(const Oblique& oblique, double force, double peak) {
  const double theta = oblique.coupling;
  if (theta >= 1.0) return oblique_displacement(oblique, force);
  const double now = force / oblique.initial.limit, top = peak / oblique.initial.limit;
  const double stuck = 1.0 + 0.5 * (theta * (now - top) - (now + top));
  return scale(oblique.initial) *
         (two_thirds(1.0 + theta * now) + two_thirds(1.0 - theta * top - top) - 2.0 * two_thirds(stuck));
}

double oblique_cycle_energy(const Oblique& oblique, double peak) {
  const double theta = oblique.coupling;
  if (theta >= 1.0) return 0.0;
  if (theta == 0.0) return cycle_energy(oblique.initial, peak);
  const double top = load_ratio(oblique.initial, peak);
  const double high = five_thirds(1.0 + theta * top), low = five_thirds(1.0 - theta * top);
  const double stuck = five_thirds(1.0 - top);
  return scale(oblique.initial) * oblique.initial.limit *
         (2.4 * ((high - stuck) / (1.0 + theta) + (low - stuck) / (1.0 - theta)) - 1.2 * (high - low) / theta -
          4.0 * top * two_thirds(1.0 - top));
}

}  // namespace osculate::mindlin
