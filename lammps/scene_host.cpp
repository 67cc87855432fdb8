#include "lammps/scene_host.hpp"

#include <fmt/format.h>
#include <lammps/library.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lammps/fix_rigid.hpp"
#include "lammps/pair_osculate.hpp"
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
    const double room = world.shapes[static_cast<std::size_t>(body.shape)].bounding_radius + world.skin;
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
  command(lmp, fmt::format("neighbor {:.17g} bin", world.skin));
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

void turn_atoms(LAMMPS_NS::LAMMPS& lmp, const Setup& setup) {
  auto& rigid = dynamic_cast<FixRigid&>(*lmp.modify->fix[lmp.modify->find_fix("move")]);
  for (int i = 0; i < lmp.atom->nlocal; ++i) {
    const BodyStart& body = setup.bodies[static_cast<std::size_t>(lmp.atom->tag[i] - 1)];
    rigid.set_orientation(i, body.pose.orientation.normalized());
    for (int k = 0; k < 3; ++k) lmp.atom->omega[i][k] = body.angular_velocity[k];
  }
}

}  // namespace

SceneOrders orders_of(const io::Scene& scene) {
  return {.steps = scene.steps(),
          .dump_every = scene.steps_in(scene.output.interval),
          .thermo_every = scene.steps_in(scene.output.series_interval),
          .dump = scene.file.stem().string() + ".lammpstrj"};
}

void run_scene(LAMMPS_NS::LAMMPS& lmp, const io::Scene& scene, const SceneOrders& orders) {
  const Setup& setup = scene.setup;
  require_supported(scene);
  const std::vector<AtomKind> kinds = kinds_of(scene);
  make_box(lmp, make_world(setup), kinds.size());
  make_atoms(lmp, setup, kinds);
  command(lmp, "pair_style osculate");
  pair_of(&lmp, "a scene").set_kinds(scene, kinds);
  command(lmp, "fix move all osculate/rigid");
  turn_atoms(lmp, setup);
  if (pair_of(&lmp, "a scene").rank().driven > 0) command(lmp, "fix walls all osculate/walls");
  if (!setup.gravity.isZero(0.0))
    command(lmp,
            fmt::format("fix gravity all gravity {:.17g} vector {}", setup.gravity.norm(), vector_text(setup.gravity)));
  command(lmp, fmt::format("timestep {:.17g}", setup.time_step));
  command(lmp, "compute contacts all pair osculate");
  command(lmp,
          fmt::format(
              "dump frames all custom {} {} id type x y z vx vy vz omegax omegay omegaz d_qw d_qx d_qy d_qz fx fy fz",
              orders.dump_every, orders.dump));
  command(lmp, "dump_modify frames sort id format float %.17g");
  command(lmp, fmt::format("thermo {}", orders.thermo_every));
  command(lmp, "thermo_style custom step time ke f_move pe c_contacts[3] c_contacts[4] c_contacts[5] c_contacts[7]");
  command(lmp, "thermo_modify norm no lost error");
  command(lmp, fmt::format("run {}", orders.steps));
}

}  // namespace osculate::lammps
