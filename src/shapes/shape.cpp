#include "osculate/shapes/shape.hpp"

#include <limits>
#include <string>
#include <type_traits>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

std::string_view kind_of(const Superquadric&) {
  return "superquadric";
}
std::string_view kind_of(const Ellipsoid&) {
  return "ellipsoid";
}
std::string_view kind_of(const Sphere&) {
  return "sphere";
}
std::string_view kind_of(const PotentialParticle&) {
  return "potential particle";
}
std::string_view kind_of(const HalfSpace&) {
  return "half-space";
}
std::string_view kind_of(const Cylinder&) {
  return "cylinder";
}
std::string_view kind_of(const SphereContainer&) {
  return "sphere container";
}

template <class S>
constexpr bool is_wall = requires(const S& shape, const Vec3& x) {
  signed_distance(shape, x);
};

/// Puts a question to the particle in `shape`, ellipsoids and spheres answering as superquadrics.
template <class Question>
auto ask_particle(const Shape& shape, std::string_view what, const Question& question) {
  using Answer = std::invoke_result_t<const Question&, const Superquadric&>;
  return std::visit(
      [&](const auto& s) -> Answer {
        using S = std::decay_t<decltype(s)>;
        if constexpr (is_wall<S>) {
          throw InputError(std::string(what), "a wall (" + std::string(kind_of(s)) + ")", "a particle");
        } else if constexpr (requires { as_superquadric(s); }) {
          return question(as_superquadric(s));
        } else {
          return question(s);
        }
      },
      shape);
}

}  // namespace

std::string_view kind(const Shape& shape) {
  return std::visit([](const auto& s) { return kind_of(s); }, shape);
}

bool is_particle(const Shape& shape) {
  return std::visit([](const auto& s) { return !is_wall<std::decay_t<decltype(s)>>; }, shape);
}

void validate(const Shape& shape) {
  std::visit([](const auto& s) { validate(s); }, shape);
}

Gauge gauge(const Shape& shape, const Vec3& x_b) {
  return ask_particle(shape, "gauge", [&](const auto& s) { return gauge(s, x_b); });
}

Vec3 support_point(const Shape& shape, const Vec3& u_b) {
  return ask_particle(shape, "support point", [&](const auto& s) { return support_point(s, u_b); });
}

double bounding_radius(const Shape& shape) {
  if (!is_particle(shape)) return std::numeric_limits<double>::infinity();
  return ask_particle(shape, "bounding radius", [](const auto& s) { return bounding_radius(s); });
}

OrientedBox oriented_box(const Shape& shape) {
  return ask_particle(shape, "oriented box", [](const auto& s) { return oriented_box(s); });
}

MassProperties mass_properties(const Shape& shape) {
  return ask_particle(shape, "mass properties", [](const auto& s) { return mass_properties(s); });
}

}  // namespace osculate
