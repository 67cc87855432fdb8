// The narrow phase has no state of its own: callers may share it among threads. For the thread sanitizer (preset tsan),
// which sees std::thread; answers must be the same bits besides.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <thread>
#include <vector>

#include "osculate/geometry/common_normal.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"
#include "osculate/shapes/shape.hpp"

using namespace osculate;

namespace {

struct Found {
  ContactCaches caches;
  ContactColumns cold, warm;
  ContactGeometry with_plane;
};

SuperquadricPairs some_pairs() {
  const std::vector<Superquadric> shapes{{{1.0, 1.0, 1.0}, {2.0, 2.0}},
                                         {{1.0, 0.8, 1.5}, {4.0, 4.0}},
                                         {{1.2, 1.0, 0.5}, {2.7, 3.1}},
                                         {{1.0, 1.0, 1.0}, {1.4, 1.6}}};
  constexpr std::size_t count = 60;
  SuperquadricPairs pairs;
  pairs.resize(count);
  const auto turned = [](double angle) {
    return Quat(Eigen::AngleAxisd(angle, Vec3(std::cos(2.0 * angle), std::sin(3.0 * angle), 0.5).normalized()));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(i);
    const Vec3 direction = Vec3(std::cos(x), std::sin(x), std::cos(0.7 * x)).normalized();
    pairs.set(i, shapes[i % 4], {.position = Vec3::Zero(), .orientation = turned(x)}, shapes[i / 4 % 4],
              {.position = (1.0 + 0.02 * x) * direction, .orientation = turned(x + 0.5)});
  }
  return pairs;
}

Found find(const SuperquadricPairs& pairs) {
  Found found;
  common_normals(pairs, found.caches, found.cold);
  common_normals(pairs, found.caches, found.warm);
  const Pose above{.position = {0.0, 0.0, 0.6}, .orientation = Quat::Identity()};
  found.with_plane = common_normal(HalfSpace{}, Pose{}, Superquadric{{1.0, 0.8, 0.7}, {3.0, 3.0}}, above);
  return found;
}

}  // namespace

TEST_CASE("Several threads at once find the contacts that one finds") {
  const SuperquadricPairs pairs = some_pairs();
  std::vector<Found> found(4);
  {
    std::vector<std::jthread> threads;
    for (Found& one : found) threads.emplace_back([&] { one = find(pairs); });
  }
  const Found alone = find(pairs);
  CHECK(std::count(alone.cold.statuses.begin(), alone.cold.statuses.end(), ContactStatus::touching) > 20);
  for (const Found& one : found) {
    CHECK(one.cold.statuses == alone.cold.statuses);
    CHECK(one.with_plane.overlap == alone.with_plane.overlap);
    for (std::size_t k = 0; k < 25; ++k)
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        CHECK(one.cold.columns[k][i] == alone.cold.columns[k][i]);
        CHECK(one.warm.columns[k][i] == alone.warm.columns[k][i]);
      }
  }
}
