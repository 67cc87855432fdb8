// Contacts through the C API: bodies gathered into the batches of the narrow phase, a part of the pairs at a time.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "c/boundary.hpp"
#include "c/handles.hpp"
#include "osculate/geometry/shape_contacts.hpp"

namespace {

using namespace osculate;
using c::guarded;
using c::required;
using c::whole;

static_assert(OSCULATE_TOUCHING == static_cast<int>(ContactStatus::touching));
static_assert(OSCULATE_SEPARATED == static_cast<int>(ContactStatus::separated));
static_assert(OSCULATE_AMBIGUOUS == static_cast<int>(ContactStatus::ambiguous));
static_assert(OSCULATE_FLAT == static_cast<int>(ContactStatus::flat));
static_assert(OSCULATE_NOT_CONVERGED == static_cast<int>(ContactStatus::not_converged));
static_assert(OSCULATE_DEGENERATE == static_cast<int>(ContactStatus::degenerate));

/// A cache as bytes: its state, then the columns of ContactCaches.
struct PackedCache {
  std::int64_t state;
  std::array<double, ContactCaches::width> values;
};
static_assert(sizeof(PackedCache) == sizeof(std::int64_t) + ContactCaches::width * sizeof(double));

/// Pairs worked on at a time: what the kernels read and write of them stays in the second-level cache.
constexpr std::size_t most_at_once = 512;

Gap gap_of(int gap) {
  if (gap != OSCULATE_GAP_RESOLVE && gap != OSCULATE_GAP_SKIP)
    throw InputError("gap", std::to_string(gap), "OSCULATE_GAP_RESOLVE or OSCULATE_GAP_SKIP");
  return gap == OSCULATE_GAP_RESOLVE ? Gap::resolve : Gap::skip;
}

/// `where` makes the text of the place, if it is needed.
template <class Where>
void check_pose(const Pose& pose, const Where& where) {
  constexpr double unit = 2e-6;  // of the squared length; the kernels take rotations as they are
  if (!pose.position.allFinite()) throw InputError(where(), "a position that is not finite", "finite numbers [m]");
  if (!(std::fabs(pose.orientation.squaredNorm() - 1.0) <= unit))
    throw InputError(where(), "an orientation of length " + std::to_string(pose.orientation.norm()),
                     "a unit quaternion w, x, y, z");
}

bool is_superquadric(const Shape& shape) {
  return std::holds_alternative<Superquadric>(shape) || std::holds_alternative<Ellipsoid>(shape) ||
         std::holds_alternative<Sphere>(shape);
}

Superquadric superquadric_of(const Shape& shape) {
  if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape)) return as_superquadric(*ellipsoid);
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return as_superquadric(*sphere);
  return std::get<Superquadric>(shape);
}

template <class Where>
void unpack(const unsigned char* bytes, ContactCaches& caches, std::size_t row, const Where& where) {
  PackedCache packed;
  std::memcpy(&packed, bytes, sizeof packed);
  if (packed.state < 0 || packed.state > static_cast<int>(ContactCache::State::separation))
    throw InputError(where(), "a cache of bytes that no call left there", "zeros, or what a call left");
  caches.states[row] = static_cast<ContactCache::State>(packed.state);
  for (std::size_t k = 0; k < packed.values.size(); ++k) caches.columns[k][row] = packed.values[k];
}

void pack(const ContactCaches& caches, std::size_t row, unsigned char* bytes) {
  PackedCache packed;
  packed.state = static_cast<std::int64_t>(caches.states[row]);
  for (std::size_t k = 0; k < packed.values.size(); ++k) packed.values[k] = caches.columns[k][row];
  std::memcpy(bytes, &packed, sizeof packed);
}

/// Where the columns of ContactColumns go; those that are not wanted are NULL.
std::array<double*, 25> targets(const osculate_contact_columns& to) {
  return {to.normal[0],
          to.normal[1],
          to.normal[2],
          to.overlap,
          to.on_1[0],
          to.on_1[1],
          to.on_1[2],
          to.on_2[0],
          to.on_2[1],
          to.on_2[2],
          to.curvature_1[0],
          to.curvature_1[1],
          to.direction_1[0],
          to.direction_1[1],
          to.direction_1[2],
          to.curvature_2[0],
          to.curvature_2[1],
          to.direction_2[0],
          to.direction_2[1],
          to.direction_2[2],
          to.R_i,
          to.R_j,
          to.major_axis[0],
          to.major_axis[1],
          to.major_axis[2]};
}

