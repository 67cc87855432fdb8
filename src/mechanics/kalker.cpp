#include "osculate/mechanics/kalker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate::kalker {
namespace {

constexpr auto nodes = static_cast<std::size_t>(Table::nodes);
using Column = std::array<double, nodes>;

/// a/b: 0.1 … 0.9, 1, and the inverses of 0.9 … 0.1.
constexpr Column ratios{0.1,       0.2,       0.3,       0.4,       0.5,       0.6,       0.7,
                        0.8,       0.9,       1.0,       1.0 / 0.9, 1.0 / 0.8, 1.0 / 0.7, 1.0 / 0.6,
                        1.0 / 0.5, 1.0 / 0.4, 1.0 / 0.3, 1.0 / 0.2, 1.0 / 0.1};

/// [Kalker90] table E.3, first given in his thesis of 1967: coefficient, ν = 0, 1/4, 1/2, ratio.
constexpr std::array<std::array<Column, 3>, 4> published{{
    {{{2.51, 2.59, 2.68, 2.78, 2.88, 2.98, 3.09, 3.19, 3.29, 3.40, 3.51, 3.65, 3.82, 4.06, 4.37, 4.84, 5.57, 6.96,
       10.7},
      {3.31, 3.37, 3.44, 3.53, 3.62, 3.72, 3.81, 3.91, 4.01, 4.12, 4.22, 4.36, 4.54, 4.78, 5.10, 5.57, 6.34, 7.78,
       11.7},
      {4.85, 4.81, 4.80, 4.82, 4.83, 4.91, 4.97, 5.05, 5.12, 5.20, 5.30, 5.42, 5.58, 5.80, 6.11, 6.57, 7.34, 8.82,
       12.9}}},
    {{{2.51, 2.59, 2.68, 2.78, 2.88, 2.98, 3.09, 3.19, 3.29, 3.40, 3.51, 3.65, 3.82, 4.06, 4.37, 4.84, 5.57, 6.96,
       10.7},
      {2.52, 2.63, 2.75, 2.88, 3.01, 3.14, 3.28, 3.41, 3.54, 3.67, 3.81, 3.99, 4.21, 4.50, 4.90, 5.48, 6.40, 8.14,
       12.8},
      {2.53, 2.66, 2.81, 2.98, 3.14, 3.31, 3.48, 3.65, 3.82, 3.98, 4.16, 4.39, 4.67, 5.04, 5.56, 6.31, 7.51, 9.79,
       16.0}}},
    {{{0.334, 0.483, 0.607, 0.720, 0.827, 0.930, 1.03, 1.13, 1.23, 1.33, 1.44, 1.58, 1.76, 2.01, 2.35, 2.88, 3.79, 5.72,
       12.2},
      {0.473, 0.603, 0.715, 0.823, 0.929, 1.03, 1.14, 1.25, 1.36, 1.47, 1.59, 1.75, 1.95, 2.23, 2.62, 3.24, 4.32, 6.63,
       14.6},
      {0.731, 0.809, 0.889, 0.977, 1.07, 1.18, 1.29, 1.40, 1.51, 1.63, 1.77, 1.94, 2.18, 2.50, 2.96, 3.70, 5.01, 7.89,
       18.0}}},
    {{{6.42, 3.46, 2.49, 2.02, 1.74, 1.56, 1.43, 1.34, 1.27, 1.21, 1.16, 1.10, 1.05, 1.01, 0.958, 0.912, 0.868, 0.828,
       0.795},
      {8.28, 4.27, 2.96, 2.32, 1.93, 1.68, 1.50, 1.37, 1.27, 1.19, 1.11, 1.04, 0.965, 0.892, 0.819, 0.747, 0.674, 0.601,
       0.526},
      {11.7, 5.66, 3.72, 2.77, 2.22, 1.86, 1.60, 1.42, 1.27, 1.16, 1.06, 0.954, 0.852, 0.751, 0.650, 0.549, 0.446,
       0.341, 0.228}}},
}};

Column log_ratios() {
  Column x{};
  std::transform(ratios.begin(), ratios.end(), x.begin(), [](double ratio) { return std::log(ratio); });
  return x;
}

/// Second derivatives of the natural cubic spline, by elimination of its tridiagonal system.
Column spline(const Column& x, const Column& y) {
  Column second{}, pivot{};
  for (std::size_t i = 1; i + 1 < nodes; ++i) {
    const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
    const double share = left / (left + right);
    const double p = share * pivot[i - 1] + 2.0;
    const double bend = 6.0 * ((y[i + 1] - y[i]) / right - (y[i] - y[i - 1]) / left) / (left + right);
    pivot[i] = (share - 1.0) / p;
    second[i] = (bend - share * second[i - 1]) / p;
  }
  for (std::size_t i = nodes - 1; i-- > 1;) second[i] += pivot[i] * second[i + 1];
  return second;
}

}  // namespace

Table table(double poissons_ratio) {
  if (!(poissons_ratio >= 0.0 && poissons_ratio <= 0.5))
    throw InputError("kalker::table", "Poisson's ratio " + std::to_string(poissons_ratio),
                     "a value in [0, 0.5], the range of Kalker's table");
  const double s = 4.0 * poissons_ratio;  // 0, 1, 2 at the columns
  const double w0 = 0.5 * (s - 1.0) * (s - 2.0), w1 = s * (2.0 - s), w2 = 0.5 * s * (s - 1.0);
  const Column x = log_ratios();
  Table result{};
  for (std::size_t c = 0; c < published.size(); ++c) {
    const auto& columns = published[c];
    for (std::size_t i = 0; i < nodes; ++i)
      result.logarithm[c][i] = std::log(w0 * columns[0][i] + w1 * columns[1][i] + w2 * columns[2][i]);
    result.curvature[c] = spline(x, result.logarithm[c]);
  }
  return result;
}

