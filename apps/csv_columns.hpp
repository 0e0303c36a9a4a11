// A table of comma-separated text as columns of numbers and words.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace graze {

// Words that stand often, each by its place among those that there are; -1: an empty cell.
struct WordColumn {
  std::vector<std::int32_t> codes;
  std::vector<std::string> words;
};

struct CsvColumn {
  std::string name;
  // Numbers, NaN for empty cells; whole numbers, where all are and none is missing; or words.
  std::variant<std::vector<double>, std::vector<std::int64_t>, WordColumn> values;
};

// Of a text that one of the functions of csv.hpp made.
std::vector<CsvColumn> csv_columns(const std::string& text);

}  // namespace graze
