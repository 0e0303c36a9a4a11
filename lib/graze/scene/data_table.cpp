#include "graze/scene/data_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace graze {
namespace {

std::string stripped(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  std::string inner = text.substr(first, text.find_last_not_of(" \t") - first + 1);
  if (inner.size() >= 2 && inner.front() == '"' && inner.back() == '"')
    inner = inner.substr(1, inner.size() - 2);
  return inner;
}

std::optional<double> plain_number(const std::string& text) {
  const char* first = text.data();
  const char* const last = first + text.size();
  if (first != last && *first == '+') ++first;
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc::result_out_of_range) return HUGE_VAL;
  if (error != std::errc() || end != last) return {};
  return value;
}

// The unit without blanks and multiplication signs: "N m", "N*m" and "Nm" are the same.
std::string plain_unit(const std::string& text) {
  if (text == "1") return "";
  std::string plain;
  for (const char c : text)
    if (c != ' ' && c != '*') plain += c;
  return plain;
}

// The power of ten in a unit that is one times `unit`, -3 of "mm/s" beside "m/s".
std::optional<int> power_of_ten(const std::string& written, const std::string& unit) {
  static constexpr std::pair<const char*, int> kPrefixes[] = {
      {"", 0},   {"n", -9}, {"u", -6}, {"\u00b5", -6}, {"\u03bc", -6},
      {"m", -3}, {"c", -2}, {"k", 3},  {"M", 6},       {"G", 9}};
  const std::string given = plain_unit(written), wanted = plain_unit(unit);
  for (const auto& [prefix, power] : kPrefixes)
    if (given == prefix + wanted &&
        (power == 0 || std::string("smNr").find(wanted[0]) != std::string::npos))
      return power;
  return {};
}

// A cell as a message shows it; it may hold any text.
std::string shown(const std::string& text) {
  constexpr std::size_t kMost = 40;
  std::string plain;
  for (const char c : text.substr(0, kMost)) plain += c < ' ' || c == 0x7f ? '?' : c;
  return text.size() > kMost ? plain + ".." : plain;
}

char parting_of(const std::string& first_row) {
  for (const char parting : {';', ',', '\t'})
    if (first_row.find(parting) != std::string::npos) return parting;
  return ',';
}

}  // namespace

DataTable::DataTable(const std::string& text, std::string name, ColumnNames names)
    : name_(std::move(name)) {
  std::size_t start = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // a byte order mark
  for (int number = 1; start < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::string line = text.substr(start, end - start);
    start = end + 1;
    if (line.ends_with('\r')) line.pop_back();
    if (line.find('\0') != std::string::npos)
      throw InputError({name_, number, static_cast<int>(line.find('\0')) + 1}, "data",
                       "this is no text; a table must be comma-separated numbers under a row of "
                       "names");
    if (stripped(line).empty() || line.front() == '#') continue;
    if (parting_ == '\0') parting_ = parting_of(line);
    Row row = split(line, number);
    if (names_.empty() && names == ColumnNames::kOptional && number_in(row.cells.front().text))
      number_columns(row);
    if (names_.empty()) {
      read_names(std::move(row));
      continue;
    }
    check_width(row);
    for (const Cell& cell : row.cells)
      has_point_ =
          has_point_ || (cell.text.find('.') != std::string::npos && plain_number(cell.text));
    rows_.push_back(std::move(row));
  }
  if (names_.empty())
    throw error(names == ColumnNames::kRequired
                    ? "the file is empty; it needs a row of column names and rows of numbers"
                    : "the file is empty; it needs rows of numbers");
  if (rows_.empty()) throw error("there is no row of numbers below the column names");
}

DataTable::Row DataTable::split(const std::string& line, int number) const {
  Row row{number, {}};
  std::size_t start = 0;
  for (;;) {
    const std::size_t end = std::min(line.find(parting_, start), line.size());
    const std::string cell = line.substr(start, end - start);
    const std::size_t blank = std::min(cell.find_first_not_of(" \t"), cell.size());
    row.cells.push_back({stripped(cell), static_cast<int>(start + blank) + 1});
    if (end == line.size()) return row;
    start = end + 1;
  }
}

