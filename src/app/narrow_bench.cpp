#include "app/narrow_bench.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "app/ccd_penetration.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate::app {
namespace {

Superquadric of_unit_size(const Superquadric& shape) {
  const double radius = volume_equivalent_radius(mass_properties(shape).volume);
  return {.half_axes = shape.half_axes / radius, .exponents = shape.exponents};
}

Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Vec3 direction;
  do direction = Vec3(normal(random), normal(random), normal(random));
  while (direction.norm() < 1e-3);
  return direction.normalized();
}

Quat random_orientation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
}

Pose changed(const Pose& pose, double change, std::mt19937_64& random) {
  return {.position = pose.position + change * random_direction(random),
          .orientation = (Eigen::AngleAxisd(change, random_direction(random)) * pose.orientation).normalized()};
}

struct RandomPair {
  Superquadric shape_1, shape_2;
  Pose pose_1, pose_2;
  Vec3 line;        // body 2 moves along it until the overlap is right
  double distance;  // of the centres
};

SuperquadricPairs columns_of(const std::vector<RandomPair>& pairs) {
  SuperquadricPairs columns;
  columns.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
    columns.set(i, pairs[i].shape_1, pairs[i].pose_1, pairs[i].shape_2, pairs[i].pose_2);
  return columns;
}

std::vector<RandomPair> random_pairs(const PairClass& pair_class, std::size_t count, std::mt19937_64& random) {
  std::uniform_int_distribution<std::size_t> pick(0, pair_class.shapes.size() - 1);
  std::vector<RandomPair> pairs(count);
  for (RandomPair& pair : pairs) {
    pair.shape_1 = pair_class.shapes[pick(random)];
    pair.shape_2 = pair_class.shapes[pick(random)];
    pair.pose_1 = {.position = random_direction(random), .orientation = random_orientation(random)};
    pair.pose_2.orientation = random_orientation(random);
    pair.line = random_direction(random);
    pair.distance = bounding_radius(pair.shape_1) + bounding_radius(pair.shape_2);
    pair.pose_2.position = pair.pose_1.position + pair.distance * pair.line;
  }
  return pairs;
}

/// Moves every body 2 along its line until the overlap is `overlap` (R_vol = 1): the overlap is concave in the
/// distance, with slope −n·line, so that Newton from outside converges steadily.
void set_overlap(std::vector<RandomPair>& pairs, double overlap) {
  constexpr int steps = 30;
  ContactCaches caches;
  caches.resize(pairs.size());
  ContactColumns contacts;
  for (int step = 0; step < steps; ++step) {
    common_normals(columns_of(pairs), caches, contacts);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const ContactGeometry contact = contacts.get(i);
      const double slope = contact.normal.dot(pairs[i].line);
      if (is_resolved(contact.status) && slope > 0.0) pairs[i].distance += (contact.overlap - overlap) / slope;
      pairs[i].pose_2.position = pairs[i].pose_1.position + pairs[i].distance * pairs[i].line;
    }
  }
}

/// Two poses of the same pairs a small change apart, visited in turn: every warm call starts from the other's answer.
struct TwoPoses {
  SuperquadricPairs here, there;
  bool at_here = true;

  const SuperquadricPairs& next() {
    at_here = !at_here;
    return at_here ? here : there;
  }
};

TwoPoses two_poses(const std::vector<RandomPair>& pairs, double change, std::mt19937_64& random) {
  std::vector<RandomPair> moved = pairs;
  for (RandomPair& pair : moved) pair.pose_2 = changed(pair.pose_2, change, random);
  return {.here = columns_of(pairs), .there = columns_of(moved)};
}

using Solver = decltype(&common_normals);

Timing time_warm(const std::vector<RandomPair>& pairs, Solver solve, Gap gap, const NarrowSettings& settings) {
  std::mt19937_64 random(settings.seed);
  TwoPoses poses = two_poses(pairs, settings.pose_change, random);
  ContactCaches caches;
  caches.resize(pairs.size());
  ContactColumns contacts;
  return time_of(
      pairs.size(), settings.repetitions, [] {}, [&] { solve(poses.next(), caches, contacts, gap, Curvatures::all); });
}

Timing time_cold(const std::vector<RandomPair>& pairs, Solver solve, const NarrowSettings& settings) {
  const SuperquadricPairs columns = columns_of(pairs);
  ContactCaches caches;
  ContactColumns contacts;
  const auto forget = [&] {
    caches.resize(pairs.size());
    std::fill(caches.states.begin(), caches.states.end(), ContactCache::State::empty);
  };
  return time_of(pairs.size(), settings.repetitions, forget,
                 [&] { solve(columns, caches, contacts, Gap::resolve, Curvatures::all); });
}

