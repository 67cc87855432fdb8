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
constexpr std::size_t cache_bytes = sizeof(std::int64_t) + ContactCaches::width * sizeof(double);

/// Pairs worked on at a time: what the kernels read and write of them stays in the second-level cache.
constexpr std::size_t most_at_once = 256;

Gap gap_of(int gap) {
  if (gap != OSCULATE_GAP_RESOLVE && gap != OSCULATE_GAP_SKIP)
    throw InputError("gap", std::to_string(gap), "OSCULATE_GAP_RESOLVE or OSCULATE_GAP_SKIP");
  return gap == OSCULATE_GAP_RESOLVE ? Gap::resolve : Gap::skip;
}

/// `where` makes the text of the place, if it is needed.
template <class Where>
void check_pose(const std::array<double, 3>& x, const std::array<double, 4>& q, const Where& where) {
  constexpr double unit = 2e-6;  // of the squared length; the kernels take rotations as they are
  if (!std::isfinite(std::fabs(x[0]) + std::fabs(x[1]) + std::fabs(x[2])))
    throw InputError(where(), "a position that is not finite", "finite numbers [m]");
  const double length2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  if (!(std::fabs(length2 - 1.0) <= unit))
    throw InputError(where(), "an orientation of length " + std::to_string(std::sqrt(length2)),
                     "a unit quaternion w, x, y, z");
}

/// Columns of one piece of memory by where the first begins and how far apart they are: a row of many is then written
/// without looking up each column.
struct Strided {
  double* first;
  std::size_t stride;

  template <std::size_t N>
  explicit Strided(Columns<N>& columns)
      : first(columns[0]), stride(static_cast<std::size_t>(columns[1] - columns[0])) {}
  double* at(std::size_t column, std::size_t row) const { return first + column * stride + row; }
};

/// A row of ContactCaches from bytes and to bytes.
class CacheRows {
 public:
  explicit CacheRows(ContactCaches& caches) : states_(caches.states.data()), columns_(caches.columns) {}

  template <class Where>
  void unpack(const unsigned char* bytes, std::size_t row, const Where& where) const {
    std::int64_t state;
    std::memcpy(&state, bytes, sizeof state);
    if (state < 0 || state > static_cast<int>(ContactCache::State::separation))
      throw InputError(where(), "a cache of bytes that no call left there", "zeros, or what a call left");
    states_[row] = static_cast<ContactCache::State>(state);
    for (std::size_t k = 0; k < ContactCaches::width; ++k)
      std::memcpy(columns_.at(k, row), bytes + sizeof state + k * sizeof(double), sizeof(double));
  }

  void pack(std::size_t row, unsigned char* bytes) const {
    const auto state = static_cast<std::int64_t>(states_[row]);
    std::memcpy(bytes, &state, sizeof state);
    for (std::size_t k = 0; k < ContactCaches::width; ++k)
      std::memcpy(bytes + sizeof state + k * sizeof(double), columns_.at(k, row), sizeof(double));
  }