void check(const osculate_bodies& bodies) {
  required(bodies.shape, "bodies.shape");
  for (const double* column : bodies.position) required(column, "bodies.position");
  for (const double* column : bodies.orientation) required(column, "bodies.orientation");
}

void check(const osculate_contact_columns& to) {
  required(to.status, "contacts.status");
  whole(to.normal, "contacts.normal");
  whole(to.on_1, "contacts.on_1");
  whole(to.on_2, "contacts.on_2");
  whole(to.curvature_1, "contacts.curvature_1");
  whole(to.direction_1, "contacts.direction_1");
  whole(to.curvature_2, "contacts.curvature_2");
  whole(to.direction_2, "contacts.direction_2");
  whole(to.major_axis, "contacts.major_axis");
}

/// Pairs that one batch of the narrow phase takes: where they stand in the caller's columns, and their answers.
struct Rows {
  std::vector<std::size_t> pairs;
  ContactCaches caches;
  ContactColumns contacts;
};

class Search {
 public:
  Search(const osculate_bodies& bodies, const std::int32_t* body_1, const std::int32_t* body_2, Gap gap,
         unsigned char* caches, const osculate_contact_columns& contacts)
      : bodies_(bodies),
        body_1_(body_1),
        body_2_(body_2),
        gap_(gap),
        caches_(caches),
        statuses_(contacts.status),
        targets_(targets(contacts)) {}

  void run(std::size_t start, std::size_t end) {
    smooth_.pairs.clear(), any_.pairs.clear();
    superquadrics_.resize(end - start);
    for (std::size_t pair = start; pair < end; ++pair) {
      const Body one = body(body_1_[pair], pair), two = body(body_2_[pair], pair);
      const bool smooth = is_superquadric(*one.shape) && is_superquadric(*two.shape);
      if (!smooth && !is_particle(*one.shape) && !is_particle(*two.shape))
        throw InputError("pair " + std::to_string(pair), "two walls", "at most one");
      Rows& rows = smooth ? smooth_ : any_;
      const std::size_t row = rows.pairs.size();
      rows.pairs.push_back(pair);
      if (smooth) {
        superquadrics_.set(row, superquadric_of(*one.shape), one.pose, superquadric_of(*two.shape), two.pose);
      } else {
        shapes_.resize(row + 1);
        shapes_.set(row, *one.shape, one.pose, *two.shape, two.pose);
      }
    }
    superquadrics_.resize(smooth_.pairs.size());
    shapes_.resize(any_.pairs.size());
    read_caches(smooth_), read_caches(any_);
    if (!smooth_.pairs.empty()) common_normals(superquadrics_, smooth_.caches, smooth_.contacts, gap_);
    if (!any_.pairs.empty()) common_normals(shapes_, any_.caches, any_.contacts, gap_);
    write(smooth_), write(any_);
  }

 private:
  struct Body {
    const Shape* shape;
    Pose pose;
  };

  Body body(std::int32_t index, std::size_t pair) const {
    const auto where = [&] { return "pair " + std::to_string(pair) + ", body " + std::to_string(index); };
    if (index < 0 || static_cast<std::size_t>(index) >= bodies_.size)
      throw InputError("pair " + std::to_string(pair), "body " + std::to_string(index),
                       "an index below " + std::to_string(bodies_.size));
    const auto i = static_cast<std::size_t>(index);
    if (bodies_.shape[i] == nullptr) throw c::NullPointer(where() + ", shape");
    const Pose pose{.position = Vec3(bodies_.position[0][i], bodies_.position[1][i], bodies_.position[2][i]),
                    .orientation = Quat(bodies_.orientation[0][i], bodies_.orientation[1][i], bodies_.orientation[2][i],
                                        bodies_.orientation[3][i])};
    check_pose(pose, where);
    return {&bodies_.shape[i]->shape, pose};
  }

