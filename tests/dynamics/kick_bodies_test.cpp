#include "dynamics/kick_bodies.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "osculate/dynamics/random.hpp"

using namespace osculate;

TEST_CASE("Wrenches of all chunks add up, and free bodies get their kick") {
  for (const std::size_t count : {1, 3, 4, 9}) {
    Random random(count);
    Bodies bodies;
    PairList pairs;
    pairs.chunks.resize(3);
    std::vector<Vec3> force(count, Vec3::Zero()), torque(count, Vec3::Zero());
    for (std::size_t i = 0; i < count; ++i) {
      bodies.motion.push_back(i % 3 == 1 ? 0 : Bodies::free);
      bodies.position.push_back(Vec3::Zero());
      bodies.orientation.push_back(random.orientation());
      bodies.velocity.push_back(random.direction());
      bodies.angular_momentum.push_back(random.direction());
      // What a driven body holds here must not matter.
      bodies.mass.push_back(bodies.is_free(i) ? random.uniform(1.0, 2.0) : 0.0);
      bodies.force.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
      bodies.torque.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
      for (std::size_t c = 0; c < 3; ++c) {
        if ((i + c) % 3 == 0 && c > 0) continue;  // a chunk without this body
        const Vec3 f = random.direction(), t = random.direction();
        pairs.chunks[c].bodies.push_back(static_cast<std::int32_t>(i));
        pairs.chunks[c].wrenches.push_back({{f.x(), f.y(), f.z(), 0.0, t.x(), t.y(), t.z(), 0.0}});
        force[i] += f, torque[i] += t;
      }
    }
    index_bodies(pairs, count);
    const Bodies before = bodies;
    const Kick kick{.time = 0.1, .gravity = {1.0, 2.0, -9.81}};
    kick_bodies(kick, 0, count, pairs, bodies);
    constexpr double round_off = 1e-14;  // numbers of order one
    for (std::size_t i = 0; i < count; ++i) {
      CHECK((bodies.force[i] - force[i]).norm() < round_off);
      CHECK((bodies.torque[i] - torque[i]).norm() < round_off);
      if (!before.is_free(i)) {
        CHECK(bodies.velocity[i] == before.velocity[i]);
        CHECK(bodies.angular_momentum[i] == before.angular_momentum[i]);
        continue;
      }
      const Vec3 velocity = before.velocity[i] + kick.time * (force[i] / before.mass[i] + kick.gravity);
      const Vec3 momentum = before.angular_momentum[i] + kick.time * (before.orientation[i].conjugate() * torque[i]);
      CHECK((bodies.velocity[i] - velocity).norm() < round_off);
      CHECK((bodies.angular_momentum[i] - momentum).norm() < round_off);
    }
  }
}
