#pragma once
// Colours of pictures.

#include <string_view>

namespace osculate::io {

/// sRGB, each in [0, 1].
struct Colour {
  double red, green, blue;
};

/// A palette that stays apart in print and for colour-blind eyes (after Okabe & Ito).
namespace palette {
inline constexpr Colour black{0.10, 0.10, 0.12};
inline constexpr Colour grey{0.55, 0.57, 0.60};
inline constexpr Colour blue{0.25, 0.50, 0.75};
inline constexpr Colour orange{0.90, 0.58, 0.15};
inline constexpr Colour green{0.10, 0.60, 0.45};
inline constexpr Colour red{0.80, 0.25, 0.15};
inline constexpr Colour purple{0.58, 0.36, 0.65};
}  // namespace palette

/// The perceptually uniform colour map "viridis" (S. van der Walt & N. Smith, matplotlib) from dark violet at 0 to
/// yellow at 1, within 0.015 of its table; values outside are clamped.
Colour viridis(double value);

}  // namespace osculate::io
