#include "io/assembly_picture.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "io/particle_values.hpp"
#include "io/results_samples.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;
using namespace osculate::io;
using Catch::Matchers::Contains;

namespace {

AssemblyLook look_at(const ParticleFrame& frame, const ResultsHead& head, ParticleColour colour) {
  return {.title = head.title, .colour = colour, .most = 0.5, .extent = extent_of(frame, head)};
}

}  // namespace

TEST_CASE("A picture holds one mesh a shape and every particle once, where its shape is") {
  const ParticleFrame frame = sample_frame();
  const ResultsHead head = sample_head();
  const Picture picture = assembly_picture(frame, head, look_at(frame, head, ParticleColour::speed));
  REQUIRE(picture.swarms.size() == 4);
  CHECK(picture.swarms[0].poses.size() == 2);  // particles 0 and 4 are cylinders
  CHECK(picture.swarms[3].poses[0].position == shape_pose_of(frame, head, 3).position);
  REQUIRE(picture.colour_bar);
  CHECK(picture.colour_bar->title == "speed (mm/s)");
  CHECK(picture.colour_bar->upper == Approx(500.0));
  CHECK(picture.swarms[2].scalars[0] == Approx(1e3 * frame.velocity[2].norm()));
}

TEST_CASE("The floor shows as far as the particles reach") {
  const ParticleFrame frame = sample_frame();
  const ResultsHead head = sample_head();
  const Picture picture = assembly_picture(frame, head, look_at(frame, head, ParticleColour::shape));
  CHECK_FALSE(picture.colour_bar);
  REQUIRE(picture.bodies.size() == 1);
  for (const Vec3& corner : picture.bodies[0].mesh.vertices) CHECK(std::fabs(corner.z()) < 1e-15);
}

TEST_CASE("A drum is seen all around unless it is far larger than what it holds") {
  ResultsHead head = sample_head();
  const Quat along_y = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY());
  ParticleFrame frame = sample_frame();
  frame.walls = {{Vec3(0.04, 0.3, 0.05), along_y}};
  head.walls = {{"drum", 0, Cylinder{0.06, Cylinder::Solid::outside}}};
  const Box near = extent_of(frame, head);
  CHECK(near.lower.z() == Approx(-0.01));
  CHECK(near.upper.z() == Approx(0.11));
  head.walls = {{"drum", 0, Cylinder{6.0, Cylinder::Solid::outside}}};
  const Box far = extent_of(frame, head);
  CHECK(far.upper.z() < 0.02);
  CHECK(near.upper.y() == far.upper.y());  // along its axis a drum ends nowhere
}

TEST_CASE("A mesh is seen through, with the edges where it turns") {
  ResultsHead head = sample_head();
  ParticleFrame frame = sample_frame();
  // A square of two triangles and a third one upright on its side.
  head.meshes = {{"tray",
                  1,
                  {.vertices = {{0, 0, 0}, {0.04, 0, 0}, {0.04, 0.04, 0}, {0, 0.04, 0}, {0, 0, 0.04}},
                   .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}}}}};
  frame.meshes = {{.position = {0.0, 0.0, 0.001}}};
  const Picture before = assembly_picture(frame, sample_head(), look_at(frame, sample_head(), ParticleColour::shape));
  const Picture picture = assembly_picture(frame, head, look_at(frame, head, ParticleColour::shape));
  REQUIRE(picture.bodies.size() == before.bodies.size() + 1);
  const PictureBody& mesh = picture.bodies.back();
  CHECK(mesh.opacity < 1.0);
  CHECK(mesh.mesh.triangles.size() == 3);
  for (const Vec3& normal : mesh.mesh.normals) CHECK(normal.dot(picture.view.towards_viewer) >= 0.0);
  CHECK(mesh.mesh.vertices[0].z() == Approx(0.001));
  CHECK(picture.lines.size() == before.lines.size() + 6);  // all but the diagonal of the square
}

TEST_CASE("Kinetic energy has a part of motion and one of rotation") {
  ParticleFrame frame = sample_frame();
  const ResultsHead head = sample_head();
  frame.shape = {2, 2, 2, 2, 2};  // balls of steel
  const double mass = 7800.0 * mass_properties(head.shapes[2].shape).volume;
  const std::vector<double> energies = kinetic_energies(frame, head);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const double expected = 0.5 * mass * frame.velocity[i].squaredNorm() +
                            0.5 * 0.4 * mass * 2e-3 * 2e-3 * frame.angular_velocity[i].squaredNorm();
    CHECK(energies[i] == Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("What cannot be pictured is said") {
  const ResultsHead head = sample_head();
  CHECK_THROWS_WITH(extent_of(ParticleFrame{}, head), Contains("a frame without particles"));
  const ParticleFrame frame = sample_frame();
  AssemblyLook look = look_at(frame, head, ParticleColour::id);
  look.elevation = 90.0;
  CHECK_THROWS_WITH(assembly_picture(frame, head, look), Contains("an elevation of 90°"));
}
