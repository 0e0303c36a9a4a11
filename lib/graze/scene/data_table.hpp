// A table of numbers as text (measurements, a torque over time): columns under a row of names, each
// cell with its place, so that a message can point at it. The first row decides what separates
// columns: a semicolon where it has one, else a comma, else a tab. With semicolons and tabs numbers
// may have a decimal comma.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/errors.hpp"

namespace graze {

// Whether the first row must name the columns, or may hold numbers already.
enum class ColumnNames { kRequired, kOptional };

class DataTable {
 public:
  // `name` stands for the file in messages. Lines that are empty or begin with # are passed over;
  // names and cells may stand in double quotes. Throws InputError (file:line:column) for a text
  // without names or rows, a name that is missing or stands twice, and a row with more or fewer
  // cells than there are columns. Columns without names are called "column 1", "column 2", ..
  DataTable(const std::string& text, std::string name, ColumnNames names = ColumnNames::kRequired);

  const std::string& name() const { return name_; }
  std::size_t columns() const { return names_.size(); }
  std::size_t rows() const { return rows_.size(); }
  // The column's name without its unit: "time" of "time (s)".
  const std::string& column_name(std::size_t column) const { return names_[column].text; }
  // The text in brackets after the name; nullopt when there are none.
  const std::optional<std::string>& column_unit(std::size_t column) const { return units_[column]; }
  std::optional<std::size_t> find(const std::string& column) const;

  // The cell's text.
  const std::string& text(std::size_t row, std::size_t column) const {
    return rows_[row].cells[column].text;
  }
  // The cell as a finite number; throws InputError where it is none.
  double number(std::size_t row, std::size_t column) const;
  // The same in `unit`, where the column's name gives a decimal multiple of it: "t (ms)" read in
  // "s".
  double number(std::size_t row, std::size_t column, const std::string& unit) const;
  // Throws InputError where the column's name gives a unit that is no decimal multiple of `unit`.
  void check_unit(std::size_t column, const std::string& unit) const;
  SourceLocation place(std::size_t row, std::size_t column) const {
    return {name_, rows_[row].line, rows_[row].cells[column].column};
  }

  // An error about a cell, a column's name, or the text as a whole.
  InputError cell_error(std::size_t row, std::size_t column, const std::string& sentence) const;
  InputError name_error(std::size_t column, const std::string& sentence) const;
  InputError error(const std::string& sentence) const;

 private:
  struct Cell {
    std::string text;
    int column = 0;  // in the line, characters from 1
  };
  struct Row {
    int line = 0;
    std::vector<Cell> cells;
  };

  Row split(const std::string& line, int number) const;
  void read_names(Row row);
  void number_columns(const Row& first);
  void check_width(const Row& row) const;
  std::optional<double> number_in(std::string text) const;

  std::string name_;
  char parting_ = '\0';     // what separates columns, once the first row is read
  bool has_point_ = false;  // in some cell
  int header_line_ = 0;     // which says how many columns there are: the row of names, or the first
  bool named_ = true;
  std::vector<Cell> names_;
  std::vector<std::optional<std::string>> units_;
  std::vector<Row> rows_;
};

}  // namespace graze
