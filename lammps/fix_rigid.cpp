#include "lammps/fix_rigid.hpp"

#include <algorithm>

#include "dynamics/move_bodies.hpp"
#include "lammps/pair_osculate.hpp"

namespace osculate::lammps {
namespace {

constexpr const char* who = "fix osculate/rigid";
constexpr std::array<const char*, 4> orientation_names{"qw", "qx", "qy", "qz"};

Vec3 vec3(const double* from) {
  return {from[0], from[1], from[2]};
}
void put(const Vec3& v, double* to) {
  to[0] = v.x(), to[1] = v.y(), to[2] = v.z();
}

}  // namespace

FixRigid::FixRigid(LAMMPS_NS::LAMMPS* host, int count, char** arguments) : Fix(host, count, arguments) {
  if (count != 3) stop_all(error, "fix osculate/rigid takes no arguments");
  if (igroup != 0) stop_all(error, "fix osculate/rigid moves the group all");
  time_integrate = 1;
  scalar_flag = 1;
  global_freq = 1;
  extscalar = 1;
  maxexchange = BodyMotion::doubles;
  grow_arrays(atom->nmax);
  atom->add_callback(LAMMPS_NS::Atom::GROW);
}

FixRigid::~FixRigid() {
  atom->delete_callback(id, LAMMPS_NS::Atom::GROW);
}

int FixRigid::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | FINAL_INTEGRATE | PRE_EXCHANGE;
}

void FixRigid::post_constructor() {
  int is_double = 0, columns = 0;
  if (atom->find_custom(orientation_names[0], is_double, columns) < 0)
    modify->add_fix(std::string(id) + "_orientation all property/atom d_qw d_qx d_qy d_qz");
  find_orientations();
}

void FixRigid::find_orientations() {
  for (std::size_t k = 0; k < 4; ++k) {
    int is_double = 0, columns = 0;
    const int index = atom->find_custom(orientation_names[k], is_double, columns);
    if (index < 0 || is_double == 0 || columns != 0)
      stop_all(error, "fix osculate/rigid wants the atom properties d_qw d_qx d_qy d_qz; fix property/atom makes them");
    orientation_[k] = index;
  }
}

void FixRigid::init() {
  PairOsculate& pair = pair_of(lmp, who);
  pair.set_rigid_fix(this);
  find_orientations();
  const RankBodies& rank = pair.rank();
  for (int i = 0; i < atom->nlocal; ++i) {
    const AtomKind& kind = rank.kinds[static_cast<std::size_t>(atom->type[i] - 1)];
    const BodyShape& shape = rank.world.shapes[static_cast<std::size_t>(kind.shape)];
    atom->rmass[i] = rank.density(kind) * shape.volume;
    atom->radius[i] = shape.bounding_radius;
  }
}

Quat FixRigid::orientation(int i) const {
  const auto value = [&](std::size_t k) { return atom->dvector[orientation_[k]][i]; };
  const Quat q(value(0), value(1), value(2), value(3));
  if (q.coeffs().isZero(0.0)) return Quat::Identity();
  return q;
}

void FixRigid::set_orientation(int i, const Quat& q) {
  const double values[] = {q.w(), q.x(), q.y(), q.z()};
  for (std::size_t k = 0; k < 4; ++k) atom->dvector[orientation_[k]][i] = values[k];
}

