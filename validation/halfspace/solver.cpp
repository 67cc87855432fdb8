#include "validation/halfspace/solver.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate::validation::halfspace {
namespace {

struct Free {
  void operator()(void* memory) const { fftw_free(memory); }
};
struct DestroyPlan {
  void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using Plan = std::unique_ptr<fftw_plan_s, DestroyPlan>;

/// ∫∫ dA/r over the rectangle between the origin and the corner (x, y), none of which is zero.                 [Love29]
double corner(double x, double y) {
  return x * std::asinh(y / std::fabs(x)) + y * std::asinh(x / std::fabs(y));
}

/// Deflection at the centre of a cell (i, j) cells away from one under unit pressure, for Ê = 1.
double influence(const Grid& grid, int i, int j) {
  const double left = (i - 0.5) * grid.cell_x, right = (i + 0.5) * grid.cell_x;
  const double low = (j - 0.5) * grid.cell_y, high = (j + 0.5) * grid.cell_y;
  return (corner(right, high) - corner(left, high) - corner(right, low) + corner(left, low)) / std::numbers::pi;
}

/// The deflection of both bodies under a pressure field.
class Deflection {
 public:
  Deflection(const Grid& grid, double modulus)
      : grid_(grid),
        wide_(2 * grid.cells_x),
        high_(2 * grid.cells_y),
        field_(fftw_alloc_real(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_))),
        transform_(fftw_alloc_complex(spectrum_size())),
        forward_(fftw_plan_dft_r2c_2d(high_, wide_, field_.get(), transform_.get(), FFTW_ESTIMATE)),
        backward_(fftw_plan_dft_c2r_2d(high_, wide_, transform_.get(), field_.get(), FFTW_ESTIMATE)) {
    const double scale = 1.0 / (modulus * wide_ * high_);
    for (int j = 0; j < high_; ++j)
      for (int i = 0; i < wide_; ++i)
        at(i, j) = scale * influence(grid, std::min(i, wide_ - i), std::min(j, high_ - j));
    fftw_execute(forward_.get());
    kernel_.resize(spectrum_size());
    for (std::size_t k = 0; k < kernel_.size(); ++k) kernel_[k] = {transform_.get()[k][0], transform_.get()[k][1]};
  }

  void apply(const std::vector<double>& pressure, std::vector<double>& deflection) {
    std::fill_n(field_.get(), static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_), 0.0);
    for (int j = 0; j < grid_.cells_y; ++j)
      for (int i = 0; i < grid_.cells_x; ++i) at(i, j) = pressure[cell(i, j)];
    fftw_execute(forward_.get());
    for (std::size_t k = 0; k < kernel_.size(); ++k) {
      fftw_complex& value = transform_.get()[k];
      const std::complex<double> product = std::complex<double>(value[0], value[1]) * kernel_[k];
      value[0] = product.real(), value[1] = product.imag();
    }
    fftw_execute(backward_.get());
    for (int j = 0; j < grid_.cells_y; ++j)
      for (int i = 0; i < grid_.cells_x; ++i) deflection[cell(i, j)] = at(i, j);
  }

 private:
  std::size_t spectrum_size() const {
    return static_cast<std::size_t>(high_) * static_cast<std::size_t>(wide_ / 2 + 1);
  }
  std::size_t cell(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.cells_x) + static_cast<std::size_t>(i);
  }
  double& at(int i, int j) {
    return field_.get()[static_cast<std::size_t>(j) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(i)];
  }

  Grid grid_;
  int wide_, high_;
  std::unique_ptr<double, Free> field_;
  std::unique_ptr<fftw_complex, Free> transform_;
  Plan forward_, backward_;
  std::vector<std::complex<double>> kernel_;
};

void require(bool good, const std::string& what, double value, const char* expected) {
  if (!good) throw InputError("halfspace", what + " " + std::to_string(value), expected);
}

}  // namespace

Solution solve(const Grid& grid, const std::vector<double>& gap, double modulus, double overlap) {
  require(grid.cells_x >= 2 && grid.cells_y >= 2, "cells", std::min(grid.cells_x, grid.cells_y),
          "two or more each way");
  require(grid.cell_x > 0.0 && grid.cell_y > 0.0, "cell size", std::min(grid.cell_x, grid.cell_y),
          "positive sizes [m]");
  require(modulus > 0.0 && std::isfinite(modulus), "effective modulus", modulus, "a positive, finite value [Pa]");
  require(overlap > 0.0 && std::isfinite(overlap), "overlap", overlap, "a positive, finite value [m]");
  const std::size_t size = static_cast<std::size_t>(grid.cells_x) * static_cast<std::size_t>(grid.cells_y);
  require(gap.size() == size, "gap values", static_cast<double>(gap.size()), "one for each cell");

  Deflection deflection(grid, modulus);
  // In contact at first: where the bodies interpenetrate. A smooth guess of the pressure's size.
  std::vector<double> pressure(size, 0.0), distance(size), direction(size, 0.0), image(size);
  const double width = std::sqrt(grid.cell_x * grid.cells_x * grid.cell_y * grid.cells_y);
  for (std::size_t k = 0; k < size; ++k)
    if (gap[k] < overlap) pressure[k] = modulus * (overlap - gap[k]) / width;

  constexpr int most_iterations = 1000;
  constexpr double tolerance = 1e-9;
  Solution solution{};
  double norm_before = 1.0;
  bool conjugate = false;
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    solution.iterations = iteration;
    deflection.apply(pressure, distance);
    double norm = 0.0, worst = 0.0;
    for (std::size_t k = 0; k < size; ++k) {
      distance[k] += gap[k] - overlap;
      if (pressure[k] > 0.0) {
        norm += distance[k] * distance[k];
        worst = std::max(worst, std::fabs(distance[k]));
      } else {
        worst = std::max(worst, -distance[k]);
      }
    }
    solution.residual = worst / overlap;
    if (solution.residual < tolerance) {
      solution.converged = true;
      break;
    }
    const double turn = conjugate ? norm / norm_before : 0.0;
    norm_before = norm;
    for (std::size_t k = 0; k < size; ++k) direction[k] = pressure[k] > 0.0 ? distance[k] + turn * direction[k] : 0.0;
    deflection.apply(direction, image);
    double along = 0.0, curvature = 0.0;
    for (std::size_t k = 0; k < size; ++k) {
      if (!(pressure[k] > 0.0)) continue;
      along += distance[k] * direction[k];
      curvature += image[k] * direction[k];
    }
    // Nothing in contact touches: the step then only has to bring in what overlaps.
    const double step = curvature > 0.0 ? along / curvature : modulus / width;
    conjugate = true;
    for (std::size_t k = 0; k < size; ++k) {
      if (pressure[k] > 0.0) {
        pressure[k] = std::max(0.0, pressure[k] - step * direction[k]);
      } else if (distance[k] < 0.0) {
        pressure[k] = -step * distance[k];
        conjugate = false;  // the set of contacts has grown
      }
    }
  }

  const double cell = grid.cell_x * grid.cell_y;
  for (const double p : pressure) {
    solution.force += p * cell;
    if (p > 0.0) solution.area += cell;
    solution.peak_pressure = std::max(solution.peak_pressure, p);
  }
  solution.pressure = std::move(pressure);
  return solution;
}

}  // namespace osculate::validation::halfspace