  void read_caches(Rows& rows) const {
    if (caches_ == nullptr) rows.caches.resize(0);
    rows.caches.resize(rows.pairs.size());  // what is new is empty
    if (caches_ == nullptr) return;
    for (std::size_t row = 0; row < rows.pairs.size(); ++row)
      unpack(caches_ + rows.pairs[row] * sizeof(PackedCache), rows.caches, row,
             [&] { return "pair " + std::to_string(rows.pairs[row]); });
  }

  void write(const Rows& rows) const {
    for (std::size_t row = 0; row < rows.pairs.size(); ++row) {
      statuses_[rows.pairs[row]] = static_cast<std::int32_t>(rows.contacts.statuses[row]);
      if (caches_ != nullptr) pack(rows.caches, row, caches_ + rows.pairs[row] * sizeof(PackedCache));
    }
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      if (targets_[k] == nullptr) continue;
      for (std::size_t row = 0; row < rows.pairs.size(); ++row)
        targets_[k][rows.pairs[row]] = rows.contacts.columns[k][row];
    }
  }

  const osculate_bodies& bodies_;
  const std::int32_t *body_1_, *body_2_;
  Gap gap_;
  unsigned char* caches_;
  std::int32_t* statuses_;
  std::array<double*, 25> targets_;
  SuperquadricPairs superquadrics_;
  ShapePairs shapes_;
  Rows smooth_, any_;
};

Pose pose_of(const osculate_pose& pose) {
  return {.position = Eigen::Map<const Vec3>(pose.position),
          .orientation = Quat(pose.orientation[0], pose.orientation[1], pose.orientation[2], pose.orientation[3])};
}

}  // namespace

size_t osculate_cache_size(void) {
  return sizeof(PackedCache);
}

int osculate_find_contact(const osculate_shape* shape_1, const osculate_pose* pose_1, const osculate_shape* shape_2,
                          const osculate_pose* pose_2, int gap, void* cache, osculate_contact* contact) {
  return guarded("osculate_find_contact", [&] {
    const Shape &one = required(shape_1, "shape_1").shape, &two = required(shape_2, "shape_2").shape;
    const Pose at_1 = pose_of(required(pose_1, "pose_1")), at_2 = pose_of(required(pose_2, "pose_2"));
    required(contact, "contact");
    check_pose(at_1, [] { return "pose_1"; });
    check_pose(at_2, [] { return "pose_2"; });
    const Gap how = gap_of(gap);
    ContactCaches caches;
    caches.resize(1);
    auto* const bytes = static_cast<unsigned char*>(cache);
    if (bytes != nullptr) unpack(bytes, caches, 0, [] { return "cache"; });
    ContactCache known = caches.get(0);
    const ContactGeometry found = common_normal(one, at_1, two, at_2, known, how);
    caches.set(0, known);
    if (bytes != nullptr) pack(caches, 0, bytes);

    const auto put = [](const Vec3& from, double* to) { Eigen::Map<Vec3>{to} = from; };
    contact->status = static_cast<std::int32_t>(found.status);
    contact->overlap = found.overlap;
    put(found.normal, contact->normal);
    put(found.on_1, contact->on_1);
    put(found.on_2, contact->on_2);
    contact->curvature_1[0] = found.curvature_1.max, contact->curvature_1[1] = found.curvature_1.min;
    contact->curvature_2[0] = found.curvature_2.max, contact->curvature_2[1] = found.curvature_2.min;
    put(found.curvature_1.max_direction, contact->direction_1);
    put(found.curvature_2.max_direction, contact->direction_2);
    contact->R_i = found.relative.R_i;
    contact->R_j = found.relative.R_j;
    put(found.relative.major_axis, contact->major_axis);
  });
}

int osculate_find_contacts(const osculate_bodies* bodies, size_t pairs, const int32_t* body_1, const int32_t* body_2,
                           int gap, void* caches, const osculate_contact_columns* contacts) {
  return guarded("osculate_find_contacts", [&] {
    check(required(bodies, "bodies"));
    check(required(contacts, "contacts"));
    const Gap how = gap_of(gap);
    if (pairs == 0) return;
    required(body_1, "body_1"), required(body_2, "body_2");
    Search search(*bodies, body_1, body_2, how, static_cast<unsigned char*>(caches), *contacts);
    for (std::size_t start = 0; start < pairs; start += most_at_once)
      search.run(start, std::min(start + most_at_once, pairs));
  });
}
