#pragma once
// Columns of contacts for the tests of composed laws.

#include <vector>

#include "osculate/core/aligned_allocator.hpp"
#include "osculate/core/types.hpp"
#include "osculate/mechanics/law_registry.hpp"

inline const osculate::ElasticMaterial glass{.youngs_modulus = 71e9, .poissons_ratio = 0.22};
inline const osculate::ElasticMaterial steel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};

struct LawRow {
  double R_i = 2e-3, R_j = 1e-3, overlap = 1e-6;
  osculate::Vec3 normal = osculate::Vec3::UnitZ(), major = osculate::Vec3::UnitX();
  osculate::Vec3 velocity = osculate::Vec3::Zero(), angular = osculate::Vec3::Zero(),
                 mean_angular = osculate::Vec3::Zero();
  double reduced_mass = 1e-5, effective_radius = 1e-3;
};

class LawBed {
 public:
  using Column = std::vector<double>;

  LawBed(const osculate::ContactLaw& law, std::size_t size)
      : memory(law.memory_length(size)),
        status(size),
        in_(std::vector<Column>(20, Column(size))),
        out_(std::vector<Column>(6, Column(size))) {
    for (Column* column : optional()) column->resize(size);
    normal_force.resize(size);
  }

  void set(std::size_t i, const LawRow& row) {
    std::size_t c = 0;
    for (const double value : {row.R_i, row.R_j, row.overlap, row.reduced_mass, row.effective_radius})
      in_[c++][i] = value;
    for (const auto& vector : {row.normal, row.major, row.velocity, row.angular, row.mean_angular})
      for (int k = 0; k < 3; ++k) in_[c++][i] = vector[k];
  }
  /// From now on only what every law must say.
  void drop_optional() {
    for (Column* column : optional()) column->clear();
  }

  osculate::LawInput input() const {
    const auto vectors = [&](std::size_t c) { return osculate::Vectors<const double>{in_[c], in_[c + 1], in_[c + 2]}; };
    return {.R_i = in_[0],
            .R_j = in_[1],
            .overlap = in_[2],
            .normal = vectors(5),
            .major_axis = vectors(8),
            .velocity = vectors(11),
            .angular_velocity = vectors(14),
            .mean_angular_velocity = vectors(17),
            .reduced_mass = in_[3],
            .effective_radius = in_[4],
            .smallest_radius = smallest,
            .time_step = time_step};
  }
  osculate::LawOutput output() {
    return {.force = {out_[0], out_[1], out_[2]},
            .couple = {out_[3], out_[4], out_[5]},
            .normal_force = normal_force,
            .status = status,
            .a_c = a_c,
            .axis_ratio = axis_ratio,
            .stiffness = stiffness,
            .stored_normal = stored_normal,
            .stored_tangential = stored_tangential,
            .viscous_loss = viscous_loss,
            .friction_loss = friction_loss,
            .hysteresis_loss = hysteresis_loss};
  }
  void evaluate(const osculate::ContactLaw& law) { law.evaluate(input(), memory, output()); }

  osculate::Vec3 force(std::size_t i) const { return {out_[0][i], out_[1][i], out_[2][i]}; }
  osculate::Vec3 couple(std::size_t i) const { return {out_[3][i], out_[4][i], out_[5][i]}; }

  double time_step = 1e-6;
  Column smallest;
  std::vector<double, osculate::AlignedAllocator<double>> memory;
  std::vector<osculate::LawStatus> status;
  Column normal_force, a_c, axis_ratio, stiffness, stored_normal, stored_tangential, viscous_loss, friction_loss,
      hysteresis_loss;

 private:
  std::vector<Column*> optional() {
    return {&a_c,          &axis_ratio,    &stiffness,      &stored_normal, &stored_tangential,
            &viscous_loss, &friction_loss, &hysteresis_loss};
  }
  std::vector<Column> in_, out_;
};
