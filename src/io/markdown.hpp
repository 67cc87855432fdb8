#pragma once
// Pages of the documentation as HTML: the part of Markdown that they use.

#include <string>
#include <string_view>

namespace osculate::io {

/// Text with & < > " made harmless.
std::string escape_html(std::string_view text);

/// Formulas as they are written in plain text: R_c, F_{3/2}, δ^{3/2}, x^½ with the index below and the power above.
std::string html_of_formula(std::string_view text);

/// Headings, paragraphs, bullet lists, tables (\| is a bar within a cell), `code`, *emphasis* and [links](to), whose
/// text alone is kept; formulas outside code. Headings start at the given level.
std::string html_of_markdown(std::string_view page, int top_level);

}  // namespace osculate::io
