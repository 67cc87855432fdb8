#include <cmath>
#include <random>
#include <vector>

#include "app/narrow_bench.hpp"
#include "osculate/mechanics/hertz.hpp"

namespace osculate::app {

Timing time_hertz(const NarrowSettings& settings) {
  constexpr double modulus = 37e9;
  constexpr double largest_log_ratio = 4.6;  // R_i/R_j up to 100
  std::mt19937_64 random(settings.seed);
  std::uniform_real_distribution<double> log_ratio(0.0, largest_log_ratio);
  std::uniform_real_distribution<double> radius(0.1, 1.0);
  const std::size_t count = settings.pairs;
  std::vector<double> R_i(count), R_j(count), smallest(count), moduli(count, modulus),
      overlaps(count, settings.overlap);
  for (std::size_t i = 0; i < count; ++i) {
    R_j[i] = radius(random);
    R_i[i] = R_j[i] * std::exp(log_ratio(random));
    smallest[i] = R_j[i];
  }
  std::vector<double> force(count), a_c(count), b_c(count), pressure(count), stiffness(count), energy(count);
  std::vector<hertz::Validity> validity(count);
  const hertz::BatchInput input{
      .R_i = R_i, .R_j = R_j, .smallest_radius = smallest, .modulus = moduli, .overlap = overlaps};
  const hertz::BatchOutput output{.force = force,
                                  .a_c = a_c,
                                  .b_c = b_c,
                                  .peak_pressure = pressure,
                                  .stiffness = stiffness,
                                  .strain_energy = energy,
                                  .validity = validity};
  return time_of(
      count, settings.repetitions, [] {}, [&] { hertz::contacts(input, output); });
}

}  // namespace osculate::app
