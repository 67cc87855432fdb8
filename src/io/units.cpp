#include "io/units.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace osculate::io {

std::optional<double> Dimension::in_si(std::string_view symbol) const {
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) { return unit.symbol == symbol; });
  if (found == units.end()) return std::nullopt;
  return found->in_si;
}

std::string Dimension::symbols() const {
  std::string text;
  for (const Unit& unit : units) {
    if (!text.empty()) text += ", ";
    text += unit.symbol;
  }
  return text;
}

const Dimension& length() {
  static const Dimension dimension{
      "length", {{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"µm", 1e-6}, {"nm", 1e-9}, {"in", 0.0254}}};
  return dimension;
}

const Dimension& pressure() {
  static const Dimension dimension{"pressure", {{"Pa", 1.0}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}}};
  return dimension;
}

const Dimension& density() {
  static const Dimension dimension{"density", {{"kg/m3", 1.0}, {"kg/m³", 1.0}, {"g/cm3", 1e3}, {"g/cm³", 1e3}}};
  return dimension;
}

const Dimension& velocity() {
  static const Dimension dimension{"velocity", {{"m/s", 1.0}, {"cm/s", 1e-2}, {"mm/s", 1e-3}}};
  return dimension;
}

const Dimension& angular_velocity() {
  static const Dimension dimension{
      "angular velocity", {{"rad/s", 1.0}, {"deg/s", std::numbers::pi / 180.0}, {"rpm", std::numbers::pi / 30.0}}};
  return dimension;
}

const Dimension& angle() {
  static const Dimension dimension{"angle",
                                   {{"rad", 1.0}, {"deg", std::numbers::pi / 180.0}, {"°", std::numbers::pi / 180.0}}};
  return dimension;
}

const Dimension& acceleration() {
  static const Dimension dimension{"acceleration", {{"m/s2", 1.0}, {"m/s²", 1.0}, {"m/s^2", 1.0}}};
  return dimension;
}

const Dimension& frequency() {
  static const Dimension dimension{"frequency", {{"Hz", 1.0}, {"kHz", 1e3}, {"rpm", 1.0 / 60.0}}};
  return dimension;
}

const Dimension& force() {
  static const Dimension dimension{"force", {{"N", 1.0}, {"kN", 1e3}, {"mN", 1e-3}, {"uN", 1e-6}, {"µN", 1e-6}}};
  return dimension;
}

const Dimension& shear_rate() {
  static const Dimension dimension{"shear rate", {{"1/s", 1.0}, {"s^-1", 1.0}}};
  return dimension;
}

const Dimension& mass_rate() {
  static const Dimension dimension{"mass rate",
                                   {{"kg/s", 1.0}, {"g/s", 1e-3}, {"kg/min", 1.0 / 60.0}, {"t/h", 1.0 / 3.6}}};
  return dimension;
}

const Dimension& duration() {
  static const Dimension dimension{"duration", {{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"µs", 1e-6}, {"ns", 1e-9}}};
  return dimension;
}

const Dimension& surface_energy() {
  static const Dimension dimension{
      "surface energy",
      {{"J/m2", 1.0}, {"J/m²", 1.0}, {"J/m^2", 1.0}, {"mJ/m2", 1e-3}, {"mJ/m²", 1e-3}, {"mJ/m^2", 1e-3}}};
  return dimension;
}

Unit suitable_length(double metres) {
  constexpr std::array<Unit, 4> units{{{"m", 1.0}, {"mm", 1e-3}, {"µm", 1e-6}, {"nm", 1e-9}}};
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return metres >= 0.5 * u.in_si; });
  return found == units.end() ? units.back() : *found;
}

}  // namespace osculate::io
