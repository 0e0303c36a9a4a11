// Aligned text tables with units, one row an orbit or special point.
#pragma once

#include <string>
#include <vector>

namespace graze {

// The head of a column, "gap (m)"; the name alone of a pure number.
std::string with_unit(const std::string& name, const std::string& unit);

// Columns line up on the right; the header row comes first.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.size() == 1; }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace graze
