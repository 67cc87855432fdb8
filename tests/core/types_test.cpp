#include "osculate/core/types.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace osculate;

TEST_CASE("Poses ask for no alignment that depends on the compiler's flags") {
  STATIC_REQUIRE(alignof(Vec3) == alignof(double));
  STATIC_REQUIRE(alignof(Quat) == alignof(double));
  STATIC_REQUIRE(sizeof(Pose) == 7 * sizeof(double));
}

TEST_CASE("Eigen's own quaternions serve as orientations") {
  const Eigen::Quaterniond quarter(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ()));
  const Pose pose{.position = {1.0, 2.0, 3.0}, .orientation = quarter};
  CHECK((pose.to_world(Vec3::UnitX()) - Vec3(1.0, 3.0, 3.0)).norm() < 1e-15);
  CHECK((pose.to_body({1.0, 3.0, 3.0}) - Vec3::UnitX()).norm() < 1e-15);
}
