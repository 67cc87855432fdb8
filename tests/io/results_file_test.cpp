#include "io/results_file.hpp"

#include <hdf5.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "io/journaled_file.hpp"
#include "io/results_writer.hpp"
#include "osculate/core/error.hpp"
#include "temporary.hpp"

namespace osculate::io {
namespace {

using test::fresh_folder;

std::filesystem::path fresh_path(const std::string& name) {
  return fresh_folder("results_" + name) / name;
}

ResultsHead head_of_all_shapes() {
  PotentialParticle cube{.planes = {}, .sphericity = 0.3, .edge_radius = 1e-3, .sphere_radius = 4e-3};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) cube.planes.push_back({side * Vec3::Unit(axis), 2e-3 + 1e-4 * axis});
  const Pose frame{.position = {1e-4, -2e-4, 3e-4}, .orientation = Quat(0.5, 0.5, -0.5, 0.5)};
  ResultsHead head{.title = "all shapes",
                   .scene = "title = \"all shapes\"\n",
                   .shapes = {{"bead", Sphere{2e-3}, {}, "glass", 2500.0},
                              {"candy", Ellipsoid{{3e-3, 2e-3, 1e-3}}, {}, "glass", 2500.0},
                              {"box", Superquadric{{1e-3, 2e-3, 3e-3}, {6.0, 5.0}}, {}, "steel", 7800.0},
                              {"stone", cube, frame, "steel", 7800.0}},
                   .walls = {{"floor", 0, HalfSpace{}},
                             {"drum", 1, Cylinder{0.05, Cylinder::Solid::outside}},
                             {"rod", 2, Cylinder{0.01, Cylinder::Solid::inside}},
                             {"bowl", 3, SphereContainer{0.1}}},
                   .box = {.origin = {0, 0, -1}, .length = {0.1, 0.2, std::numeric_limits<double>::infinity()}},
                   .gravity = {0, 0, -9.81},
                   .time_step = 1e-6};
  return head;
}

ParticleFrame frame_at(std::uint64_t step, std::size_t count) {
  ParticleFrame frame{.time = 1e-6 * static_cast<double>(step),
                      .step = step,
                      .id = {},
                      .shape = {},
                      .position = {},
                      .orientation = {},
                      .velocity = {},
                      .angular_velocity = {},
                      .walls = std::vector<Pose>(4)};
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(i + 1), t = static_cast<double>(step);
    frame.id.push_back(static_cast<std::uint32_t>(i + 4));
    frame.shape.push_back(static_cast<std::uint32_t>(i % 4));
    frame.position.emplace_back(1.0 / x, t / 3.0, -x);
    frame.orientation.push_back(Quat(x, t, 1.0, 2.0).normalized());
    frame.velocity.emplace_back(t / x, 0.1, 0.2);
    frame.angular_velocity.emplace_back(x / 7.0, t, 1e-30);
  }
  frame.walls[1].position = {0.1, 0.2, 0.3};
  frame.walls[1].orientation = Quat(0.6, 0.0, 0.8, 0.0);
  return frame;
}

NumberTable rows_at(double first, std::size_t count) {
  NumberTable rows{{"time", "kinetic"}, {{}, {}}};
  for (std::size_t i = 0; i < count; ++i) {
    rows.columns[0].push_back(first + static_cast<double>(i));
    rows.columns[1].push_back(100.0 * (first + static_cast<double>(i)));
  }
  return rows;
}

