#pragma once
// The laws against values that were computed with 40-digit arithmetic, without this library.

#include <filesystem>
#include <string>
#include <vector>

namespace osculate::validation::contact_mechanics {

/// One quantity over all rows of its family.
struct QuantityError {
  std::string family;
  std::string quantity;     ///< as the file names it
  std::size_t values = 0;   ///< how many were compared
  double worst = 0.0;       ///< largest relative error; absolute where the reference is 0
  std::string lost_digits;  ///< the difference that the question itself loses digits in; else empty
};

/// What every quantity is asked to reach.
inline constexpr double bar = 1e-11;

/// The families hertz, greenwood_williamson, johnson_greenwood, tangential and mindlin_cycle of a file like
/// tests/data/contact_mechanics.json. Throws InputError for a file that cannot be read or lacks something.
std::vector<QuantityError> reference_errors(const std::filesystem::path& file);

}  // namespace osculate::validation::contact_mechanics
