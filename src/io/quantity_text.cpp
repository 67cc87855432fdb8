#include "io/quantity_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace osculate::io {

PrefixedUnit prefixed_unit(double value, std::string_view unit) {
  constexpr std::array<std::string_view, 9> prefixes{"p", "n", "µ", "m", "", "k", "M", "G", "T"};
  constexpr int unprefixed = 4;
  constexpr double step = 1000.0;
  // Six digits are written: what rounds up to 1000 belongs to the next prefix.
  constexpr double rounds_up = 1.0 + 5e-7;
  if (value == 0.0 || !std::isfinite(value)) return {std::string(unit), 1.0};
  const int power = static_cast<int>(std::floor(std::log10(std::fabs(value) * rounds_up) / 3.0));
  const int index = unprefixed + power;
  if (index < 0 || index >= static_cast<int>(prefixes.size())) return {std::string(unit), 1.0};
  return {std::string(prefixes[static_cast<std::size_t>(index)]) + std::string(unit), std::pow(step, power)};
}

std::string quantity_text(double value, std::string_view unit) {
  const PrefixedUnit prefixed = prefixed_unit(value, unit);
  return fmt::format("{:#.6g} {}", value / prefixed.size, prefixed.symbol);
}

std::string vector_text(const Vec3& vector, double scale, int digits) {
  // What rounds to zero is written without a sign.
  const double smallest = 0.5 * std::pow(10.0, -digits);
  const auto number = [&](double value) {
    const double scaled = value / scale;
    return fmt::format("{: .{}f}", std::fabs(scaled) < smallest ? 0.0 : scaled, digits);
  };
  return fmt::format("({}, {}, {})", number(vector.x()), number(vector.y()), number(vector.z()));
}

}  // namespace osculate::io
