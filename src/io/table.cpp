#include "io/table.hpp"

#include <algorithm>
#include <cstddef>

#include "io/markdown.hpp"

namespace osculate::io {
namespace {

std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::string to_text(const Table& table) {
  std::vector<std::size_t> widths;
  const auto measure = [&](const std::vector<std::string>& row) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  };
  measure(table.header);
  for (const auto& row : table.rows) measure(row);

  std::string text;
  const auto write = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - width(row[i]), ' ');
      if (i > 0) text += "  ";
      text += i < table.words ? row[i] + padding : padding + row[i];
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  };
  write(table.header);
  std::size_t total = 0;
  for (std::size_t i = 0; i < widths.size(); ++i) total += widths[i] + (i > 0 ? 2 : 0);
  text += std::string(total, '-') + '\n';
  for (const auto& row : table.rows) write(row);
  return text;
}

std::string to_html(const Table& table) {
  std::string html = "<table>\n";
  const auto write = [&](const std::vector<std::string>& row, const std::string& cell) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html.append("<").append(cell).append(i < table.words ? ">" : " class=\"number\">");
      html.append(escape_html(row[i])).append("</").append(cell).append(">");
    }
    html += "</tr>\n";
  };
  write(table.header, "th");
  for (const auto& row : table.rows) write(row, "td");
  return html + "</table>\n";
}

std::string to_text(const std::vector<Property>& properties) {
  std::size_t widest = 0;
  for (const Property& property : properties) widest = std::max(widest, width(property.name));
  std::string text;
  for (const Property& property : properties) {
    text += property.name + std::string(widest - width(property.name) + 3, ' ') + property.value + '\n';
  }
  return text;
}

}  // namespace osculate::io