void require_equal(const ParticleFrame& one, const ParticleFrame& two) {
  CHECK(one.time == two.time);
  CHECK(one.step == two.step);
  CHECK(one.id == two.id);
  CHECK(one.shape == two.shape);
  CHECK(one.position == two.position);
  CHECK(one.velocity == two.velocity);
  CHECK(one.angular_velocity == two.angular_velocity);
  REQUIRE(one.orientation.size() == two.orientation.size());
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one.orientation[i].coeffs() == two.orientation[i].coeffs());
  REQUIRE(one.walls.size() == two.walls.size());
  for (std::size_t i = 0; i < one.walls.size(); ++i) {
    CHECK(one.walls[i].position == two.walls[i].position);
    CHECK(one.walls[i].orientation.coeffs() == two.walls[i].orientation.coeffs());
  }
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
void put_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("A results file gives back what was written, bit by bit") {
  const auto path = fresh_path("round_trip.h5");
  const ResultsHead head = head_of_all_shapes();
  const ContactFrame contacts{.bodies = {{4, 5}, {0, 4}},
                              .point = {{1, 2, 3}, {4, 5, 6}},
                              .normal = {{1, 0, 0}, {0, 0, 1}},
                              .overlap = {1e-6, 2e-6},
                              .force = {{-1, 0, 0}, {0, 0.5, -2}}};
  {
    ResultsWriter writer(path, head, {"time", "kinetic"});
    writer.append(frame_at(0, 5), {}, rows_at(0.0, 1));
    writer.append(frame_at(1000, 500), contacts, rows_at(1.0, 700));
  }
  const ResultsFile file(path);
  CHECK(file.head().title == head.title);
  CHECK(file.head().scene == head.scene);
  CHECK(file.head().gravity == head.gravity);
  CHECK(file.head().box.length == head.box.length);
  CHECK(file.head().box.origin == head.box.origin);
  CHECK(file.head().time_step == head.time_step);
  REQUIRE(file.shapes().size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(file.shapes()[i].name == head.shapes[i].name);
    CHECK(kind(file.shapes()[i].shape) == kind(head.shapes[i].shape));
    CHECK(file.shapes()[i].material == head.shapes[i].material);
    CHECK(file.shapes()[i].density == head.shapes[i].density);
    CHECK(file.shapes()[i].frame.position == head.shapes[i].frame.position);
    // The surface in a direction is decided by every number of a shape.
    const Vec3 direction(0.3, -0.5, 0.7);
    CHECK(support_point(file.shapes()[i].shape, direction) == support_point(head.shapes[i].shape, direction));
  }
  REQUIRE(file.walls().size() == 4);
  CHECK(file.walls()[2].name == "rod");
  CHECK(file.walls()[2].id == 2);
  CHECK(std::get<Cylinder>(file.walls()[2].shape).solid == Cylinder::Solid::inside);
  CHECK(std::get<Cylinder>(file.walls()[1].shape).solid == Cylinder::Solid::outside);
  CHECK(std::get<SphereContainer>(file.walls()[3].shape).radius == 0.1);
  REQUIRE(file.frame_count() == 2);
  require_equal(file.frame(0), frame_at(0, 5));
  require_equal(file.frame(1), frame_at(1000, 500));
  CHECK_FALSE(file.has_contacts(0));
  REQUIRE(file.has_contacts(1));
  CHECK(file.contacts(1).bodies == contacts.bodies);
  CHECK(file.contacts(1).point == contacts.point);
  CHECK(file.contacts(1).normal == contacts.normal);
  CHECK(file.contacts(1).overlap == contacts.overlap);
  CHECK(file.contacts(1).force == contacts.force);
  const NumberTable series = file.series();
  CHECK(series.names == std::vector<std::string>{"time", "kinetic"});
  REQUIRE(series.rows() == 701);
  CHECK(series.columns[1][700] == 70000.0);
  CHECK_THROWS_WITH(file.frame(2), Catch::Contains("frame 2") && Catch::Contains("0 to 1"));
  CHECK_THROWS_WITH(file.contacts(0), Catch::Contains("no contacts in frame 0"));
}

TEST_CASE("Meshes and a box's shear stand in the results, and frames without particles") {
  const auto path = fresh_path("meshes.h5");
  ResultsHead head = head_of_all_shapes();
  head.meshes = {{"funnel",
                  7,
                  {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}, {1, 1, 0.1}}, .triangles = {{0, 1, 2}, {1, 3, 2}}}}};
  head.box.shear = BoxShear{.flow = 1, .gradient = 0, .rate = -3.5};
  ParticleFrame empty = frame_at(0, 0), later = frame_at(10, 3);
  empty.meshes = {Pose{}};
  later.meshes = {Pose{.position = {0.1, 0.2, 0.3}, .orientation = Quat(0.6, 0.0, 0.8, 0.0)}};
  {
    ResultsWriter writer(path, head, {"time", "kinetic"});
    writer.append(empty, {}, rows_at(0.0, 1));
    writer.append(later, {}, rows_at(1.0, 1));
  }
  const ResultsFile file(path);
  REQUIRE(file.head().meshes.size() == 1);
  CHECK(file.head().meshes[0].name == "funnel");
  CHECK(file.head().meshes[0].id == 7);
  CHECK(file.head().meshes[0].triangles.vertices == head.meshes[0].triangles.vertices);
  CHECK(file.head().meshes[0].triangles.triangles == head.meshes[0].triangles.triangles);
  REQUIRE(file.head().box.shear);
  CHECK(file.head().box.shear->flow == 1);
  CHECK(file.head().box.shear->gradient == 0);
  CHECK(file.head().box.shear->rate == -3.5);
  CHECK(file.frame(0).size() == 0);
  require_equal(file.frame(1), later);
  REQUIRE(file.frame(1).meshes.size() == 1);
  CHECK(file.frame(1).meshes[0].position == later.meshes[0].position);
  CHECK(file.frame(1).meshes[0].orientation.coeffs() == later.meshes[0].orientation.coeffs());
}

