#include "lammps/pair_osculate.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/fault_text.hpp"
#include "lammps/fix_contacts.hpp"
#include "lammps/fix_rigid.hpp"
#include "osculate/core/error.hpp"

namespace osculate::lammps {
namespace {

constexpr const char* contacts_fix_id = "OSCULATE_CONTACTS";
/// Doubles of a body that its ghosts hear of every step: orientation, four velocities, travel.
constexpr int ghost_doubles = 17;

Vec3 vec3(const double* from) {
  return {from[0], from[1], from[2]};
}
double* put(const Vec3& v, double* to) {
  to[0] = v.x(), to[1] = v.y(), to[2] = v.z();
  return to + 3;
}

enum Sum {
  stored_normal,
  stored_tangential,
  viscous_loss,
  friction_loss,
  hysteresis_loss,
  curvature_gain,
  contacts,
  candidates,
  sums
};

}  // namespace

PairOsculate& pair_of(LAMMPS_NS::LAMMPS* lmp, const char* who) {
  auto* pair = dynamic_cast<PairOsculate*>(lmp->force->pair_match("osculate", 1));
  if (pair == nullptr) stop_all(lmp->error, std::string(who) + " needs pair_style osculate");
  return *pair;
}

PairOsculate::PairOsculate(LAMMPS_NS::LAMMPS* host) : Pair(host) {
  single_enable = 0;
  restartinfo = 0;
  one_coeff = 1;
  no_virial_fdotr_compute = 1;
  centroidstressflag = LAMMPS_NS::CENTROID_NOTAVAIL;
  comm_forward = ghost_doubles;
  nextra = sums;
  pvector = new double[sums];
}

PairOsculate::~PairOsculate() {
  delete[] pvector;
  if (allocated != 0) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
  if (contacts_ != nullptr) modify->delete_fix(contacts_fix_id);
}

void PairOsculate::settings(int count, char**) {
  if (count != 0) stop_all(error, "pair_style osculate takes no arguments; the scene file stands in pair_coeff");
}

void PairOsculate::coeff(int count, char** arguments) {
  const auto is = [&](int k, const char* text) { return std::string(arguments[k]) == text; };
  if (count != 3 + atom->ntypes || !is(0, "*") || !is(1, "*"))
    stop_all(error, fmt::format("found pair_coeff with {} arguments; expected: pair_coeff * * FILE and the name of "
                                "particles for each of {} atom types",
                                count, atom->ntypes));
  try {
    const io::Scene scene = io::read_scene(arguments[2]);
    set_kinds(scene.setup, kinds_by_name(scene, {arguments + 3, arguments + count}));
  } catch (const InputError& bad) {
    stop_all(error, bad.what());
  }
}

void PairOsculate::set_kinds(const Setup& setup, const std::vector<AtomKind>& kinds) {
  rank_ = make_rank_bodies(setup, kinds);
  pairs_ = {};
  const int types = atom->ntypes;
  if (allocated == 0) {
    memory->create(setflag, types + 1, types + 1, "pair:setflag");
    memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
    allocated = 1;
  }
  for (int i = 1; i <= types; ++i)
    for (int j = i; j <= types; ++j) setflag[i][j] = 1;
}

void PairOsculate::init_style() {
  if (!rank_) stop_all(error, "pair_style osculate needs pair_coeff");
  if (force->newton_pair != 0) stop_all(error, "pair_style osculate needs the command: newton off");
  if (atom->omega_flag == 0 || atom->torque_flag == 0 || atom->rmass_flag == 0 || atom->radius_flag == 0)
    stop_all(error, "pair_style osculate needs atom_style sphere");
  if (atom->tag_enable == 0) stop_all(error, "pair_style osculate needs atom IDs");
  if (neighbor->every != 1 || neighbor->delay != 0 || neighbor->dist_check == 0)
    stop_all(error, "pair_style osculate needs the command: neigh_modify every 1 delay 0 check yes");
  rigid_ = nullptr;
  if (modify->find_fix(contacts_fix_id) < 0) modify->add_fix(std::string(contacts_fix_id) + " all osculate/contacts");
  neighbor->request(this, instance_me);
}

double PairOsculate::init_one(int type_1, int type_2) {
  const World& ours = rank_->world;
  const auto radius = [&](int type) {
    return ours.shapes[static_cast<std::size_t>(rank_->kinds[static_cast<std::size_t>(type - 1)].shape)]
        .bounding_radius;
  };
  const double cut = radius(type_1) + radius(type_2) + *std::max_element(ours.reach.begin(), ours.reach.end());
  for (int k = 0; k < 3; ++k) {
    const double length = domain->boxhi[k] - domain->boxlo[k];
    if (domain->periodicity[k] != 0 && !(length > 2.0 * (cut + neighbor->skin)))
      stop_all(error,
               fmt::format("a periodic box {:.6g} m wide: bodies could meet each other twice; expected more than "
                           "{:.6g} m",
                           length, 2.0 * (cut + neighbor->skin)));
  }
  return cut;
}

double PairOsculate::time() const {
  return update->atime + static_cast<double>(update->ntimestep - update->atimestep) * update->dt;
}

std::pair<Vec3, double> PairOsculate::extent() const {
  const Vec3 lower = vec3(domain->boxlo), upper = vec3(domain->boxhi);
  // Atoms may be as far outside as they move between two lists.
  return {0.5 * (lower + upper), 0.5 * (upper - lower).norm() + neighbor->skin};
}

/// All bodies at rest in their records: nothing has moved yet.
void PairOsculate::start_records() {
  for (int i = 0; i < atom->nlocal; ++i) {
    BodyRecord& record = rank_->kinematics.records[rank_->index(i)];
    record.velocity = record.last_velocity = vec3(atom->v[i]);
    record.mean_angular_velocity = record.last_angular_velocity = vec3(atom->omega[i]);
    const Quat q = rigid_->orientation(i);
    if (!(std::fabs(q.norm() - 1.0) < 1e-6))
      stop_one(error, fmt::format("atom {}: found an orientation of norm {:.6g}; expected a unit quaternion",
                                  atom->tag[i], q.norm()));
    rigid_->set_orientation(i, q.normalized());
  }
  const auto [centre, far] = extent();
  place_driven(*rank_, time(), 0.0, centre, far);
}

void PairOsculate::relist() {
  ++lists_;
  set_atoms(*rank_, static_cast<std::size_t>(atom->nlocal), static_cast<std::size_t>(atom->nghost), atom->type);
  if (update->setupflag != 0) {
    start_records();
  } else {
    for (int i = 0; i < atom->nlocal; ++i) {
      const BodyMotion& motion = rigid_->motion(i);
      BodyRecord& record = rank_->kinematics.records[rank_->index(i)];
      record.velocity = motion.velocity;
      record.mean_angular_velocity = motion.mean_angular_velocity;
      record.last_velocity = motion.last_velocity;
      record.last_angular_velocity = motion.last_angular_velocity;
    }
  }
  for (int i = 0; i < atom->nlocal; ++i)
    rank_->kinematics.records[rank_->index(i)].place(vec3(atom->x[i]), rigid_->orientation(i));
  found_.clear();
  for (int k = 0; k < list->inum; ++k) {
    const int i = list->ilist[k];
    for (int n = 0; n < list->numneigh[i]; ++n) found_.push_back({i, list->firstneigh[i][n] & NEIGHMASK});
  }
}

void PairOsculate::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (eflag_atom != 0 || vflag_atom != 0)
    stop_all(error, "pair_style osculate has no energy or virial of single atoms");
  if (rigid_ == nullptr) stop_all(error, "pair_style osculate needs fix osculate/rigid");
  const bool listed_anew = neighbor->ago == 0;
  if (listed_anew) relist();
  comm->forward_comm_pair(this);
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; ++i) {
    BodyRecord& record = rank_->kinematics.records[rank_->index(i)];
    record.place(vec3(atom->x[i]), record.orientation());
  }
  if (listed_anew) pairs_.list(*rank_, atom->tag, found_, neighbor->skin, contacts_->stowed());
  rank_->kinematics.time_step = update->setupflag != 0 ? 0.0 : update->dt;
  const PairChunk* fault = pairs_.evaluate(*rank_);
  if (fault != nullptr) stop_at(*fault);
  collect();
  if (vflag_global != 0) tally_virial();
}

