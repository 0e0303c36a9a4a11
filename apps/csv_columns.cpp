#include "csv_columns.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

namespace graze {
namespace {

// The cells of a line; those in quotes hold commas, and quotes twice.
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char letter = line[i];
    if (letter == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"')
        cells.back() += line[++i];
      else
        quoted = !quoted;
    } else if (letter == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += letter;
    }
  }
  return cells;
}

template <class Number>
bool reads(const std::string& cell, Number& number) {
  const char* end = cell.data() + cell.size();
  const auto read = std::from_chars(cell.data(), end, number);
  return read.ec == std::errc() && read.ptr == end;
}

// One column as it grows: whole numbers until a cell is none, then numbers until a cell is none.
class GrowingColumn {
 public:
  explicit GrowingColumn(std::string name) : name_(std::move(name)) {}

  void add(const std::string& cell) {
    if (is_whole_) {
      std::int64_t number = 0;
      if (reads(cell, number)) {
        whole_.push_back(number);
        return;
      }
      is_whole_ = false;
      for (const std::int64_t value : whole_) numbers_.push_back(static_cast<double>(value));
    }
    if (!is_words_) {
      double number = NAN;
      if (cell.empty() || reads(cell, number)) {
        numbers_.push_back(number);
        return;
      }
      // Numbers before the first word are no column of the tables that there are.
      is_words_ = true;
      words_.codes.assign(numbers_.size(), -1);
    }
    add_word(cell);
  }

  CsvColumn column() && {
    if (is_words_) return {std::move(name_), std::move(words_)};
    if (is_whole_ && !whole_.empty()) return {std::move(name_), std::move(whole_)};
    return {std::move(name_), std::move(numbers_)};
  }

 private:
  void add_word(const std::string& cell) {
    if (cell.empty()) {
      words_.codes.push_back(-1);
      return;
    }
    const auto [at, is_new] = places_.emplace(cell, static_cast<std::int32_t>(words_.words.size()));
    if (is_new) words_.words.push_back(cell);
    words_.codes.push_back(at->second);
  }

  std::string name_;
  bool is_whole_ = true, is_words_ = false;
  std::vector<std::int64_t> whole_;
  std::vector<double> numbers_;
  WordColumn words_;
  std::map<std::string, std::int32_t> places_;
};

}  // namespace

std::vector<CsvColumn> csv_columns(const std::string& text) {
  std::vector<GrowingColumn> growing;
  bool is_head = true;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::vector<std::string> cells =
        cells_of(std::string_view(text).substr(start, end - start));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (is_head)
        growing.emplace_back(cells[i]);
      else if (i < growing.size())
        growing[i].add(cells[i]);
    }
    is_head = false;
    start = end + 1;
  }
  std::vector<CsvColumn> columns;
  for (GrowingColumn& column : growing) columns.push_back(std::move(column).column());
  return columns;
}

}  // namespace graze