TEST_CASE("Going on from an earlier frame cuts off what came after it") {
  const auto path = fresh_path("cut.h5");
  {
    ResultsWriter writer(path, head_of_all_shapes(), {"time", "kinetic"});
    for (std::uint64_t i = 0; i < 5; ++i) writer.append(frame_at(i, 100), {}, rows_at(static_cast<double>(i), 1));
  }
  {
    ResultsWriter writer(path, 2, 2);
    CHECK(writer.frames() == 2);
    writer.append(frame_at(77, 90), {}, rows_at(77.0, 1));
  }
  {
    const ResultsFile file(path);
    REQUIRE(file.frame_count() == 3);
    require_equal(file.frame(1), frame_at(1, 100));
    require_equal(file.frame(2), frame_at(77, 90));
    CHECK(file.series().columns[0] == std::vector<double>{0.0, 1.0, 77.0});
  }
  CHECK_THROWS_WITH(ResultsWriter(path, 4, 2), Catch::Contains("3 frames"));
}

TEST_CASE("Results can be read while they are being written") {
  const auto path = fresh_path("live.h5");
  ResultsWriter writer(path, head_of_all_shapes(), {"time", "kinetic"});
  CHECK(ResultsFile(path).frame_count() == 0);
  writer.append(frame_at(0, 200), {}, rows_at(0.0, 1));
  const ResultsFile early(path);
  CHECK(early.frame_count() == 1);
  writer.append(frame_at(1, 200), {}, rows_at(1.0, 1));
  require_equal(early.frame(0), frame_at(0, 200));
  CHECK(ResultsFile(path).frame_count() == 2);
}

TEST_CASE("The file is plain HDF5: the library's own driver reads it") {
  const auto path = fresh_path("plain.h5");
  {
    ResultsWriter writer(path, head_of_all_shapes(), {"time", "kinetic"});
    writer.append(frame_at(0, 100), {}, rows_at(0.0, 1));
  }
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  REQUIRE(file >= 0);
  CHECK(H5Lexists(file, "frames/000000/position", H5P_DEFAULT) > 0);
  H5Fclose(file);
}

TEST_CASE("A crash while the file changes loses at most the frame being written") {
  // A write is: append, journal, apply, remove the journal. Stopped after each, the file is as before or as after.
  const auto path = fresh_path("crash.h5");
  const auto journal = journal_path(path);
  ResultsWriter writer(path, head_of_all_shapes(), {"time", "kinetic"});
  writer.append(frame_at(0, 300), {}, rows_at(0.0, 1));
  const std::string before = bytes_of(path);
  // The journal's path is taken by a folder: the file system refuses where a crash would have come.
  std::filesystem::create_directory(journal);
  CHECK_THROWS_WITH(writer.append(frame_at(1, 300), {}, rows_at(1.0, 1)), Catch::Contains(journal.string()));
  std::filesystem::remove(journal);
  const std::string appended = bytes_of(path);
  CHECK(appended.substr(0, before.size()) == before);
  const auto copy = fresh_path("crash_copy.h5");
  put_bytes(copy, appended);
  CHECK(ResultsFile(copy).frame_count() == 1);
  require_equal(ResultsFile(copy).frame(0), frame_at(0, 300));

  SECTION("a journal that ends early is dropped") {
    put_bytes(copy, appended);
    put_bytes(journal_path(copy), std::string(1000, 'x'));
    CHECK(ResultsFile(copy).frame_count() == 1);
    CHECK_FALSE(std::filesystem::exists(journal_path(copy)));
  }
}

TEST_CASE("What is no results file is refused with a reason") {
  const auto path = fresh_path("wrong.h5");
  CHECK_THROWS_WITH(ResultsFile(path), Catch::Contains("no such file"));
  put_bytes(path, "not HDF5");
  CHECK_THROWS_WITH(ResultsFile(path), Catch::Contains("no HDF5"));
  const hid_t other = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(other);
  CHECK_THROWS_WITH(ResultsFile(path), Catch::Contains("no mark of a results file"));
  CHECK_THROWS_AS(ResultsWriter("/proc/no/such/folder.h5", head_of_all_shapes(), {}), InputError);
}

}  // namespace osculate::io
