#pragma once
// What is behind a Simulation: the state and the stages of a step.

#include <optional>

#include "dynamics/chunk_forces.hpp"
#include "dynamics/kick_bodies.hpp"
#include "dynamics/pair_list.hpp"
#include "dynamics/parallel.hpp"
#include "osculate/dynamics/simulation.hpp"

namespace osculate {

class Simulation::Engine {
 public:
  explicit Engine(const Setup& setup);
  Engine(const Setup& setup, const State& state);

  void advance(std::uint64_t steps);

  double time() const { return static_cast<double>(steps_) * world_.setup.time_step; }
  std::uint64_t steps() const { return steps_; }
  std::span<const Poured> poured() const { return poured_; }
  const World& world() const { return world_; }
  const Bodies& bodies() const { return bodies_; }
  const PeriodicBox& box() const { return world_.box; }
  std::vector<Contact> contacts() const;
  EnergyLedger energy() const;
  StepCounts counts() const;
  StageTimes times() const;
  std::size_t memory_bytes() const;
  std::size_t contact_bytes() const;
  State state() const;

 private:
  struct Driven {
    std::size_t body;
    Vec3 displacement = Vec3::Zero(), turn = Vec3::Zero();                      ///< of the last step: [m], [rad]
    Vec3 position = Vec3::Zero(), force = Vec3::Zero(), torque = Vec3::Zero();  ///< at its beginning
  };

  void make_room();
  void make_room_for(std::size_t body);
  bool pour_is_due() const;
  void pour();
  void move(bool kick_is_due);
  void move_driven(Driven& driven);
  void rebuild();
  void wrap(std::size_t body);
  void evaluate_pairs(ContactForces forces);
  void end_step();
  void add_driven_work();
  double image_power() const;
  Vec3 flow_at(const Vec3& position) const;
  double flow_way(double time) const;
  Kick half_kick() const { return {0.5 * world_.setup.time_step, world_.setup.gravity}; }
  void choose_skins();
  void stop_at_lost(double most) const;
  [[noreturn]] void stop_at(const PairChunk& chunk) const;
  std::string when() const;

  template <class Self, class Visitor>
  static void visit_state(Self& self, Visitor& visitor);

  World world_;
  Bodies bodies_;
  Kinematics kinematics_;
  PairList pairs_;
  std::vector<Driven> driven_;
  std::vector<Poured> poured_;       ///< of each of the setup's pours
  std::vector<double> radius_;       ///< of each body's bounding sphere [m]
  std::vector<double> step_travel_;  ///< of each body in the last step [m]
  std::vector<Vec3> listed_at_;      ///< where each body was when the pairs were listed [m]
  double extent_ = 0.0;              ///< no particle was further than this from centre_ when the pairs were listed [m]
  Vec3 centre_ = Vec3::Zero();
  double driven_work_ = 0.0;       ///< [J]
  double image_power_ = 0.0;       ///< of forces through the faces of a sheared box [W]
  double flow_reach_ = 0.0;        ///< no two bodies of a listed pair are further apart than this [m]
  std::uint64_t listed_step_ = 0;  ///< when the pairs were listed
  bool list_is_stale_ = false;     ///< a body has left its skin
  double poured_energy_ = 0.0;     ///< [J]
  double gravity_wrapped_ = 0.0;   ///< gravity's energy that wrapping positions took away [J]
  std::uint64_t steps_ = 0, rebuilds_ = 0;
  Threads threads_;
  std::vector<ChunkScratch> scratch_;  ///< one a thread
  StageTimes times_;
};

}  // namespace osculate
