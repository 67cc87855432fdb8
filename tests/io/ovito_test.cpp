#include "io/ovito.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "io/particle_values.hpp"
#include "io/results_samples.hpp"

using namespace osculate;
using namespace osculate::io;

namespace {

/// OVITO's form of a superquadric at a point of the particle's frame; 1 on the surface.
double ovito_form(const OvitoShape& s, const Vec3& x) {
  const Vec3 r = x.cwiseQuotient(s.half_axes).cwiseAbs();
  return std::pow(std::pow(r.x(), 2.0 / s.phi) + std::pow(r.y(), 2.0 / s.phi), s.phi / s.theta) +
         std::pow(r.z(), 2.0 / s.theta);
}

}  // namespace

TEST_CASE("OVITO draws an upright cylinder for n1 = 8, n2 = 2: round seen along z, flat at its ends") {
  const Superquadric cylinder{{2e-3, 2e-3, 4e-3}, {8.0, 2.0}};
  const OvitoShape drawn = ovito_shape(cylinder);
  CHECK(drawn.phi == 1.0);
  CHECK(drawn.theta == 0.25);
  CHECK_FALSE(drawn.is_stand_in);
  OvitoShape swapped = drawn;
  std::swap(swapped.phi, swapped.theta);
  double worst_of_swapped = 0.0;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 6; ++j) {
      const double polar = 0.1 + 0.5 * j, around = 0.3 + 0.5 * i;
      const Vec3 ray(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
      const Vec3 on_surface = ray / gauge(cylinder, ray).value;
      CHECK(ovito_form(drawn, on_surface) == Approx(1.0).epsilon(1e-13));
      worst_of_swapped = std::max(worst_of_swapped, std::fabs(ovito_form(swapped, on_surface) - 1.0));
    }
  }
  CHECK(worst_of_swapped > 0.5);  // the test would tell
}

TEST_CASE("A shape that OVITO lacks becomes the ball of its volume, and says so") {
  const ResultsHead head = sample_head();
  const OvitoShape stone = ovito_shape(head.shapes[3].shape);
  CHECK(stone.is_stand_in);
  const double ball = mass_properties(Shape(Sphere{stone.half_axes.x()})).volume;
  CHECK(ball == Approx(mass_properties(head.shapes[3].shape).volume).epsilon(1e-12));
}

TEST_CASE("A dump's columns carry every particle under OVITO's names") {
  ResultsHead head = sample_head();
  head.box = {.origin = {0, 0, -1}, .length = {0.1, 0.2, std::numeric_limits<double>::infinity()}};
  const ParticleFrame frame = sample_frame();
  std::istringstream dump(dump_block(frame, head));
  std::string line;
  const auto next = [&] {
    REQUIRE(std::getline(dump, line));
    return line;
  };
  CHECK(next() == "ITEM: TIME");
  CHECK(next() == "0.25");
  CHECK(next() == "ITEM: TIMESTEP");
  CHECK(next() == "1000");
  CHECK(next() == "ITEM: NUMBER OF ATOMS");
  CHECK(next() == "5");
  CHECK(next() == "ITEM: BOX BOUNDS pp pp ff");
  CHECK(next().starts_with("0 0.1"));
  CHECK(next().starts_with("0 0.2"));
  next();
  CHECK(next() ==
        "ITEM: ATOMS id type x y z vx vy vz AngularVelocity.X AngularVelocity.Y AngularVelocity.Z AsphericalShape.X "
        "AsphericalShape.Y AsphericalShape.Z Orientation.X Orientation.Y Orientation.Z Orientation.W "
        "SuperquadricRoundness.Phi SuperquadricRoundness.Theta");
  for (std::size_t i = 0; i < frame.size(); ++i) {
    std::istringstream row(next());
    std::uint32_t id = 0, type = 0;
    double x[18];
    REQUIRE(row >> id >> type);
    for (double& value : x) REQUIRE(row >> value);
    CHECK(id == frame.id[i]);
    CHECK(type == frame.shape[i] + 1);
    const Pose pose = shape_pose_of(frame, head, i);
    constexpr double nine_digits = 1e-8;
    CHECK((Vec3(x[0], x[1], x[2]) - pose.position).norm() < nine_digits);
    CHECK((Vec3(x[3], x[4], x[5]) - frame.velocity[i]).norm() < nine_digits);
    CHECK((Vec3(x[6], x[7], x[8]) - frame.angular_velocity[i]).norm() < 10.0 * nine_digits);
    CHECK(Quat(x[15], x[12], x[13], x[14]).angularDistance(pose.orientation) < 10.0 * nine_digits);
  }
}
