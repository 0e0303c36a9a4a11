// The files that CalculiX (ccx) writes with *FREQUENCY, SOLVER=MATRIXSTORAGE: name.sti and name.mas
// hold the stiffness and the mass as lines of row, column, value, one triangle and the diagonal;
// row k is the k-th line of name.dof.
#include <fmt/format.h>

#include <algorithm>

#include "graze/fem/detail/matrix_entries.hpp"
#include "graze/fem/detail/matrix_formats.hpp"

namespace graze {

LabelledMatrix read_calculix(TextLines& lines) {
  std::vector<MatrixEntry> entries;
  long size = 0;
  while (lines.next()) {
    const auto& parts = lines.parts();
    if (parts.empty()) continue;
    if (parts.size() != 3)
      lines.fail(fmt::format("the line has {} entries, it must have three: row, column, value",
                             parts.size()));
    const long row = lines.integer(parts[0]), column = lines.integer(parts[1]);
    for (const long number : {row, column})
      if (number < 1 || number > 20'000'000)
        lines.fail(fmt::format("the row or column {} is not allowed, it must be from 1 to 20000000",
                               number));
    size = std::max({size, row, column});
    entries.push_back({static_cast<int>(row - 1), static_cast<int>(column - 1), lines.number(),
                       lines.real(parts[2])});
  }
  LabelledMatrix result{lines.name(), {}, numbered_labels(static_cast<int>(size)), false, {}};
  set_entries(result, static_cast<int>(size), std::move(entries), EntryStorage::kEither);
  return result;
}

}  // namespace graze
