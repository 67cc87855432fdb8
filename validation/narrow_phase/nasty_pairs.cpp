#include "validation/narrow_phase/nasty_pairs.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "validation/narrow_phase/contact_checks.hpp"
#include "validation/narrow_phase/plain_superquadric.hpp"

namespace osculate::validation {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

struct NamedShape {
  const char* name;
  Superquadric shape;
};

std::vector<NamedShape> nasty_shapes() {
  return {{"sphere", {.half_axes = {1, 1, 1}, .exponents = {2, 2}}},
          {"ellipsoid", {.half_axes = {1, 2, 3}, .exponents = {2, 2}}},
          {"box", {.half_axes = {1, 1.5, 2}, .exponents = {6, 6}}},
          {"cube n=64", {.half_axes = {1, 1, 1}, .exponents = {64, 64}}},
          {"cylinder", {.half_axes = {1, 1, 1.5}, .exponents = {8, 2}}},
          {"disc", {.half_axes = {10, 10, 0.1}, .exponents = {20, 2}}},
          {"needle 1e3", {.half_axes = {0.1, 0.1, 100}, .exponents = {3, 3}}},
          {"plate 1e3", {.half_axes = {10, 10, 0.01}, .exponents = {10, 10}}},
          {"octahedron n=1.05", {.half_axes = {1, 1, 1}, .exponents = {1.05, 1.05}}},
          {"octa n=1.3", {.half_axes = {1, 1.2, 0.8}, .exponents = {1.3, 1.3}}},
          {"lens", {.half_axes = {1, 1, 0.5}, .exponents = {1.2, 2}}},
          {"pillow", {.half_axes = {1, 1, 1}, .exponents = {1.05, 64}}},
          {"bicone", {.half_axes = {1, 1, 1}, .exponents = {64, 1.05}}}};
}

Quat turn(double degrees, const Vec3& axis) {
  return Quat(Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()));
}

/// How body 2 lies against body 1 along `direction`.
struct Setting {
  const char* name;
  Quat orientation_1, orientation_2;
  Vec3 direction;  // of contact, unit
};

/// From body 1's z face, x face and edges; exact quarter turns are written out so that they are exact.
std::vector<Setting> settings() {
  const Quat none = Quat::Identity();
  const double half = std::sqrt(0.5);
  const Quat quarter_x(half, half, 0, 0), quarter_y(half, 0, half, 0), quarter_z(half, 0, 0, half), flip_x(0, 1, 0, 0);
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  const Quat onto_vertex = Quat::FromTwoVectors(Vec3(1, 1, 1).normalized(), -z);
  return {{"z faces aligned", none, none, z},
          {"x faces aligned", none, none, x},
          {"z faces against -z", none, none, -z},
          {"z faces, quarter turn about z", none, quarter_z, z},
          {"z face on x face", none, quarter_y, z},
          {"z face on y face", none, quarter_x, z},
          {"z faces, upside down", none, flip_x, z},
          {"z faces, eighth turn about z", none, turn(45, z), z},
          {"z faces, tilted 1e-9", none, turn(1e-9 * 180 / std::numbers::pi, x), z},
          {"parallel edges", turn(45, z), turn(45, z), x},
          {"edge on face", none, turn(45, Vec3::UnitY()), z},
          {"crossed edges", turn(45, Vec3::UnitY()), turn(45, x), z},
          {"vertex on face", none, onto_vertex, z},
          {"vertex on vertex", onto_vertex.conjugate(), onto_vertex, z},
          {"general", turn(40, Vec3(1, 2, 3)), turn(77, Vec3(-1, 0.3, 2)), Vec3(0.3, -0.5, 0.8).normalized()}};
}

class Builder {
 public:
  explicit Builder(double scale) : scale_(scale) {}

