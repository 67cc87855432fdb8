#pragma once
// The figures of the review [KDY23], computed anew. The project does not have the review's pictures: what a figure
// shows was inferred from the sections that surround it, and its caption says so.

#include <string>
#include <string_view>
#include <vector>

#include "io/plot.hpp"

namespace osculate::validation::kildashti2023 {

struct Figure {
  std::string caption;  ///< what is drawn, with the numbers that were chosen
  io::Plot plot;
};

/// Fig. 2: axes, γ and β of the contact ellipse.
Figure figure2();
/// Fig. 4: Hertz against the simplified model in the three cases.
Figure figure4();
/// Fig. 6: elliptical JKR.
Figure figure6();
/// Fig. 7: rough contacts, elastic and elastic–plastic.
Figure figure7();
/// Fig. 8: viscous and plastic collisions.
Figure figure8();
/// Fig. 12: tangential loops at a constant normal force.
Figure figure12();
/// Fig. 13: oblique loading, and rough surfaces.
Figure figure13();
/// Fig. 14: rolling and twisting.
Figure figure14();

struct FigureEntry {
  std::string_view name;
  Figure (*compute)();
};

const std::vector<FigureEntry>& figures();

}  // namespace osculate::validation::kildashti2023
