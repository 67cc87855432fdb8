#include "lammps/trajectories.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>

#include "lammps/scene_on_ranks.hpp"

namespace osculate::lammps {
namespace {

constexpr double parted = 1e-3;

Setup nudged(Setup setup) {
  for (BodyStart& body : setup.bodies) {
    if (body.motion != Bodies::free) continue;
    for (double& x : body.pose.position) x = std::nextafter(x, std::numeric_limits<double>::infinity());
  }
  return setup;
}

/// The library's engine, its nudged twin, and who met whom.
class Reference {
 public:
  explicit Reference(const io::Scene& scene)
      : speed_(scene.speed), simulation_(scene.setup), twin_(nudged(scene.setup)), met_(scene.setup.bodies.size()) {}

  void advance(std::uint64_t steps) {
    simulation_.advance(steps);
    twin_.advance(steps);
    for (const Contact& contact : simulation_.contacts()) {
      met_[static_cast<std::size_t>(contact.body_1)].insert(contact.body_2);
      met_[static_cast<std::size_t>(contact.body_2)].insert(contact.body_1);
    }
  }

  TrajectoryRow row() const {
    const auto count = [&](auto&& condition) {
      std::size_t found = 0;
      for (std::size_t i = 0; i < met_.size(); ++i)
        if (simulation_.bodies().is_free(i) && condition(i)) ++found;
      return found;
    };
    return {.time = simulation_.time(),
            .single = count([&](std::size_t i) { return is_single(i); }),
            .met = count([&](std::size_t i) { return !met_[i].empty(); }),
            .free = count([](std::size_t) { return true; }),
            .nudged = from(bodies_of(twin_)),
            .lammps = {}};
  }

  Difference from(const std::vector<BodyStart>& other) const {
    Difference most;
    for (std::size_t i = 0; i < other.size(); ++i) {
      if (!simulation_.bodies().is_free(i)) continue;
      const double one = difference(i, other[i]);
      most.all = std::max(most.all, one);
      if (is_single(i)) most.single = std::max(most.single, one);
    }
    return most;
  }

 private:
  bool is_single(std::size_t i) const {
    if (met_[i].size() != 1) return false;
    const auto other = static_cast<std::size_t>(*met_[i].begin());
    return !simulation_.bodies().is_free(other) || met_[other].size() == 1;
  }

  double difference(std::size_t i, const BodyStart& other) const {
    const Bodies& bodies = simulation_.bodies();
    const double radius = simulation_.shapes()[static_cast<std::size_t>(bodies.shape[i])].bounding_radius;
    Vec3 way = other.pose.position - bodies.position[i];
    way += nearest_image_shift(simulation_.setup().box, way);
    const auto largest = [](const auto& v) { return v.cwiseAbs().maxCoeff(); };
    return std::max({largest(way) / radius, largest(other.velocity - bodies.velocity[i]) / speed_,
                     largest(other.angular_velocity - bodies.angular_velocity(i)) * radius / speed_,
                     largest(other.pose.orientation.coeffs() - bodies.orientation[i].coeffs())});
  }

  double speed_;
  Simulation simulation_, twin_;
  std::vector<std::set<std::int32_t>> met_;  ///< by each body
};

bool all_parted(const TrajectoryRow& row) {
  return row.nudged.all > parted &&
         std::all_of(row.lammps.begin(), row.lammps.end(), [](const Difference& one) { return one.all > parted; });
}

}  // namespace

void follow_trajectories(const io::Scene& scene, const TrajectoryOrders& orders,
                         const std::function<void(const TrajectoryRow&)>& look) {
  std::optional<Reference> reference;
  if (rank_in(MPI_COMM_WORLD) == 0) reference.emplace(scene);
  std::vector<std::unique_ptr<SceneOnRanks>> engines;
  for (const int ranks : orders.ranks) engines.push_back(std::make_unique<SceneOnRanks>(ranks, scene));
  int going_on = 1;
  for (std::uint64_t step = 0; step < orders.steps && going_on != 0; step += orders.every) {
    const std::uint64_t count = std::min(orders.every, orders.steps - step);
    if (reference) reference->advance(count);
    meet(MPI_COMM_WORLD);
    std::optional<TrajectoryRow> row;
    if (reference) row = reference->row();
    for (const auto& engine : engines) {
      engine->advance(count);
      const std::vector<BodyStart> bodies = engine->bodies(scene.setup);
      if (row) row->lammps.push_back(reference->from(bodies));
    }
    if (row) {
      look(*row);
      going_on = all_parted(*row) || (row->met == row->free && row->single == 0) ? 0 : 1;
    }
    MPI_Bcast(&going_on, 1, MPI_INT, 0, MPI_COMM_WORLD);
  }
}

}  // namespace osculate::lammps
