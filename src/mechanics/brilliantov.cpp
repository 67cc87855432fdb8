#include "osculate/mechanics/brilliantov.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate::brilliantov {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr const char* place = "brilliantov";

void require(bool good, const char* what, double value, const char* expected) {
  if (!good || !std::isfinite(value))
    throw InputError(place, std::string(what) + " " + std::to_string(value), expected);
}

}  // namespace

void validate(const Viscosity& viscosity) {
  require(viscosity.shear >= 0.0, "shear viscosity", viscosity.shear, "a finite value >= 0 [Pa s]");
  require(viscosity.bulk >= 0.0, "bulk viscosity", viscosity.bulk, "a finite value >= 0 [Pa s]");
  if (viscosity.shear == 0.0 && viscosity.bulk == 0.0)
    throw InputError(place, "two viscosities of zero", "at least one above zero");
}

double dissipative_time(const ElasticMaterial& material, const Viscosity& viscosity) {
  osculate::validate(material);
  validate(viscosity);
  const double nu = material.poissons_ratio, eta_1 = viscosity.shear, eta_2 = viscosity.bulk;
  require(nu != 0.0, "Poisson's ratio", nu, "a value other than 0, where A has no value");
  const double viscous = (3.0 * eta_2 - eta_1) * (3.0 * eta_2 - eta_1) / (3.0 * eta_2 + 2.0 * eta_1);
  return viscous / 3.0 * (1.0 - nu * nu) * (1.0 - 2.0 * nu) / (material.youngs_modulus * nu * nu);
}

void validate_time(double dissipative_time) {
  require(dissipative_time >= 0.0, "dissipative time", dissipative_time, "a finite value >= 0 [s]");
}

double dissipative_force(double dissipative_time, double stiffness, double rate) {
  return dissipative_time * stiffness * rate;
}

double dissipative_force(double dissipative_time, const johnson_greenwood::State& state, double rate) {
  return dissipative_force(dissipative_time, std::max(state.stiffness, 0.0), rate);
}

double dissipative_force_circular(double dissipative_time, double radius, double modulus, double work_of_adhesion,
                                  double a_c, double radius_rate) {
  const double D = 0.75 / modulus;
  return dissipative_time * radius_rate *
         (3.0 * a_c * a_c / (D * radius) - 1.5 * std::sqrt(6.0 * pi * work_of_adhesion / D * a_c));
}

double total_force(double elastic, double dissipative, Attraction attraction) {
  const double sum = elastic + dissipative;
  return attraction == Attraction::cut_off ? std::max(sum, 0.0) : sum;
}

double tangential_dissipative_force(double shear_viscosity, double shear_modulus, double no_slip_stiffness, double slip,
                                    double rate) {
  return shear_viscosity / shear_modulus * no_slip_stiffness * rate * std::sqrt(std::max(0.0, 1.0 - slip));
}

double restitution(double dissipative_time, double force_constant, double reduced_mass, double speed) {
  validate_time(dissipative_time);
  require(force_constant > 0.0, "force constant", force_constant, "a positive, finite value [N/m^(3/2)]");
  require(reduced_mass > 0.0, "reduced mass", reduced_mass, "a positive, finite value [kg]");
  require(speed >= 0.0, "speed", speed, "a finite value >= 0 [m/s]");
  const double C_1 = std::sqrt(pi) * std::tgamma(0.6) / (std::pow(2.0, 0.2) * std::pow(5.0, 0.4) * std::tgamma(2.1));
  const double loss =
      C_1 * 1.5 * dissipative_time * std::pow(force_constant / reduced_mass, 0.4) * std::pow(speed, 0.2);
  return 1.0 - loss + 0.6 * loss * loss;
}

}  // namespace osculate::brilliantov
