#pragma once
// Pages of the documentation as HTML: the part of Markdown that they use.

#include <string>
#include <string_view>

namespace osculate::io {

/// Text with & < > " made harmless.
std::string escape_html(std::string_view text);

/// Headings, paragraphs, bullet lists, tables (\| is a bar within a cell), `code`, *emphasis* and [links](to), whose
/// text alone is kept. Headings start at the given level.
std::string html_of_markdown(std::string_view page, int top_level);

}  // namespace osculate::io
