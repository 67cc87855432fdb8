#include "validation/kildashti2023/figures.hpp"

namespace osculate::validation::kildashti2023 {

const std::vector<FigureEntry>& figures() {
  static const std::vector<FigureEntry> list{{"fig2", figure2},   {"fig4", figure4},  {"fig6", figure6},
                                             {"fig7", figure7},   {"fig8", figure8},  {"fig12", figure12},
                                             {"fig13", figure13}, {"fig14", figure14}};
  return list;
}

}  // namespace osculate::validation::kildashti2023
