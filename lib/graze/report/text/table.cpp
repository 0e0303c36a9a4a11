#include "graze/report/text/detail/table.hpp"

#include <algorithm>

#include "graze/report/text/detail/line_breaks.hpp"

namespace graze {
namespace {

constexpr std::size_t kIndent = 2;  // blanks before the first column
// and between others, as many as a table has room for.
constexpr std::size_t kWideGap = 3, kNarrowGap = 2;

using Lines = std::vector<std::string>;

std::size_t widest_of(const Lines& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, width_of(line));
  return width;
}

// The rows of a table, each cell in one or more lines.
struct Layout {
  std::vector<std::vector<Lines>> rows;
  std::vector<std::size_t> widths;
  std::size_t gap = kWideGap;
};

// How a table is made narrower.
struct Fitting {
  std::size_t head_lines = 1;  // that heads are broken into, at most
  bool breaks_lists = false;
  std::size_t gap = kWideGap;
};

// The ways to do so, in the order in which they are tried: those that cost lines come last.
constexpr Fitting kFittings[] = {{1, false, kWideGap},   {2, false, kWideGap}, {3, false, kWideGap},
                                 {3, false, kNarrowGap}, {1, true, kWideGap},  {2, true, kWideGap},
                                 {3, true, kNarrowGap}};

Layout laid_out(const std::vector<std::vector<std::string>>& rows, const Fitting& fitting) {
  Layout layout;
  layout.gap = fitting.gap;
  layout.widths.assign(rows.front().size(), 0);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    layout.rows.emplace_back();
    for (std::size_t i = 0; i < rows[r].size(); ++i) {
      const std::string& cell = rows[r][i];
      layout.rows.back().push_back(r == 0                 ? balanced_lines(cell, fitting.head_lines)
                                   : fitting.breaks_lists ? list_lines(cell)
                                                          : Lines{cell});
      layout.widths[i] = std::max(layout.widths[i], widest_of(layout.rows.back().back()));
    }
  }
  return layout;
}

// Column numbers, in the order in which they stand side by side.
using Block = std::vector<std::size_t>;

std::size_t total_width(const Layout& layout, const Block& block) {
  std::size_t width = kIndent;
  for (const std::size_t i : block)
    width += layout.widths[i] + (i == block.front() ? 0 : layout.gap);
  return width;
}

Block all_columns(const Layout& layout) {
  Block block(layout.widths.size());
  for (std::size_t i = 0; i < block.size(); ++i) block[i] = i;
  return block;
}

// As many columns from `first` on as fit beside the keys, up to the end of a group if one fits.
std::size_t block_end(const Layout& layout, const TableColumns& columns, std::size_t first,
                      std::size_t most) {
  Block block;
  for (std::size_t i = 0; i < columns.keys; ++i) block.push_back(i);
  std::size_t end = first;
  while (end < layout.widths.size()) {
    block.push_back(end);
    if (end > first && total_width(layout, block) > most) break;
    ++end;
  }
  if (end == layout.widths.size()) return end;
  for (std::size_t part = end; part > first; --part)
    if (std::count(columns.parts.begin(), columns.parts.end(), part) > 0) return part;
  return end;
}

// Whether a row has contents besides its keys; a row without cells is a separator.
bool shows(const std::vector<Lines>& row, const Block& block, std::size_t keys) {
  return std::any_of(block.begin() + static_cast<std::ptrdiff_t>(keys), block.end(),
                     [&](std::size_t i) { return i < row.size() && widest_of(row[i]) > 0; });
}

std::string line_of(const Layout& layout, const std::vector<Lines>& row, const Block& block,
                    std::size_t line, std::size_t height, bool is_head) {
  std::string text;
  for (const std::size_t i : block) {
    if (i >= row.size()) break;
    // Heads stand on the line above the numbers, cells begin on their first line.
    const std::size_t above = is_head ? height - row[i].size() : 0;
    const std::string cell =
        line >= above && line - above < row[i].size() ? row[i][line - above] : "";
    text += std::string(text.empty() ? kIndent : layout.gap, ' ') +
            std::string(layout.widths[i] - width_of(cell), ' ') + cell;
  }
  return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

std::string text_of(const Layout& layout, const Block& block, std::size_t keys, bool is_first) {
  std::string text;
  for (std::size_t r = 0; r < layout.rows.size(); ++r) {
    const std::vector<Lines>& row = layout.rows[r];
    if (!is_first && !shows(row, block, keys)) continue;
    std::size_t height = 0;
    for (const std::size_t i : block)
      if (i < row.size()) height = std::max(height, row[i].size());
    for (std::size_t line = 0; line < height; ++line)
      text += line_of(layout, row, block, line, height, r == 0);
  }
  return text;
}

}  // namespace

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " (" + unit + ")";
}

std::string Table::text(std::size_t most) const {
  Layout layout;
  for (const Fitting& fitting : kFittings) {
    layout = laid_out(rows_, fitting);
    const Block all = all_columns(layout);
    if (total_width(layout, all) <= most) return text_of(layout, all, columns_.keys, true);
  }
  std::string text;
  for (std::size_t first = columns_.keys, end = 0; first < layout.widths.size(); first = end) {
    end = block_end(layout, columns_, first, most);
    Block block;
    for (std::size_t i = 0; i < columns_.keys; ++i) block.push_back(i);
    for (std::size_t i = first; i < end; ++i) block.push_back(i);
    text += (text.empty() ? "" : "\n") + text_of(layout, block, columns_.keys, text.empty());
  }
  return text;
}

}  // namespace graze
