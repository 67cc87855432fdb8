#pragma once
// What a chunk does with its contacts, many at a time: from the bodies' records to what the narrow phase and the law
// want, and from the law's answer to forces and torques.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/read_ahead.hpp"
#include "dynamics/kinematics.hpp"
#include "dynamics/pair_chunk.hpp"

namespace osculate {

/// Pairs, and where their bodies' records are.
struct PairRecords {
  std::span<const LocalPair> pairs;
  const std::int32_t* bodies;  ///< of the chunk
  const BodyRecord* records;   ///< of all bodies
};

/// How the images of a sheared box move: `rate` times their distance along `gradient`, along `flow`.
struct ImageFlow {
  Eigen::Index flow, gradient;
  double rate;  ///< [1/s]
};

/// Which images of bodies 2 stand next to bodies 1.
struct ImageShifts {
  Columns<3> shift;  ///< from bodies 2 to their images [m]; no rows where nothing is repeated in space
  std::optional<ImageFlow> flow;

  /// Of the image in a row against its original [m/s]; with a flow only.
  Vec3 velocity(std::size_t row) const {
    return flow->rate * shift[static_cast<std::size_t>(flow->gradient)][row] * Vec3::Unit(flow->flow);
  }
};

/// Columns of ContactColumns, of the motion, of the law's answer and of the arms.
namespace of_geometry {
enum : std::size_t { normal = 0, overlap = 3, on_1 = 4, on_2 = 7, R_i = 20, R_j = 21, major_axis = 22 };
}
namespace of_motion {
enum : std::size_t { velocity = 0, angular = 3, mean_angular = 6, columns = 9 };
}
namespace of_answer {
enum : std::size_t {
  force = 0,
  couple = 3,
  normal_force = 6,
  stiffness,
  stored_normal,
  stored_tangential,
  viscous_loss,
  friction_loss,
  hysteresis_loss,
  columns
};
}
namespace of_arms {
enum : std::size_t { arm_1 = 0, arm_2 = 3, columns = 6 };  ///< from the centroids to the contact point [m]
}

// Each goes on reading ahead with every batch.

/// Shapes and poses of the pairs as the narrow phase wants them; nothing is repeated in space.
void fill_pairs(const PairRecords& of, SuperquadricPairs& pairs, ReadAhead& ahead);

/// Arms and relative motion at the contacts; radii of curvature are held below their caps. Velocities are those of the
/// step in the contact plane and of its end along the normal. A gap that was proved but not resolved has neither points
/// nor curvatures: its radii are the caps, its arms and motion zero.
/// @param needs   angular velocities that are not needed are left alone
void describe_motion(const PairRecords& of, const ImageShifts& images, const std::vector<double>& radius_cap,
                     const LawNeeds& needs, ContactColumns& geometry, Columns<of_arms::columns>& arms,
                     Columns<of_motion::columns>& motion, ReadAhead& ahead);

/// A chunk's contacts as the law left them.
struct LawAnswer {
  const ContactColumns& geometry;
  const Columns<of_arms::columns>& arms;
  const Columns<of_motion::columns>& motion;
  Columns<of_answer::columns>& answer;
  double time_step;  ///< [s]
  bool has_couples, has_springs;
};

/// What becomes of it.
struct LawEffects {
  std::vector<NormalSpring>& springs;
  std::span<Vec3> force, couple;  ///< of each contact, where they are wanted; couples only if the law has some
  std::span<const LocalPair> pairs;
  std::vector<Wrench>& wrenches;  ///< on the chunk's bodies
};

/// Sums over contacts.
struct LawSums {
  double viscous_loss = 0.0, friction_loss = 0.0, hysteresis_loss = 0.0;  ///< in the step [J]
  double stored_normal = 0.0, stored_tangential = 0.0;                    ///< [J]
  /// Energy that normal springs gained since the last step because their coefficients changed: the bodies touch where
  /// they are curved otherwise. No force took it from the motion. Only of springs that go with a power of the overlap,
  /// from linear to quadratic. [J]
  double curvature_gain = 0.0;
  double stiffest = 0.0;  ///< largest stiffness over reduced mass [1/s²]
  double deepest = 0.0;   ///< largest overlap [m]
};

/// Corrects the force where a contact begins or ends (contact_edge.hpp), adds forces and torques to the bodies'
/// wrenches and adds up the rest.
LawSums collect(const LawAnswer& law, const std::vector<double>& reduced_mass, const LawEffects& effects,
                ReadAhead& ahead);

}  // namespace osculate
