#include "lammps/bulk.hpp"

#include <cmath>

#include "lammps/scene_on_ranks.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/measures.hpp"
#include "osculate/dynamics/random.hpp"

namespace osculate::lammps {
namespace {

/// Chaos does the rest.
io::Scene begun_otherwise(io::Scene scene, int beginning) {
  constexpr double share = 0.02;  // of the scene's speed
  Random random(static_cast<std::uint64_t>(beginning) + 1);
  for (BodyStart& body : scene.setup.bodies) {
    if (body.motion != Bodies::free) continue;
    for (double& v : body.velocity) v += share * scene.speed * random.normal();
  }
  return scene;
}

struct Losses {
  double viscous, friction;  ///< [J]
};

/// The same way for every engine: its bodies are put into a simulation of their own, whose contacts are looked at.
Bulk bulk_of(const io::Scene& scene, std::vector<BodyStart> bodies, const Losses& losses) {
  Setup setup = scene.setup;
  setup.bodies = std::move(bodies);
  const Simulation still(setup);
  constexpr int points_an_axis = 96;
  constexpr double milli = 1e3;
  const Connectivity net = connectivity(still);
  const EnergyLedger energy = still.energy();
  return {solid_fraction(still, *scene.output.fraction_region, points_an_axis),
          net.coordination,
          net.particle_coordination,
          static_cast<double>(net.rattlers) / static_cast<double>(net.particles),
          milli * (energy.kinetic + energy.rotational),
          milli * energy.gravity,
          milli * energy.stored_normal,
          milli * losses.viscous,
          milli * losses.friction};
}

Bulk run_embedded(const io::Scene& scene) {
  Simulation simulation(scene.setup);
  simulation.advance(scene.steps());
  const EnergyLedger energy = simulation.energy();
  return bulk_of(scene, bodies_of(simulation), {.viscous = energy.viscous_loss, .friction = energy.friction_loss});
}

}  // namespace

Estimate estimate(const std::vector<Bulk>& bulks, std::size_t quantity) {
  const auto count = static_cast<double>(bulks.size());
  double sum = 0.0, squares = 0.0;
  for (const Bulk& bulk : bulks) sum += bulk[quantity];
  for (const Bulk& bulk : bulks) squares += std::pow(bulk[quantity] - sum / count, 2);
  return {.mean = sum / count, .error = std::sqrt(squares / (count - 1.0) / count)};
}

double difference_in_errors(const Estimate& one, const Estimate& two) {
  return (two.mean - one.mean) / std::hypot(one.error, two.error);
}

std::vector<Ensemble> run_ensembles(const io::Scene& scene, const BulkOrders& orders,
                                    const std::function<void(double)>& progress) {
  if (!scene.output.fraction_region)
    throw InputError(scene.file.string(), "found no output.fraction_region",
                     "the region whose solid fraction is compared");
  const bool is_first = rank_in(MPI_COMM_WORLD) == 0;
  std::vector<Ensemble> ensembles(orders.ranks.size() + 1);
  const double runs = static_cast<double>(orders.beginnings) * static_cast<double>(ensembles.size());
  double done = 0.0;
  const auto ran = [&] {
    done += 1.0;
    if (is_first) progress(done / runs);
  };
  for (int k = 0; k < orders.beginnings; ++k) {
    const io::Scene one = begun_otherwise(scene, k);
    if (is_first) ensembles[0].push_back(run_embedded(one));
    meet(MPI_COMM_WORLD);
    ran();
    for (std::size_t e = 0; e < orders.ranks.size(); ++e) {
      SceneOnRanks engine(orders.ranks[e], one);
      engine.advance(one.steps());
      const PairSums sums = engine.sums();
      const std::vector<BodyStart> bodies = engine.bodies(one.setup);
      if (is_first)
        ensembles[e + 1].push_back(
            bulk_of(one, bodies, {.viscous = sums.viscous_loss, .friction = sums.friction_loss}));
      ran();
    }
  }
  return ensembles;
}

}  // namespace osculate::lammps
