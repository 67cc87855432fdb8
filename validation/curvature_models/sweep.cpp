#include "validation/curvature_models/sweep.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/geometry/common_normal.hpp"
#include "osculate/mechanics/hertz.hpp"
#include "osculate/shapes/surface.hpp"
#include "validation/narrow_phase/random_pairs.hpp"

namespace osculate::validation::curvature_models {
namespace {

constexpr const char* place = "study curvature";

void require(const std::vector<double>& values, double above, double most, const char* what, const char* expected) {
  if (values.empty()) throw InputError(place, fmt::format("no {}", what), "at least one");
  for (const double value : values)
    if (!(value > above && value <= most)) throw InputError(place, fmt::format("{} {:g}", what, value), expected);
}

void validate(const Sweep& sweep) {
  require(sweep.exponents, 1.0, 64.0, "exponent", "a value in (1, 64]");
  require(sweep.aspects, std::nextafter(0.01, 0.0), 100.0, "aspect ratio", "a value in [0.01, 100]");
  require(sweep.overlaps, 0.0, 0.1, "overlap", "a value in (0, 0.1] R_vol");
  if (sweep.orientations < 1)
    throw InputError(place, fmt::format("{} orientations", sweep.orientations), "at least one");
  if (!(sweep.cap > 0.0)) throw InputError(place, fmt::format("cap {:g}", sweep.cap), "a positive number of R_vol");
}

/// Of R_vol = 1.
Superquadric body_of(double exponent, double aspect) {
  Superquadric body{Vec3(1.0, 1.0, aspect), {exponent, exponent}};
  body.half_axes /= volume_equivalent_radius(mass_properties(body).volume);
  return body;
}

/// Body 2 comes along `direction` until the overlap is δ. The overlap falls convexly with the distance, and its slope
/// is −n·direction, so Newton's method from a contact that is too deep or open finds the place.
ContactCase touching(ContactCase contact, const Vec3& direction) {
  double distance = 2.0 * bounding_radius(Shape(contact.body));
  constexpr int most_steps = 60;
  ContactCache cache;
  for (int i = 0; i < most_steps; ++i) {
    contact.pose_2.position = distance * direction;
    contact.contact = common_normal(contact.body, contact.pose_1, contact.body, contact.pose_2, cache);
    const double excess = contact.contact.overlap - contact.overlap;
    // A body's size over the machine's precision is as near as an overlap can be.
    if (std::fabs(excess) < 1e-13) return contact;
    distance += excess / contact.contact.normal.dot(direction);
  }
  return contact;
}

Load hertz_load(double R_i, double R_j, double overlap) {
  const ContactEllipse ellipse = contact_ellipse(R_i, R_j);
  return {.force = hertz::force(ellipse, 1.0, overlap),
          .area = std::numbers::pi * ellipse.beta() * ellipse.R_c * overlap};
}

PotentialError potential_error(const ContactCase& contact, const std::optional<Load>& reference) {
  const GeometricPotentialContact found =
      geometric_potential(contact.body, contact.pose_1, contact.body, contact.pose_2);
  PotentialError error{.status = found.status, .point = 0.0, .normal = 0.0, .overlap = 0.0, .force = 0.0};
  if (!is_resolved(found.status)) return error;
  error.point = (found.point - contact.contact.point()).norm() / contact.contact.overlap;
  error.normal =
      std::atan2(found.normal.cross(contact.contact.normal).norm(), found.normal.dot(contact.contact.normal));
  error.overlap = found.overlap / contact.contact.overlap - 1.0;
  if (reference)
    error.force = hertz_load(found.relative.R_i, found.relative.R_j, found.overlap).force / reference->force - 1.0;
  return error;
}

CaseErrors errors_of(const ContactCase& contact, double cap, const Reference& reference) {
  CaseErrors errors{.input = contact, .has_reference = false, .force = {}, .area = {}, .capped = {}, .potential = {}};
  const std::optional<Load> truth = is_resolved(contact.contact.status) ? reference(contact) : std::nullopt;
  errors.has_reference = truth.has_value();
  errors.potential = potential_error(contact, truth);
  if (!truth) return errors;
  const ContactBody body_1{.curvature = contact.contact.curvature_1, .volume_radius = 1.0},
      body_2{.curvature = contact.contact.curvature_2, .volume_radius = 1.0};
  for (std::size_t i = 0; i < models.size(); ++i) {
    const RelativeCurvature relative = relative_curvature(models[i], contact.contact.normal, body_1, body_2, cap);
    const Load load = hertz_load(relative.R_i, relative.R_j, contact.contact.overlap);
    errors.force[i] = load.force / truth->force - 1.0;
    errors.area[i] = load.area / truth->area - 1.0;
    errors.capped[i] = relative.capped;
  }
  return errors;
}

}  // namespace

std::optional<Load> exact_hertz(const ContactCase& contact) {
  const RelativeCurvature& relative = contact.contact.relative;
  if (!std::isfinite(relative.R_i)) return std::nullopt;
  return hertz_load(relative.R_i, relative.R_j, contact.contact.overlap);
}

std::vector<CaseErrors> errors(const Sweep& sweep, const Reference& reference,
                               const std::function<void(double)>& progress) {
  validate(sweep);
  std::vector<CaseErrors> found;
  const double count =
      static_cast<double>(sweep.exponents.size() * sweep.aspects.size() * sweep.overlaps.size()) * sweep.orientations;
  for (const double exponent : sweep.exponents)
    for (const double aspect : sweep.aspects) {
      const Superquadric body = body_of(exponent, aspect);
      for (const double overlap : sweep.overlaps)
        for (int i = 0; i < sweep.orientations; ++i) {
          // The same turns for every shape and overlap, so that these alone make the differences.
          Random random(sweep.seed * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(i));
          ContactCase contact{.exponent = exponent,
                              .aspect = aspect,
                              .overlap = overlap,
                              .orientation = i,
                              .body = body,
                              .pose_1 = {.position = Vec3::Zero(), .orientation = random.orientation()},
                              .pose_2 = {.position = Vec3::Zero(), .orientation = random.orientation()},
                              .contact = {}};
          found.push_back(errors_of(touching(contact, random.direction()), sweep.cap, reference));
          progress(static_cast<double>(found.size()) / count);
        }
    }
  return found;
}

}  // namespace osculate::validation::curvature_models
