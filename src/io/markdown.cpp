#include "io/markdown.hpp"

#include <fmt/core.h>

#include <cctype>
#include <sstream>
#include <vector>

namespace osculate::io {
namespace {

/// How many bytes the character at a place takes in UTF-8.
std::size_t length_of_character(std::string_view text, std::size_t at) {
  std::size_t length = 1;
  while (at + length < text.size() && (static_cast<unsigned char>(text[at + length]) & 0xC0U) == 0x80U) ++length;
  return length;
}

/// An index or power that begins at a place of a text.
struct Script {
  std::string_view content;
  std::size_t end;  ///< place after it; the place itself if there is none
};

Script script_at(std::string_view text, std::size_t at, char kind) {
  if (at >= text.size()) return {{}, at};
  if (text[at] == '{') {
    const std::size_t close = text.find('}', at);
    return close == std::string_view::npos ? Script{{}, at} : Script{text.substr(at + 1, close - at - 1), close + 1};
  }
  std::size_t end = at;
  if (kind == '^') {
    if (text[at] != ' ') end += length_of_character(text, at);
  } else {
    while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end])) != 0) ++end;
  }
  return {text.substr(at, end - at), end};
}

/// Code, emphasis and links within a line.
std::string html_of_line(std::string_view line) {
  std::string html, plain;
  const auto add = [&](const std::string& part) {
    html += html_of_formula(plain) + part;
    plain.clear();
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '\\' && i + 1 < line.size() && std::ispunct(static_cast<unsigned char>(line[i + 1])) != 0) {
      add(escape_html(line.substr(++i, 1)));
      continue;
    }
    const std::size_t end = c == '`' || c == '*' ? line.find(c, i + 1) : std::string_view::npos;
    // "F_t* and δ*" are formulas: emphasis begins before a letter, after a space, and ends within the line.
    const bool begins_word = (i == 0 || line[i - 1] == ' ') && i + 1 < line.size() && line[i + 1] != ' ';
    if (end != std::string_view::npos && (c == '`' || begins_word)) {
      const std::string_view inner = line.substr(i + 1, end - i - 1);
      add(c == '`' ? "<code>" + escape_html(inner) + "</code>" : "<em>" + html_of_line(inner) + "</em>");
      i = end;
      continue;
    }
    if (c == '[') {
      const std::size_t close = line.find("](", i), last = line.find(')', close);
      if (close != std::string_view::npos && last != std::string_view::npos) {
        add(html_of_line(line.substr(i + 1, close - i - 1)));
        i = last;
        continue;
      }
    }
    plain += c;
  }
  add("");
  return html;
}

std::vector<std::string> cells_of(std::string_view row) {
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i] == '|' && row[i - 1] != '\\') {
      const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
      cell.clear();
    } else {
      cell += row[i];
    }
  }
  return cells;
}

bool is_rule(std::string_view row) {
  return row.find_first_not_of("|-: ") == std::string_view::npos;
}

/// Lines that belong together, and what they are.
enum class Block { none, paragraph, list, table };

class Page {
 public:
  explicit Page(int top_level) : top_level_(top_level) {}

  void add(const std::string& line) {
    if (line.empty()) return begin(Block::none);
    if (line[0] == '#') {
      begin(Block::none);
      const std::size_t depth = line.find_first_not_of('#');
      const int level = top_level_ + static_cast<int>(depth) - 1;
      html_ += fmt::format("<h{0}>{1}</h{0}>\n", level, html_of_line(line.substr(depth + 1)));
    } else if (line[0] == '|') {
      const bool first = block_ != Block::table;
      begin(Block::table);
      if (!is_rule(line)) add_row(line, first ? "th" : "td");
    } else if (line.rfind("- ", 0) == 0) {
      begin(Block::list);
      html_ += "<li>" + html_of_line(line.substr(2)) + "\n";
    } else {
      if (block_ != Block::list) begin(Block::paragraph);
      html_ += html_of_line(line) + "\n";
    }
  }

  std::string finish() {
    begin(Block::none);
    return html_;
  }

 private:
  void begin(Block block) {
    if (block == block_) return;
    static constexpr const char* close[] = {"", "</p>\n", "</ul>\n", "</table>\n"};
    static constexpr const char* open[] = {"", "<p>", "<ul>\n", "<table>\n"};
    html_ += close[static_cast<int>(block_)];
    html_ += open[static_cast<int>(block)];
    block_ = block;
  }

  void add_row(const std::string& line, const char* cell) {
    html_ += "<tr>";
    for (const auto& text : cells_of(line)) html_ += fmt::format("<{0}>{1}</{0}>", cell, html_of_line(text));
    html_ += "</tr>\n";
  }

  int top_level_;
  Block block_ = Block::none;
  std::string html_;
};

}  // namespace

std::string escape_html(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string html_of_formula(std::string_view text) {
  std::string html;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    // An index or power stands behind something.
    if ((c == '_' || c == '^') && i > 0 && text[i - 1] != ' ') {
      const Script script = script_at(text, i + 1, c);
      if (script.end > i + 1) {
        const char* element = c == '_' ? "sub" : "sup";
        html += fmt::format("<{0}>{1}</{0}>", element, html_of_formula(script.content));
        i = script.end;
        continue;
      }
    }
    html += escape_html(text.substr(i, 1));
    ++i;
  }
  return html;
}

std::string html_of_markdown(std::string_view page, int top_level) {
  Page html(top_level);
  std::istringstream lines{std::string(page)};
  for (std::string line; std::getline(lines, line);) html.add(line);
  return html.finish();
}

}  // namespace osculate::io
