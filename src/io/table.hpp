#pragma once
// Tables in the terminal: aligned columns under a header, as people read them.

#include <cstddef>
#include <string>
#include <vector>

namespace osculate::io {

/// Rows of text; numbers are formatted by the caller. The first columns hold words and are left-aligned, the others
/// right-aligned.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t words = 1;  ///< columns of words
};

/// The table as text, ending in a newline. Widths count code points, so that δ and ° keep the columns straight.
std::string to_text(const Table& table);

/// The table for a page, numbers to the right.
std::string to_html(const Table& table);

/// A name and what belongs to it.
struct Property {
  std::string name;
  std::string value;
};

/// One a line, values below one another.
std::string to_text(const std::vector<Property>& properties);

}  // namespace osculate::io
