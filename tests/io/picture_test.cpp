#include "io/picture.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/picture_triangles.hpp"
#include "io/renderer.hpp"
#include "osculate/core/error.hpp"
#include "temporary.hpp"

using namespace osculate;
using Catch::Matchers::Contains;
using osculate::test::temporary;

namespace {

io::PictureBody ball(const Vec3& at, const io::Colour& colour, double opacity) {
  return {.mesh = surface_mesh(Sphere{1.0}, 16), .pose = {.position = at}, .colour = colour, .opacity = opacity};
}

/// 100 × 100 px of a world of 4 m, seen from +z, x to the right, y up.
const io::Projection from_above{
    .to_view = Mat3::Identity(), .centre = Vec3::Zero(), .scale = 25.0, .middle = {50, 50, 0}};

io::RenderScene scene_of(const std::vector<io::PictureBody>& bodies) {
  io::RenderScene scene{.opaque = {}, .translucent = {}, .on_top = {}, .width = 100, .height = 100};
  for (const auto& body : bodies) {
    add_body(body.opacity < 1.0 ? scene.translucent : scene.opaque, body, std::nullopt, from_above);
  }
  sort_by_depth(scene.translucent);
  return scene;
}

struct Pixel {
  int red, green, blue;
};

/// x to the right, y up, as in the world above.
Pixel at(const io::Image& image, int x, int y) {
  const std::size_t i = 3 * (static_cast<std::size_t>(image.height - 1 - y) * 100 + static_cast<std::size_t>(x));
  return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

constexpr io::Colour red{0.8, 0.0, 0.0}, blue{0.0, 0.0, 0.8};

}  // namespace

TEST_CASE("A nearer body hides a farther one whatever their order, and the background is white") {
  const auto near = ball({0, 0, 3}, red, 1.0), far = ball({1, 1, -3}, blue, 1.0);
  for (const auto& bodies : {std::vector{near, far}, std::vector{far, near}}) {
    const auto image = io::render(scene_of(bodies));
    CHECK(at(image, 50, 50).red > 2 * at(image, 50, 50).blue);
    CHECK(at(image, 60, 60).red > 2 * at(image, 60, 60).blue);  // covered by both
    CHECK(at(image, 85, 80).blue > 2 * at(image, 85, 80).red);  // x to the right, y up
    CHECK(at(image, 5, 5).red == 255);
    CHECK(at(image, 5, 5).green == 255);
  }
}

TEST_CASE("A translucent body lets the one behind show, whatever their order") {
  const auto near = ball({0, 0, 3}, red, 0.5), far = ball({0, 0, -3}, blue, 0.5);
  const auto image = io::render(scene_of({near, far}));
  const auto swapped = io::render(scene_of({far, near}));
  CHECK(image.pixels == swapped.pixels);
  CHECK(at(image, 50, 50).red > at(image, 50, 50).blue);
  CHECK(at(image, 50, 50).blue > at(image, 50, 50).green + 20);
}

TEST_CASE("Arrows, lines and points stand where the projection puts them") {
  io::RenderScene scene{.opaque = {}, .translucent = {}, .on_top = {}, .width = 100, .height = 100};
  add_arrow(scene.on_top, {.from = {-1.5, 0, 0}, .to = {1.5, 0, 0}, .colour = red, .width = 6.0}, from_above);
  add_point(scene.on_top, {.position = {0, 1, 0}, .colour = blue, .diameter = 10.0}, from_above);
  add_line(scene.opaque, {.points = {{-1, -1, 0}, {1, -1, 0}}, .colour = blue, .width = 5.0}, from_above);
  const auto image = io::render(scene);
  CHECK(at(image, 20, 50).green < 128);
  CHECK(at(image, 80, 50).green < 128);
  CHECK(at(image, 95, 50).green == 255);
  CHECK(at(image, 50, 75).red < 128);
  CHECK(at(image, 50, 25).red < 128);
  CHECK(at(image, 50, 35).red == 255);
}

TEST_CASE("viridis runs through the published ends and middle") {
  const auto near = [](const io::Colour& c, int rgb) {
    // 0.015 is the fit's stated error.
    CHECK(c.red == Approx(((rgb >> 16) & 255) / 255.0).margin(0.015));
    CHECK(c.green == Approx(((rgb >> 8) & 255) / 255.0).margin(0.015));
    CHECK(c.blue == Approx((rgb & 255) / 255.0).margin(0.015));
  };
  near(io::viridis(0.0), 0x440154);
  near(io::viridis(0.5), 0x21918c);
  near(io::viridis(1.0), 0xfde725);
}

TEST_CASE("A picture is a PNG of the size asked for") {
  io::Picture picture{.title = "Ball", .notes = {"2 m across"}, .width = 400, .height = 300};
  picture.bodies.push_back(ball(Vec3::Zero(), red, 1.0));
  picture.bodies.back().scalars.assign(picture.bodies.back().mesh.vertices.size(), 0.3);
  picture.colour_bar = {.title = "mean curvature (1/m)", .lower = 0.0, .upper = 1.0};
  picture.labels.push_back({.position = Vec3::Zero(), .text = "centre"});
  const auto path = temporary("picture_test.png");
  io::write_png(picture, path);
  std::ifstream file(path, std::ios::binary);
  std::string head(24, '\0');
  file.read(head.data(), 24);
  CHECK(head.substr(1, 3) == "PNG");
  CHECK(static_cast<unsigned char>(head[18]) * 256 + static_cast<unsigned char>(head[19]) == 400);
  CHECK(static_cast<unsigned char>(head[22]) * 256 + static_cast<unsigned char>(head[23]) == 300);
  std::filesystem::remove(path);
}

TEST_CASE("A picture that cannot be drawn is refused with the reason") {
  io::Picture picture;
  CHECK_THROWS_WITH(io::write_png(picture, "x.png"), Contains("no body"));
  picture.bodies.push_back(ball(Vec3::Zero(), red, 1.0));
  CHECK_THROWS_WITH(io::write_png(picture, "no/such/folder/x.png"), Contains("no/such/folder/x.png"));
  picture.view.towards_viewer = Vec3::UnitZ();
  CHECK_THROWS_WITH(io::write_png(picture, "x.png"), Contains("along its up direction"));
  picture.view = {};
  picture.bodies.back().scalars = {1.0};
  CHECK_THROWS_WITH(io::write_png(picture, "x.png"), Contains("1 scalars"));
}
