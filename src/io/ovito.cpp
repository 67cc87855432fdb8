#include "io/ovito.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "io/assembly_picture.hpp"
#include "io/atomic_file.hpp"
#include "io/particle_values.hpp"

namespace osculate::io {
namespace {

OvitoShape drawn(const Superquadric& shape) {
  return {shape.half_axes, 2.0 / shape.exponents.n2, 2.0 / shape.exponents.n1};
}

OvitoShape drawn(const Ellipsoid& shape) {
  return {shape.half_axes, 1.0, 1.0};
}

OvitoShape drawn(const Sphere& shape) {
  return {Vec3::Constant(shape.radius), 1.0, 1.0};
}

template <class Other>
OvitoShape drawn(const Other& shape) {
  return {Vec3::Constant(volume_equivalent_radius(mass_properties(Shape(shape)).volume)), 1.0, 1.0, true};
}

/// A sheared box as a tilted one.
struct Tilt {
  int flow;
  int place;   ///< among xy, xz, yz
  double way;  ///< [m]
};

/// Nothing without shear, and along an axis across an earlier one: tilts of that kind have no place in a dump.
std::optional<Tilt> tilt_of(const PeriodicBox& box) {
  if (!box.shear || box.shear->flow > box.shear->gradient) return std::nullopt;
  const auto flow = static_cast<int>(box.shear->flow), gradient = static_cast<int>(box.shear->gradient);
  return Tilt{flow, flow + gradient - 1, box.shear->offset};
}

}  // namespace

OvitoShape ovito_shape(const Shape& particle) {
  return std::visit([](const auto& shape) { return drawn(shape); }, particle);
}

std::string dump_block(const ParticleFrame& frame, const ResultsHead& head) {
  require_shapes(frame, head);
  std::vector<OvitoShape> shapes;
  for (const ResultsShape& shape : head.shapes) shapes.push_back(ovito_shape(shape.shape));
  std::string text = fmt::format("ITEM: TIME\n{:.17g}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS",
                                 frame.time, frame.step, frame.size());
  const Box extent = frame.size() > 0 ? extent_of(frame, head) : Box{Vec3::Zero(), Vec3::Zero()};
  const auto repeats = [&](int axis) { return std::isfinite(head.box.length[axis]); };
  const std::optional<Tilt> tilt = tilt_of(at_time(head.box, frame.time));
  if (tilt) text += " xy xz yz";
  for (int axis = 0; axis < 3; ++axis) text += repeats(axis) ? " pp" : " ff";
  text += '\n';
  const auto out = std::back_inserter(text);
  for (int axis = 0; axis < 3; ++axis) {
    const double lower = repeats(axis) ? head.box.origin[axis] : extent.lower[axis];
    const double upper = repeats(axis) ? lower + head.box.length[axis] : extent.upper[axis];
    // LAMMPS writes the box around a tilted one, and the tilts xy, xz and yz behind.
    if (tilt && axis == tilt->flow)
      fmt::format_to(out, "{:.17g} {:.17g}", lower + std::min(tilt->way, 0.0), upper + std::max(tilt->way, 0.0));
    else
      fmt::format_to(out, "{:.17g} {:.17g}", lower, upper);
    if (tilt) fmt::format_to(out, " {:.17g}", axis == tilt->place ? tilt->way : 0.0);
    text += '\n';
  }
  text +=
      "ITEM: ATOMS id type x y z vx vy vz AngularVelocity.X AngularVelocity.Y AngularVelocity.Z AsphericalShape.X "
      "AsphericalShape.Y AsphericalShape.Z Orientation.X Orientation.Y Orientation.Z Orientation.W "
      "SuperquadricRoundness.Phi SuperquadricRoundness.Theta\n";
  const auto vector = [&](const Vec3& v) { fmt::format_to(out, " {:.9g} {:.9g} {:.9g}", v.x(), v.y(), v.z()); };
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const OvitoShape& shape = shapes[frame.shape[i]];
    const Pose pose = shape_pose_of(frame, head, i);
    fmt::format_to(out, "{} {}", frame.id[i], frame.shape[i] + 1);
    vector(pose.position);
    vector(frame.velocity[i]);
    vector(frame.angular_velocity[i]);
    vector(shape.half_axes);
    const Quat& q = pose.orientation;
    fmt::format_to(out, " {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n", q.x(), q.y(), q.z(), q.w(), shape.phi,
                   shape.theta);
  }
  return text;
}

void write_ovito(const ResultsFile& results, const std::filesystem::path& path,
                 const std::function<void(std::size_t)>& written) {
  AtomicFile file(path.string());
  for (std::size_t i = 0; i < results.frame_count(); ++i) {
    file.write(dump_block(results.frame(i), results.head()));
    written(i + 1);
  }
  file.commit();
}

}  // namespace osculate::io
