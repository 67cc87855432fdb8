#include "io/picture_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace osculate::io {
namespace {

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

std::array<float, 4> floats(const Colour& colour, double opacity) {
  return {static_cast<float>(colour.red), static_cast<float>(colour.green), static_cast<float>(colour.blue),
          static_cast<float>(opacity)};
}

std::uint32_t count(const PictureTriangles& triangles) {
  return static_cast<std::uint32_t>(triangles.vertices.size());
}

constexpr int around = 24;  // sides of tubes and cones, few pixels wide

/// A surface of revolution between two rings, in pixels; a ring of radius 0 closes it.
void add_ring_pair(PictureTriangles& triangles, const Vec3& from, double from_radius, const Vec3& to, double to_radius,
                   const std::array<float, 4>& colour) {
  const Vec3 along = to - from;
  if (!(along.norm() > 0.0)) return;
  const Vec3 axis = along.normalized(), side = axis.unitOrthogonal(), other = axis.cross(side);
  const double slope = (from_radius - to_radius) / along.norm();
  const std::uint32_t first = count(triangles);
  for (int i = 0; i < around; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / around;
    const Vec3 out = std::cos(angle) * side + std::sin(angle) * other;
    const auto normal = floats(Vec3((out + slope * axis).normalized()));
    triangles.vertices.push_back({floats(Vec3(from + from_radius * out)), normal, colour});
    triangles.vertices.push_back({floats(Vec3(to + to_radius * out)), normal, colour});
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % around);
    triangles.triangles.insert(triangles.triangles.end(), {{a, b, a + 1}, {b, b + 1, a + 1}});
  }
}

void add_disc(PictureTriangles& triangles, const Vec3& centre, const Vec3& normal, double radius,
              const std::array<float, 4>& colour) {
  const Vec3 side = normal.unitOrthogonal(), other = normal.cross(side);
  const std::uint32_t first = count(triangles);
  triangles.vertices.push_back({floats(centre), floats(normal), colour});
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / around;
    const Vec3 rim = centre + radius * (std::cos(angle) * side + std::sin(angle) * other);
    triangles.vertices.push_back({floats(rim), floats(normal), colour});
    triangles.triangles.push_back({first, first + 1 + i, first + 1 + (i + 1) % around});
  }
}

void add_ball(PictureTriangles& triangles, const Vec3& centre, double radius, const std::array<float, 4>& colour) {
  constexpr int rings = around / 2;
  const std::uint32_t first = count(triangles);
  for (int i = 0; i <= rings; ++i) {
    const double polar = std::numbers::pi * i / rings;
    for (int j = 0; j < around; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / around;
      const Vec3 out(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
      triangles.vertices.push_back({floats(Vec3(centre + radius * out)), floats(out), colour});
    }
  }
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const std::uint32_t next = (j + 1) % around, a = first + i * around, b = a + around;
      triangles.triangles.insert(triangles.triangles.end(), {{a + j, b + j, b + next}, {a + j, b + next, a + next}});
    }
  }
}

}  // namespace

void add_body(PictureTriangles& triangles, const PictureBody& body, const std::optional<ColourBar>& bar,
              const Projection& projection) {
  const std::uint32_t first = count(triangles);
  for (std::size_t i = 0; i < body.mesh.vertices.size(); ++i) {
    const Colour colour = body.scalars.empty() || !bar
                              ? body.colour
                              : viridis((body.scalars[i] - bar->lower) / (bar->upper - bar->lower));
    triangles.vertices.push_back({floats(projection.point(body.pose.to_world(body.mesh.vertices[i]))),
                                  floats(projection.direction(body.pose.rotate_to_world(body.mesh.normals[i]))),
                                  floats(colour, body.opacity)});
  }
  for (const auto& corners : body.mesh.triangles) {
    std::array<std::uint32_t, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = first + static_cast<std::uint32_t>(corners[i]);
    triangles.triangles.push_back(triangle);
  }
}

void add_line(PictureTriangles& triangles, const PictureLine& line, const Projection& projection) {
  const auto colour = floats(line.colour, 1.0);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vec3 here = projection.point(line.points[i]);
    add_ball(triangles, here, 0.5 * line.width, colour);
    if (i == 0) continue;
    add_ring_pair(triangles, projection.point(line.points[i - 1]), 0.5 * line.width, here, 0.5 * line.width, colour);
  }
}

void add_arrow(PictureTriangles& triangles, const PictureArrow& arrow, const Projection& projection) {
  const auto colour = floats(arrow.colour, 1.0);
  const Vec3 from = projection.point(arrow.from), to = projection.point(arrow.to);
  const double length = (to - from).norm();
  if (!(length > 0.0)) return;
  const Vec3 axis = (to - from) / length;
  const double head = std::min(4.5 * arrow.width, 0.6 * length), head_radius = 0.36 * head;
  const Vec3 neck = to - head * axis;
  const double radius = std::min(0.5 * arrow.width, 0.6 * head_radius);
  add_disc(triangles, from, -axis, radius, colour);
  add_ring_pair(triangles, from, radius, neck, radius, colour);
  add_disc(triangles, neck, -axis, head_radius, colour);
  add_ring_pair(triangles, neck, head_radius, to, 0.0, colour);
}

void add_point(PictureTriangles& triangles, const PicturePoint& point, const Projection& projection) {
  add_ball(triangles, projection.point(point.position), 0.5 * point.diameter, floats(point.colour, 1.0));
}

void sort_by_depth(PictureTriangles& triangles) {
  const auto depth = [&](const std::array<std::uint32_t, 3>& corners) {
    float sum = 0.0F;
    for (const std::uint32_t corner : corners) sum += triangles.vertices[corner].position[2];
    return sum;
  };
  std::ranges::stable_sort(triangles.triangles, {}, depth);
}

}  // namespace osculate::io
