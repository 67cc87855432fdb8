#include "lammps/scene_host.hpp"

#include <fmt/format.h>
#include <lammps/library.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>

#include "lammps/fix_rigid.hpp"
#include "lammps/pair_osculate.hpp"
#include "lammps/styles.hpp"
#include "osculate/core/error.hpp"

namespace osculate::lammps {
namespace {

struct Extent {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;
};

bool repeats(const Setup& setup, int axis) {
  return std::isfinite(setup.box.length[axis]);
}

/// The periodic box; along other axes what holds all free bodies at the start. LAMMPS lets it grow there.
Extent extent_of(const World& world) {
  const Setup& setup = world.setup;
  Extent extent;
  for (const BodyStart& body : setup.bodies) {
    if (body.motion != Bodies::free) continue;
    const double room = world.shapes[static_cast<std::size_t>(body.shape)].bounding_radius + 2.0 * world.least_skin;
    extent.lower = extent.lower.cwiseMin(body.pose.position - Vec3::Constant(room));
    extent.upper = extent.upper.cwiseMax(body.pose.position + Vec3::Constant(room));
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!repeats(setup, axis)) continue;
    extent.lower[axis] = setup.box.origin[axis];
    extent.upper[axis] = setup.box.origin[axis] + setup.box.length[axis];
  }
  return extent;
}

void command(LAMMPS_NS::LAMMPS& lmp, const std::string& line) {
  lmp.input->one(line);
}

std::string vector_text(const Vec3& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

void make_box(LAMMPS_NS::LAMMPS& lmp, const World& world, std::size_t types) {
  const Setup& setup = world.setup;
  command(lmp, "units si");
  command(lmp, "atom_style sphere");
  command(lmp, "atom_modify map yes");
  command(lmp, "newton off");
  const auto side = [&](int axis) { return repeats(setup, axis) ? "p" : "m"; };
  command(lmp, fmt::format("boundary {} {} {}", side(0), side(1), side(2)));
  const Extent extent = extent_of(world);
  command(lmp,
          fmt::format("region box block {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} units box", extent.lower.x(),
                      extent.upper.x(), extent.lower.y(), extent.upper.y(), extent.lower.z(), extent.upper.z()));
  command(lmp, fmt::format("create_box {} box", types));
  command(lmp, fmt::format("neighbor {:.17g} bin", 2.0 * world.least_skin));
  command(lmp, "neigh_modify every 1 delay 0 check yes");
}

void make_atoms(LAMMPS_NS::LAMMPS& lmp, const Setup& setup, const std::vector<AtomKind>& kinds) {
  std::vector<int> tags, types;
  std::vector<double> x, v;
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    const BodyStart& body = setup.bodies[i];
    if (body.motion != Bodies::free) continue;
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const AtomKind& one) {
      return one.shape == body.shape && one.material == body.material;
    });
    tags.push_back(static_cast<int>(i) + 1);
    types.push_back(static_cast<int>(kind - kinds.begin()) + 1);
    const Vec3 position = wrapped(setup.box, body.pose.position);
    x.insert(x.end(), position.begin(), position.end());
    v.insert(v.end(), body.velocity.begin(), body.velocity.end());
  }
  const int count = static_cast<int>(tags.size());
  if (lammps_create_atoms(&lmp, count, tags.data(), types.data(), x.data(), v.data(), nullptr, 1) != count)
    throw InputError("the scene's bodies", "LAMMPS did not take all of them", "bodies inside the box");
}

FixRigid& rigid_of(LAMMPS_NS::LAMMPS& lmp) {
  return dynamic_cast<FixRigid&>(*lmp.modify->fix[lmp.modify->find_fix("move")]);
}

void turn_atoms(LAMMPS_NS::LAMMPS& lmp, const Setup& setup) {
  FixRigid& rigid = rigid_of(lmp);
  for (int i = 0; i < lmp.atom->nlocal; ++i) {
    const BodyStart& body = setup.bodies[static_cast<std::size_t>(lmp.atom->tag[i] - 1)];
    rigid.set_orientation(i, body.pose.orientation.normalized());
    for (int k = 0; k < 3; ++k) lmp.atom->omega[i][k] = body.angular_velocity[k];
  }
}

}  // namespace

std::filesystem::path frames_path(const std::filesystem::path& folder) {
  return folder / "frames.lammpstrj";
}
std::filesystem::path log_path(const std::filesystem::path& folder) {
  return folder / "log.lammps";
}

std::filesystem::path ready_folder(const std::filesystem::path& folder, bool overwrite) {
  if (!overwrite && std::filesystem::exists(frames_path(folder)))
    throw InputError(frames_path(folder).string(), "found results of an earlier run",
                     "--overwrite to start anew, or another folder by --out");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be made (" + error.message() + ")", "a place for the results");
  return folder;
}

SceneOrders orders_of(const io::Scene& scene, const std::filesystem::path& folder) {
  return {.steps = scene.steps(),
          .frame_every = scene.steps_in(scene.output.interval),
          .row_every = scene.steps_in(scene.output.series_interval),
          .frames = frames_path(folder)};
}

