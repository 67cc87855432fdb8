#pragma once
// The discrete element method: bodies that move freely and push each other where they touch.
//
// One step, from t to t + dt (velocity Verlet, [DLM97] for the rotation):
//   v += a dt/2, L += τ dt/2;  x += v dt, free rotation;  new contacts, forces;  v += a dt/2, L += τ dt/2.
// Contact laws see the velocities extrapolated to t + dt where they depend on them along the normal, and the
// displacement of the step along the contact plane. Results are bit-identical for any number of threads, and after a
// restart from a state.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "osculate/dynamics/body_shape.hpp"
#include "osculate/dynamics/setup.hpp"
#include "osculate/dynamics/state.hpp"
#include "osculate/dynamics/step_error.hpp"

namespace osculate {

/// Two bodies in contact.
struct Contact {
  std::int32_t body_1;  ///< the smaller index
  std::int32_t body_2;
  Vec3 point;      ///< [m], in a periodic box near body 1
  Vec3 normal;     ///< unit, from body 1 to body 2
  double overlap;  ///< [m]
  Vec3 force;      ///< on body 1 [N]
  Vec3 couple;     ///< on body 1 [N m], besides that of the force
  Vec3 branch;     ///< from the centroid of body 1 to that of body 2 [m]
};

/// Where the energy is, and where it went since the start [J].
struct EnergyLedger {
  double kinetic;
  double rotational;
  double gravity;            ///< −Σ m g·x
  double stored_normal;      ///< in contacts
  double stored_tangential;  ///< in contacts
  double viscous_loss;
  double friction_loss;
  double hysteresis_loss;
  double curvature_gain;  ///< of normal springs whose stiffness changed because the bodies touched where they are
                          ///< curved otherwise: no force takes this energy from the motion. Small; 0 for spheres
  double driven_work;     ///< that driven bodies, or the images of a sheared box, did on the others
  double poured;          ///< kinetic and of gravity, brought by particles that came in during the run

  double mechanical() const { return kinetic + rotational + gravity + stored_normal + stored_tangential; }
  double lost() const { return viscous_loss + friction_loss + hysteresis_loss; }
  /// What is constant when all is accounted for.
  double balance() const { return mechanical() + lost() - driven_work - poured - curvature_gain; }
};

/// What the last step was like.
struct StepCounts {
  std::uint64_t candidates;  ///< pairs near each other
  std::uint64_t checked;     ///< of them, pairs given to the narrow phase
  std::uint64_t contacts;    ///< of them, pairs that touch
  std::uint64_t rebuilds;    ///< of the candidate list, since the start
};

/// Seconds spent since the start, on all threads together.
struct StageTimes {
  double move = 0.0, broad = 0.0, narrow = 0.0, law = 0.0;
};

class Simulation {
 public:
  /// Bodies at time 0, forces evaluated. Throws InputError for a setup that is not valid, StepError if bodies overlap
  /// by more than half of the smaller one's least half width.
  explicit Simulation(const Setup& setup);
  /// Goes on from a state that this setup led to. Throws InputError if the two do not belong together.
  Simulation(const Setup& setup, const State& state);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Throws StepError, naming the body, when numbers are no longer finite, a body moved further in one step than half
  /// of the least half width of all particles, or two bodies overlap as said above.
  void advance(std::uint64_t steps);

  double time() const;  ///< [s]
  std::uint64_t steps() const;
  const Setup& setup() const;
  const PeriodicBox& box() const;  ///< as it is now: the images of a sheared one move
  const Bodies& bodies() const;    ///< the setup's, then the faces of its meshes, then what was poured, as it came
  std::int32_t first_face(std::size_t mesh) const;  ///< the body that is the first face of one of the setup's meshes
  std::span<const Poured> poured() const;           ///< what came in of each of the setup's pours
  std::span<const BodyShape> shapes() const;        ///< one for each of the setup's, then the faces
  std::vector<Contact> contacts() const;            ///< in a fixed order
  EnergyLedger energy() const;
  StepCounts counts() const;
  StageTimes times() const;
  std::size_t memory_bytes() const;   ///< of everything that grows with the number of bodies
  std::size_t contact_bytes() const;  ///< of them, those that grow with the number of contacts
  State state() const;

 private:
  class Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace osculate
