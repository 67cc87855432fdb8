#include "validation/narrow_phase/contact_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "validation/narrow_phase/plain_superquadric.hpp"

namespace osculate::validation {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double distance_from_surface(const Superquadric& shape, const Vec3& point_b) {
  if (point_b == Vec3::Zero()) return std::numeric_limits<double>::infinity();
  const auto [value, gradient] = plain::gauge<double>(shape, point_b);
  return std::fabs(value - 1.0) / gradient.norm();  // to first order
}

double short_of_support(const Superquadric& shape, const Vec3& normal_b, const Vec3& point_b) {
  return std::fabs(plain::support<double>(shape, normal_b).value - normal_b.dot(point_b));
}

/// NaN wins, so that it cannot pass for agreement.
double worse(double a, double b) {
  return std::isnan(a) || a > b ? a : b;
}

std::vector<Vec3> lattice(int count) {
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2 * i + 1.0) / count, turn = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    directions.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  return directions;
}

/// Beside the largest component, one below this has a square that vanishes: it has no digits to keep when lengths
/// scale.
constexpr double without_digits = 1e-150;

bool same_but_vanishing(const Vec3& a, const Vec3& b) {
  const double vanishing = without_digits * a.cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i)
    if (a[i] != b[i] && !(std::fabs(a[i]) < vanishing && std::fabs(b[i]) < vanishing)) return false;
  return true;
}

bool same_bits(const PrincipalCurvatures& a, const PrincipalCurvatures& b) {
  return a.max == b.max && a.min == b.min && a.max_direction == b.max_direction;
}

bool scaled_bits(const PrincipalCurvatures& a, const PrincipalCurvatures& b, double factor) {
  return a.max == b.max * factor && a.min == b.min * factor && same_but_vanishing(a.max_direction, b.max_direction);
}

}  // namespace

Tolerance tolerance_of(const Pair& pair) {
  const double smaller = std::min(plain::volume_radius(pair.shape_1), plain::volume_radius(pair.shape_2));
  const double extent = pair.shape_1.half_axes.maxCoeff() + pair.shape_2.half_axes.maxCoeff() +
                        (pair.pose_2.position - pair.pose_1.position).norm();
  // Positions are exact inputs: only their difference, the points and the rotations are rounded.
  const double overlap = 1e-12 * smaller + 50.0 * epsilon * extent;
  const double world = pair.pose_1.position.norm() + pair.pose_2.position.norm() + extent;
  const double point = overlap + 4.0 * epsilon * world;
  return {.overlap = overlap, .point = point, .offset = point + 1e-7 * smaller};
}

SelfConsistency self_consistency(const Pair& pair, const Tolerance& tolerance, const ContactGeometry& contact) {
  const auto& [shape_1, pose_1, shape_2, pose_2, label] = pair;
  const Vec3 point_1 = pose_1.to_body(contact.on_1), point_2 = pose_2.to_body(contact.on_2);
  const Vec3 normal_1 = pose_1.rotate_to_body(contact.normal), normal_2 = pose_2.rotate_to_body(-contact.normal);
  const Vec3 apart = contact.on_1 - contact.on_2;
  SelfConsistency off{};
  off.off_surface =
      worse(distance_from_surface(shape_1, point_1), distance_from_surface(shape_2, point_2)) / tolerance.point;
  off.off_support = worse(short_of_support(shape_1, normal_1, point_1), short_of_support(shape_2, normal_2, point_2)) /
                    tolerance.point;
  off.off_overlap =
      worse(worse(std::fabs(apart.dot(contact.normal) - contact.overlap) / tolerance.point,
                  std::fabs(overlap_in_double(pair, contact.normal) - contact.overlap) / tolerance.overlap),
            std::fabs(contact.normal.norm() - 1.0) / (8.0 * epsilon));
  off.off_line = (apart - contact.overlap * contact.normal).norm() / tolerance.offset;
  return off;
}

bool is_finite(const ContactGeometry& contact) {
  const auto curvature = [](const PrincipalCurvatures& k) {
    return std::isfinite(k.max) && std::isfinite(k.min) && k.max_direction.allFinite();
  };
  return contact.normal.allFinite() && std::isfinite(contact.overlap) && contact.on_1.allFinite() &&
         contact.on_2.allFinite() && curvature(contact.curvature_1) && curvature(contact.curvature_2) &&
         !std::isnan(contact.relative.R_i) && !std::isnan(contact.relative.R_j) &&
         contact.relative.major_axis.allFinite();
}

double overlap_in_double(const Pair& pair, const Vec3& normal) {
  return plain::support<double>(pair.shape_1, pair.pose_1.rotate_to_body(normal)).value +
         plain::support<double>(pair.shape_2, pair.pose_2.rotate_to_body(-normal)).value -
         normal.dot(pair.pose_2.position - pair.pose_1.position);
}

double least_of_samples(const Pair& pair) {
  static const std::vector<Vec3> directions = lattice(200);
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const Vec3& u) { least = std::min(least, overlap_in_double(pair, u)); };
  for (const Vec3& u : directions) look(u);
  for (int i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0}) {
      look(pair.pose_1.rotate_to_world(sign * Vec3::Unit(i)));
      look(pair.pose_2.rotate_to_world(sign * Vec3::Unit(i)));
    }
  const Vec3 centres = pair.pose_2.position - pair.pose_1.position;
  if (centres.norm() > 0.0) look(centres.normalized());
  return least;
}

bool is_exact_swap(const ContactGeometry& a, const ContactGeometry& b) {
  return a.status == b.status && a.overlap == b.overlap && a.normal == -b.normal && a.on_1 == b.on_2 &&
         a.on_2 == b.on_1 && same_bits(a.curvature_1, b.curvature_2) && same_bits(a.curvature_2, b.curvature_1) &&
         a.relative.R_i == b.relative.R_i && a.relative.R_j == b.relative.R_j &&
         a.relative.major_axis == b.relative.major_axis;
}

bool is_same(const ContactGeometry& a, const ContactGeometry& b) {
  return a.status == b.status && a.overlap == b.overlap && a.normal == b.normal && a.on_1 == b.on_1 &&
         a.on_2 == b.on_2 && same_bits(a.curvature_1, b.curvature_1) && same_bits(a.curvature_2, b.curvature_2) &&
         a.relative.R_i == b.relative.R_i && a.relative.R_j == b.relative.R_j;
}

bool is_exact_scaling(const ContactGeometry& a, const ContactGeometry& b, double factor) {
  return a.status == b.status && a.overlap * factor == b.overlap && same_but_vanishing(a.normal, b.normal) &&
         same_but_vanishing(a.on_1 * factor, b.on_1) && same_but_vanishing(a.on_2 * factor, b.on_2) &&
         scaled_bits(a.curvature_1, b.curvature_1, factor) && scaled_bits(a.curvature_2, b.curvature_2, factor) &&
         a.relative.R_i * factor == b.relative.R_i && a.relative.R_j * factor == b.relative.R_j;
}

}  // namespace osculate::validation
