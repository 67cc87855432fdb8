#include "osculate/dynamics/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "dynamics/pair_chunk.hpp"
#include "dynamics/world.hpp"
#include "osculate/core/error.hpp"
#include "osculate/geometry/curvature.hpp"

namespace osculate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The most of a body that shortens an impact.
struct Extremes {
  double flattest;    ///< the largest geometric mean of the principal radii [m]; ∞ on a flat face
  double compliance;  ///< max |x × n|² along the principal axes, over the unit moments [m^-3]
};

/// Directions to the faces, edges and corners of a cube, and one third of the way between them.
std::vector<Vec3> directions() {
  constexpr int half = 3;
  std::vector<Vec3> found;
  for (int i = -half; i <= half; ++i)
    for (int j = -half; j <= half; ++j)
      for (int k = -half; k <= half; ++k)
        if (std::max({std::abs(i), std::abs(j), std::abs(k)}) == half) found.push_back(Vec3(i, j, k).normalized());
  return found;
}

Extremes extremes_of(const BodyShape& shape) {
  Extremes extremes{.flattest = 0.0, .compliance = 0.0};
  if (!is_particle(shape.shape)) return {.flattest = infinity, .compliance = 0.0};
  std::vector<Vec3> normals = directions();
  if (const auto* potential = std::get_if<PotentialParticle>(&shape.shape))
    for (const FacePlane& plane : potential->planes) normals.push_back(plane.normal);
  for (const Vec3& normal : normals) {
    const Vec3 point = support_point(shape.shape, normal);
    const PrincipalCurvatures curvature = principal_curvatures(shape.shape, point);
    const double product = std::sqrt(std::max(curvature.max, 0.0)) * std::sqrt(std::max(curvature.min, 0.0));
    extremes.flattest = std::max(extremes.flattest, product > 0.0 ? 1.0 / product : infinity);
    const Vec3 arm = shape.frame.orientation * point + shape.frame.position;
    const Vec3 lever = arm.cross(shape.frame.orientation * normal);
    extremes.compliance = std::max(extremes.compliance, lever.cwiseAbs2().cwiseQuotient(shape.inertia).sum());
  }
  return extremes;
}

double inverse_mass(const World& world, const Extremes& extremes, const BodyKind& kind) {
  if (!kind.is_free) return 0.0;
  const double density = world.setup.materials[static_cast<std::size_t>(kind.material)].density;
  return (1.0 / world.shapes[static_cast<std::size_t>(kind.shape)].volume + extremes.compliance) / density;
}

/// One contact with a law, pressed along the normal.
class Press {
 public:
  Press(const ContactLaw& law, double radius, double mass) : law_(law), radius_(radius), mass_(mass) {
    memory_.resize(law.memory_length(1) / law_lanes);
  }

  struct Answer {
    double force, stiffness;
    LawStatus status;
  };
  Answer at(double overlap, double speed, double time_step) {
    const double one = 1.0, zero = 0.0;
    const auto single = [](const double& value) { return std::span(&value, 1); };
    const Vectors<const double> along_z{single(zero), single(zero), single(one)};
    const Vectors<const double> along_x{single(one), single(zero), single(zero)},
        none{single(zero), single(zero), single(zero)};
    const double approach = -speed;
    Answer answer{};
    double force[3], couple[3];
    const auto out = [](double& value) { return std::span(&value, 1); };
    law_.evaluate({.R_i = single(radius_),
                   .R_j = single(radius_),
                   .overlap = single(overlap),
                   .normal = along_z,
                   .major_axis = along_x,
                   .velocity = {single(zero), single(zero), single(approach)},
                   .angular_velocity = none,
                   .mean_angular_velocity = none,
                   .reduced_mass = single(mass_),
                   .effective_radius = single(radius_),
                   .smallest_radius = {},
                   .time_step = time_step},
                  doubles_of(memory_),
                  {.force = {out(force[0]), out(force[1]), out(force[2])},
                   .couple = {out(couple[0]), out(couple[1]), out(couple[2])},
                   .normal_force = out(answer.force),
                   .status = std::span(&answer.status, 1),
                   .a_c = {},
                   .axis_ratio = {},
                   .stiffness = out(answer.stiffness),
                   .stored_normal = {},
                   .stored_tangential = {},
                   .viscous_loss = {},
                   .friction_loss = {},
                   .hysteresis_loss = {}});
    return answer;
  }

