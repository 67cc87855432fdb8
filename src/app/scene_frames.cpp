#include "app/scene_frames.hpp"

#include "osculate/dynamics/measures.hpp"

namespace osculate::app {
namespace {

constexpr int fraction_points = 32;  // an axis

/// Of a box that repeats along all axes [m³].
std::optional<double> box_volume(const PeriodicBox& box) {
  if (!box.length.allFinite()) return std::nullopt;
  return box.length.prod();
}

bool has_particle_shape(const Simulation& simulation, std::size_t body) {
  return is_particle(simulation.shapes()[static_cast<std::size_t>(simulation.bodies().shape[body])].shape);
}

/// Driven bodies keep no angular momentum: their motion knows how they turn.
Vec3 angular_velocity_of(const Simulation& simulation, std::size_t body) {
  const Bodies& bodies = simulation.bodies();
  if (bodies.is_free(body)) return bodies.angular_velocity(body);
  const Setup& setup = simulation.setup();
  const Motion& motion = setup.motions[static_cast<std::size_t>(bodies.motion[body])];
  return at_time(motion, setup.bodies[body].pose, simulation.time()).angular_velocity;
}

}  // namespace

io::ResultsHead head_of(const io::Scene& scene, const Simulation& simulation) {
  const Setup& setup = scene.setup;
  io::ResultsHead head{.title = scene.title,
                       .scene = scene.text,
                       .shapes = {},
                       .walls = {},
                       .box = setup.box,
                       .gravity = setup.gravity,
                       .time_step = setup.time_step};
  for (std::size_t i = 0; i < setup.shapes.size() && is_particle(setup.shapes[i]); ++i) {
    const Material& material = setup.materials[static_cast<std::size_t>(scene.shape_materials[i])];
    head.shapes.push_back(
        {scene.shape_names[i], setup.shapes[i], simulation.shapes()[i].frame, material.name, material.density});
  }
  for (const io::SceneWall& wall : scene.walls) {
    const auto shape = static_cast<std::size_t>(setup.bodies[static_cast<std::size_t>(wall.body)].shape);
    head.walls.push_back({wall.name, static_cast<std::uint32_t>(wall.body), setup.shapes[shape]});
  }
  for (std::size_t m = 0; m < setup.meshes.size(); ++m)
    head.meshes.push_back(
        {scene.mesh_names[m], static_cast<std::uint32_t>(simulation.first_face(m)), setup.meshes[m].triangles});
  return head;
}

io::ParticleFrame frame_of(const io::Scene& scene, const Simulation& simulation) {
  const Bodies& bodies = simulation.bodies();
  io::ParticleFrame frame{.time = simulation.time(),
                          .step = simulation.steps(),
                          .id = {},
                          .shape = {},
                          .position = {},
                          .orientation = {},
                          .velocity = {},
                          .angular_velocity = {},
                          .walls = {}};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!has_particle_shape(simulation, i)) continue;
    frame.id.push_back(static_cast<std::uint32_t>(i));
    frame.shape.push_back(static_cast<std::uint32_t>(bodies.shape[i]));
    frame.position.push_back(wrapped(simulation.box(), bodies.position[i]));
    frame.orientation.push_back(bodies.orientation[i]);
    frame.velocity.push_back(bodies.velocity[i] +
                             image_velocity(simulation.box(), shift_inside(simulation.box(), bodies.position[i])));
    frame.angular_velocity.push_back(angular_velocity_of(simulation, i));
  }
  for (const io::SceneWall& wall : scene.walls) frame.walls.push_back(bodies.pose(static_cast<std::size_t>(wall.body)));
  for (std::size_t m = 0; m < scene.setup.meshes.size(); ++m)
    frame.meshes.push_back(bodies.pose(static_cast<std::size_t>(simulation.first_face(m))));
  return frame;
}

io::ContactFrame contacts_of(const Simulation& simulation) {
  io::ContactFrame frame;
  for (const Contact& contact : simulation.contacts()) {
    frame.bodies.push_back({static_cast<std::uint32_t>(contact.body_1), static_cast<std::uint32_t>(contact.body_2)});
    frame.point.push_back(contact.point);
    frame.normal.push_back(contact.normal);
    frame.overlap.push_back(contact.overlap);
    frame.force.push_back(contact.force);
  }
  return frame;
}

std::vector<std::string> series_names(const io::Scene& scene) {
  std::vector<std::string> names{"time",
                                 "step",
                                 "kinetic",
                                 "rotational",
                                 "gravity",
                                 "stored_normal",
                                 "stored_tangential",
                                 "viscous_loss",
                                 "friction_loss",
                                 "hysteresis_loss",
                                 "curvature_gain",
                                 "driven_work",
                                 "poured",
                                 "balance",
                                 "particles",
                                 "contacts",
                                 "coordination",
                                 "particle_coordination",
                                 "rattlers"};
  if (scene.output.fraction_region) names.emplace_back("solid_fraction");
  if (box_volume(scene.setup.box))
    for (const char* stress : {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yx", "stress_xz",
                               "stress_zx", "stress_yz", "stress_zy"})
      names.emplace_back(stress);
  return names;
}

std::vector<double> series_row(const io::Scene& scene, const Simulation& simulation) {
  const EnergyLedger energy = simulation.energy();
  const Connectivity net = connectivity(simulation);
  std::vector<double> row{simulation.time(),
                          static_cast<double>(simulation.steps()),
                          energy.kinetic,
                          energy.rotational,
                          energy.gravity,
                          energy.stored_normal,
                          energy.stored_tangential,
                          energy.viscous_loss,
                          energy.friction_loss,
                          energy.hysteresis_loss,
                          energy.curvature_gain,
                          energy.driven_work,
                          energy.poured,
                          energy.balance(),
                          static_cast<double>(net.particles),
                          static_cast<double>(net.contacts),
                          net.coordination,
                          net.particle_coordination,
                          static_cast<double>(net.rattlers)};
  if (scene.output.fraction_region)
    row.push_back(solid_fraction(simulation, *scene.output.fraction_region, fraction_points));
  if (const std::optional<double> volume = box_volume(scene.setup.box)) {
    const Stress parts = stress(simulation, *volume);
    const Mat3 whole = parts.contact + parts.streaming;
    row.insert(row.end(), {whole(0, 0), whole(1, 1), whole(2, 2), whole(0, 1), whole(1, 0), whole(0, 2), whole(2, 0),
                           whole(1, 2), whole(2, 1)});
  }
  return row;
}

}  // namespace osculate::app
