#pragma once
// The page docs/errata.md, as it was when the program was built.

#include <string_view>

namespace osculate::validation::kildashti2023 {

/// Markdown.
std::string_view errata_page();

}  // namespace osculate::validation::kildashti2023
