// Properties of the narrow phase for whatever bodies and poses RapidCheck thinks of; it shrinks what fails to the
// simplest pair that still does. Bounded by the number of cases. RC_PARAMS in the environment asks for more:
//   RC_PARAMS="max_success=1000000" test_validation "[property]"
#include <rapidcheck.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include "osculate/geometry/superquadric_contacts.hpp"
#include "validation/narrow_phase/contact_checks.hpp"

using namespace osculate;
using namespace osculate::validation;

namespace {

/// A body from small integers, so that shrinking leads to round exponents, equal axes, no rotation, the origin.
struct Knobs {
  std::array<int, 3> axes;      // half-axes 10^(k/100)
  std::array<int, 2> exponent;  // n = 2 · 10^(k/100), within (1, 64]
  std::array<int, 3> turn;      // rotation vector, [rad/100]
  std::array<int, 3> place;     // position in units of 1/1000
};

rc::Gen<Knobs> knobs() {
  const auto three = [](int bound) {
    return rc::gen::container<std::array<int, 3>>(rc::gen::inRange(-bound, bound + 1));
  };
  return rc::gen::construct<Knobs>(three(100), rc::gen::container<std::array<int, 2>>(rc::gen::inRange(-25, 121)),
                                   three(315), three(2000));
}

Superquadric shape_of(const Knobs& knobs) {
  const auto power = [](int k) { return std::pow(10.0, k / 100.0); };
  return {.half_axes = {power(knobs.axes[0]), power(knobs.axes[1]), power(knobs.axes[2])},
          .exponents = {.n1 = 2.0 * power(knobs.exponent[0]), .n2 = 2.0 * power(knobs.exponent[1])}};
}

Pose pose_of(const Knobs& knobs) {
  const Vec3 turn = Vec3(knobs.turn[0], knobs.turn[1], knobs.turn[2]) / 100.0;
  const double angle = turn.norm();
  Quat orientation = Quat::Identity();
  if (angle > 0.0) orientation = Eigen::AngleAxisd(angle, turn / angle);
  return {.position = Vec3(knobs.place[0], knobs.place[1], knobs.place[2]) / 1000.0, .orientation = orientation};
}

/// RapidCheck prints with this.
void showValue(const Knobs& knobs, std::ostream& out) {
  const Superquadric shape = shape_of(knobs);
  const Pose pose = pose_of(knobs);
  out.precision(17);
  out << "half-axes " << shape.half_axes.transpose() << ", n1 " << shape.exponents.n1 << ", n2 " << shape.exponents.n2
      << ", at " << pose.position.transpose() << ", quaternion wxyz " << pose.orientation.w() << ' '
      << pose.orientation.vec().transpose();
}

ContactGeometry contact_of(const Pair& pair) {
  SuperquadricPairs pairs;
  pairs.resize(1);
  pairs.set(0, pair.shape_1, pair.pose_1, pair.shape_2, pair.pose_2);
  ContactCaches caches;
  ContactColumns contacts;
  common_normals(pairs, caches, contacts);
  return contacts.get(0);
}

/// What every answer must be; not being deepest is left to `osculate validate narrow`, whose random pairs overlap as
/// touching grains do.
void check(const Knobs& one, const Knobs& two) {
  const Pair pair{shape_of(one), pose_of(one), shape_of(two), pose_of(two), ""};
  const ContactGeometry contact = contact_of(pair);
  RC_ASSERT(is_finite(contact));
  RC_ASSERT(contact.status != ContactStatus::degenerate);
  const ContactGeometry exchanged = contact_of({pair.shape_2, pair.pose_2, pair.shape_1, pair.pose_1, ""});
  const bool same_body = pair.shape_1.half_axes == pair.shape_2.half_axes &&
                         pair.pose_1.position == pair.pose_2.position &&
                         pair.pose_1.orientation.coeffs() == pair.pose_2.orientation.coeffs();
  RC_ASSERT(same_body || is_exact_swap(contact, exchanged));
  if (!is_resolved(contact.status)) RC_DISCARD("not converged, and says so");
  const Tolerance tolerance = tolerance_of(pair);
  const SelfConsistency off = self_consistency(pair, tolerance, contact);
  RC_ASSERT(off.off_surface <= 1.0);
  RC_ASSERT(off.off_support <= 1.0);
  RC_ASSERT(off.off_overlap <= 1.0);
  RC_ASSERT(off.off_line <= 1.0);
}

}  // namespace

TEST_CASE("Whatever the bodies, their contact is finite, swaps exactly and lies on both surfaces", "[property]") {
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  if (std::getenv("RC_PARAMS") == nullptr) {
    params.seed = 1;  // the same cases in every run of the tests
    params.maxSuccess = 20000;
  }
  params.maxSize = 100;
  const auto result = rc::detail::checkTestable(
      [] {
        const Knobs one = *knobs().as("body 1");
        const Knobs two = *knobs().as("body 2");
        check(one, two);
      },
      rc::detail::TestMetadata{}, params);
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  INFO(message.str());
  CHECK(result.template is<rc::detail::SuccessResult>());
}
