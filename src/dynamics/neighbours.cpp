#include "dynamics/neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace osculate {
namespace {

using Cell = Eigen::Array<std::int64_t, 3, 1>;

/// Cells of one size; those along x are consecutive.
class Grid {
 public:
  Grid(const Vec3& lower, const Vec3& upper, double cell, const PeriodicBox& box) {
    constexpr double most_cells = 1 << 20;  // an axis: three of them fit into a key
    for (Eigen::Index k = 0; k < 3; ++k) {
      const bool repeats = std::isfinite(box.length[k]);
      // Across the gradient of a shear no cells of a box and its image face each other.
      periodic_[static_cast<std::size_t>(k)] = repeats && !(box.shear && box.shear->gradient == k);
      origin_[k] = repeats ? box.origin[k] : lower[k];
      const double length = repeats ? box.length[k] : upper[k] - lower[k];
      const double count = std::clamp(std::floor(length / cell), 1.0, most_cells);
      count_[k] = static_cast<std::int64_t>(count);
      inverse_cell_[k] = length > 0.0 ? count / length : 0.0;
    }
  }

  Cell cell_of(const Vec3& x) const {
    const Eigen::Array3d place = ((x - origin_).array() * inverse_cell_.array()).floor();
    return place.max(0.0).cast<std::int64_t>().min(count_ - 1);
  }
  std::int64_t key(const Cell& cell) const { return (cell[2] * count_[1] + cell[1]) * count_[0] + cell[0]; }

  void insert(std::int64_t key, std::int32_t ball) { entries_.push_back({key, ball}); }
  void sort() { std::sort(entries_.begin(), entries_.end()); }

  /// Calls visit(ball) for the balls in a cell and around it, each once.
  template <class Visit>
  void visit_around(const Cell& cell, const Visit& visit) const {
    const Runs along_x = runs(cell, 0), along_y = runs(cell, 1), along_z = runs(cell, 2);
    for (int c = 0; c < along_z.count; ++c)
      for (std::int64_t z = along_z.first[c]; z <= along_z.last[c]; ++z)
        for (int b = 0; b < along_y.count; ++b)
          for (std::int64_t y = along_y.first[b]; y <= along_y.last[b]; ++y)
            for (int a = 0; a < along_x.count; ++a)
              visit_run(key({along_x.first[a], y, z}), along_x.last[a] - along_x.first[a], visit);
  }

 private:
  struct Entry {
    std::int64_t key;
    std::int32_t ball;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  /// Consecutive cells along an axis; two runs where the box repeats between them.
  struct Runs {
    std::int64_t first[2], last[2];
    int count;
  };

  /// The distinct cells −1, 0, +1 from one.
  Runs runs(const Cell& cell, Eigen::Index axis) const {
    const std::int64_t end = count_[axis] - 1, below = cell[axis] - 1, above = cell[axis] + 1;
    const auto single = [](std::int64_t first, std::int64_t last) { return Runs{{first, 0}, {last, 0}, 1}; };
    if (!periodic_[static_cast<std::size_t>(axis)] || (below >= 0 && above <= end))
      return single(std::max<std::int64_t>(below, 0), std::min(above, end));
    if (end <= 2) return single(0, end);
    if (below < 0) return {{0, end}, {1, end}, 2};
    return {{0, end - 1}, {0, end}, 2};
  }

  template <class Visit>
  void visit_run(std::int64_t first, std::int64_t more, const Visit& visit) const {
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), first,
                                  [](const Entry& e, std::int64_t key) { return e.key < key; });
    for (; entry != entries_.end() && entry->key <= first + more; ++entry) visit(entry->ball);
  }

  std::array<bool, 3> periodic_{};
  Vec3 origin_, inverse_cell_;
  Cell count_;
  std::vector<Entry> entries_;
};

int level_of(double radius, double smallest) {
  return std::max(0, std::ilogb(radius / smallest));
}

}  // namespace

/// The images of a ball across the gradient of a shear that may touch a ball in the box.
std::vector<Vec3> sheared_images(const PeriodicBox& box, const Vec3& centre, double reach) {
  std::vector<Vec3> images;
  if (!box.shear) return images;
  const BoxShear& shear = *box.shear;
  for (const double side : {-1.0, 1.0}) {
    Vec3 image = centre + side * (box.length[shear.gradient] * Vec3::Unit(shear.gradient) +
                                  shear.offset * Vec3::Unit(shear.flow));
    const double above = image[shear.gradient] - box.origin[shear.gradient];
    if (above < -reach || above > box.length[shear.gradient] + reach) continue;
    const double length = box.length[shear.flow], along = image[shear.flow] - box.origin[shear.flow];
    image[shear.flow] -= length * std::floor(along / length);
    images.push_back(image);
  }
  return images;
}

std::vector<BodyPair> touching_balls(std::span<const Ball> balls, const PeriodicBox& box) {
  std::vector<BodyPair> pairs;
  if (balls.size() < 2) return pairs;
  std::vector<Vec3> centres(balls.size());
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  double smallest = balls[0].radius, largest = smallest;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    centres[i] = wrapped(box, balls[i].centre);
    lower = lower.cwiseMin(centres[i]);
    upper = upper.cwiseMax(centres[i]);
    smallest = std::min(smallest, balls[i].radius);
    largest = std::max(largest, balls[i].radius);
  }
  std::vector<Grid> grids;
  std::vector<double> largest_of(static_cast<std::size_t>(level_of(largest, smallest)) + 1, 0.0);
  for (const Ball& ball : balls) {
    double& most = largest_of[static_cast<std::size_t>(level_of(ball.radius, smallest))];
    most = std::max(most, ball.radius);
  }
  for (const double most : largest_of) grids.emplace_back(lower, upper, 2.0 * std::max(most, smallest), box);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    Grid& grid = grids[static_cast<std::size_t>(level_of(balls[i].radius, smallest))];
    grid.insert(grid.key(grid.cell_of(centres[i])), static_cast<std::int32_t>(i));
  }
  for (Grid& grid : grids) grid.sort();

  for (std::size_t i = 0; i < balls.size(); ++i) {
    const auto index = static_cast<std::int32_t>(i);
    const auto level = static_cast<std::size_t>(level_of(balls[i].radius, smallest));
    for (std::size_t other = level; other < grids.size(); ++other) {
      if (largest_of[other] == 0.0) continue;
      const auto add_if_touching = [&](std::int32_t j) {
        if (other == level && j <= index) return;
        const auto at = static_cast<std::size_t>(j);
        Vec3 apart = centres[at] - centres[i];
        if (box.repeats()) apart += nearest_image_shift(box, apart);
        const double reach = balls[i].radius + balls[at].radius;
        if (apart.squaredNorm() <= reach * reach) pairs.push_back({std::min(index, j), std::max(index, j)});
      };
      grids[other].visit_around(grids[other].cell_of(centres[i]), add_if_touching);
      for (const Vec3& image : sheared_images(box, centres[i], balls[i].radius + largest_of[other]))
        grids[other].visit_around(grids[other].cell_of(image), add_if_touching);
    }
  }
  if (box.shear) {  // a ball may be seen next to another one and next to its image
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }
  return pairs;
}

}  // namespace osculate
