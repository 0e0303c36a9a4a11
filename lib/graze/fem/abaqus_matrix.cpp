// The text that *MATRIX OUTPUT of Abaqus writes (Abaqus Analysis User's Guide, "Generating
// structural matrices"): FORMAT=MATRIX INPUT has lines of row node, row degree of freedom, column
// node, column degree of freedom, value, separated by commas; FORMAT=COORDINATE has row, column,
// value. For a symmetric matrix one triangle by the program's own order of nodes may be listed, or
// both.
#include <fmt/format.h>

#include <algorithm>

#include "graze/fem/detail/label_index.hpp"
#include "graze/fem/detail/matrix_formats.hpp"

namespace graze {
namespace {

// Abaqus holds a degree of freedom by a stiffness of 1e36.
constexpr double kHeldStiffness = 1e30;

DofLabel label_of(const TextLines& lines, std::string_view node, std::string_view direction) {
  DofLabel label{lines.integer(node), 0};
  const long number = lines.integer(direction);
  if (number < 0 || number > 1000)
    lines.fail(
        fmt::format("the degree of freedom {} is not allowed, it must be from 0 to 1000", number));
  label.direction = static_cast<int>(number);
  return label;
}

DofLabel numbered(const TextLines& lines, std::string_view part) {
  const long number = lines.integer(part);
  if (number < 1)
    lines.fail(fmt::format("the row or column {} is not allowed, it must be at least 1", number));
  return {number, 0};
}

// A first line n n m above m lines, none of them beyond row and column n, is no entry.
void refuse_sizes(const TextLines& lines, const std::vector<LabelledEntry>& listed) {
  const LabelledEntry& first = listed.front();
  if (first.row != first.column || first.value != static_cast<double>(listed.size() - 1)) return;
  for (const LabelledEntry& entry : listed)
    if (std::max(entry.row, entry.column) > first.row) return;
  lines.fail_at(first.line,
                fmt::format("the line tells {} rows, {} columns and {} entries, as in a Matrix "
                            "Market file, whose first line is missing: %%MatrixMarket matrix "
                            "coordinate real symmetric (or general)",
                            first.row.node, first.row.node, listed.size() - 1));
}

}  // namespace

LabelledMatrix read_abaqus(TextLines& lines) {
  std::vector<LabelledEntry> listed;
  std::size_t width = 0;  // of the first line
  while (lines.next()) {
    const std::string_view text = trimmed(lines.line());
    if (text.empty() || text.front() == '*') continue;
    const auto& parts = lines.parts();
    if (text.front() == '%')
      lines.fail(
          "the line is a comment of a Matrix Market file, whose first line is missing: "
          "%%MatrixMarket matrix coordinate real symmetric (or general)");
    if (width == 0 && parts.size() != 3 && parts.size() != 5)
      lines.fail(
          fmt::format("the line has {} entries, it must have five (row node, row dof, "
                      "column node, column dof, value) or three (row, column, value)",
                      parts.size()));
    if (width == 0) width = parts.size();
    if (parts.size() != width)
      lines.fail(
          fmt::format("the line has {} entries, the lines before have {}", parts.size(), width));
    if (width == 5)
      listed.push_back({label_of(lines, parts[0], parts[1]), label_of(lines, parts[2], parts[3]),
                        lines.number(), lines.real(parts[4])});
    else
      listed.push_back({numbered(lines, parts[0]), numbered(lines, parts[1]), lines.number(),
                        lines.real(parts[2])});
  }
  if (width == 3) refuse_sizes(lines, listed);
  LabelledMatrix result{lines.name(), {}, {}, width == 5, {}};
  std::vector<MatrixEntry> entries = indexed(listed, result.labels);
  const auto size = static_cast<int>(result.labels.size());
  if (width == 3 && size > 0) {
    // Rows without an entry count as well.
    const auto last = static_cast<int>(result.labels.back().node);
    for (MatrixEntry& entry : entries) {
      entry.row = static_cast<int>(result.labels[static_cast<std::size_t>(entry.row)].node) - 1;
      entry.column =
          static_cast<int>(result.labels[static_cast<std::size_t>(entry.column)].node) - 1;
    }
    result.labels = numbered_labels(last);
  }
  for (const MatrixEntry& entry : entries)
    if (entry.row == entry.column && entry.value >= kHeldStiffness)
      result.held.push_back(result.labels[static_cast<std::size_t>(entry.row)]);
  std::erase_if(entries, [](const MatrixEntry& entry) { return entry.value >= kHeldStiffness; });
  set_entries(result, static_cast<int>(result.labels.size()), std::move(entries),
              EntryStorage::kEither);
  return result;
}

}  // namespace graze
