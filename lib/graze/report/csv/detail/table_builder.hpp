// Private to this room. Tables of a result, from its description.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "graze/record/described/detail/result_visitor.hpp"
#include "graze/report/csv/result_table.hpp"

namespace graze {

// The names of its tables, in their order.
class TableNames : public ResultVisitor {
 public:
  const std::vector<std::string>& names() const { return names_; }
  bool wants_rows(std::string_view) const override { return true; }
  bool sees_all() const override { return true; }

 protected:
  // A row contains no rows, except for tables beside it.
  bool open(const Field& field, Shape shape) override;
  void close() override {}
  void take(const Field&, const FieldValue&) override {}
  bool wants(Field::Use use) const override { return use != Field::Use::kDocument; }
  bool begin_row(std::string_view table) override;
  void end_row(std::string_view) override { --rows_; }

 private:
  std::vector<std::string> names_;
  int rows_ = 0;  // around what is handed over
};

// Builds one of them. The result has to be described to it twice: for its columns, then its rows.
class TableBuilder : public ResultVisitor {
 public:
  explicit TableBuilder(std::string table) : table_(std::move(table)) {}
  // From now on described fields are rows.
  void begin_rows();
  ResultTable take();
  bool wants_rows(std::string_view table) const override { return table == table_; }
  bool sees_all() const override { return names_columns_; }

 protected:
  bool wants(Field::Use use) const override { return use != Field::Use::kDocument; }
  bool open(const Field& field, Shape shape) override;
  void close() override;
  void take(const Field& field, const FieldValue& value) override;
  bool begin_row(std::string_view table) override;
  void end_row(std::string_view table) override;
  std::string set_prefix(std::string_view words) override;

 private:
  struct Column {
    std::string prefix, name;
    bool in_row;  // else the same in all rows of a scope
    ColumnBuilder cells;
  };
  // Fields outside of rows, which are repeated in all rows within.
  struct Scope {
    std::string_view name;
    std::string prefix;  // before it
    std::size_t first_row;
    struct Cell {
      std::size_t column;
      FieldValue value;
      std::string word;  // that the value refers to
    };
    std::vector<Cell> cells{};
  };
  bool is_in_row() const { return row_depth_ > 0; }
  bool repeats(const Field& field) const;
  std::size_t column_of(std::string_view name, std::string_view unit);
  void add(std::string_view name, std::string_view unit, const FieldValue& value);

  std::string table_;
  bool names_columns_ = true;
  std::vector<Column> columns_;
  std::set<std::string, std::less<>> leads_;  // names of lists and parts with rows in them
  std::vector<Scope> scopes_;
  std::size_t row_depth_ = 0;  // scopes around the row, and itself
  std::size_t rows_ = 0, next_ = 0;
  std::string prefix_;
};

// The table of that name, of a result that `tell` describes to the visitor passed to it.
template <class Tell>
ResultTable built_table(std::string_view name, const Tell& tell) {
  TableBuilder builder{std::string(name)};
  tell(builder);
  builder.begin_rows();
  tell(builder);
  return builder.take();
}

}  // namespace graze