 private:
  ContactCache::State* states_;
  Strided columns_;
};

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
    const Strided columns(superquadrics_.columns);
    for (std::size_t pair = start; pair < end; ++pair) {
      const std::size_t one = body(body_1_[pair], pair), two = body(body_2_[pair], pair);
      const osculate_shape &shape_1 = *bodies_.shape[one], &shape_2 = *bodies_.shape[two];
      if (shape_1.is_superquadric && shape_2.is_superquadric) {
        const std::size_t row = smooth_.pairs.size();
        place(one, columns, 0, row);
        place(two, columns, SuperquadricPairs::per_body, row);
        smooth_.pairs.push_back(pair);
        continue;
      }
      if (!shape_1.is_particle && !shape_2.is_particle)
        throw InputError("pair " + std::to_string(pair), "two walls", "at most one");
      const std::size_t row = any_.pairs.size();
      shapes_.resize(row + 1);
      shapes_.set(row, shape_1.shape, pose(one), shape_2.shape, pose(two));
      any_.pairs.push_back(pair);
    }
    superquadrics_.resize(smooth_.pairs.size());
    shapes_.resize(any_.pairs.size());
    read_caches(smooth_), read_caches(any_);
    if (!smooth_.pairs.empty()) common_normals(superquadrics_, smooth_.caches, smooth_.contacts, gap_);
    if (!any_.pairs.empty()) common_normals(shapes_, any_.caches, any_.contacts, gap_);
    write(smooth_), write(any_);
  }

 private:
  Pose pose(std::size_t i) const {
    const auto& x = bodies_.position;
    const auto& q = bodies_.orientation;
    return {.position = Vec3(x[0][i], x[1][i], x[2][i]), .orientation = Quat(q[0][i], q[1][i], q[2][i], q[3][i])};
  }

  /// A body's index, once it is known to be in order.
  std::size_t body(std::int32_t index, std::size_t pair) const {
    if (index < 0 || static_cast<std::size_t>(index) >= bodies_.size)
      throw InputError("pair " + std::to_string(pair), "body " + std::to_string(index),
                       "an index below " + std::to_string(bodies_.size));
    const auto where = [&] { return "pair " + std::to_string(pair) + ", body " + std::to_string(index); };
    const auto i = static_cast<std::size_t>(index);
    if (bodies_.shape[i] == nullptr) throw c::NullPointer(where() + ", shape");
    const auto& x = bodies_.position;
    const auto& q = bodies_.orientation;
    check_pose({x[0][i], x[1][i], x[2][i]}, {q[0][i], q[1][i], q[2][i], q[3][i]}, where);
    return i;
  }

  /// One body's part of a row of SuperquadricPairs.
  void place(std::size_t i, const Strided& columns, std::size_t column, std::size_t row) const {
    const std::array<double, 5>& shape = bodies_.shape[i]->columns;
    for (const double value : shape) *columns.at(column++, row) = value;
    for (const double* position : bodies_.position) *columns.at(column++, row) = position[i];
    for (const double* orientation : bodies_.orientation) *columns.at(column++, row) = orientation[i];
  }

  void read_caches(Rows& rows) const {
    if (caches_ == nullptr) rows.caches.resize(0);
    rows.caches.resize(rows.pairs.size());  // what is new is empty
    if (caches_ == nullptr) return;
    const CacheRows to(rows.caches);
    for (std::size_t row = 0; row < rows.pairs.size(); ++row)
      to.unpack(caches_ + rows.pairs[row] * cache_bytes, row,
                [&] { return "pair " + std::to_string(rows.pairs[row]); });
  }

  void write(Rows& rows) const {
    const std::size_t size = rows.pairs.size();
    if (size == 0) return;
    for (std::size_t row = 0; row < size; ++row)
      statuses_[rows.pairs[row]] = static_cast<std::int32_t>(rows.contacts.statuses[row]);
    if (caches_ != nullptr) {
      const CacheRows from(rows.caches);
      for (std::size_t row = 0; row < size; ++row) from.pack(row, caches_ + rows.pairs[row] * cache_bytes);
    }
    const std::size_t first = rows.pairs.front();
    const bool contiguous = rows.pairs.back() - first + 1 == size;
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      double* const target = targets_[k];
      const double* const column = rows.contacts.columns[k];
      if (target == nullptr) continue;
      if (contiguous)
        std::copy_n(column, size, target + first);
      else
        for (std::size_t row = 0; row < size; ++row) target[rows.pairs[row]] = column[row];
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
  return cache_bytes;
}

int osculate_find_contact(const osculate_shape* shape_1, const osculate_pose* pose_1, const osculate_shape* shape_2,
                          const osculate_pose* pose_2, int gap, void* cache, osculate_contact* contact) {
  return guarded("osculate_find_contact", [&] {
    const Shape &one = required(shape_1, "shape_1").shape, &two = required(shape_2, "shape_2").shape;
    const Pose at_1 = pose_of(required(pose_1, "pose_1")), at_2 = pose_of(required(pose_2, "pose_2"));
    required(contact, "contact");
    check_pose(std::to_array(pose_1->position), std::to_array(pose_1->orientation), [] { return "pose_1"; });
    check_pose(std::to_array(pose_2->position), std::to_array(pose_2->orientation), [] { return "pose_2"; });
    const Gap how = gap_of(gap);
    ContactCaches caches;
    caches.resize(1);
    auto* const bytes = static_cast<unsigned char*>(cache);
    if (bytes != nullptr) CacheRows(caches).unpack(bytes, 0, [] { return "cache"; });
    ContactCache known = caches.get(0);
    const ContactGeometry found = common_normal(one, at_1, two, at_2, known, how);
    caches.set(0, known);
    if (bytes != nullptr) CacheRows(caches).pack(0, bytes);

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