std::size_t count_unresolved(const std::vector<RandomPair>& pairs) {
  ContactCaches caches;
  caches.resize(pairs.size());
  ContactColumns contacts;
  common_normals(columns_of(pairs), caches, contacts);
  return static_cast<std::size_t>(std::count_if(contacts.statuses.begin(), contacts.statuses.end(),
                                                [](ContactStatus status) { return !is_resolved(status); }));
}

/// libccd is slow: a part of the pairs and fewer repetitions tell as much.
void time_ccd(const std::vector<RandomPair>& pairs, const NarrowSettings& settings, NarrowTimes& times) {
  constexpr std::size_t every = 8;
  constexpr int fewer = 4;
  std::vector<std::pair<PlacedBody, PlacedBody>> bodies;
  for (std::size_t i = 0; i < pairs.size(); i += every)
    bodies.emplace_back(place(pairs[i].shape_1, pairs[i].pose_1), place(pairs[i].shape_2, pairs[i].pose_2));
  std::vector<std::optional<double>> depths(bodies.size());
  times.ccd = time_of(
      bodies.size(), std::max(3, settings.repetitions / fewer), [] {},
      [&] {
        for (std::size_t i = 0; i < bodies.size(); ++i)
          depths[i] = ccd_penetration(bodies[i].first, bodies[i].second, settings.epa_tolerance);
      });
  std::vector<double> errors;
  for (const std::optional<double>& depth : depths) {
    if (depth)
      errors.push_back(std::fabs(*depth / settings.overlap - 1.0));
    else
      ++times.ccd_failures;
  }
  if (errors.empty()) return;
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  times.ccd_depth_error = errors[errors.size() / 2];
}

}  // namespace

std::vector<PairClass> narrow_classes() {
  const auto shape = [](double a, double b, double c, double n1, double n2) {
    return of_unit_size({.half_axes = {a, b, c}, .exponents = {.n1 = n1, .n2 = n2}});
  };
  std::vector<PairClass> classes{{"sphere", {shape(1, 1, 1, 2, 2)}},     {"ellipsoid", {shape(1, 1, 2, 2, 2)}},
                                 {"blocky", {shape(1, 1, 1, 4, 4)}},     {"box", {shape(1, 1, 2, 6, 6)}},
                                 {"cylinder", {shape(1, 1, 1.5, 8, 2)}}, {"needle", {shape(1, 1, 5, 3, 3)}},
                                 {"sharpbox", {shape(1, 2, 3, 12, 12)}}, {"octa", {shape(1, 1, 1, 1.3, 1.3)}}};
  PairClass mixed{"mixed", {}};
  for (const PairClass& one : classes)
    if (one.name != "sphere" && one.name != "octa") mixed.shapes.push_back(one.shapes.front());
  classes.push_back(mixed);

  constexpr std::size_t general_shapes = 64;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(2.0, 8.0);
  std::uniform_real_distribution<double> axis(0.5, 1.0);
  PairClass general{"general", {}};
  for (std::size_t i = 0; i < general_shapes; ++i)
    general.shapes.push_back(shape(axis(random), axis(random), axis(random), exponent(random), exponent(random)));
  classes.push_back(general);
  return classes;
}

NarrowTimes time_narrow_phase(const PairClass& pair_class, const NarrowSettings& settings) {
  std::mt19937_64 random(settings.seed);
  std::vector<RandomPair> pairs = random_pairs(pair_class, settings.pairs, random);
  set_overlap(pairs, settings.overlap);

  NarrowTimes times;
  times.name = pair_class.name;
  times.unresolved = count_unresolved(pairs);
  times.warm_batched = time_warm(pairs, &common_normals, Gap::resolve, settings);
  times.warm_scalar = time_warm(pairs, &common_normals_scalar, Gap::resolve, settings);
  times.cold_batched = time_cold(pairs, &common_normals, settings);
  times.cold_scalar = time_cold(pairs, &common_normals_scalar, settings);
  time_ccd(pairs, settings, times);

  std::vector<RandomPair> apart = pairs;
  set_overlap(apart, -settings.overlap);
  times.separated_batched = time_warm(apart, &common_normals, Gap::skip, settings);
  times.separated_scalar = time_warm(apart, &common_normals_scalar, Gap::skip, settings);
  return times;
}

}  // namespace osculate::app