 private:
  const ContactLaw& law_;
  double radius_, mass_;
  std::vector<MemoryLine> memory_;
};

/// Twice the time from first touch to the deepest overlap. The step is halved until that is many steps.
double impact_duration(const ContactLaw& law, double radius, double mass, double speed) {
  constexpr int enough = 400, most_refinements = 60;
  double step = radius / speed * 1e-3;
  for (int refinement = 0; refinement < most_refinements; ++refinement) {
    Press press(law, radius, mass);
    double overlap = 0.0, rate = speed, force = 0.0;
    int taken = 0;
    while (rate > 0.0 && taken < enough) {  // velocity Verlet
      rate -= 0.5 * step * force / mass;
      overlap += step * rate;
      force = press.at(overlap, rate, step).force;
      rate -= 0.5 * step * force / mass;
      ++taken;
    }
    if (taken >= enough / 4) return 2.0 * step * taken;
    step *= taken > 2 ? 2.0 * taken / enough : 1e-2;
  }
  throw InputError("time step", "an impact that has no end", "a law whose force stops it");
}

}  // namespace

TimeStepLimits time_step_limits(const Setup& setup, double speed) {
  if (!(speed > 0.0) || !std::isfinite(speed))
    throw InputError("time step", "an impact speed of " + std::to_string(speed) + " m/s", "a finite value > 0");
  Setup checked = setup;
  checked.time_step = 1.0;
  const World world = make_world(checked);
  std::vector<Extremes> extremes;
  for (const BodyShape& shape : world.shapes) extremes.push_back(extremes_of(shape));
  const std::set<BodyKind> kinds = body_kinds(world);
  TimeStepLimits limits{
      .contact_duration = infinity, .rayleigh_time = infinity, .shortest = {}, .recommended = 0, .largest = 0};

  const auto shape_of = [&](const BodyKind& kind) -> const BodyShape& {
    return world.shapes[static_cast<std::size_t>(kind.shape)];
  };
  const auto name_of = [&](const BodyKind& kind) {
    return "shape " + std::to_string(kind.shape) + ", " + setup.materials[static_cast<std::size_t>(kind.material)].name;
  };
  for (const BodyKind& one : kinds) {
    if (!one.is_free) continue;
    const Material& material = setup.materials[static_cast<std::size_t>(one.material)];
    const double wave = std::sqrt(material.density / material.elastic.shear_modulus());
    limits.rayleigh_time = std::min(limits.rayleigh_time, std::numbers::pi * shape_of(one).half_width * wave /
                                                              (0.1631 * material.elastic.poissons_ratio + 0.8766));
    for (const BodyKind& two : kinds) {
      if (two.is_free && two < one) continue;
      const std::int32_t law = world.law_between(one.material, two.material);
      if (law < 0) continue;
      const Extremes &first = extremes[static_cast<std::size_t>(one.shape)],
                     &second = extremes[static_cast<std::size_t>(two.shape)];
      const double curvature = 1.0 / first.flattest + 1.0 / second.flattest;
      const double cap = setup.radius_cap * std::min(shape_of(one).volume_radius, shape_of(two).volume_radius);
      const double radius = curvature * cap > 1.0 ? 1.0 / curvature : cap;
      const double mass = 1.0 / (inverse_mass(world, first, one) + inverse_mass(world, second, two));
      const double duration =
          impact_duration(setup.interactions[static_cast<std::size_t>(law)].law, radius, mass, speed);
      if (duration >= limits.contact_duration) continue;
      limits.contact_duration = duration;
      limits.shortest = name_of(one) + " on " + name_of(two);
    }
  }
  limits.recommended = std::min(limits.contact_duration / steps_per_contact, rayleigh_share * limits.rayleigh_time);
  limits.largest = limits.contact_duration / fewest_steps_per_contact;
  return limits;
}

}  // namespace osculate
