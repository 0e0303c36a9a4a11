#include "graze/report/csv/detail/table_builder.hpp"

#include <algorithm>
#include <utility>

namespace graze {
namespace {

void add_cell(const FieldValue& value, ColumnBuilder& cells) {
  if (const auto* number = std::get_if<double>(&value)) return cells.add_number(*number);
  if (const auto* whole = std::get_if<long long>(&value)) return cells.add_whole(*whole);
  if (const auto* word = std::get_if<std::string_view>(&value)) return cells.add_word(*word);
  if (const auto* truth = std::get_if<bool>(&value)) return cells.add_truth(*truth);
  const Missing missing = std::get<Missing>(value);
  if (missing == Missing::kWord) return cells.add_word("");
  if (missing == Missing::kTruth) return cells.add_truth(std::nullopt);
  cells.skip(1);
}

// Whether the blank-separated list has the word.
bool has_word(std::string_view list, std::string_view word) {
  for (std::size_t at = list.find(word); at != std::string_view::npos;
       at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' ')) return true;
  }
  return false;
}

}  // namespace

bool TableNames::open(const Field& field, Shape shape) {
  if (field.use == Field::Use::kDocument || shape == Shape::kValues) return false;
  return rows_ == 0 || (shape != Shape::kList && shape != Shape::kColumns);
}

bool TableNames::begin_row(std::string_view table) {
  ++rows_;
  if (std::find(names_.begin(), names_.end(), table) == names_.end()) names_.emplace_back(table);
  return true;
}

void TableBuilder::begin_rows() {
  names_columns_ = false;
  scopes_.push_back({"", "", 0});
}

ResultTable TableBuilder::take() {
  close();
  std::vector<ColumnBuilder> columns;
  for (Column& column : columns_) {
    column.cells.skip(rows_ - column.cells.rows());
    columns.push_back(std::move(column.cells));
  }
  return ResultTable(std::move(columns));
}

bool TableBuilder::open(const Field& field, Shape shape) {
  if (field.use == Field::Use::kDocument || shape == Shape::kValues) return false;
  // A row contains parts, and elements with columns of their own; other lists have rows or none.
  if (is_in_row() && (shape == Shape::kList || shape == Shape::kColumns)) return false;
  if (!is_in_row() && !names_columns_ && shape != Shape::kElement && !leads_.contains(field.name))
    return false;
  scopes_.push_back({field.name, prefix_, rows_});
  if (is_in_row() && shape == Shape::kPart && !field.name.empty())
    prefix_ += std::string(field.name) + "_";
  return true;
}

void TableBuilder::close() {
  const Scope scope = std::move(scopes_.back());
  scopes_.pop_back();
  prefix_ = scope.prefix;
  for (const Scope::Cell& cell : scope.cells) {
    ColumnBuilder& cells = columns_[cell.column].cells;
    cells.skip(scope.first_row - cells.rows());
    const bool is_word = std::holds_alternative<std::string_view>(cell.value);
    const FieldValue value = is_word ? FieldValue(std::string_view(cell.word)) : cell.value;
    while (cells.rows() < rows_) add_cell(value, cells);
  }
}

bool TableBuilder::repeats(const Field& field) const { return has_word(field.tables, table_); }

// Fields come in the order of the columns, except those that an element does not have.
std::size_t TableBuilder::column_of(std::string_view name, std::string_view unit) {
  const auto is_it = [&](const Column& column) {
    return column.name == name && column.prefix == prefix_;
  };
  if (next_ < columns_.size() && is_it(columns_[next_])) return next_++;
  const auto known = std::find_if(columns_.begin(), columns_.end(), is_it);
  const auto at = static_cast<std::size_t>(known - columns_.begin());
  if (known == columns_.end())
    columns_.push_back({prefix_, std::string(name), is_in_row(),
                        ColumnBuilder(prefix_ + std::string(name), std::string(unit))});
  next_ = at + 1;
  return at;
}

void TableBuilder::add(std::string_view name, std::string_view unit, const FieldValue& value) {
  const std::size_t column = column_of(name, unit);
  if (names_columns_) return;
  if (is_in_row()) return add_cell(value, columns_[column].cells);
  const auto* word = std::get_if<std::string_view>(&value);
  scopes_.back().cells.push_back({column, value, word ? std::string(*word) : ""});
}

void TableBuilder::take(const Field& field, const FieldValue& value) {
  if (field.use == Field::Use::kDocument || field.use == Field::Use::kUnit) return;
  if (!is_in_row() && !repeats(field)) return;
  const std::string_view name = field.column.empty() ? field.name : field.column;
  const std::size_t comma = name.find(',');
  if (comma == std::string_view::npos) return add(name, field.unit, value);
  const auto* pair = std::get_if<NumberPair>(&value);
  add(name.substr(0, comma), field.unit, pair ? FieldValue(pair->first) : Missing::kNumber);
  add(name.substr(comma + 1), field.unit, pair ? FieldValue(pair->second) : Missing::kNumber);
}

bool TableBuilder::begin_row(std::string_view table) {
  if (table != table_) return !is_in_row();
  if (names_columns_)
    for (const Scope& scope : scopes_) leads_.emplace(scope.name);
  scopes_.push_back({"", prefix_, rows_});
  row_depth_ = scopes_.size();
  return true;
}

void TableBuilder::end_row(std::string_view table) {
  if (table != table_) return;
  scopes_.pop_back();
  row_depth_ = 0;
  if (names_columns_) return;
  ++rows_;
  for (Column& column : columns_)
    if (column.in_row && column.cells.rows() < rows_) column.cells.skip(1);
}

std::string TableBuilder::set_prefix(std::string_view words) {
  return std::exchange(prefix_, std::string(words));
}

}  // namespace graze
