#include "io/colour.hpp"

#include <algorithm>
#include <array>

namespace osculate::io {

Colour viridis(double value) {
  // A sixth-degree fit to the table, coefficients by M. Zucker (public domain), constant term first.
  constexpr std::array<std::array<double, 3>, 7> coefficients{
      {{0.2777273272234177, 0.005407344544966578, 0.3340998053353061},
       {0.1050930431085774, 1.404613529898575, 1.384590162594685},
       {-0.3308618287255563, 0.214847559468213, 0.09509516302823659},
       {-4.634230498983486, -5.799100973351585, -19.33244095627987},
       {6.228269936347081, 14.17993336680509, 56.69055260068105},
       {4.776384997670288, -13.74514537774601, -65.35303263337234},
       {-5.435455855934631, 4.645852612178535, 26.3124352495832}}};
  const double t = std::clamp(value, 0.0, 1.0);
  std::array<double, 3> channel{};
  for (auto row = coefficients.rbegin(); row != coefficients.rend(); ++row) {
    for (std::size_t i = 0; i < 3; ++i) channel[i] = channel[i] * t + (*row)[i];
  }
  for (double& c : channel) c = std::clamp(c, 0.0, 1.0);
  return {channel[0], channel[1], channel[2]};
}

}  // namespace osculate::io