void PairOsculate::collect() {
  for (std::size_t i = 0; i < rank_->driven; ++i) {
    rank_->bodies.force[i].setZero();
    rank_->bodies.torque[i].setZero();
  }
  for (const PairChunk& chunk : pairs_.chunks())
    for (std::size_t k = 0; k < chunk.bodies.size(); ++k) {
      const auto body = static_cast<std::size_t>(chunk.bodies[k]);
      const Wrench& wrench = chunk.wrenches[k];
      if (rank_->is_driven(body)) {
        rank_->bodies.force[body] += wrench.force();
        rank_->bodies.torque[body] += wrench.torque();
      } else if (rank_->is_owned(body)) {
        const std::size_t i = body - rank_->driven;
        put(vec3(atom->f[i]) + wrench.force(), atom->f[i]);
        put(vec3(atom->torque[i]) + wrench.torque(), atom->torque[i]);
      }
    }
  const PairSums all = pairs_.sums();
  pvector[stored_normal] = all.stored_normal;
  pvector[stored_tangential] = all.stored_tangential;
  pvector[viscous_loss] = all.viscous_loss;
  pvector[friction_loss] = all.friction_loss;
  pvector[hysteresis_loss] = all.hysteresis_loss;
  pvector[curvature_gain] = all.curvature_gain;
  pvector[contacts] = all.contacts;
  pvector[candidates] = all.candidates;
  eng_vdwl = all.stored_normal + all.stored_tangential;
}