Coefficients coefficients(const Table& table, double a_over_b) {
  static const Column x = log_ratios();
  const double at = std::log(a_over_b);
  const double inside = std::clamp(at, x.front(), x.back());
  const auto above = static_cast<std::size_t>(std::upper_bound(x.begin() + 1, x.end() - 1, inside) - x.begin());
  const std::size_t below = above - 1;
  const double h = x[above] - x[below], b = (inside - x[below]) / h, a = 1.0 - b;
  const auto value = [&](std::size_t c) {
    const Column& y = table.logarithm[c];
    const Column& second = table.curvature[c];
    const double spline_value =
        a * y[below] + b * y[above] + ((a * a * a - a) * second[below] + (b * b * b - b) * second[above]) * h * h / 6.0;
    const double slope = (y[above] - y[below]) / h +
                         h / 6.0 * ((3.0 * b * b - 1.0) * second[above] - (3.0 * a * a - 1.0) * second[below]);
    return std::exp(spline_value + slope * (at - inside));
  };
  return {.c11 = value(0), .c22 = value(1), .c23 = value(2), .c33 = value(3), .outside_table = at != inside};
}

double axes_along_rolling(double axis_ratio, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), m1 = axis_ratio * axis_ratio;
  // 1/r² along is c²/a² + s²/b², across s²/a² + c²/b².
  return std::sqrt((m1 * s * s + c * c) / (m1 * c * c + s * s));
}

Composite composite(const ElasticMaterial& material_1, const ElasticMaterial& material_2) {
  validate(material_1);
  validate(material_2);
  const double G_1 = material_1.shear_modulus(), G_2 = material_2.shear_modulus();
  const double G = 2.0 / (1.0 / G_1 + 1.0 / G_2);
  return {.shear_modulus = G,
          .poissons_ratio = 0.5 * G * (material_1.poissons_ratio / G_1 + material_2.poissons_ratio / G_2)};
}

Rolling rolling(const Vec3& normal, const Motion& body_1, const Motion& body_2) {
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  Eigen::Matrix<double, 3, 2> basis;
  basis << e1, e2;
  const Vec3 slip = body_1.velocity - body_2.velocity;
  const Vec3 spin = body_1.angular_velocity - body_2.angular_velocity;
  const Eigen::Matrix2d sum = basis.transpose() * (body_1.shape_operator + body_2.shape_operator) * basis;
  const Eigen::Matrix2d difference = basis.transpose() * (body_1.shape_operator - body_2.shape_operator) * basis;
  const Eigen::Vector2d turning = basis.transpose() * normal.cross(spin);
  const Eigen::Vector2d creep = basis.transpose() * slip;

  Rolling result{};
  const double largest = sum.cwiseAbs().maxCoeff();
  if (!(std::fabs(sum.determinant()) > 1e-24 * largest * largest)) return result;
  const Eigen::Vector2d patch = sum.inverse() * (turning + 0.5 * difference * creep);
  const double V = patch.norm();
  if (!(V > 0.0)) return result;
  result.rolls = true;
  result.velocity = V;
  result.direction = basis * (patch / V);
  result.lateral = normal.cross(result.direction);
  result.creepage = {.longitudinal = slip.dot(result.direction) / V,
                     .lateral = slip.dot(result.lateral) / V,
                     .spin = spin.dot(normal) / V};
  return result;
}

Force linear_force(const Coefficients& coefficients, double shear_modulus, double a_c, double b_c,
                   const Creepage& creepage) {
  const double c2 = a_c * b_c, c = std::sqrt(c2);
  const double unit = c2 * shear_modulus;
  return {.longitudinal = -unit * coefficients.c11 * creepage.longitudinal,
          .lateral = -unit * (coefficients.c22 * creepage.lateral + c * coefficients.c23 * creepage.spin),
          .moment = unit * c * (coefficients.c23 * creepage.lateral - c * coefficients.c33 * creepage.spin)};
}

Force limited(const Force& force, const Limit& limit) {
  if (!(limit.force > 0.0 && limit.moment > 0.0)) return {};
  const double asked =
      std::hypot(std::hypot(force.longitudinal, force.lateral) / limit.force, force.moment / limit.moment);
  if (!(asked > 1.0)) return force;
  return {.longitudinal = force.longitudinal / asked, .lateral = force.lateral / asked, .moment = force.moment / asked};
}

Force sliding(double longitudinal_slip, double lateral_slip, double spin, const Limit& limit) {
  if (!(limit.force > 0.0 && limit.moment > 0.0)) return {};
  const double arm = limit.moment / limit.force;
  const double slip = std::hypot(std::hypot(longitudinal_slip, lateral_slip), arm * spin);
  if (!(slip > 0.0)) return {};
  return {.longitudinal = -limit.force * longitudinal_slip / slip,
          .lateral = -limit.force * lateral_slip / slip,
          .moment = -limit.moment * arm * spin / slip};
}

}  // namespace osculate::kalker
