#pragma once
// What a law of the registry brings: its description, and how it binds to parameters and materials. A bound part works
// on one contact at a time; parts run in the order of their slots and read what those before them found.

#include <concepts>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "osculate/core/types.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/law_registry.hpp"
#include "osculate/mechanics/tangent_vector.hpp"

namespace osculate::laws {

/// One contact of a step.
struct Contact {
  // Where it is and how it moves.
  double R_i, R_j;       ///< R_i ≤ largest_radius_ratio R_j; a normal law on spheres puts theirs here
  double overlap, rate;  ///< dδ/dt > 0 on approach
  double reduced_mass;   ///< 0 unless asked for in LawNeeds, as the next
  double effective_radius;
  double time_step;
  Vec3 normal, major, minor;  ///< minor = normal × major
  TangentVector velocity;     ///< of body 2 against body 1, along major and minor
  Vec3 angular_velocity;      ///< of body 2 against body 1, world
  double spin;                ///< mean rotation about the normal in this step [rad]

  // What carries the load: found by the normal law, or by the one that replaces it.
  bool closed = false;
  bool converged = true;
  double elastic = 0.0;    ///< F_n without dashpot [N]
  double stiffness = 0.0;  ///< dF_n/dδ [N/m]
  double a_c = 0.0, axis_ratio = 0.0;
  double stored_normal = 0.0;
  double hysteresis_loss = 0.0;
  double friction_load = 0.0;  ///< what μ multiplies, without the dashpot's share [N]
  bool pulls = false;          ///< the law is adhesive: dashpots need not stop at a force of zero

  double dashpot = 0.0;  ///< viscous part of F_n [N]

  // Found by tangential, twisting and rolling laws, on body 1.
  TangentVector force{};       ///< along major and minor
  Vec3 couple = Vec3::Zero();  ///< world
  double stored_tangential = 0.0;
  double friction_loss = 0.0, viscous_loss = 0.0;

  /// The ellipse in which the undeformed surfaces would be pressed, whatever carries the load; found when first asked.
  const ContactEllipse& ellipse() {
    if (!known_ellipse) known_ellipse = contact_ellipse(R_i, R_j);
    return *known_ellipse;
  }
  std::optional<ContactEllipse> known_ellipse = std::nullopt;

  double normal_force() const { return elastic + dashpot; }
  TangentVector displacement() const { return time_step * velocity; }
};

/// A part's memory of one contact: its doubles stand a block's width apart.
class Memory {
 public:
  Memory() = default;
  explicit Memory(double* first) : first_(first) {}
  double& operator[](std::size_t entry) const { return first_[entry * law_lanes]; }

 private:
  double* first_ = nullptr;
};

/// Contacts that a law works on at a time, at most.
inline constexpr std::size_t stretch = 4 * law_lanes;

/// A bound law. It is asked also when a contact is open, and then forgets.
class Step {
 public:
  /// For one contact after the other.
  template <std::invocable<Contact&, Memory> One>
  Step(const One& one)  // NOLINT: a law is written down as what it does
      : many_([one](std::span<Contact> contacts, std::span<const Memory> memories) {
          for (std::size_t i = 0; i < contacts.size(); ++i) one(contacts[i], memories[i]);
        }) {}
  /// For up to `stretch` contacts at once.
  template <std::invocable<std::span<Contact>, std::span<const Memory>> Many>
  Step(const Many& many) : many_(many) {}  // NOLINT

  void operator()(std::span<Contact> contacts, std::span<const Memory> memories) const { many_(contacts, memories); }

 private:
  std::function<void(std::span<Contact>, std::span<const Memory>)> many_;
};

struct Part {
  Step step;
  LawNeeds needs = {};
  bool makes_couples = false;
  std::function<double(double R_i, double R_j)> range = {};
};

/// What a law binds to; its parameters are in their ranges, the materials valid.
struct Binding {
  const ElasticMaterial& material_1;
  const ElasticMaterial& material_2;
  const std::map<std::string, double>& parameters;  ///< all of them

  double operator[](std::string_view name) const { return parameters.at(std::string(name)); }
};

struct Law {
  LawDescription description;
  Part (*bind)(const Binding& binding);
};

}  // namespace osculate::laws
