// A table of a result: named columns of numbers or words, filled row by row.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "graze/record/file/spool.hpp"

namespace graze {

// Repeated words, each by its index in the list of distinct ones; -1: none.
struct WordColumn {
  std::vector<std::int32_t> codes;
  std::vector<std::string> words;
};

// True (1), false (0), or not known (-1).
struct TruthColumn {
  std::vector<std::int8_t> codes;
};

struct ResultColumn {
  std::string name;
  // Whole numbers, if all are and none is missing; numbers, NaN for missing ones; words; or truth
  // values.
  std::variant<std::vector<std::int64_t>, std::vector<double>, WordColumn, TruthColumn> values;
  std::string unit{};  // SI; empty of pure numbers, words and truths
};

// A column that grows cell by cell. It holds numbers, words or truths, never two of them.
class ColumnBuilder {
 public:
  explicit ColumnBuilder(std::string name, std::string unit = {})
      : column_{std::move(name), std::vector<std::int64_t>(), std::move(unit)} {}

  // A number that is not finite is no value.
  void add_number(double value);
  void add_whole(std::int64_t value);
  // An empty word is no value.
  void add_word(std::string_view word);
  void add_truth(std::optional<bool> holds);
  // Adds `count` cells without a value.
  void skip(std::size_t count);

  std::size_t rows() const;
  const ResultColumn& column() const { return column_; }
  // Moves the column out; without rows it is one of numbers.
  ResultColumn take();

 private:
  std::vector<double>& numbers();

  ResultColumn column_;
  std::unordered_map<std::string, std::int32_t> places_;  // of words
};

class ResultTable {
 public:
  explicit ResultTable(std::vector<ColumnBuilder> columns) : columns_(std::move(columns)) {}
  // `names`: a line of the columns' names, with commas between them.
  explicit ResultTable(const std::string& names);

  // The next cells, from left to right; behind the last column of a row the next one begins. A
  // number that is not finite, an empty optional and an empty word are no value. A column holds
  // numbers, words or truths, never two of them; as text true is 1 and false 0.
  template <class... Cells>
  ResultTable& add(const Cells&... cells) {
    (add_cell(cells), ...);
    return *this;
  }
  // Adds `count` cells without a value.
  ResultTable& skip(std::size_t count);

  const std::vector<ColumnBuilder>& columns() const { return columns_; }
  // Moves the columns out; those of an empty table are columns of numbers.
  std::vector<ResultColumn> take_columns();

  // As comma-separated text: a row of names, then every number with all its digits; words with
  // commas or quotes stand in quotes. Row by row.
  void write_csv(const TextSink& sink) const;

 private:
  void add_cell(double value) { next_column().add_number(value); }
  template <std::same_as<bool> Truth>
  void add_cell(Truth holds) {
    next_column().add_truth(holds);
  }
  template <std::integral Whole>
  requires(!std::same_as<Whole, bool>) void add_cell(Whole value) {
    next_column().add_whole(static_cast<std::int64_t>(value));
  }
  void add_cell(std::string_view word) { next_column().add_word(word); }
  void add_cell(std::nullopt_t) { skip(1); }
  template <class Cell>
  void add_cell(const std::optional<Cell>& cell) {
    if constexpr (std::same_as<Cell, bool>)
      next_column().add_truth(cell);
    else if (cell)
      add_cell(*cell);
    else
      skip(1);
  }

  ColumnBuilder& next_column();

  std::vector<ColumnBuilder> columns_;
  std::size_t next_ = 0;  // column
};

// Its text in one piece.
std::string csv_text(const ResultTable& table);

}  // namespace graze
