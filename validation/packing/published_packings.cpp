#include "validation/packing/published_packings.hpp"

#include <cmath>

#include "osculate/core/error.hpp"

namespace osculate::validation {

std::vector<PublishedPacking> published_packings() {
  const auto superball = [](double n) { return Superquadric{.half_axes = Vec3::Ones(), .exponents = {n, n}}; };
  return {
      {"sphere", Sphere{1.0}, {0.63, 0.65}, {5.9, 6.5}, "0.64, Z ≈ 6 [DCSV04]"},
      {"M&M spheroid, 1.93 : 1.93 : 1",
       Ellipsoid{{6.70, 6.70, 3.465}},
       {0.68, 0.71},
       {9.5, 10.5},
       "0.68 to 0.71, Z ≈ 10 [DCSV04]"},
      {"ellipsoid, 1.25 : 1 : 0.8",
       Ellipsoid{{1.25, 1.0, 0.8}},
       {0.73, 0.75},
       {6.0, 12.0},
       "0.74 [DCSV04, MDS05], Z < 12 [YVSO19]"},
      {"superball n = 3", superball(3.0), {0.65, 0.82}, {6.0, 12.0}, "above spheres, Z < 12 [JST10], below n = 5"},
      {"superball n = 5",
       superball(5.0),
       {0.65, 0.82},
       {6.0, 12.0},
       "above spheres, Z < 12 [JST10], at most 0.82 [DC10]"},
  };
}

Mean mean_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  if (values.size() < 2) throw InputError("a mean", std::to_string(values.size()), "two values at least");
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {.value = mean, .error = std::sqrt(squares / (count - 1.0) / count)};
}

bool PackingRow::agrees() const {
  constexpr double errors = 2.0;
  return published.fraction.holds(fraction.value, errors * fraction.error) &&
         published.coordination.holds(coordination.value, errors * coordination.error);
}

std::vector<PackingRow> packing_rows(const std::vector<PublishedPacking>& published, std::uint64_t particles, int seeds,
                                     int threads, const Done& done) {
  std::vector<PackingRow> rows;
  for (const PublishedPacking& one : published)
    rows.push_back({.published = one,
                    .packings = std::vector<JammedPacking>(static_cast<std::size_t>(seeds)),
                    .fraction = {},
                    .coordination = {},
                    .rattlers = {}});
  std::vector<Case> cases;
  for (PackingRow& row : rows)
    for (std::uint64_t seed = 1; seed <= row.packings.size(); ++seed)
      cases.push_back([&row, particles, seed](const Done& part) {
        row.packings[seed - 1] = jam({.shape = row.published.shape, .particles = particles, .seed = seed}, part);
      });
  run_independent(cases, threads, done);
  const auto mean = [](const PackingRow& row, double JammedPacking::*quantity) {
    std::vector<double> values;
    for (const JammedPacking& packing : row.packings) values.push_back(packing.*quantity);
    return mean_of(values);
  };
  for (PackingRow& row : rows) {
    row.fraction = mean(row, &JammedPacking::fraction);
    row.coordination = mean(row, &JammedPacking::coordination);
    row.rattlers = mean(row, &JammedPacking::rattlers);
  }
  return rows;
}

}  // namespace osculate::validation