void DataTable::read_names(Row row) {
  header_line_ = row.line;
  for (Cell& cell : row.cells) {
    const SourceLocation where{name_, row.line, cell.column};
    if (cell.text.empty()) throw InputError(where, "data", "a column has no name");
    if (number_in(cell.text))
      throw InputError(where, "data",
                       fmt::format("'{}' is a number; the first row must name the columns, e.g. "
                                   "time,force",
                                   shown(cell.text)));
    std::optional<std::string> unit;
    const std::size_t open = cell.text.find_last_of("([");
    if (open != std::string::npos && open > 0 &&
        (cell.text.back() == ')' || cell.text.back() == ']')) {
      unit = cell.text.substr(open + 1, cell.text.size() - open - 2);
      cell.text = stripped(cell.text.substr(0, open));
    }
    if (row.cells.size() == 1 && cell.text.find_first_of(" \t") != std::string::npos)
      throw InputError(where, "data", "columns must be separated by commas, semicolons or tabs");
    if (find(cell.text))
      throw InputError(where, "data",
                       fmt::format("column '{}' stands there twice", shown(cell.text)));
    names_.push_back(cell);
    units_.push_back(std::move(unit));
  }
}

void DataTable::number_columns(const Row& first) {
  header_line_ = first.line;
  named_ = false;
  for (std::size_t i = 0; i < first.cells.size(); ++i)
    names_.push_back({fmt::format("column {}", i + 1), first.cells[i].column});
  units_.resize(names_.size());
}

void DataTable::check_width(const Row& row) const {
  const std::size_t wanted = names_.size(), given = row.cells.size();
  if (given == wanted) return;
  const Cell& at = given > wanted ? row.cells[wanted] : row.cells.back();
  throw InputError(
      {name_, row.line, at.column}, "data",
      fmt::format("the row has {} cell{}, line {} {} {} column{}", given, given == 1 ? "" : "s",
                  header_line_, named_ ? "names" : "has", wanted, wanted == 1 ? "" : "s"));
}

std::optional<std::size_t> DataTable::find(const std::string& column) const {
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (names_[i].text == column) return i;
  return {};
}

double DataTable::number(std::size_t row, std::size_t column) const {
  const std::string& cell = text(row, column);
  const std::string& name = column_name(column);
  if (cell.empty()) throw cell_error(row, column, fmt::format("{}: a number is missing", name));
  const std::optional<double> value = number_in(cell);
  if (!value && has_point_ && cell.find(',') != std::string::npos)
    throw cell_error(row, column,
                     fmt::format("{}: '{}' has a comma where other numbers have a point; numbers "
                                 "must be written in one way, without separators of thousands",
                                 name, shown(cell)));
  if (!value)
    throw cell_error(row, column, fmt::format("{}: '{}' is not a number", name, shown(cell)));
  if (!std::isfinite(*value))
    throw cell_error(row, column,
                     fmt::format("{}: '{}' is not a finite number", name, shown(cell)));
  return *value;
}

double DataTable::number(std::size_t row, std::size_t column, const std::string& unit) const {
  const double value = number(row, column);
  if (!units_[column] || *units_[column] == unit) return value;
  check_unit(column, unit);
  const int power = *power_of_ten(*units_[column], unit);
  // Powers up to 1e9 are exact, so the result is rounded once.
  return power < 0 ? value / std::pow(10.0, -power) : value * std::pow(10.0, power);
}

void DataTable::check_unit(std::size_t column, const std::string& unit) const {
  const std::optional<std::string>& written = units_[column];
  if (!written || power_of_ten(*written, unit)) return;
  throw name_error(column, fmt::format("{}: it is in {}, which is not converted; give it in {}",
                                       column_name(column), *written, unit));
}

std::optional<double> DataTable::number_in(std::string text) const {
  // Where commas part columns there is none in a cell.
  if (const std::size_t comma = text.find(','); comma != std::string::npos && !has_point_)
    text[comma] = '.';
  return plain_number(text);
}

InputError DataTable::cell_error(std::size_t row, std::size_t column,
                                 const std::string& sentence) const {
  return {place(row, column), "data", sentence};
}

InputError DataTable::name_error(std::size_t column, const std::string& sentence) const {
  return {{name_, header_line_, names_[column].column}, "data", sentence};
}

InputError DataTable::error(const std::string& sentence) const {
  return {{name_, std::max(header_line_, 1), 1}, "data", sentence};
}

}  // namespace graze
