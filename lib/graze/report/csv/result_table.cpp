#include "graze/report/csv/result_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace graze {
namespace {

constexpr std::size_t kPiece = 64 * 1024;  // of text
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

using Text = std::back_insert_iterator<std::string>;

void write_word(const std::string& word, std::string& text) {
  if (word.find_first_of(",\"") == std::string::npos) {
    text += word;
    return;
  }
  text += '"';
  for (const char letter : word) text.append(letter == '"' ? 2 : 1, letter);
  text += '"';
}

constexpr std::int8_t kUnknown = -1;  // of truths

struct CellWriter {
  std::size_t row;
  std::string& text;

  void operator()(const std::vector<std::int64_t>& list) const {
    fmt::format_to(Text(text), "{}", list[row]);
  }
  void operator()(const std::vector<double>& list) const {
    if (std::isfinite(list[row])) fmt::format_to(Text(text), "{}", list[row]);
  }
  void operator()(const WordColumn& list) const {
    if (list.codes[row] >= 0)
      write_word(list.words[static_cast<std::size_t>(list.codes[row])], text);
  }
  void operator()(const TruthColumn& list) const {
    if (list.codes[row] != kUnknown) text += list.codes[row] == 1 ? '1' : '0';
  }
};

// The column as one of codes; its rows so far have no value, -1.
template <class Coded>
Coded& coded(ResultColumn& column, std::size_t rows) {
  if (!std::holds_alternative<Coded>(column.values)) {
    Coded none;
    none.codes.assign(rows, -1);
    column.values = std::move(none);
  }
  return std::get<Coded>(column.values);
}

}  // namespace

std::size_t ColumnBuilder::rows() const {
  return std::visit(
      [](const auto& list) {
        if constexpr (requires { list.codes; })
          return list.codes.size();
        else
          return list.size();
      },
      column_.values);
}

// Whole numbers become numbers among others.
std::vector<double>& ColumnBuilder::numbers() {
  if (const auto* whole = std::get_if<std::vector<std::int64_t>>(&column_.values))
    column_.values = std::vector<double>(whole->begin(), whole->end());
  return std::get<std::vector<double>>(column_.values);
}

void ColumnBuilder::add_number(double value) {
  numbers().push_back(std::isfinite(value) ? value : kNoNumber);
}

void ColumnBuilder::add_whole(std::int64_t value) {
  if (auto* whole = std::get_if<std::vector<std::int64_t>>(&column_.values))
    whole->push_back(value);
  else
    numbers().push_back(static_cast<double>(value));
}

void ColumnBuilder::add_word(std::string_view word) {
  auto& list = coded<WordColumn>(column_, rows());
  if (word.empty()) {
    list.codes.push_back(-1);
    return;
  }
  const auto [at, is_new] =
      places_.emplace(std::string(word), static_cast<std::int32_t>(list.words.size()));
  if (is_new) list.words.emplace_back(word);
  list.codes.push_back(at->second);
}

void ColumnBuilder::add_truth(std::optional<bool> holds) {
  coded<TruthColumn>(column_, rows()).codes.push_back(!holds ? kUnknown : *holds ? 1 : 0);
}

void ColumnBuilder::skip(std::size_t count) {
  if (auto* words = std::get_if<WordColumn>(&column_.values))
    words->codes.insert(words->codes.end(), count, -1);
  else if (auto* truths = std::get_if<TruthColumn>(&column_.values))
    truths->codes.insert(truths->codes.end(), count, kUnknown);
  else if (count > 0)
    numbers().insert(numbers().end(), count, kNoNumber);
}

ResultColumn ColumnBuilder::take() {
  if (rows() == 0) column_.values = std::vector<double>();
  return std::move(column_);
}

ResultTable::ResultTable(const std::string& names) {
  std::istringstream list(names.substr(0, names.find('\n')));
  for (std::string name; std::getline(list, name, ',');) columns_.emplace_back(name);
}

ColumnBuilder& ResultTable::next_column() {
  ColumnBuilder& column = columns_[next_];
  next_ = (next_ + 1) % columns_.size();
  return column;
}

ResultTable& ResultTable::skip(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) next_column().skip(1);
  return *this;
}

std::vector<ResultColumn> ResultTable::take_columns() {
  std::vector<ResultColumn> taken;
  for (ColumnBuilder& column : columns_) taken.push_back(column.take());
  return taken;
}

void ResultTable::write_csv(const TextSink& sink) const {
  std::string text;
  for (const ColumnBuilder& column : columns_)
    text += (text.empty() ? "" : ",") + column.column().name;
  text += '\n';
  const std::size_t rows = columns_.empty() ? 0 : columns_.front().rows();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (j > 0) text += ',';
      std::visit(CellWriter{row, text}, columns_[j].column().values);
    }
    text += '\n';
    if (text.size() < kPiece) continue;
    sink(text);
    text.clear();
  }
  sink(text);
}

std::string csv_text(const ResultTable& table) {
  std::string text;
  table.write_csv([&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace graze