void FixRigid::initial_integrate(int) {
  PairOsculate& pair = pair_of(lmp, who);
  RankBodies& rank = pair.rank();
  Bodies& bodies = rank.bodies;
  const double dt = update->dt;
  for (int i = 0; i < atom->nlocal; ++i) {
    const std::size_t body = rank.index(i);
    const Quat q = orientation(i);
    bodies.position[body] = vec3(atom->x[i]);
    bodies.orientation[body] = q;
    bodies.velocity[body] = vec3(atom->v[i]);
    bodies.angular_momentum[body] = bodies.inertia[body].cwiseProduct(q.conjugate() * vec3(atom->omega[i]));
    bodies.force[body] = vec3(atom->f[i]);
    bodies.torque[body] = vec3(atom->torque[i]);
  }
  // Gravity is among the forces.
  move_bodies({.time_step = dt, .gravity = Vec3::Zero()}, rank.driven, rank.driven + rank.owned, bodies,
              rank.kinematics, rank.radius, rank.way);
  const double most = 0.5 * rank.world.least_half_width;
  for (int i = 0; i < atom->nlocal; ++i) {
    const std::size_t body = rank.index(i);
    if (!(rank.way[body] <= most))
      stop_one(error, fmt::format("step {}: atom {} moved {:.6g} m in one step, more than half of the least half width "
                                  "{:.6g} m of all particles, or its position is not finite",
                                  update->ntimestep, atom->tag[i], rank.way[body], rank.world.least_half_width));
    rank.kinematics.travel[body] += rank.way[body];
    put(bodies.position[body], atom->x[i]);
    put(bodies.velocity[body], atom->v[i]);
    put(bodies.angular_velocity(body), atom->omega[i]);
    set_orientation(i, bodies.orientation[body]);
  }
  const auto [centre, far] = pair.extent();
  if (rank.driven_act) place_driven(rank, pair.time(), dt, centre, far);
}

void FixRigid::final_integrate() {
  const RankBodies& rank = pair_of(lmp, who).rank();
  const double half = 0.5 * update->dt;
  for (int i = 0; i < atom->nlocal; ++i) {
    const std::size_t body = rank.index(i);
    const Quat q = orientation(i);
    const Vec3& inertia = rank.bodies.inertia[body];
    put(vec3(atom->v[i]) + half / rank.bodies.mass[body] * vec3(atom->f[i]), atom->v[i]);
    const Vec3 kick = half * (q.conjugate() * vec3(atom->torque[i])).cwiseQuotient(inertia);
    put(vec3(atom->omega[i]) + q * kick, atom->omega[i]);
  }
}

void FixRigid::pre_exchange() {
  const RankBodies& rank = pair_of(lmp, who).rank();
  for (int i = 0; i < atom->nlocal && static_cast<std::size_t>(i) < rank.owned; ++i) {
    const BodyRecord& record = rank.kinematics.records[rank.index(i)];
    motion_[static_cast<std::size_t>(i)] = {record.velocity, record.mean_angular_velocity, record.last_velocity,
                                            record.last_angular_velocity};
  }
}

void FixRigid::copy_arrays(int from, int to, int) {
  motion_[static_cast<std::size_t>(to)] = motion_[static_cast<std::size_t>(from)];
}

int FixRigid::pack_exchange(int i, double* to) {
  const BodyMotion& motion = motion_[static_cast<std::size_t>(i)];
  put(motion.velocity, to);
  put(motion.mean_angular_velocity, to + 3);
  put(motion.last_velocity, to + 6);
  put(motion.last_angular_velocity, to + 9);
  return BodyMotion::doubles;
}

int FixRigid::unpack_exchange(int i, double* from) {
  motion_[static_cast<std::size_t>(i)] = {vec3(from), vec3(from + 3), vec3(from + 6), vec3(from + 9)};
  return BodyMotion::doubles;
}

double FixRigid::compute_scalar() {
  const RankBodies& rank = pair_of(lmp, who).rank();
  double mine = 0.0, all = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    const AtomKind& kind = rank.kinds[static_cast<std::size_t>(atom->type[i] - 1)];
    const Vec3 inertia = rank.density(kind) * rank.world.shapes[static_cast<std::size_t>(kind.shape)].inertia;
    const Vec3 omega = orientation(i).conjugate() * vec3(atom->omega[i]);
    mine += 0.5 * omega.dot(inertia.cwiseProduct(omega));
  }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixRigid::memory_usage() {
  return static_cast<double>(motion_.capacity() * sizeof(BodyMotion));
}

}  // namespace osculate::lammps
