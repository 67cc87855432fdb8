#pragma once
// Bodies that stand, to be asked whether another one fits between them.

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "osculate/dynamics/body_shape.hpp"
#include "osculate/dynamics/insertion.hpp"
#include "osculate/dynamics/periodic_box.hpp"
#include "osculate/dynamics/random.hpp"

namespace osculate {

class Crowd {
 public:
  /// @param gap  to be kept between any two bodies ≥ 0 [m]
  Crowd(std::span<const BodyShape> shapes, const PeriodicBox& box, double gap);

  void add(std::int32_t shape, const Pose& pose);
  /// True if the body would be further than the gap from all that were added: by the narrow phase, not by spheres.
  bool has_room_for(std::int32_t shape, const Pose& pose) const;

 private:
  struct Member {
    std::int32_t shape;
    Pose pose;
  };
  using Cell = std::array<std::int64_t, 3>;

  const BodyShape& shape_of(const Member& member) const { return shapes_[static_cast<std::size_t>(member.shape)]; }
  double cell_size() const { return 2.0 * largest_ + gap_; }
  Cell cell_of(const Vec3& point) const;
  std::vector<Vec3> nearby_images(const Vec3& position) const;
  bool touches(const Member& one, const Member& other) const;

  std::span<const BodyShape> shapes_;
  PeriodicBox box_;
  double gap_;
  double largest_ = 0.0;
  std::vector<Member> walls_;
  std::map<Cell, std::vector<Member>> particles_;
};

/// Where a particle could go: anywhere in the region, any orientation. Nothing if none of the tries had room.
std::optional<Pose> random_place(const Crowd& crowd, const Region& region, std::int32_t shape, int tries,
                                 Random& random);

/// What insertions of any kind have to say. Throws InputError.
void check_kinds(const Setup& setup, const std::vector<Kind>& kinds, const std::string& where);
void check_numbers(double gap, int tries, const Vec3& velocity, double fluctuation, const std::string& where);

std::vector<double> weights_of(const std::vector<Kind>& kinds);
Vec3 random_velocity(const Vec3& mean, double fluctuation, Random& random);

}  // namespace osculate
