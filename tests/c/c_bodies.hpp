#pragma once
// Bodies for the C API and for the C++ library: the same shapes, placed at random so that many of them touch.

#include <Eigen/Geometry>
#include <cstring>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include "osculate/geometry/shape_contacts.hpp"
#include "osculate/osculate.h"
#include "shapes/sample_shapes.hpp"

struct ShapeHandle {
  osculate_shape* handle = nullptr;

  explicit ShapeHandle(const osculate::Shape& shape) {
    std::visit([&](const auto& s) { make(s); }, shape);
  }
  ShapeHandle(ShapeHandle&& other) noexcept : handle(std::exchange(other.handle, nullptr)) {}
  ShapeHandle& operator=(ShapeHandle&&) = delete;
  ~ShapeHandle() { osculate_free_shape(handle); }

 private:
  void make(const osculate::Sphere& s) { osculate_new_sphere(s.radius, &handle); }
  void make(const osculate::Ellipsoid& s) { osculate_new_ellipsoid(s.half_axes.data(), &handle); }
  void make(const osculate::Superquadric& s) {
    osculate_new_superquadric(s.half_axes.data(), s.exponents.n1, s.exponents.n2, &handle);
  }
  void make(const osculate::PotentialParticle& s) {
    std::vector<double> normals, distances;
    for (const auto& plane : s.planes) {
      normals.insert(normals.end(), plane.normal.begin(), plane.normal.end());
      distances.push_back(plane.distance);
    }
    osculate_new_potential_particle(distances.size(), normals.data(), distances.data(), s.sphericity, s.edge_radius,
                                    s.sphere_radius, &handle);
  }
  void make(const osculate::HalfSpace&) { osculate_new_half_space(&handle); }
  void make(const osculate::Cylinder& s) {
    osculate_new_cylinder(s.radius,
                          s.solid == osculate::Cylinder::Solid::inside ? OSCULATE_SOLID_INSIDE : OSCULATE_SOLID_OUTSIDE,
                          &handle);
  }
  void make(const osculate::SphereContainer& s) { osculate_new_sphere_container(s.radius, &handle); }
};

inline osculate_pose c_pose(const osculate::Pose& pose) {
  const osculate::Vec3& x = pose.position;
  const osculate::Quat& q = pose.orientation;
  return {{x.x(), x.y(), x.z()}, {q.w(), q.x(), q.y(), q.z()}};
}

/// Bodies of centimetres in a crowd.
class Crowd {
 public:
  explicit Crowd(std::vector<osculate::Shape> kinds, std::size_t size, unsigned seed)
      : kinds_(std::move(kinds)), random_(seed) {
    for (const osculate::Shape& kind : kinds_) handles_.emplace_back(kind);
    std::uniform_real_distribution<double> place(-0.02, 0.02);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < size; ++i) {
      kind_.push_back(i % kinds_.size());
      shape_.push_back(handles_[kind_[i]].handle);
      poses_.push_back(
          {.position = osculate::Vec3(place(random_), place(random_), place(random_)),
           .orientation =
               osculate::Quat(normal(random_), normal(random_), normal(random_), normal(random_)).normalized()});
    }
    fill_columns();
  }

  /// A small motion of all.
  void move() {
    std::normal_distribution<double> normal;
    for (osculate::Pose& pose : poses_) {
      pose.position += 1e-5 * osculate::Vec3(normal(random_), normal(random_), normal(random_));
      const osculate::Vec3 turn = 1e-3 * osculate::Vec3(normal(random_), normal(random_), normal(random_));
      pose.orientation =
          (osculate::Quat(1.0, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()) * pose.orientation).normalized();
    }
    fill_columns();
  }

  std::size_t size() const { return poses_.size(); }
  const osculate::Shape& shape(std::size_t i) const { return kinds_[kind_[i]]; }
  const osculate_shape* handle(std::size_t i) const { return shape_[i]; }
  const osculate::Pose& pose(std::size_t i) const { return poses_[i]; }
  osculate_bodies bodies() const {
    const auto column = [&](std::size_t k) { return columns_[k].data(); };
    return {size(), shape_.data(), {column(0), column(1), column(2)}, {column(3), column(4), column(5), column(6)}};
  }

 private:
  void fill_columns() {
    for (auto& column : columns_) column.resize(size());
    for (std::size_t i = 0; i < size(); ++i) {
      const osculate_pose pose = c_pose(poses_[i]);
      for (std::size_t k = 0; k < 3; ++k) columns_[k][i] = pose.position[k];
      for (std::size_t k = 0; k < 4; ++k) columns_[3 + k][i] = pose.orientation[k];
    }
  }

  std::vector<osculate::Shape> kinds_;
  std::vector<ShapeHandle> handles_;
  std::mt19937 random_;
  std::vector<std::size_t> kind_;
  std::vector<const osculate_shape*> shape_;
  std::vector<osculate::Pose> poses_;
  std::vector<double> columns_[7];
};

/// Bytes at an address that suits nothing but bytes; `move` takes them elsewhere, as a host does.
class OddBytes {
 public:
  explicit OddBytes(std::size_t size) : size_(size), bytes_(size + 2, 0) {}
  void* data() { return bytes_.data() + 1; }
  void move() {
    std::vector<unsigned char> elsewhere(size_ + 2, 0xAA);
    std::memcpy(elsewhere.data() + 1, data(), size_);
    std::fill(bytes_.begin(), bytes_.end(), static_cast<unsigned char>(0xAA));
    bytes_.swap(elsewhere);
  }

 private:
  std::size_t size_;
  std::vector<unsigned char> bytes_;
};