  /// Centres on the line `setting.direction`, at the distance where the overlap along it is `overlap` R_vol.
  void along(const NamedShape& one, const NamedShape& two, const Setting& setting, double overlap,
             const Vec3& shift = Vec3::Zero(), const Vec3& place = Vec3::Zero(), const char* what = "") {
    Pair pair = start(one, two, setting);
    const double smaller = std::min(plain::volume_radius(pair.shape_1), plain::volume_radius(pair.shape_2));
    const double depth = overlap * smaller;
    const double reach = plain::support<double>(pair.shape_1, pair.pose_1.rotate_to_body(setting.direction)).value +
                         plain::support<double>(pair.shape_2, pair.pose_2.rotate_to_body(-setting.direction)).value;
    pair.pose_2.position = (reach - depth) * setting.direction + shift;
    pair.pose_1.position += scale_ * place;
    pair.pose_2.position += scale_ * place;
    pair.label =
        fmt::format("{} / {}, {}, overlap {:g}, scale {:g}{}", one.name, two.name, setting.name, overlap, scale_, what);
    const double bound = overlap_in_double(pair, setting.direction);
    found.push_back({std::move(pair), bound});
  }

  void at(const NamedShape& one, const NamedShape& two, const Setting& setting, const Vec3& apart, const char* what) {
    Pair pair = start(one, two, setting);
    pair.pose_2.position = scale_ * apart;
    pair.label = fmt::format("{} / {}, {}, {}, scale {:g}", one.name, two.name, setting.name, what, scale_);
    found.push_back({std::move(pair), unknown});
  }

  std::vector<Candidate> found;

 private:
  Pair start(const NamedShape& one, const NamedShape& two, const Setting& setting) const {
    Pair pair{one.shape, {.orientation = setting.orientation_1}, two.shape, {.orientation = setting.orientation_2}, ""};
    pair.shape_1.half_axes *= scale_;
    pair.shape_2.half_axes *= scale_;
    return pair;
  }

  double scale_;
};

}  // namespace

std::vector<Candidate> nasty_pairs() {
  std::vector<Candidate> all;
  const std::vector<NamedShape> shapes = nasty_shapes();
  const std::vector<Setting> poses = settings();
  const Setting &aligned = poses.front(), &general = poses.back();
  for (const double scale : {1.0, 1e-6}) {
    Builder build(scale);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const NamedShape &one = shapes[i], &next = shapes[(i + 1) % shapes.size()];
      for (const Setting& pose : poses) {
        for (const double overlap : {1e-12, 1e-8, 1e-4, 0.1, 0.5}) {
          build.along(one, one, pose, overlap);
          build.along(one, next, pose, overlap);
        }
        build.along(one, one, pose, -1e-12);
        build.along(one, next, pose, -0.1);
        build.at(one, one, pose, Vec3::Zero(), "coincident centres");
        build.at(one, next, pose, Vec3::Zero(), "coincident centres");
        build.at(one, next, pose, Vec3(1e-12, -1e-13, 1e-14), "almost coincident centres");
      }
      for (const double overlap : {1e-8, 0.1}) {
        build.along(one, one, aligned, overlap, Vec3(5e-324, 0, 0), Vec3::Zero(), ", shifted by a denormal number");
        build.along(one, one, aligned, overlap, Vec3(1e-310, -1e-315, 0), Vec3::Zero(), ", shifted by denormals");
        build.along(one, one, aligned, overlap, 0.3 * scale * one.shape.half_axes.x() * Vec3::UnitX(), Vec3::Zero(),
                    ", shifted sideways");
        build.along(one, next, general, overlap, Vec3::Zero(), Vec3(1e6, -1e6, 0.5e6), ", 1e6 sizes from the origin");
        build.along(one, one, aligned, overlap, Vec3::Zero(), Vec3(-1e6, 1e6, 1e6), ", 1e6 sizes from the origin");
        const NamedShape tiny{next.name, {next.shape.half_axes * 1e-4, next.shape.exponents}};
        build.along(one, tiny, aligned, overlap, Vec3::Zero(), Vec3::Zero(), ", the second 1e-4 times as large");
        build.along(one, tiny, general, overlap, Vec3::Zero(), Vec3::Zero(), ", the second 1e-4 times as large");
        build.along(tiny, one, general, overlap, Vec3::Zero(), Vec3::Zero(), ", the first 1e-4 times as large");
      }
      build.at(one, next, general, Vec3(0, 0, 1e6), "1e6 sizes apart");
      build.at(one, next, general, 0.01 * Vec3(0.5, 0.7, -0.2).cwiseProduct(one.shape.half_axes), "deep inside");
    }
    all.insert(all.end(), build.found.begin(), build.found.end());
  }
  return all;
}

}  // namespace osculate::validation
