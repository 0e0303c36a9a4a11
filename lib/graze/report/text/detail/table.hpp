// Aligned text tables with units, one row an orbit or special point.
#pragma once

#include <string>
#include <vector>

namespace graze {

// The head of a column, "gap (m)"; the name alone for a pure number.
std::string with_unit(const std::string& name, const std::string& unit);

// Grouping of the columns of a table, for one that is too wide.
struct TableColumns {
  std::size_t keys = 1;              // the first ones, which say what a row is
  std::vector<std::size_t> parts{};  // where a new part begins
};

// Columns are aligned on the right; the header row comes first. A table that is too wide first has
// its heads and then its lists ("GR at 1, GR at 2") broken into lines; if still too wide, it is cut
// into blocks, one below the other, that repeat the keys and leave out rows without other contents.
// Only a single column that is too wide by itself stays so.
class Table {
 public:
  explicit Table(std::vector<std::string> header, TableColumns columns = {})
      : columns_{std::move(columns)}, rows_{std::move(header)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.size() == 1; }
  // `most`: characters of a line.
  std::string text(std::size_t most) const;

 private:
  TableColumns columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace graze