std::unique_ptr<LAMMPS_NS::LAMMPS> start_lammps(MPI_Comm ranks, std::vector<std::string> options) {
  options.insert(options.begin(), "osculate-lammps");
  std::vector<char*> pointers;
  for (std::string& option : options) pointers.push_back(option.data());
  pointers.push_back(nullptr);
  auto lmp = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(options.size()), pointers.data(), ranks);
  add_styles(*lmp);
  return lmp;
}

void build_scene(LAMMPS_NS::LAMMPS& lmp, const io::Scene& scene) {
  const Setup& setup = scene.setup;
  require_supported(setup);
  const std::vector<AtomKind> kinds = kinds_of(setup);
  make_box(lmp, make_world(setup), kinds.size());
  make_atoms(lmp, setup, kinds);
  command(lmp, "pair_style osculate");
  pair_of(&lmp, "a scene").set_kinds(setup, kinds);
  command(lmp, "fix move all osculate/rigid");
  turn_atoms(lmp, setup);
  if (pair_of(&lmp, "a scene").rank().driven > 0) command(lmp, "fix walls all osculate/walls");
  if (!setup.gravity.isZero(0.0))
    command(lmp,
            fmt::format("fix gravity all gravity {:.17g} vector {}", setup.gravity.norm(), vector_text(setup.gravity)));
  command(lmp, fmt::format("timestep {:.17g}", setup.time_step));
  command(lmp, "compute contacts all pair osculate");
  command(lmp, "thermo_style custom step time ke f_move pe c_contacts[3] c_contacts[4] c_contacts[5] c_contacts[7]");
  command(lmp, "thermo_modify norm no lost error");
}

void run_scene(LAMMPS_NS::LAMMPS& lmp, const SceneOrders& orders) {
  const std::string frames = fmt::format(
      "\"{}\" id type x y z vx vy vz omegax omegay omegaz d_qw d_qx d_qy d_qz fx fy fz", orders.frames.string());
  const std::string look = "sort id format float %.17g";
  command(lmp, fmt::format("dump frames all custom {} {}", orders.frame_every, frames));
  command(lmp, "dump_modify frames " + look);
  command(lmp, fmt::format("thermo {}", orders.row_every));
  // Bodies fall and gather: ranks share them evenly, to a tenth.
  command(lmp, "fix balance all balance 1000 1.1 shift xyz 5 1.05");
  command(lmp, fmt::format("run {}", orders.steps));
  command(lmp, "undump frames");
  // The end is a frame too.
  if (orders.steps % orders.frame_every != 0)
    command(lmp, fmt::format("write_dump all custom {} modify {} append yes", frames, look));
}

void advance(LAMMPS_NS::LAMMPS& lmp, std::uint64_t steps) {
  command(lmp, fmt::format("run {} pre no post no", steps));
}

std::vector<BodyStart> gather_bodies(LAMMPS_NS::LAMMPS& lmp, const Setup& setup) {
  constexpr int numbers = 14;  // of an atom: tag, position, orientation, velocity, angular velocity
  const auto& rigid = rigid_of(lmp);
  std::vector<double> mine, all;
  for (int i = 0; i < lmp.atom->nlocal; ++i) {
    const Quat q = rigid.orientation(i);
    mine.insert(mine.end(), {static_cast<double>(lmp.atom->tag[i]), lmp.atom->x[i][0], lmp.atom->x[i][1],
                             lmp.atom->x[i][2], q.w(), q.x(), q.y(), q.z()});
    mine.insert(mine.end(), lmp.atom->v[i], lmp.atom->v[i] + 3);
    mine.insert(mine.end(), lmp.atom->omega[i], lmp.atom->omega[i] + 3);
  }
  int rank = 0, ranks = 1;
  MPI_Comm_rank(lmp.world, &rank);
  MPI_Comm_size(lmp.world, &ranks);
  const auto count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(counts.size());
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, lmp.world);
  std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
  if (rank == 0) all.resize(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Gatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, 0, lmp.world);
  if (rank != 0) return {};
  std::vector<BodyStart> bodies = setup.bodies;
  for (std::size_t at = 0; at < all.size(); at += numbers) {
    const double* n = &all[at];
    BodyStart& body = bodies[static_cast<std::size_t>(n[0]) - 1];
    body.pose = {.position = {n[1], n[2], n[3]}, .orientation = {n[4], n[5], n[6], n[7]}};
    body.velocity = {n[8], n[9], n[10]};
    body.angular_velocity = {n[11], n[12], n[13]};
  }
  const double time = pair_of(&lmp, "a scene").time();
  for (BodyStart& body : bodies)
    if (body.motion != Bodies::free)
      body.pose = at_time(setup.motions[static_cast<std::size_t>(body.motion)], body.pose, time).pose;
  return bodies;
}

PairSums gather_sums(LAMMPS_NS::LAMMPS& lmp) {
  const PairSums mine = pair_of(&lmp, "a scene").pair_sums();
  static_assert(std::is_trivially_copyable_v<PairSums> && sizeof(PairSums) % sizeof(double) == 0);
  PairSums all;
  MPI_Reduce(&mine, &all, sizeof(PairSums) / sizeof(double), MPI_DOUBLE, MPI_SUM, 0, lmp.world);
  return all;
}

}  // namespace osculate::lammps
