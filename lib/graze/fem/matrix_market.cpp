// Matrix Market, https://math.nist.gov/MatrixMarket/formats.html: a line with the format, comments,
// the sizes, the entries; arrays column by column, for a symmetric matrix its lower triangle.
#include <fmt/format.h>

#include "graze/fem/detail/matrix_entries.hpp"
#include "graze/fem/detail/matrix_formats.hpp"

namespace graze {
namespace {

struct Banner {
  bool is_array = false, is_symmetric = false;
};

Banner read_banner(TextLines& lines) {
  lines.next_text();
  const std::vector<std::string_view> words = lines.parts();
  const auto is = [&](std::size_t i, const char* word) {
    return starts_without_case(words[i], word) && words[i].size() == std::string_view(word).size();
  };
  if (words.size() != 5 || !is(1, "matrix"))
    lines.fail(
        "the first line must be \"%%MatrixMarket matrix\" with coordinate or array, real or "
        "integer, general or symmetric");
  Banner banner;
  if (!is(2, "array") && !is(2, "coordinate"))
    lines.fail(
        fmt::format("the format \"{}\" is not allowed, it must be coordinate or array", words[2]));
  banner.is_array = is(2, "array");
  if (!is(3, "real") && !is(3, "integer") && !is(3, "double"))
    lines.fail(
        fmt::format("a matrix of the field \"{}\" has no real numbers, it must be real or "
                    "integer",
                    words[3]));
  if (!is(4, "general") && !is(4, "symmetric"))
    lines.fail(fmt::format("the symmetry \"{}\" is not allowed, it must be general or symmetric",
                           words[4]));
  banner.is_symmetric = is(4, "symmetric");
  return banner;
}

bool next_entry(TextLines& lines) {
  while (lines.next())
    if (const std::string_view text = trimmed(lines.line()); !text.empty() && text.front() != '%')
      return true;
  return false;
}

int index(const TextLines& lines, std::string_view part, int size, const char* what) {
  const long number = lines.integer(part);
  if (number < 1 || number > size)
    lines.fail(
        fmt::format("the {} {} is not allowed, it must be from 1 to {}", what, number, size));
  return static_cast<int>(number - 1);
}

std::vector<MatrixEntry> array_entries(TextLines& lines, int size, bool is_symmetric) {
  std::vector<MatrixEntry> entries;
  for (int j = 0; j < size; ++j) {
    for (int i = is_symmetric ? j : 0; i < size; ++i) {
      if (!next_entry(lines))
        lines.fail(fmt::format("the array ends before its entry ({}, {})", i + 1, j + 1));
      if (lines.parts().size() != 1) lines.fail("a line of an array must hold one number");
      const double value = lines.real(lines.parts().front());
      if (value != 0.0) entries.push_back({i, j, lines.number(), value});
    }
  }
  return entries;
}

std::vector<MatrixEntry> listed_entries(TextLines& lines, int size, long count) {
  std::vector<MatrixEntry> entries;
  for (long k = 0; k < count; ++k) {
    if (!next_entry(lines))
      lines.fail(fmt::format("the file ends after {} of its {} entries", k, count));
    const auto& parts = lines.parts();
    if (parts.size() != 3)
      lines.fail(fmt::format("the line has {} entries, it must have three: row, column, value",
                             parts.size()));
    entries.push_back({index(lines, parts[0], size, "row"), index(lines, parts[1], size, "column"),
                       lines.number(), lines.real(parts[2])});
  }
  return entries;
}

}  // namespace

LabelledMatrix read_matrix_market(TextLines& lines) {
  const Banner banner = read_banner(lines);
  if (!next_entry(lines)) lines.fail("the line with the sizes is missing");
  const std::vector<std::string_view> sizes = lines.parts();
  const std::size_t wanted = banner.is_array ? 2 : 3;
  if (sizes.size() != wanted)
    lines.fail(
        fmt::format("the line of sizes has {} numbers, it must have {}", sizes.size(),
                    banner.is_array ? "two: rows, columns" : "three: rows, columns, entries"));
  const long rows = lines.integer(sizes[0]), columns = lines.integer(sizes[1]);
  if (rows != columns || rows < 1)
    lines.fail(fmt::format("the matrix is {} x {}, it must be square", rows, columns));
  if (rows > 20'000'000) lines.fail(fmt::format("{} rows are more than 20000000", rows));
  const int size = static_cast<int>(rows);
  LabelledMatrix result{lines.name(), {}, numbered_labels(size), false, {}};
  std::vector<MatrixEntry> entries = banner.is_array
                                         ? array_entries(lines, size, banner.is_symmetric)
                                         : listed_entries(lines, size, lines.integer(sizes[2]));
  if (next_entry(lines)) lines.fail("the file goes on after the last of its entries");
  set_entries(result, size, std::move(entries),
              banner.is_symmetric ? EntryStorage::kOneTriangle : EntryStorage::kFull);
  return result;
}

}  // namespace graze