/// Of contacts between atoms; walls are outside the system.
void PairOsculate::tally_virial() {
  for (std::size_t c = 0; c < pairs_.chunks().size(); ++c) {
    const PairChunk& chunk = pairs_.chunks()[c];
    for (std::size_t k = 0; k < chunk.contacts.size(); ++k) {
      const auto one = static_cast<std::size_t>(chunk.bodies[static_cast<std::size_t>(chunk.contacts.bodies[k].first)]);
      const auto two =
          static_cast<std::size_t>(chunk.bodies[static_cast<std::size_t>(chunk.contacts.bodies[k].second)]);
      if (rank_->is_driven(one)) continue;
      const auto& records = rank_->kinematics.records;
      const Mat3 product =
          pairs_.weight(c) * (records[one].position() - records[two].position()) * chunk.contacts.force[k].transpose();
      const double entries[] = {product(0, 0), product(1, 1), product(2, 2),
                                product(0, 1), product(0, 2), product(1, 2)};
      for (int v = 0; v < 6; ++v) virial[v] += entries[v];
    }
  }
}

int PairOsculate::pack_forward_comm(int count, int* atoms, double* to, int, int*) {
  for (int k = 0; k < count; ++k) {
    const std::size_t body = rank_->index(atoms[k]);
    const BodyRecord& record = rank_->kinematics.records[body];
    const Quat q = record.orientation();
    *to++ = q.w();
    to = put(q.vec(), to);
    to = put(record.velocity, to);
    to = put(record.mean_angular_velocity, to);
    to = put(record.last_velocity, to);
    to = put(record.last_angular_velocity, to);
    *to++ = rank_->kinematics.travel[body];
  }
  return count * ghost_doubles;
}

void PairOsculate::unpack_forward_comm(int count, int first, double* from) {
  for (int i = first; i < first + count; ++i, from += ghost_doubles) {
    const std::size_t body = rank_->index(i);
    BodyRecord& record = rank_->kinematics.records[body];
    record.place(record.position(), Quat(from[0], from[1], from[2], from[3]));
    record.velocity = vec3(from + 4);
    record.mean_angular_velocity = vec3(from + 7);
    record.last_velocity = vec3(from + 10);
    record.last_angular_velocity = vec3(from + 13);
    rank_->kinematics.travel[body] = from[16];
  }
}

void PairOsculate::stow(std::vector<StowedContacts>& atoms) {
  pairs_.stow(*rank_, atom->tag, atoms);
}

void PairOsculate::stop_at(const PairChunk& chunk) {
  const auto name = [&](std::int32_t body) {
    const auto index = static_cast<std::size_t>(body);
    if (rank_->is_driven(index)) return fmt::format("wall or obstacle {}", index);
    return fmt::format("atom {}", atom->tag[index - rank_->driven]);
  };
  stop_one(error,
           fmt::format("step {}: {}", update->ntimestep,
                       fault_text(chunk, name(chunk.fault_pair.first) + " and " + name(chunk.fault_pair.second))));
}

double PairOsculate::memory_usage() {
  double bytes = static_cast<double>(rank_->kinematics.records.capacity() * sizeof(BodyRecord));
  for (const PairChunk& chunk : pairs_.chunks())
    bytes += static_cast<double>(chunk.far.capacity() * (sizeof(FarPair) + sizeof(FarCache)) +
                                 chunk.contacts.memory.capacity() * sizeof(MemoryLine) +
                                 chunk.contacts.bodies.capacity() *
                                     (sizeof(chunk.contacts.bodies[0]) + ContactCaches::width * sizeof(double) +
                                      sizeof(std::uint16_t) + sizeof(NormalSpring) + sizeof(Vec3)) +
                                 chunk.bodies.capacity() * (sizeof(std::int32_t) + sizeof(Wrench)));
  return bytes;
}

}  // namespace osculate::lammps
