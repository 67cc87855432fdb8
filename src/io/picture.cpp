#include "io/picture.hpp"

#include <fmt/format.h>

#include "io/picture_annotation.hpp"
#include "io/picture_triangles.hpp"
#include "io/renderer.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

void validate(const Picture& picture) {
  const auto refuse = [](const std::string& found, const std::string& expected) {
    throw InputError("picture", "found " + found, expected);
  };
  if (picture.bodies.empty() && picture.swarms.empty()) refuse("no body", "at least one");
  for (const int side : {picture.width, picture.height}) {
    if (side < 200 || side > 5000) refuse(fmt::format("a side of {} px", side), "200 to 5000 px");
  }
  for (const PictureBody& body : picture.bodies) {
    if (body.mesh.vertices.empty()) refuse("a body without surface", "a mesh");
    if (body.scalars.empty()) continue;
    if (body.scalars.size() != body.mesh.vertices.size()) {
      refuse(fmt::format("{} scalars on {} vertices", body.scalars.size(), body.mesh.vertices.size()), "one a vertex");
    }
    if (!picture.colour_bar) refuse("scalars but no colour bar", "a colour bar, which says what they are");
  }
  for (const PictureSwarm& swarm : picture.swarms) {
    if (swarm.mesh.vertices.empty()) refuse("a swarm without surface", "a mesh");
    const std::size_t given = swarm.scalars.empty() ? swarm.colours.size() : swarm.scalars.size();
    if (given != swarm.poses.size()) {
      refuse(fmt::format("{} colours or scalars for {} bodies", given, swarm.poses.size()), "one a body");
    }
    if (!swarm.scalars.empty() && !picture.colour_bar) {
      refuse("scalars but no colour bar", "a colour bar, which says what they are");
    }
  }
  if (picture.colour_bar && !(picture.colour_bar->upper > picture.colour_bar->lower)) {
    refuse(fmt::format("a colour bar from {} to {}", picture.colour_bar->lower, picture.colour_bar->upper),
           "an upper end above the lower");
  }
  const PictureView& view = picture.view;
  if (!(view.towards_viewer.cross(view.up).norm() > 1e-6 * view.towards_viewer.norm() * view.up.norm())) {
    refuse("a view along its up direction", "two directions that are not parallel");
  }
}

RenderSwarm render_swarm(const PictureSwarm& swarm, const std::optional<ColourBar>& bar, const Projection& projection) {
  RenderSwarm drawn{swarm.mesh, projection.scale, {}};
  drawn.instances.reserve(swarm.poses.size());
  for (std::size_t i = 0; i < swarm.poses.size(); ++i) {
    const Colour colour = swarm.scalars.empty() || !bar
                              ? swarm.colours[i]
                              : viridis((swarm.scalars[i] - bar->lower) / (bar->upper - bar->lower));
    drawn.instances.push_back({projection.to_view * swarm.poses[i].orientation.toRotationMatrix(),
                               projection.point(swarm.poses[i].position), colour});
  }
  return drawn;
}

/// The bodies seen along the view: in the middle of the free part of the picture, filling it.
Projection fit(const Picture& picture) {
  const Frame frame = free_frame(picture);
  const Vec3 towards = picture.view.towards_viewer.normalized();
  const Vec3 right = picture.view.up.cross(towards).normalized();
  Projection projection;
  projection.to_view.row(0) = right;
  projection.to_view.row(1) = towards.cross(right);
  projection.to_view.row(2) = towards;

  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const auto hold = [&](const Vec3& point) {
    const Vec3 seen = projection.to_view * point;
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  };
  if (picture.view.shows.empty()) {
    for (const PictureBody& body : picture.bodies) {
      for (const Vec3& vertex : body.mesh.vertices) hold(body.pose.to_world(vertex));
    }
    for (const PictureSwarm& swarm : picture.swarms) {
      for (const Pose& pose : swarm.poses) {
        for (const Vec3& vertex : swarm.mesh.vertices) hold(pose.to_world(vertex));
      }
    }
  }
  for (const Vec3& point : picture.view.shows) hold(point);
  projection.centre = picture.view.centre.value_or(projection.to_view.transpose() * (0.5 * (low + high)));
  const Vec3 extent = high - low;
  projection.scale = picture.view.half_height ? 0.5 * frame.height / *picture.view.half_height
                                              : std::min(frame.width / extent.x(), frame.height / extent.y());
  projection.middle = Vec3(frame.left + 0.5 * frame.width, picture.height - frame.top - 0.5 * frame.height, 0.0);
  return projection;
}

}  // namespace

void write_png(const Picture& picture, const std::filesystem::path& path) {
  validate(picture);
  const Projection projection = fit(picture);
  RenderScene scene{.opaque = {},
                    .translucent = {},
                    .on_top = {},
                    .width = picture.width,
                    .height = picture.height,
                    .shade_radius = projection.scale * picture.shade_radius};
  for (const PictureSwarm& swarm : picture.swarms) {
    scene.swarms.push_back(render_swarm(swarm, picture.colour_bar, projection));
  }
  for (const PictureBody& body : picture.bodies) {
    add_body(body.opacity < 1.0 ? scene.translucent : scene.opaque, body, picture.colour_bar, projection);
  }
  const auto part_of = [&](Depth depth) -> PictureTriangles& {
    return depth == Depth::always_seen ? scene.on_top : scene.opaque;
  };
  for (const PictureLine& line : picture.lines) add_line(part_of(line.depth), line, projection);
  for (const PictureArrow& arrow : picture.arrows) add_arrow(part_of(arrow.depth), arrow, projection);
  for (const PicturePoint& point : picture.points) add_point(part_of(point.depth), point, projection);
  sort_by_depth(scene.translucent);
  add_axes(scene.on_top, projection);
  write_annotated(render(scene), picture, projection, path);
}

}  // namespace osculate::io
